// SPDX-License-Identifier: MIT
// l3d_micro_grid: the vertices of a diced piece of surface, ready to be filled.
#ifndef L3D_RASTER_MICRO_GRID_H
#define L3D_RASTER_MICRO_GRID_H

#include "base/public.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Sub-pixel resolution of every surface vertex: 8 fraction bits, so that products of two
/// coordinate differences of a 64-pixel quad fit 32 bits (2 * (6 + 8) + 2 sign and sum bits = 30).
inline constexpr int l3d_subpixel_bits = 8;
/// One pixel in these units.
inline constexpr std::int32_t l3d_subpixel_one = 1 << l3d_subpixel_bits;

/// One vertex of a surface.
///
/// Units: x, y in 1/256 pixel from the top left corner of the picture, |x|, |y| <= 2^23.
///        inv_w = 1 / distance along the view axis, in 1 / world units, > 0.
///        normal = the direction of dS/du x dS/dv in world space, not yet turned to the eye: a
///        unit vector, or zero. Fast fills rely on that.
///
/// In frames of mode l3d_shade::levels the three numbers of `normal` have other meanings.
/// - [0] is the level 229.5 n.l, n turned to the eye. (The grey is round(25.5 + max(0, level)).)
/// - [1] and [2] are bends of sides: the level in a side's middle less the mean of both ends. In a
///   grid they belong to the sides to the next vertex along u and v.
/// - In a triangle, corner 0 has the bends of the sides to corners 1 and 2. Corner 1 has 0 in [1],
///   and the bend of the side to corner 2 in [2]. Corner 2 has 0 in both.
struct L3D_PUBLIC l3d_micro_vertex {
    /// The place in the picture.
    std::int32_t x = 0, y = 0;
    float inv_w = 0;             ///< 1 / distance along the view axis
    float normal[3] = {0, 0, 0}; ///< the normal, or levels
};

/// A rows x columns array of vertices, one array per component so that a row can be stepped,
/// projected and set up in SIMD lanes.
///
/// Shape: index = row * pitch + column; columns run along u, rows along v. pitch >= columns is a
///        multiple of 16 so that every row starts a full vector.
/// Cost:  resize allocates only when a grid is larger than any before.
struct L3D_PUBLIC l3d_micro_grid {
    /// Vertices along u, vertices along v, and the distance between rows in the arrays.
    int columns = 0, rows = 0, pitch = 0;
    /// Places in the picture, of all vertices. Units: 1/256 pixel.
    std::vector<std::int32_t> x, y;
    std::vector<float> inv_w;     ///< 1 / distance, of all vertices
    std::vector<float> normal[3]; ///< the normals' components, of all vertices

    /// Whether some quads show the side of dS/du x dS/dv, and others the other one. Levels and
    /// bends, or normals, belong to the first. A quad, or a piece of a folded one, that turns to
    /// the right in the picture shows the other side: all its light has the other sign.
    bool shows_both = false;

    /// Quads that are not drawn, since triangles stand for them: index() of their first corners, in
    /// rising order.
    std::vector<std::uint32_t> cut;

    /// Whether a quad is in `cut`. Expects: the index of its first corner.
    bool is_cut(std::size_t p00) const {
        return !cut.empty() && std::binary_search(cut.begin(), cut.end(), p00);
    }

    /// Makes room for so many vertices along u and v. Former contents of the arrays are lost.
    void resize(int new_columns, int new_rows) {
        shows_both = false;
        cut.clear();
        columns = new_columns;
        rows = new_rows;
        pitch = (new_columns + 15) / 16 * 16;
        const std::size_t count = static_cast<std::size_t>(pitch) * static_cast<std::size_t>(rows);
        if (x.size() >= count)
            return;
        x.resize(count);
        y.resize(count);
        inv_w.resize(count);
        for (auto& component : normal)
            component.resize(count);
    }

    /// The index of a vertex in the arrays. Expects: a row and a column of the grid.
    std::size_t index(int row, int column) const {
        assert(row >= 0 && row < rows && column >= 0 && column < columns);
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(pitch) +
               static_cast<std::size_t>(column);
    }

    /// All numbers of a vertex. Expects: a row and a column of the grid.
    l3d_micro_vertex vertex(int row, int column) const { return vertex(index(row, column)); }
    /// All numbers of the vertex at that index.
    l3d_micro_vertex vertex(std::size_t i) const {
        return {x[i], y[i], inv_w[i], {normal[0][i], normal[1][i], normal[2][i]}};
    }
};

#endif
