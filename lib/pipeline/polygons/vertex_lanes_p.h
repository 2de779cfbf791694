// SPDX-License-Identifier: MIT
// vertex_lanes: places vertices in the picture, and chooses the triangles that may be seen there.
#ifndef L3D_PIPELINE_POLYGONS_VERTEX_LANES_P_H
#define L3D_PIPELINE_POLYGONS_VERTEX_LANES_P_H

#include "pipeline/polygons/polygon_model.h"
#include "pipeline/frame_report.h"
#include "pipeline/polygons/polygon_view.h"
#include "raster/surface_part.h"
#include "scene/dice_view.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// The vertices of a model, placed in the picture, each once.
///
/// Shape: a place is x, y (1/256 pixel), the bits of inv_w, and 0. inv_w is 0 if the vertex cannot
///        be drawn, since it lies behind the near plane or too far outside. A normal is three
///        numbers in world space and 0. So each place and each normal fills a vector of 16 bytes,
///        and four vectors at once are turned into vectors of their components.
struct placed_vertices {
    using place = std::array<std::int32_t, 4>;
    using normal = std::array<float, 4>;

    std::vector<place> places;
    /// A normal for each place; unused if corners do not have the vertices' normals.
    std::vector<normal> normals;
};

/// The values by which vertices are placed in the picture.
struct vertex_placing {
    const l3d_polygon_view& view;
    const l3d_dice_view& window;
    l3d_view_depths depths;
};

/// Places vertices from `begin` to before `end` in the picture, and turns their normals into world
/// space, unless `normals` is empty. Places and depths are those of l3d_canonical_vertex, bit for
/// bit, on every processor.
/// Expects: room in `to` for all vertices.
void place_vertices(const vertex_placing& how, std::span<const l3d_polygon_model::vector> vertices,
                    std::span<const l3d_polygon_model::direction> normals, std::size_t begin,
                    std::size_t end, placed_vertices& to);

/// The rules by which triangles of a model are chosen to be drawn.
struct triangle_choice {
    const l3d_polygon_model& model;
    const l3d_polygon_view& view;
    std::span<const placed_vertices::place> places;
    bool cull = true;     ///< whether triangles that are seen from behind are left out
    bool squares = false; ///< whether triangles that hold no pixel's centre are chosen, too
};

/// The triangles that were chosen, in the model's order.
struct chosen_triangles {
    /// The largest number of triangles. They take 2 KB, less than the nearest cache holds.
    static constexpr std::size_t room = 256;
    /// The sign bit of a float: marks a triangle that is seen from behind.
    static constexpr std::uint32_t from_behind = std::uint32_t{1} << 31;

    std::array<std::uint32_t, room> triangle;
    /// For each chosen triangle, the bit that reverses its normals: from_behind, or 0 if the
    /// triangle is seen from the front.
    std::array<std::uint32_t, room> sign;
    std::size_t count = 0;
    bool clipped = false; ///< whether the last chosen triangle has a corner that cannot be drawn
};

/// Lists the triangles from `begin` on that may be seen. It stops before `end`, when `to` has no
/// more room, or at a triangle that must be clipped. `counts` get the triangles left out, by
/// reason.
/// Returns: the first triangle that was not looked at.
std::size_t choose_triangles(const triangle_choice& of, std::size_t begin, std::size_t end,
                             chosen_triangles& to, l3d_polygon_counts& counts);

/// Adds the first `count` chosen triangles to `to`. If `with_normals` is true, it adds the
/// vertices' normals, reversed for triangles that are seen from behind.
void add_triangles(std::span<const l3d_model_triangle> triangles, const placed_vertices& vertices,
                   bool with_normals, const chosen_triangles& chosen, std::size_t count,
                   l3d_micro_triangles& to);

} // namespace l3d_detail

#endif
