// SPDX-License-Identifier: MIT
// grid_cells: some of the quads of a grid, and the bounds of many vertices.
#ifndef L3D_RASTER_SURFACES_BAND_CELLS_P_H
#define L3D_RASTER_SURFACES_BAND_CELLS_P_H

#include "raster/surface_part.h"
#include "raster/surface_rasterizer.h"

#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// A range of a grid's quads. The first corners of these quads are in rows [row_begin, row_end) and
/// columns [column_begin, column_end).
struct grid_cells {
    int row_begin = 0, row_end = 0, column_begin = 0, column_end = 0;
};

inline grid_cells all_cells(const l3d_micro_grid& grid) {
    if (grid.rows < 2 || grid.columns < 2)
        return {};
    return {0, grid.rows - 1, 0, grid.columns - 1};
}

/// The number of quads and triangles of a part, without quads that triangles replace.
inline std::int64_t polygons(const l3d_surface_part& part) {
    const grid_cells cells = all_cells(part.grid);
    return std::int64_t{cells.row_end} * cells.column_end +
           static_cast<std::int64_t>(part.triangles.count) -
           static_cast<std::int64_t>(part.grid.cut.size());
}

/// The pixel rows [top, bottom) that a row of quads may cover; none if top >= bottom.
struct band_rows {
    std::int32_t top = 0, bottom = 0;
};

/// The box of some quads or triangles, and an upper bound of inv_w in their pixels. These bounds
/// tell whether the polygons are hidden.
struct polygon_bounds {
    l3d_subpixel_box box;
    float nearest = 0;
};

/// Finds the bounds of quads of a grid. `rows` gets the pixel rows of each row of quads.
/// Expects: cells of at least one quad.
polygon_bounds bounds_of(const l3d_micro_grid& grid, const grid_cells& cells, band_rows* rows);

/// Finds the bounds of triangles [first, last). Expects: at least one.
polygon_bounds bounds_of(const l3d_micro_triangles& triangles, std::size_t first, std::size_t last);

} // namespace l3d_detail

#endif
