// SPDX-License-Identifier: MIT
// l3d_surface_part: what a piece of surface becomes before it is filled.
#ifndef L3D_RASTER_SURFACE_PART_H
#define L3D_RASTER_SURFACE_PART_H

#include "base/public.h"
#include "raster/micro_grid.h"
#include "raster/micro_triangles.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

/// Where the blocks of a grid begin, in rows or columns of its quads; the last entry is their
/// number. A block is what is tested for being hidden, and sorted front to back, as a whole.
struct L3D_PUBLIC l3d_block_starts {
    /// Most blocks along a row or a column.
    static constexpr int most_blocks = 4;
    /// Their number.
    int blocks = 1;
    /// The first row or column of quads in each, and the end of the last one.
    std::array<int, most_blocks + 1> first{};
};

/// A straight piece of the line at which a grid of a surface ends, or a side of a loose triangle.
///
/// Units: as l3d_micro_vertex. It goes so that the quad beside it is on the right, seen in the
/// picture, if that quad's corners p00 p10 p11 p01 turn to the right there. So does that of a
/// triangle, from corner to corner.
struct L3D_PUBLIC l3d_border_edge {
    /// The column at which it begins.
    std::int32_t from_x = 0;
    /// The row at which it begins.
    std::int32_t from_y = 0;
    /// The column at which it ends.
    std::int32_t to_x = 0;
    /// The row at which it ends.
    std::int32_t to_y = 0;
    /// The inv_w at which it begins.
    float from_inv_w = 0;
    /// The inv_w at which it ends.
    float to_inv_w = 0;
    /// The level of the light beside it in mode l3d_shade::levels; not a number in others.
    float level = 0;
    /// The grid's row of the quad that it lies beside; 0 if it is a triangle's.
    int row = 0;
    /// The grid's column of that quad, or the place of the triangle.
    int column = 0;
    /// Which of the quad's sides it is: p00 to p10, p10 to p11, p11 to p01, p01 to p00. Or the
    /// corner at which the triangle's side begins.
    int side = 0;
    /// It is a contour whatever lies beside it: the surface folds over or is cut off here.
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
    /// Where the blocks along v begin.
    l3d_block_starts block_rows;
    /// Where the blocks along u begin.
    l3d_block_starts block_columns;
    /// Triangles that belong to no grid.
    l3d_micro_triangles triangles;
    /// Where the surface ends or goes on in another part, for anti-aliasing. It may be known in
    /// part or not at all: then pixels there are drawn in a slower way, and what is thinner than a
    /// pixel may be missed. A part without a grid has the sides of its triangles, in their order.
    std::vector<l3d_border_edge> border;
    /// Bit 4 * row + column is set for a block of the grid that nobody need draw.
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
