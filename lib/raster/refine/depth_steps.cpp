// SPDX-License-Identifier: MIT
// mark_jumps: finds the few pixels whose levels jump, by vectors of channels.
#include "raster/refine/depth_steps_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/depth_steps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

#ifndef L3D_RASTER_FIND_JUMPS_ONCE
#define L3D_RASTER_FIND_JUMPS_ONCE
namespace l3d_detail {

/// Whether levels jump from the second to the third of four neighbouring pixels in a row or column.
inline bool is_jump(const std::uint32_t (&words)[4]) {
    for (const int shift : {0, 8, 16}) {
        const auto rise = [&](std::size_t i) {
            return static_cast<int>(words[i + 1] >> shift & 255) -
                   static_cast<int>(words[i] >> shift & 255);
        };
        const int way = rise(1) < 0 ? -1 : 1;
        const int before = std::max(way * rise(0), 0), after = std::max(way * rise(2), 0);
        const int kink = std::min(std::max(before, after), most_kink_levels);
        if (way * rise(1) - std::max(2 * std::min(before, after), kink) > jump_levels)
            return true;
    }
    return false;
}

} // namespace l3d_detail
#endif

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// The channels of a pixel are bytes of its word, in the order of memory. The last of these four
/// bytes is transparency.
constexpr std::int32_t channels = sizeof(std::uint32_t);
constexpr hn::CappedTag<std::uint8_t, 64> levels;
constexpr auto vector_pixels = static_cast<std::int32_t>(hn::MaxLanes(levels)) / channels;
using level_lanes = hn::Vec<decltype(levels)>;
static_assert(std::endian::native == std::endian::little);

HWY_ATTR HWY_INLINE level_lanes load(const std::uint32_t* from) {
    return hn::LoadU(levels, reinterpret_cast<const std::uint8_t*>(from));
}

/// Sets a bit for each channel above jump_levels, except for transparency.
HWY_ATTR HWY_INLINE std::uint64_t far_channels(level_lanes of) {
    const auto most = hn::Set(levels, std::uint8_t{jump_levels});
    std::uint8_t bytes[sizeof(std::uint64_t)] = {};
    hn::StoreMaskBits(levels, hn::Ne(hn::Max(of, most), most), bytes);
    std::uint64_t bits = 0;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits & 0x7777777777777777;
}

/// Whether, in any of some neighbouring pixels, a channel may jump to the pixel on its right or
/// below. Transparency counts as a channel here.
HWY_ATTR HWY_INLINE bool any_far(const std::uint32_t* row, const std::uint32_t* next) {
    const auto here = load(row), beside = load(row + 1), below = load(next);
    const auto range =
        hn::Sub(hn::Max(hn::Max(here, beside), below), hn::Min(hn::Min(here, beside), below));
    const auto most = hn::Set(levels, std::uint8_t{jump_levels});
    return !hn::AllTrue(levels, hn::Eq(hn::Max(range, most), most));
}

/// Tests some pixels side by side as is_jump does, and sets a bit for each channel that jumps.
HWY_ATTR HWY_INLINE std::uint64_t jumps_between(level_lanes a, level_lanes b, level_lanes c,
                                                level_lanes e) {
    const auto most_kink = hn::Set(levels, std::uint8_t{most_kink_levels});
    const auto rest = [&](auto rise, auto before, auto after) HWY_ATTR {
        const auto steady = hn::Min(before, after);
        const auto kink = hn::Min(hn::Max(before, after), most_kink);
        return hn::SaturatedSub(rise, hn::Max(hn::SaturatedAdd(steady, steady), kink));
    };
    return far_channels(
        hn::Max(rest(hn::SaturatedSub(c, b), hn::SaturatedSub(b, a), hn::SaturatedSub(e, c)),
                rest(hn::SaturatedSub(b, c), hn::SaturatedSub(a, b), hn::SaturatedSub(c, e))));
}

/// Calls visit(i) for each pixel i that has a bit in any of its channels.
template <class Visit> HWY_INLINE void visit_pixels(std::uint64_t bits, const Visit& visit) {
    bits = (bits | bits >> 1 | bits >> 2) & 0x1111111111111111;
    for (; bits != 0; bits &= bits - 1)
        visit(std::countr_zero(bits) / channels);
}

void mark_jumps(const l3d_pixels& picture, const l3d_pixel_box& where, const l3d_pixel_box& band,
                l3d_pixel_bits& marks) {
    const auto row_at = [&](std::int32_t y) {
        return picture.row(std::clamp(y, 0, picture.height - 1)).data();
    };
    const auto mark = [&](std::int32_t x, std::int32_t y) {
        if (x < band.right && y >= band.top && y < band.bottom)
            marks.set(x, y);
    };
    for (std::int32_t y = where.top; y < where.bottom; ++y) {
        // Beyond its borders, the picture repeats its border pixels.
        const std::uint32_t *const above = row_at(y - 1), *const here = row_at(y),
                                   *const below = row_at(y + 1), *const last = row_at(y + 2);
        const auto at = [&](std::int32_t x) { return here[std::clamp(x, 0, picture.width - 1)]; };
        const auto mark_right = [&](std::int32_t x) {
            mark(x, y);
            mark(x + 1, y);
        };
        const auto mark_down = [&](std::int32_t x) {
            mark(x, y);
            mark(x, y + 1);
        };
        for (std::int32_t x = where.left; x < where.right;) {
            // A vector needs a pixel before its first one, and two after its last one.
            if (vector_pixels == 0 || x == 0 || x + vector_pixels + 1 >= picture.width) {
                if (is_jump({at(x - 1), here[x], at(x + 1), at(x + 2)}))
                    mark_right(x);
                if (is_jump({above[x], here[x], below[x], last[x]}))
                    mark_down(x);
                ++x;
                continue;
            }
            if (any_far(here + x, below + x)) {
                const auto middle = load(here + x);
                const auto in_where = [&](const auto& mark_both) {
                    return [&, x](std::int32_t i) {
                        if (x + i < where.right)
                            mark_both(x + i);
                    };
                };
                visit_pixels(jumps_between(load(here + x - 1), middle, load(here + x + 1),
                                           load(here + x + 2)),
                             in_where(mark_right));
                visit_pixels(
                    jumps_between(load(above + x), middle, load(below + x), load(last + x)),
                    in_where(mark_down));
            }
            x += vector_pixels;
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(mark_jumps);

void mark_jumps(const l3d_pixels& picture, const l3d_pixel_box& where, const l3d_pixel_box& band,
                l3d_pixel_bits& marks) {
    L3D_SIMD_CALL(mark_jumps)(picture, where, band, marks);
}

} // namespace l3d_detail
#endif
