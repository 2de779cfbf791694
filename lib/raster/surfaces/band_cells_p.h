// SPDX-License-Identifier: MIT
// grid_cells: some of the quads of a grid.
#ifndef L3D_RASTER_SURFACES_BAND_CELLS_P_H
#define L3D_RASTER_SURFACES_BAND_CELLS_P_H

#include "raster/surface_part.h"

#include <cstdint>

namespace l3d_detail {

/// The quads whose first corner is in rows [row_begin, row_end) and columns
/// [column_begin, column_end).
struct grid_cells {
    int row_begin = 0, row_end = 0, column_begin = 0, column_end = 0;
};

inline grid_cells all_cells(const l3d_micro_grid& grid) {
    if (grid.rows < 2 || grid.columns < 2)
        return {};
    return {0, grid.rows - 1, 0, grid.columns - 1};
}

/// Quads and triangles of a part.
inline std::int64_t polygons(const l3d_surface_part& part) {
    const grid_cells cells = all_cells(part.grid);
    return std::int64_t{cells.row_end} * cells.column_end +
           static_cast<std::int64_t>(part.triangles.count) -
           static_cast<std::int64_t>(part.grid.cut.size());
}

} // namespace l3d_detail

#endif
