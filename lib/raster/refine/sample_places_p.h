// SPDX-License-Identifier: MIT
// sample_places: the places at which a pixel is sampled.
#ifndef L3D_RASTER_REFINE_SAMPLE_PLACES_P_H
#define L3D_RASTER_REFINE_SAMPLE_PLACES_P_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The places of a pixel's 64 samples, in the middles of 16 x 16 cells. Each row and each column of
/// cells has four samples.
///
/// These places were searched for so that either side of any straight edge has nearly as many
/// samples as its area demands. At most 3.4 of the 64 samples are wrong, and 0.73 in the mean. A
/// (0, 2)-sequence, with one sample in each rectangle of 1/64 of the pixel, has up to 7.5 wrong
/// samples at diagonals.
///
/// Sample b is bit b of masks.
/// Units: cells.
struct sample_places {
    static constexpr std::size_t count = 64;
    static constexpr std::int32_t cells = 16;
    alignas(64) std::array<std::int16_t, count> x{
        1, 4,  8, 14, 3,  6,  10, 12, 0, 8,  11, 15, 2,  4,  6,  13, 7, 9, 11, 14, 0,  2,
        5, 12, 3, 7,  10, 14, 1,  5,  9, 15, 2,  7,  11, 13, 0,  3,  5, 9, 6,  10, 12, 14,
        2, 4,  8, 15, 0,  7,  11, 13, 1, 3,  5,  9,  6,  10, 13, 15, 1, 4, 8,  12};
    alignas(64) std::array<std::int16_t, count> y{};

    constexpr sample_places() {
        for (std::size_t i = 0; i < count; ++i)
            y[i] = static_cast<std::int16_t>(i / 4);
    }

    constexpr bool has_four_in_each_line() const {
        for (std::int16_t line = 0; line < cells; ++line)
            if (std::ranges::count(x, line) != 4 || std::ranges::count(y, line) != 4)
                return false;
        return true;
    }

    /// For each of the four bits of a coordinate, the samples in which it is set.
    static constexpr std::array<std::uint64_t, 4>
    digits(const std::array<std::int16_t, count>& of) {
        std::array<std::uint64_t, 4> masks{};
        for (std::size_t digit = 0; digit < masks.size(); ++digit)
            for (std::size_t i = 0; i < count; ++i)
                masks[digit] |= static_cast<std::uint64_t>(of[i] >> digit & 1) << i;
        return masks;
    }
};

inline constexpr sample_places the_samples;
static_assert(the_samples.has_four_in_each_line());

} // namespace l3d_detail

#endif
