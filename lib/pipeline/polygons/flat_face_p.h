// SPDX-License-Identifier: MIT
// flat_face: cuts a polygon in its plane into triangles.
#ifndef L3D_PIPELINE_POLYGONS_FLAT_FACE_P_H
#define L3D_PIPELINE_POLYGONS_FLAT_FACE_P_H

#include "geom/polygon_mesh.h"
#include "pipeline/polygons/corner_tree_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Rounds places to a grid, so that areas can be computed exactly. The grid's step is 2^-52 of the
/// larger side of the places' box, or a little more.
/// Expects: at least one place; all coordinates are finite.
std::vector<flat_place> on_grid(std::span<const std::array<double, 2>> places);

/// A face, projected to a coordinate plane to be cut into triangles. The projection goes along the
/// axis that the face's normal is nearest to. Its corners run counterclockwise.
class flat_face {
public:
    using triangle = std::array<std::size_t, 3>; ///< indices in the list of the face's corners

    flat_face(const l3d_polygon_mesh& mesh, std::span<const std::uint32_t> face);

    /// Cuts the face into triangles. There are two triangles fewer than the face has corners. If
    /// the face does not cross itself, the triangles cover it once. Corners and sides of the face
    /// may touch, as where a path leads to the border of a hole and back. Faces that cross
    /// themselves become arbitrary triangles.
    ///
    /// Each step cuts off the first ear: a corner for which the face's border does not enter the
    /// triangle of the corner and its two neighbours.
    /// Cost:   linear for a convex face. For any other face it is n log n, and three questions to a
    ///         corner_tree for each corner. Cutting a corner off changes only the triangles of its
    ///         two neighbours.
    /// Source: Meisters: Polygons have ears (American Mathematical Monthly 82, 1975).
    std::vector<triangle> triangles() const;

private:
    bool is_convex() const;

    std::vector<flat_place> places_;
};

} // namespace l3d_detail

#endif
