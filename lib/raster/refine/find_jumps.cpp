// SPDX-License-Identifier: MIT
// find_jumps: all channels of some pixels at once, as the bytes of their words.
#include "raster/refine/find_jumps_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/find_jumps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Channels are bytes of pixel words, in the order of memory.
constexpr std::int32_t channels = sizeof(std::uint32_t), most_bytes = 64;
constexpr hn::CappedTag<std::uint8_t, most_bytes> levels;
using level_lanes = hn::Vec<decltype(levels)>;

/// What each channel has to be beyond. How transparent a pixel is does not count.
struct least_jumps {
    std::uint8_t at[most_bytes + channels];

    constexpr least_jumps() : at() {
        constexpr std::size_t clear = std::endian::native == std::endian::little ? 3 : 0;
        for (std::size_t i = 0; i < sizeof at; ++i)
            at[i] = i % channels == clear ? 255 : jump_levels;
    }
};
constexpr least_jumps least;

/// The same channels of four pixels in a line, of several lines side by side.
struct four_levels {
    level_lanes a, b, c, e;
};

/// A bit for each channel that jumps from b to c.
HWY_ATTR HWY_INLINE std::uint64_t jumps_at(const four_levels& of, level_lanes least_jump) {
    const auto rest = [](auto rise, auto before, auto after) HWY_ATTR {
        const auto steady = hn::Min(before, after);
        return hn::SaturatedSub(hn::SaturatedSub(rise, steady), steady);
    };
    const auto [a, b, c, e] = of;
    const auto up = rest(hn::SaturatedSub(c, b), hn::SaturatedSub(b, a), hn::SaturatedSub(e, c));
    const auto down = rest(hn::SaturatedSub(b, c), hn::SaturatedSub(a, b), hn::SaturatedSub(c, e));
    const auto over = hn::SaturatedSub(hn::Max(up, down), least_jump);
    std::uint8_t bytes[sizeof(std::uint64_t)] = {};
    hn::StoreMaskBits(levels, hn::Ne(over, hn::Zero(levels)), bytes);
    std::uint64_t bits = 0;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
}

/// Sets the bits of pixels from x up to `end` that have such channels. The first channel is x's.
HWY_INLINE void add_pixels(std::uint64_t bits, std::int32_t x, std::int32_t end,
                           std::uint64_t* to) {
    constexpr std::uint64_t first_channels = 0x1111111111111111;
    bits = (bits | bits >> 1 | bits >> 2 | bits >> 3) & first_channels;
    for (; bits != 0; bits &= bits - 1) {
        const std::int32_t at = x + std::countr_zero(bits) / channels;
        if (at < end)
            to[pixel_bits::word_of(at)] |= std::uint64_t{1} << pixel_bits::bit_of(at);
    }
}

using row_bytes = const std::uint8_t*;

/// Pixels of a row of which some lie beyond its ends: it goes on with its first and last pixel.
struct row_end {
    std::uint32_t at[1 + most_bytes / channels + 2];

    void load(const std::uint32_t* row, std::int32_t width, std::int32_t first,
              std::int32_t count) {
        for (std::int32_t i = 0; i < count; ++i)
            at[i] = row[std::clamp(first + i, 0, width - 1)];
    }
};

/// Where jumps of pixels before `end` are written: bits of a row.
struct row_jumps {
    std::int32_t end;
    std::uint64_t *right, *down;
};

/// Finds the jumps of the vector of channels whose first one is of pixel x. It has the place `at`
/// in the rows: one above, the row itself, and two below.
HWY_ATTR HWY_NOINLINE void add_jumps(const row_bytes (&rows)[4], std::ptrdiff_t at, std::int32_t x,
                                     const row_jumps& to) {
    const auto load = [&](std::size_t row, std::ptrdiff_t pixels) HWY_ATTR {
        return hn::LoadU(levels, rows[row] + at + channels * pixels);
    };
    const auto here = load(1, 0), least_jump = hn::LoadU(levels, least.at + at % channels);
    add_pixels(jumps_at({load(1, -1), here, load(1, 1), load(1, 2)}, least_jump), x, to.end,
               to.right);
    add_pixels(jumps_at({load(0, 0), here, load(2, 0), load(3, 0)}, least_jump), x, to.end,
               to.down);
}

/// Finds the jumps of pixels from x on, whose channels have the places [begin, end) in the rows.
/// Few are far from a neighbour, and only for these it matters what is around both.
HWY_ATTR HWY_INLINE void find_between(const row_bytes (&rows)[4], std::ptrdiff_t begin,
                                      std::ptrdiff_t end, std::int32_t x, const row_jumps& to) {
    const row_bytes row = rows[1], next = rows[2];
    for (std::ptrdiff_t at = begin; at < end; at += static_cast<int>(hn::Lanes(levels))) {
        const auto here = hn::LoadU(levels, row + at), below = hn::LoadU(levels, next + at);
        const auto beside = hn::LoadU(levels, row + at + channels);
        const auto rise_to = [&](level_lanes of)
                                 HWY_ATTR { return hn::Sub(hn::Max(here, of), hn::Min(here, of)); };
        const auto least_jump = hn::LoadU(levels, least.at + at % channels);
        const auto most = hn::Max(hn::Max(rise_to(beside), rise_to(below)), least_jump);
        if (HWY_UNLIKELY(!hn::AllTrue(levels, hn::Eq(most, least_jump))))
            add_jumps(rows, at, x + static_cast<std::int32_t>((at - begin) / channels), to);
    }
}

/// As find_between, for some pixels at an end of the rows.
HWY_ATTR HWY_NOINLINE void find_at_end(const std::uint32_t* const (&rows)[4], std::int32_t width,
                                       std::int32_t x, std::int32_t pixels, const row_jumps& to) {
    row_end ends[4];
    row_bytes bytes[4];
    for (std::size_t i = 0; i < 4; ++i) {
        ends[i].load(rows[i], width, x - 1, pixels + 3);
        bytes[i] = reinterpret_cast<row_bytes>(ends[i].at);
    }
    find_between(bytes, channels, channels * (1 + pixels), x, to);
}

void find_jumps(const l3d_pixels& picture, const l3d_pixel_box& where, level_jumps& jumps) {
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(levels));
    const std::int32_t pixels = std::max(lanes / channels, 1);
    for (std::int32_t y = where.top; y < where.bottom; ++y) {
        const std::uint32_t* rows[4];
        row_bytes bytes[4];
        for (std::int32_t i = 0; i < 4; ++i) {
            rows[i] = picture.row(std::clamp(y + i - 1, 0, picture.height - 1)).data();
            bytes[i] = reinterpret_cast<row_bytes>(rows[i]);
        }
        const row_jumps to{where.right, jumps.right.row(y), jumps.down.row(y)};
        std::int32_t x = where.left;
        if (x == 0) {
            find_at_end(rows, picture.width, x, pixels, to);
            x += pixels;
        }
        // Whole vectors, with two pixels behind the last.
        const std::int32_t room = std::min(where.right + pixels - 1, picture.width - 2) - x;
        const std::int32_t inside = x + std::max(room / pixels, 0) * pixels;
        find_between(bytes, std::ptrdiff_t{channels} * x, std::ptrdiff_t{channels} * inside, x, to);
        for (x = inside; x < where.right; x += pixels)
            find_at_end(rows, picture.width, x, pixels, to);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(find_jumps);

void find_jumps(const l3d_pixels& picture, const l3d_pixel_box& where, level_jumps& jumps) {
    if (!where.empty())
        L3D_SIMD_CALL(find_jumps)(picture, where, jumps);
}

} // namespace l3d_detail
#endif
