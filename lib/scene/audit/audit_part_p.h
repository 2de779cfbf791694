// SPDX-License-Identifier: MIT
// audit_part: a triangle, or a part of a patch with the triangle that it is near to.
#ifndef L3D_SCENE_AUDIT_AUDIT_PART_P_H
#define L3D_SCENE_AUDIT_AUDIT_PART_P_H

#include "geom/bezier_patch.h"
#include "geom/vector.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// A triangle in space that finds its distance from places. It keeps its corners in coordinates of
/// its own plane. It may have no area, or be a point.
class flat_triangle {
public:
    using vector = l3d_vector<double, 3>;

    explicit flat_triangle(const std::array<vector, 3>& corners);

    const std::array<vector, 3>& corners() const { return corners_; }
    /// The square of the distance from a place to the triangle.
    double square_distance(const vector& from) const;
    /// How far a place is beyond the line through the corners k and k + 1, seen from above.
    double beyond(std::size_t k, const vector& place) const;
    /// Whether all of another triangle is beyond one of the sides, or above or below the plane, by
    /// more than `by`.
    bool is_apart(const flat_triangle& other, double by) const;

private:
    std::array<vector, 3> corners_;
    vector first_, along_, across_, normal_; ///< the first end of the longest side; unit vectors
    double length_, x_, y_; ///< the length of that side; the place of the corner across it, y_ >= 0
};

/// A place of parameters: u and v.
using patch_place = std::array<double, 2>;

/// A bicubic patch, and bounds of its second derivatives.
struct bent_patch {
    using patch = l3d_bezier_patch<double, 3>;

    explicit bent_patch(const patch& p);

    /// Parameters whose place is likely to be the nearest one, by some steps of Newton's method.
    /// They may lie beyond 0 and 1, where the patch's polynomials continue it.
    patch_place place_near(const flat_triangle::vector& to, patch_place begin) const;

    /// Bounds of the lengths of the derivatives by u twice, by u and v, and by v twice, in a
    /// rectangle. Shape: the least u and v, the most.
    std::array<double, 3> bounds(const patch_place& least, const patch_place& most) const;

    patch of;

private:
    /// The largest lengths in each row and column of the derivatives' nets.
    std::array<double, 4> uu_{}, vv_{};
    std::array<double, 3> uv_by_v_{}, uv_by_u_{};
};

/// A part of a patch whose triangles are searched together. It is a rectangle of parameters that
/// trims leave whole, or the rest of a trimmed patch near its border. The rest has no rectangle of
/// its own.
struct patch_sheet {
    const bent_patch* patch;
    std::uint32_t index; ///< the number of the patch
    bool is_whole = false;
    patch_place least{0, 0}, most{1, 1}; ///< corners of the rectangle
};

/// A triangle of a mesh, or the part of a patch over a triangle of parameters.
///
/// Each place (u, v) of a part is within `off` of the place of the flat triangle that has the same
/// weights. So part and triangle are within `off` of each other. For a triangle of a mesh, off is
/// 0.
struct audit_part {
    using vector = l3d_vector<double, 3>;
    using place = patch_place;

    /// A triangle of a mesh.
    audit_part(const std::array<vector, 3>& corners, std::uint32_t number)
        : flat(corners), index(number) {}
    /// The part of a patch over a triangle. Lives: borrows the sheet and its patch.
    audit_part(const patch_sheet& of, const std::array<place, 3>& at_corners);

    /// The place of the part's middle, on the surface itself.
    vector middle() const;
    /// Cuts the part in two. The cut runs from the opposite corner to the side from corner k to the
    /// next, and meets it at `share`.
    std::array<audit_part, 2> cut(std::size_t k, double share) const;
    /// The side that contributes most to `off`. Expects: a part of a patch.
    std::size_t bent_side() const;
    /// The longest side, in space.
    std::size_t longest_side() const;
    /// The length of the longest side, in space.
    double size() const;

    flat_triangle flat;
    std::array<place, 3> at{};          ///< parameters of the corners
    const patch_sheet* sheet = nullptr; ///< none for a triangle of a mesh
    double off = 0;
    std::uint32_t index = 0; ///< the number of the triangle or patch

private:
    audit_part(const patch_sheet& of, const std::array<place, 3>& at_corners,
               const std::array<vector, 3>& corners);
    std::array<double, 3> weights() const;
};

} // namespace l3d_detail

#endif
