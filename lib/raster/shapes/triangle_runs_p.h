// SPDX-License-Identifier: MIT
// triangle_runs: the rows of a triangle, found many at a time.
#ifndef L3D_RASTER_SHAPES_TRIANGLE_RUNS_P_H
#define L3D_RASTER_SHAPES_TRIANGLE_RUNS_P_H

#include "raster/shapes/scan_polygon_p.h"
#include "raster/surfaces/wide_rows_p.h"

#include <array>
#include <cstdint>

namespace l3d_detail {

/// The columns of a triangle in each of its rows, by the fill rule of scan_polygon, with its
/// numbers exactly.
///
/// A triangle lies on one side of the whole line of each of its sides. So each line limits all
/// rows, and no row has to know which corner is above it.
class triangle_runs {
public:
    /// Only rows that are kept will be found. Expects: corners as of scan_point.
    triangle_runs(const std::array<scan_point, 3>& corners, scan_rows kept);

    /// Finds further rows; the first ones at first. The former contents of `runs` are lost. A row
    /// may have no columns in a picture of that width: then its end is not behind its beginning.
    /// Returns: false if there are no further rows.
    bool next(std::int32_t width, wide_runs& runs);

private:
    /// Those that are still to be found.
    scan_rows rows_;
    /// So many were found. The lines begin at the first of them.
    std::int32_t found_ = 0;
    /// Whether the side from the highest to the lowest corner, the long one, is on the left.
    bool is_long_left_ = false;
    /// Lines of the long side, of the side from the highest corner, of the side to the lowest
    /// corner.
    std::array<scan_edge::line, 3> lines_{};
};

} // namespace l3d_detail

#endif
