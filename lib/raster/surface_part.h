// SPDX-License-Identifier: MIT
// l3d_surface_part: what a piece of surface becomes before it is filled.
#ifndef L3D_RASTER_SURFACE_PART_H
#define L3D_RASTER_SURFACE_PART_H

#include "base/public.h"
#include "raster/micro_grid.h"
#include "raster/micro_triangles.h"

#include <array>
#include <cstdint>

/// Where the blocks of a grid begin, in rows or columns of its quads; the last entry is their
/// number. A block is what is tested for being hidden, and sorted front to back, as a whole.
struct L3D_PUBLIC l3d_block_starts {
    /// Most blocks along a row or a column.
    static constexpr int most_blocks = 4;
    int blocks = 1; ///< their number
    std::array<int, most_blocks + 1>
        first{}; ///< the first row or column of quads in each, and the end of the last one
};

/// A grid of micro-quads and loose triangles, drawn together.
///
/// Shape:   the grid may be empty (rows < 2); triangles may be none.
/// Expects: blocks in order, the last of block_rows (block_columns) ending with the grid's last row
///          (column) of quads; the grid's normals have unit length or are zero.
struct L3D_PUBLIC l3d_surface_part {
    l3d_micro_grid grid; ///< the regular part
    /// Where the blocks along v and along u begin.
    l3d_block_starts block_rows, block_columns;
    l3d_micro_triangles triangles; ///< what belongs to no grid
    unsigned unseen = 0; ///< bit 4 * row + column: a block of the grid that nobody need draw
    std::uint32_t error_color = 0; ///< of everything in it, in mode `error`. A pixel word
};

#endif
