// SPDX-License-Identifier: MIT
// The places in a pixel at which a refined pixel is sampled.
#ifndef L3D_RASTER_REFINE_SAMPLE_PATTERN_P_H
#define L3D_RASTER_REFINE_SAMPLE_PATTERN_P_H

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// 32 rows of 8 samples. In a row, x grows by 1/8 pixel from sample to sample, and y by a little,
/// so that a row is on a line and SIMD lanes can step along it.
///
/// The rows' beginnings and slopes were searched for, so that every straight edge through the pixel
/// has nearly as many samples on either side as its area says (NUMERICS, Anti-aliasing).
/// Units: 1/512 pixel from the pixel's top left corner, all odd. So no sample is at a vertex, which
/// is at an even place.
struct sample_pattern {
    static constexpr std::size_t rows = 32, columns = 8, count = rows * columns;
    static constexpr std::int32_t pixel = 512, step_x = pixel / columns;

    static constexpr std::int32_t x(std::size_t row, std::size_t column) {
        return first_x[row] + static_cast<std::int32_t>(column) * step_x;
    }
    static constexpr std::int32_t y(std::size_t row, std::size_t column) {
        return first_y[row] + static_cast<std::int32_t>(column) * step_y[row];
    }

    alignas(64) static constexpr std::array<std::int32_t, rows> first_x{
        35, 9, 37, 51, 9,  37, 17, 51, 19, 53, 27, 35, 31, 61, 13, 63,
        27, 1, 25, 37, 21, 51, 15, 51, 27, 7,  31, 59, 23, 45, 15, 41};
    alignas(64) static constexpr std::array<std::int32_t, rows> step_y{
        -2, -2, -2, -2, 2, -2, -2, 2, -2, 2,  -2, 2, -2, 2, -2, -2,
        2,  -2, -2, 2,  2, 2,  -2, 2, -2, -2, -2, 2, 2,  2, -2, 2};
    alignas(64) static constexpr std::array<std::int32_t, rows> first_y = [] {
        std::array<std::int32_t, rows> result{};
        constexpr std::int32_t height = pixel / static_cast<std::int32_t>(rows);
        for (std::size_t row = 0; row < rows; ++row)
            result[row] =
                static_cast<std::int32_t>(row) * height + (step_y[row] > 0 ? 1 : height - 1);
        return result;
    }();
};

} // namespace l3d_detail

#endif
