// SPDX-License-Identifier: MIT
// side_rows: how much of each pixel lies on the inner side of a straight side, many rows at once.
#ifndef L3D_RASTER_PATHS_SIDE_ROWS_P_H
#define L3D_RASTER_PATHS_SIDE_ROWS_P_H

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// An edge in rows that it leads through from top to bottom.
/// Units:   pixels; row r from y = r to r + 1.
struct straight_side {
    double x0, y0, slope; ///< x = x0 + (y - y0) slope,
    double least, most;   ///< but between these
    bool is_left;         ///< what is inside lies right of it
};

/// A side in a row, and the values of this and the next columns. In columns behind those that it
/// reaches, all of a pixel is on one side.
struct side_row {
    static constexpr std::int32_t columns = 4;
    static constexpr std::size_t at_once = 8; ///< are found together

    std::int32_t first; ///< column
    std::array<std::uint8_t, columns> values;
};

/// A side with a larger slope may reach more columns of a row than side_row has.
inline constexpr double most_side_slope = side_row::columns - 1;

/// Finds `count` rows of a side from `row` on.
/// Shape:   there is room for side_row::at_once more.
/// Expects: |slope| <= most_side_slope; x >= 0.
/// Units:   a pixel that is inside wholly has the value `full`; others are rounded to nearest.
void find_side_rows(const straight_side& side, std::int32_t row, std::size_t count, double full,
                    side_row* rows);

} // namespace l3d_detail

#endif
