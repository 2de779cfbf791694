// SPDX-License-Identifier: MIT
// band_lanes: bounds of many vertices.
#ifndef L3D_RASTER_SURFACES_BAND_LANES_P_H
#define L3D_RASTER_SURFACES_BAND_LANES_P_H

#include "raster/surfaces/band_cells_p.h"
#include "raster/surface_rasterizer.h"

#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The pixel rows that a row of quads may cover. May be empty: top >= bottom.
struct band_rows {
    std::int32_t top = 0, bottom = 0;
};

/// The box of some polygons, and an upper bound of their pixels' inv_w.
struct polygon_bounds {
    l3d_subpixel_box box;
    float nearest = 0;
};

/// The bounds of the quads of a grid; `rows` gets a number for each row of quads.
/// Expects: cells of at least one quad.
polygon_bounds bounds_of(const l3d_micro_grid& grid, const grid_cells& cells, band_rows* rows);

/// The bounds of triangles [first, last). Expects: at least one.
polygon_bounds bounds_of(const l3d_micro_triangles& triangles, std::size_t first, std::size_t last);

} // namespace l3d_detail

#endif
