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

/// Rounds places to steps of 2^-52 of the larger side of their box, or a little more.
/// Expects: one place at least, all finite.
std::vector<flat_place> on_grid(std::span<const std::array<double, 2>> places);

/// A face projected along the axis that its normal is nearest to, with corners counterclockwise.
class flat_face {
public:
    using triangle = std::array<std::size_t, 3>; ///< indices in the list of the face's corners

    flat_face(const l3d_polygon_mesh& mesh, std::span<const std::uint32_t> face);

    /// Cuts the face into triangles, two fewer than its corners. If the polygon does not cross
    /// itself, they cover it once. Its corners and sides may touch, as where a path leads to the
    /// border of a hole and back. Crossing polygons become arbitrary triangles.
    ///
    /// Each step cuts off the first ear. At an ear, the border does not enter the triangle of the
    /// corner and its two neighbours.
    /// Cost:   linear for a convex face. Else n log n, and three questions to a corner_tree for
    ///         each corner: cutting one off changes the triangles of its neighbours alone.
    /// Source: Meisters: Polygons have ears (American Mathematical Monthly 82, 1975).
    std::vector<triangle> triangles() const;

private:
    bool is_convex() const;

    std::vector<flat_place> places_;
};

} // namespace l3d_detail

#endif
