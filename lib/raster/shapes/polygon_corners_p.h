// SPDX-License-Identifier: MIT
// polygon_corners: the corners of 2D polygons on the lattice of 1/256 pixel.
#ifndef L3D_RASTER_SHAPES_POLYGON_CORNERS_P_H
#define L3D_RASTER_SHAPES_POLYGON_CORNERS_P_H

#include "raster/shapes/exact_steps_p.h"
#include "raster/rasterizer_2d.h"
#include "raster/shapes/scan_edge_p.h"

#include <span>
#include <vector>

namespace l3d_detail {

/// The point of the lattice of 1/256 pixel that is nearest to a position. The point lies half a
/// pixel further right and down, as pixel (x, y) is sampled at (x + 1/2, y + 1/2) on the lattice,
/// but at (x, y) in l3d_rasterizer_2d. Coordinates beyond far_limit are clamped to it.
/// Expects: coordinates that are numbers.
far_point lattice_point(l3d_point_2d position);

/// Whether both coordinates are numbers: neither is a NaN.
bool is_number(l3d_point_2d position);

/// The corners of one polygon on the lattice.
///
/// Cost: allocates when there are more corners than ever before.
class polygon_corners {
public:
    /// Sets the corners of a polygon. Returns false if the polygon covers nothing: it has fewer
    /// than three corners or no area, or a coordinate is not a number.
    bool set(std::span<const l3d_point_2d> corners);

    /// Whether the corners go round clockwise, as seen on the screen with y down.
    bool clockwise() const { return clockwise_; }

    /// Whether near() gives the corners, as far() always does. near() gives them if all corners are
    /// within scan_limit, where scanning is fastest.
    bool all_near() const { return all_near_; }
    std::span<const scan_point> near() const { return near_; }
    std::span<const far_point> far() const { return far_; }

private:
    bool clockwise_ = false, all_near_ = false;
    std::vector<scan_point> near_;
    std::vector<far_point> far_;
};

} // namespace l3d_detail

#endif
