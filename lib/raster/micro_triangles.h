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

/// Triangles that belong to no grid: what closes the slits between pieces, and clipped pieces.
///
/// Shape: one array per corner and component, triangle i in element i, so that triangles can be
///        set up side by side in SIMD lanes. Arrays have room for a multiple of 16.
/// Cost:  clear keeps the memory; add allocates only when there are more than ever before.
struct L3D_PUBLIC l3d_micro_triangles {
    static constexpr std::size_t lanes = 16; ///< the arrays have room for a multiple of this

    /// One corner of each triangle; components as of l3d_micro_vertex.
    struct corner {
        /// Places in the picture. Units: 1/256 pixel.
        std::vector<std::int32_t> x, y;
        std::vector<float> inv_w;                 ///< 1 / distance along the view axis
        std::array<std::vector<float>, 3> normal; ///< normals, or levels
    };

    std::array<corner, 3> corners; ///< of all triangles
    std::size_t count = 0;         ///< the number of triangles
    /// Of each triangle, if not all have the one of their l3d_surface_part; else empty.
    std::vector<std::uint32_t> materials;

    /// Forgets all triangles.
    void clear() {
        count = 0;
        materials.clear();
    }

    /// Adds a triangle.
    void add(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c) {
        if (count == corners[0].x.size())
            grow(count + 1);
        set(corners[0], a);
        set(corners[1], b);
        set(corners[2], c);
        ++count;
    }

    /// Adds a triangle of a material. Expects: all others were added so.
    void add(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c,
             std::uint32_t material) {
        add(a, b, c);
        materials.push_back(material);
    }

    /// Makes room in the arrays for so many more, to be written there and counted by the caller.
    void make_room(std::size_t more) {
        if (count + more > corners[0].x.size())
            grow(count + more);
    }

    /// One corner of one triangle. Expects: triangle < count, at < 3.
    l3d_micro_vertex vertex(std::size_t triangle, std::size_t at) const {
        const corner& c = corners[at];
        return {c.x[triangle],
                c.y[triangle],
                c.inv_w[triangle],
                {c.normal[0][triangle], c.normal[1][triangle], c.normal[2][triangle]}};
    }

    /// Twice the area of a triangle in the picture, positive if its corners turn to the right
    /// there. Units: 1/65536 square pixel. Expects: triangle < count.
    std::int64_t double_area(std::size_t triangle) const {
        const auto way = [&](const std::vector<std::int32_t>& from,
                             const std::vector<std::int32_t>& to) {
            return std::int64_t{to[triangle]} - from[triangle];
        };
        const auto& [a, b, c] = corners;
        return way(a.x, b.x) * way(a.y, c.y) - way(a.y, b.y) * way(a.x, c.x);
    }

private:
    void grow(std::size_t least) {
        const std::size_t wanted = std::max(least, count + count / 2);
        const std::size_t size = (wanted + lanes - 1) / lanes * lanes;
        for (corner& c : corners) {
            c.x.resize(size);
            c.y.resize(size);
            c.inv_w.resize(size);
            for (auto& component : c.normal)
                component.resize(size);
        }
    }

    void set(corner& c, const l3d_micro_vertex& v) const {
        c.x[count] = v.x;
        c.y[count] = v.y;
        c.inv_w[count] = v.inv_w;
        for (std::size_t k = 0; k < c.normal.size(); ++k)
            c.normal[k][count] = v.normal[k];
    }
};

#endif
