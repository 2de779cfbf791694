// SPDX-License-Identifier: MIT
// l3d_surface_part: a diced piece of surface, ready to be filled.
#ifndef L3D_RASTER_SURFACE_PART_H
#define L3D_RASTER_SURFACE_PART_H

#include "base/public.h"
#include "raster/micro_grid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

/// The beginnings of a grid's blocks, in rows or columns of its quads; the last entry is their
/// number. A block is tested for being hidden, and sorted front to back, as a whole.
struct L3D_PUBLIC l3d_block_starts {
    /// The limit of blocks along a row or a column.
    static constexpr int most_blocks = 4;
    /// The number of blocks.
    int blocks = 1;
    /// The first row or column of quads in each, and the end of the last one.
    std::array<int, most_blocks + 1> first{};
};

/// A straight piece of the line at which a grid of a surface ends, or a side of a loose triangle.
///
/// Units: as l3d_micro_vertex. The quad beside it is on its right, seen in the picture, if that
///        quad's corners p00 p10 p11 p01 turn to the right there. A triangle's side goes from
///        corner to corner likewise.
struct L3D_PUBLIC l3d_border_edge {
    /// The column at which the line begins.
    std::int32_t from_x = 0;
    /// The row at which the line begins.
    std::int32_t from_y = 0;
    /// The column at which the line ends.
    std::int32_t to_x = 0;
    /// The row at which the line ends.
    std::int32_t to_y = 0;
    /// The inv_w at which it begins.
    float from_inv_w = 0;
    /// The inv_w at which it ends.
    float to_inv_w = 0;
    /// The level of the light beside the line in mode l3d_shade::levels; not a number in others.
    float level = 0;
    /// The grid's row of the quad beside the line; 0 if the line is a triangle's side.
    int row = 0;
    /// The grid's column of that quad, or the place of the triangle.
    int column = 0;
    /// The number of the quad's side: p00 to p10, p10 to p11, p11 to p01, p01 to p00. Or the corner
    /// at which the triangle's side begins.
    int side = 0;
    /// Whether the line is a contour whatever lies beside it: the surface folds over or is cut off
    /// here.
    bool always = false;

    /// The larger inv_w of its ends.
    float nearest() const { return std::max(from_inv_w, to_inv_w); }
};

/// A grid of micro-quads and loose triangles, drawn together.
///
/// Shape:   the grid may be empty (rows < 2); triangles may be none.
/// Expects: blocks in order, the last of block_rows (block_columns) ending with the grid's last row
///          (column) of quads; normals have unit length or are zero.
struct L3D_PUBLIC l3d_surface_part {
    /// The regular part.
    l3d_micro_grid grid;
    /// The blocks along v.
    l3d_block_starts block_rows;
    /// The blocks along u.
    l3d_block_starts block_columns;
    /// Triangles that belong to no grid.
    l3d_micro_triangles triangles;
    /// The lines at which the surface ends or goes on in another part, for anti-aliasing. If some
    /// are missing, pixels there are drawn in a slower way, and shapes thinner than a pixel may be
    /// missed. A part without a grid has the sides of its triangles, in their order.
    std::vector<l3d_border_edge> border;
    /// Bit 4 * row + column is set for a block of the grid that need not be drawn.
    unsigned unseen = 0;
    /// The colour of everything in it in mode `error`, as a pixel word.
    std::uint32_t error_color = 0;
    /// Index of l3d_surface_rasterizer::use_materials, of all but triangles that have their own.
    std::uint32_t material = 0;

    /// The index of a triangle's material.
    std::uint32_t material_of(std::size_t triangle) const {
        return triangles.materials.empty() ? material : triangles.materials[triangle];
    }
};

#endif
