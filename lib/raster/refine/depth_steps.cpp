// SPDX-License-Identifier: MIT
// depth_steps: finds the few pixels whose levels jump, by vectors of channels.
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

/// Whether there is a jump from the second to the third of four pixels in a line.
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

/// The channels of a pixel are bytes of its word, in the order of memory. The last of four is
/// transparency.
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

/// Whether a channel of some pixels may jump to the pixel on the right, or to that below.
/// Transparency counts as a channel here.
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

/// Marks the pixels from x up to `end` that have a bit in any of their channels.
HWY_INLINE void add_pixels(std::uint64_t bits, std::int32_t x, std::int32_t end,
                           std::uint64_t* to) {
    constexpr std::uint64_t first_channels = 0x1111111111111111;
    bits = (bits | bits >> 1 | bits >> 2) & first_channels;
    for (; bits != 0; bits &= bits - 1)
        if (const std::int32_t at = x + std::countr_zero(bits) / channels; at < end)
            to[l3d_pixel_bits::word_of(at)] |= std::uint64_t{1} << l3d_pixel_bits::bit_of(at);
}

void depth_steps(const l3d_pixels& picture, const l3d_pixel_box& where, level_jumps& jumps) {
    const auto row_at = [&](std::int32_t y) {
        return picture.row(std::clamp(y, 0, picture.height - 1)).data();
    };
    for (std::int32_t y = where.top; y < where.bottom; ++y) {
        const std::uint32_t *const above = row_at(y - 1), *const here = row_at(y),
                                   *const below = row_at(y + 1), *const last = row_at(y + 2);
        std::uint64_t *const right = jumps.right.row(y), *const down = jumps.down.row(y);
        // Whole vectors begin before this column, so that there are two pixels behind the last one.
        const std::int32_t inside = std::min(where.right, picture.width - vector_pixels - 1);
        for (std::int32_t x = where.left; x < where.right;) {
            if (vector_pixels > 0 && x > 0 && x < inside) {
                while (x < inside && !any_far(here + x, below + x))
                    x += vector_pixels;
                if (x < inside) {
                    const auto middle = load(here + x);
                    add_pixels(jumps_between(load(here + x - 1), middle, load(here + x + 1),
                                             load(here + x + 2)),
                               x, where.right, right);
                    add_pixels(
                        jumps_between(load(above + x), middle, load(below + x), load(last + x)), x,
                        where.right, down);
                    x += vector_pixels;
                }
                continue;
            }
            // Beyond its ends, a row goes on with its first and its last pixel.
            const auto at = [&](std::int32_t i) {
                return here[std::clamp(i, 0, picture.width - 1)];
            };
            if (is_jump({at(x - 1), here[x], at(x + 1), at(x + 2)}))
                jumps.right.set(x, y);
            if (is_jump({above[x], here[x], below[x], last[x]}))
                jumps.down.set(x, y);
            ++x;
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(depth_steps);

void depth_steps(const l3d_pixels& picture, const l3d_pixel_box& where, level_jumps& jumps) {
    if (!where.empty())
        L3D_SIMD_CALL(depth_steps)(picture, where, jumps);
}

} // namespace l3d_detail
#endif
