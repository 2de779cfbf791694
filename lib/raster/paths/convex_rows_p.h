// SPDX-License-Identifier: MIT
// convex_rows: the two borders of a convex outline, row by row.
#ifndef L3D_RASTER_PATHS_CONVEX_ROWS_P_H
#define L3D_RASTER_PATHS_CONVEX_ROWS_P_H

#include "raster/paths/row_pieces_p.h"
#include "raster/rasterizer_2d.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// The columns that a border reaches in a row; none if last < first.
struct reached_columns {
    std::int32_t first, last;
};

/// Walks down both borders of a convex outline.
///
/// Such an outline winds around its inside once. So the signed areas right of its edges add up to
/// the area of each pixel inside, in any order, and no edges need be sorted or ordered.
/// Lives:   borrows the corners.
/// Cost:    begin: a few operations for each corner. next_row: one division for each edge that is
///          longer than a row, and a few operations for each column that a border reaches.
class convex_rows {
public:
    /// Whether the corners go around a convex outline once, with x from 0 to `width`. Corners may
    /// coincide and be in line.
    /// Expects: rows of the picture from 0 to height - 1.
    bool begin(std::span<const l3d_point_2d> corners, std::int32_t width, std::int32_t height);

    /// The first row that it reaches, and the one behind the last.
    std::int32_t top() const { return top_; }
    std::int32_t bottom() const { return bottom_; }

    /// Adds the area of a border in a row, and says which columns it reaches.
    /// Expects: rows from top() to bottom() - 1, in order.
    reached_columns add_left(std::int32_t row, row_areas& areas) {
        return borders_[0].add_row(row + 1, areas);
    }
    reached_columns add_right(std::int32_t row, row_areas& areas) {
        return borders_[1].add_row(row + 1, areas);
    }

private:
    /// One side of the outline, from top to bottom.
    class border {
    public:
        /// `step` leads from a corner to the next; `sign` is 1 if the inside is on the right.
        void begin(std::span<const l3d_point_2d> corners, std::size_t first, std::size_t edges,
                   bool forwards, double sign);
        reached_columns add_row(double row_end, row_areas& areas);

    private:
        void take_edge();
        void take_slope();
        double x_at(double y) const {
            return std::clamp(from_.x + (y - from_.y) * slope_, left_, right_);
        }

        std::span<const l3d_point_2d> corners_;
        std::size_t at_ = 0;
        std::size_t edges_ = 0; ///< that are left, the present one included
        bool forwards_ = true;
        double sign_ = 1;
        l3d_point_2d from_, to_; ///< the present edge
        bool sloped_ = false;    ///< the next ones are known
        double slope_ = 0, per_column_ = 0;
        double left_ = 0, right_ = 0;
        l3d_point_2d reached_; ///< where the last row ended
    };

    std::array<border, 2> borders_;
    std::int32_t top_ = 0, bottom_ = 0;
};

} // namespace l3d_detail

#endif
