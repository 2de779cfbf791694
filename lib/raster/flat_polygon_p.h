// SPDX-License-Identifier: MIT
// to_scan: the corners of a flat polygon on the lattice of 1/256 pixel.
#ifndef L3D_RASTER_FLAT_POLYGON_P_H
#define L3D_RASTER_FLAT_POLYGON_P_H

#include "raster/rasterizer_2d.h"
#include "raster/scan_edge_p.h"

#include <span>
#include <vector>

namespace l3d_detail {

/// Rounds corners to the lattice on which pixel (x, y) is sampled at x + 1/2, y + 1/2.
///
/// Returns 1 if they turn clockwise on the screen, -1 if the other way; 0 if nothing is to be
/// drawn: too few corners, no area, or a corner that is not a number or too far away.
int to_scan(std::span<const l3d_point_2d> corners, std::vector<scan_point>& result);

} // namespace l3d_detail

#endif
