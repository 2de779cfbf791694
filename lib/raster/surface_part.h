// SPDX-License-Identifier: MIT
// l3d_surface_part: a diced piece of surface, its grid (l3d_micro_grid) and loose triangles, ready
// to be filled.
#ifndef L3D_RASTER_SURFACE_PART_H
#define L3D_RASTER_SURFACE_PART_H

#include "base/color.h"
#include "base/public.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/// The number of fraction bits in the place of every surface vertex. Products of two coordinate
/// differences of a 64-pixel quad then fit 32 bits (2 * (6 + 8) + 2 sign and sum bits = 30).
inline constexpr int l3d_subpixel_bits = 8;
/// One pixel, in the units of a surface vertex's place.
inline constexpr std::int32_t l3d_subpixel_one = 1 << l3d_subpixel_bits;

/// A vertex of a surface.
///
/// Units: x, y in 1/256 pixel from the top left corner of the picture, |x|, |y| <= 2^23.
///        inv_w = 1 / distance along the view axis, in 1 / world units, > 0.
///        normal = the direction of dS/du x dS/dv in world space, not yet turned to the eye: a
///        unit vector, or zero. Fast fills rely on unit normals.
///
/// In frames of mode l3d_shade::levels the three numbers of `normal` have other meanings.
/// - [0] is the level 229.5 n.l, n turned to the eye. (The grey is round(25.5 + max(0, level)).)
/// - [1] and [2] are bends of sides. A bend is the level in a side's middle, less the mean of the
///   levels at its ends. In a grid, the bends belong to the sides to the next vertices along u and
///   v.
/// - In a triangle, corner 0 has the bends of the sides to corners 1 and 2. Corner 1 has 0 in [1],
///   and the bend of the side to corner 2 in [2]. Corner 2 has 0 in both.
struct L3D_PUBLIC l3d_micro_vertex {
    /// The place in the picture.
    std::int32_t x = 0, y = 0;
    float inv_w = 0;             ///< 1 / distance along the view axis
    float normal[3] = {0, 0, 0}; ///< the normal; in mode `levels`, a level and two bends
};

/// A grid of rows x columns vertices. Each component has an array of its own, so that a row can be
/// stepped, projected and set up in SIMD lanes.
///
/// Shape: index = row * pitch + column; columns run along u, rows along v. The pitch is at least
///        `columns`, and a multiple of 16 so that every row starts a full vector.
/// Cost:  resize allocates only when a grid is larger than any before.
struct L3D_PUBLIC l3d_micro_grid {
    /// Vertices along u, vertices along v, and the distance between rows in the arrays.
    int columns = 0, rows = 0, pitch = 0;
    /// The places of all vertices in the picture. Units: 1/256 pixel.
    std::vector<std::int32_t> x, y;
    std::vector<float> inv_w;     ///< 1 / distance along the view axis, of all vertices
    std::vector<float> normal[3]; ///< the components of all vertices' normals

    /// Whether the picture shows both sides of the surface. Normals, or levels and bends, belong to
    /// the side to which dS/du x dS/dv points. A quad (or a piece of a folded quad) that turns to
    /// the right in the picture shows the other side, and its light has the other sign.
    bool shows_both = false;

    /// Whether the projection is parallel. In a parallel projection, w is the same everywhere,
    /// whatever inv_w is.
    bool is_parallel = false;

    /// The quads that are not drawn, since triangles replace them. A quad is named by the index()
    /// of its first corner, in rising order.
    std::vector<std::uint32_t> cut;

    /// Whether a quad is in `cut`. Expects: the index of its first corner.
    bool is_cut(std::size_t p00) const {
        return !cut.empty() && std::binary_search(cut.begin(), cut.end(), p00);
    }

    /// Sets the numbers of vertices along u and v. Former contents of the arrays are lost.
    void resize(int new_columns, int new_rows) {
        shows_both = is_parallel = false;
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

    /// The place, inv_w and normal of a vertex. Expects: a row and a column of the grid.
    l3d_micro_vertex vertex(int row, int column) const { return vertex(index(row, column)); }
    /// The place, inv_w and normal of the vertex at an index.
    l3d_micro_vertex vertex(std::size_t i) const {
        return {x[i], y[i], inv_w[i], {normal[0][i], normal[1][i], normal[2][i]}};
    }
};

/// Triangles that belong to no grid: they fill slits between pieces, or are parts of clipped
/// pieces.
///
/// Shape: blocks of 16 triangles. In a block, each component of each corner is an array, so that
///        triangles can be set up side by side in SIMD lanes. A block is 18 cache lines in a row,
///        mostly in one page of memory, which suits walks from block to block in any order.
/// Cost:  clear keeps the memory; add allocates only when there are more triangles than ever
///        before.
struct L3D_PUBLIC l3d_micro_triangles {
    static constexpr std::size_t lanes = 16; ///< the number of triangles in a block

    /// One corner of all triangles of a block; its components are those of l3d_micro_vertex.
    struct alignas(64) corner {
        /// Places in the picture. Units: 1/256 pixel.
        std::array<std::int32_t, lanes> x, y;
        std::array<float, lanes> inv_w;                 ///< 1 / distance along the view axis
        std::array<std::array<float, lanes>, 3> normal; ///< normals, or levels and bends
    };
    /// A block of 16 triangles, by their first, second and third corners.
    using block = std::array<corner, 3>;

    std::vector<block> blocks; ///< triangle i is in element i % lanes of block i / lanes
    std::size_t count = 0;     ///< the number of triangles
    /// Each triangle's material; empty if all triangles have the material of their
    /// l3d_surface_part.
    std::vector<std::uint32_t> materials;

    /// Forgets all triangles.
    void clear() {
        count = 0;
        materials.clear();
    }

    /// Adds a triangle.
    void add(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c) {
        make_room(1);
        set(0, a);
        set(1, b);
        set(2, c);
        ++count;
    }

    /// Adds a triangle with a material. Expects: all other triangles have a material, too.
    void add(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c,
             std::uint32_t material) {
        add(a, b, c);
        materials.push_back(material);
    }

    /// Makes room in the blocks for more triangles. The caller writes them and raises `count`.
    void make_room(std::size_t more) {
        if (count + more > blocks.size() * lanes)
            grow(count + more);
    }

    /// Corner number `at` of all triangles in a triangle's block. Expects: room for the triangle;
    /// at < 3.
    corner& corners(std::size_t triangle, std::size_t at) { return blocks[triangle / lanes][at]; }
    /// Corner number `at` of all triangles in a triangle's block, which the caller may only read.
    const corner& corners(std::size_t triangle, std::size_t at) const {
        return blocks[triangle / lanes][at];
    }

    /// Corner number `at` of one triangle. Expects: triangle < count, at < 3.
    l3d_micro_vertex vertex(std::size_t triangle, std::size_t at) const {
        const corner& c = corners(triangle, at);
        const std::size_t i = triangle % lanes;
        return {c.x[i], c.y[i], c.inv_w[i], {c.normal[0][i], c.normal[1][i], c.normal[2][i]}};
    }

    /// Twice the area of a triangle in the picture, positive if its corners turn to the right in
    /// the picture.
    /// Units: 1/65536 square pixel.
    /// Expects: triangle < count.
    std::int64_t double_area(std::size_t triangle) const {
        const auto& [a, b, c] = blocks[triangle / lanes];
        const std::size_t i = triangle % lanes;
        return (std::int64_t{b.x[i]} - a.x[i]) * (std::int64_t{c.y[i]} - a.y[i]) -
               (std::int64_t{b.y[i]} - a.y[i]) * (std::int64_t{c.x[i]} - a.x[i]);
    }

private:
    void grow(std::size_t least) {
        const std::size_t wanted = std::max(least, count + count / 2);
        blocks.resize((wanted + lanes - 1) / lanes);
    }

    void set(std::size_t at, const l3d_micro_vertex& v) {
        corner& c = corners(count, at);
        const std::size_t i = count % lanes;
        c.x[i] = v.x;
        c.y[i] = v.y;
        c.inv_w[i] = v.inv_w;
        for (std::size_t k = 0; k < c.normal.size(); ++k)
            c.normal[k][i] = v.normal[k];
    }
};

/// The first rows or columns of a grid's blocks of quads. Each block as a whole is tested for being
/// hidden, and sorted front to back.
struct L3D_PUBLIC l3d_block_starts {
    /// The limit of blocks along a row or a column.
    static constexpr int most_blocks = 4;
    /// The number of blocks.
    int blocks = 1;
    /// The first row or column of quads in each block; the entry after the last block is the number
    /// of all rows or columns.
    std::array<int, most_blocks + 1> first{};
};

/// A straight piece of the border of a surface's grid, or a side of a loose triangle.
///
/// Units: as l3d_micro_vertex. Seen in the picture, the quad beside the line is on its right if the
///        quad's corners p00 p10 p11 p01 turn to the right. The same holds for a triangle's side,
///        which goes from a corner to the next one.
struct L3D_PUBLIC l3d_border_edge {
    /// The line between two vertices, without a level of light. The caller sets the members that
    /// tell what lies beside the line.
    static l3d_border_edge between(const l3d_micro_vertex& from, const l3d_micro_vertex& to) {
        l3d_border_edge edge;
        edge.from_x = from.x;
        edge.from_y = from.y;
        edge.to_x = to.x;
        edge.to_y = to.y;
        edge.from_inv_w = from.inv_w;
        edge.to_inv_w = to.inv_w;
        edge.level = std::numeric_limits<float>::quiet_NaN();
        return edge;
    }

    /// The column at which the line begins.
    std::int32_t from_x = 0;
    /// The row at which the line begins.
    std::int32_t from_y = 0;
    /// The column at which the line ends.
    std::int32_t to_x = 0;
    /// The row at which the line ends.
    std::int32_t to_y = 0;
    /// The inv_w at which the line begins.
    float from_inv_w = 0;
    /// The inv_w at which the line ends.
    float to_inv_w = 0;
    /// In mode l3d_shade::levels, the level of the light beside the line; in other modes, NaN.
    float level = 0;
    /// The grid's row of the quad beside the line; 0 for a triangle's side.
    int row = 0;
    /// The grid's column of the quad beside the line, or the triangle's number.
    int column = 0;
    /// The number of the quad's side: 0 is p00 to p10, then p10 to p11, p11 to p01, p01 to p00. For
    /// a triangle, the number of the corner at which the side begins.
    int side = 0;
    /// Whether the line is a contour whatever lies beside it, since the surface folds over or is
    /// cut off there.
    bool always = false;

    /// The larger inv_w of the line's ends, which belongs to the nearer end.
    float nearest() const { return std::max(from_inv_w, to_inv_w); }
};

/// A part of a surface: a grid of micro-quads and loose triangles, which are filled together.
///
/// Shape:   the grid may be empty (rows < 2); triangles may be none.
/// Expects: blocks in order, the last of block_rows (block_columns) ending with the grid's last row
///          (column) of quads; normals have unit length or are zero.
struct L3D_PUBLIC l3d_surface_part {
    /// The micro-quads.
    l3d_micro_grid grid;
    /// The grid's division into blocks along v.
    l3d_block_starts block_rows;
    /// The grid's division into blocks along u.
    l3d_block_starts block_columns;
    /// Triangles that belong to no grid.
    l3d_micro_triangles triangles;
    /// The lines at which the surface ends or continues in another part, for anti-aliasing. Where
    /// some lines are missing, pixels are drawn in a slower way, and shapes thinner than a pixel
    /// may be missed. In a part without a grid, the lines are the sides of its triangles, in the
    /// triangles' order.
    std::vector<l3d_border_edge> border;
    /// The blocks of the grid that need not be drawn: bit 4 * row + column is set for each of these
    /// blocks.
    unsigned unseen = 0;
    /// The colour of the whole part in mode `error`, a pixel word.
    l3d_color error_color = 0;
    /// The part's material, an index of l3d_surface_rasterizer::use_materials. Triangles may have
    /// materials of their own.
    std::uint32_t material = 0;
    /// Whether each quad of the grid has a material of its own: the sum of `material` and the index
    /// of the quad's first corner.
    bool names_quads = false;

    /// The material of a quad. Expects: the index of its first corner.
    std::uint32_t material_of_quad(std::size_t p00) const {
        return names_quads ? material + static_cast<std::uint32_t>(p00) : material;
    }

    /// The material of a triangle.
    std::uint32_t material_of(std::size_t triangle) const {
        return triangles.materials.empty() ? material : triangles.materials[triangle];
    }
};

#endif
