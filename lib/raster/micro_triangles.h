// SPDX-License-Identifier: MIT
// l3d_micro_triangles: loose triangles of a surface, ready to be filled.
#ifndef L3D_RASTER_MICRO_TRIANGLES_H
#define L3D_RASTER_MICRO_TRIANGLES_H

#include "base/public.h"
#include "raster/micro_grid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Triangles that belong to no grid: those of slits between pieces, and of clipped pieces.
///
/// Shape: blocks of 16 triangles. In a block, each component of each corner is an array, so that
///        triangles can be set up side by side in SIMD lanes. A block is 18 cache lines in a row,
///        mostly in one page of memory, for walks from block to block in any order.
/// Cost:  clear keeps the memory; add allocates only when there are more than ever before.
struct L3D_PUBLIC l3d_micro_triangles {
    static constexpr std::size_t lanes = 16; ///< triangles in a block

    /// One corner of the triangles of a block; components as of l3d_micro_vertex.
    struct alignas(64) corner {
        /// Places in the picture. Units: 1/256 pixel.
        std::array<std::int32_t, lanes> x, y;
        std::array<float, lanes> inv_w;                 ///< 1 / distance along the view axis
        std::array<std::array<float, lanes>, 3> normal; ///< normals, or levels
    };
    /// The corners of its triangles.
    using block = std::array<corner, 3>;

    std::vector<block> blocks; ///< triangle i is in element i % lanes of block i / lanes
    std::size_t count = 0;     ///< the number of triangles
    /// Each triangle's material, if not all have the one of their l3d_surface_part; else empty.
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

    /// Adds a triangle of a material. Expects: all others have a material, too.
    void add(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c,
             std::uint32_t material) {
        add(a, b, c);
        materials.push_back(material);
    }

    /// Makes room in the blocks for more triangles, which the caller writes and counts.
    void make_room(std::size_t more) {
        if (count + more > blocks.size() * lanes)
            grow(count + more);
    }

    /// One corner of the triangles of a triangle's block. Expects: room for it; at < 3.
    corner& corners(std::size_t triangle, std::size_t at) { return blocks[triangle / lanes][at]; }
    /// The same, read-only.
    const corner& corners(std::size_t triangle, std::size_t at) const {
        return blocks[triangle / lanes][at];
    }

    /// One corner of one triangle. Expects: triangle < count, at < 3.
    l3d_micro_vertex vertex(std::size_t triangle, std::size_t at) const {
        const corner& c = corners(triangle, at);
        const std::size_t i = triangle % lanes;
        return {c.x[i], c.y[i], c.inv_w[i], {c.normal[0][i], c.normal[1][i], c.normal[2][i]}};
    }

    /// Twice the area of a triangle in the picture, positive if its corners turn to the right
    /// there. Units: 1/65536 square pixel. Expects: triangle < count.
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

#endif
