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

/// A triangle in space that finds its distance from places. For this it keeps its corners in
/// coordinates of its own plane. The triangle may have no area, or be a point.
class flat_triangle {
public:
    using vector = l3d_vector<double, 3>;

    explicit flat_triangle(const std::array<vector, 3>& corners);

    const std::array<vector, 3>& corners() const { return corners_; }
    /// The square of the distance from a place to the triangle.
    double square_distance(const vector& from) const;
    /// How far a place lies beyond the side from corner k to the next corner, measured across the
    /// side in the triangle's plane. The result is negative where the triangle lies.
    double beyond(std::size_t k, const vector& place) const;
    /// Whether all of another triangle is outside of one side of this triangle, or above or below
    /// its plane, by more than `by`.
    bool is_apart(const flat_triangle& other, double by) const;

private:
    std::array<vector, 3> corners_;
    vector first_; ///< where the longest side begins
    /// Unit vectors: along the longest side, across it in the triangle's plane, and the normal.
    vector along_, across_, normal_;
    double length_, x_, y_; ///< the longest side's length; the opposite corner's place, y_ >= 0
};

/// The parameters u and v of a place on a patch.
using patch_place = std::array<double, 2>;

/// A bicubic patch that bounds its second derivatives over rectangles of parameters, and finds the
/// place on the patch that is near to a given place.
struct bent_patch {
    using patch = l3d_bezier_patch<double, 3>;

    explicit bent_patch(const patch& p);

    /// Parameters of the patch's place that is likely to be nearest to `to`, by some steps of
    /// Newton's method from `begin`. Parameters may lie beyond 0 and 1, where polynomials continue
    /// the patch.
    patch_place place_near(const flat_triangle::vector& to, patch_place begin) const;

    /// Bounds of the lengths of second derivatives in the rectangle of parameters from `least` to
    /// `most`. Shape: by u twice, by u and v, by v twice.
    std::array<double, 3> bounds(const patch_place& least, const patch_place& most) const;

    patch of;

private:
    /// The largest lengths in each row or column of the control nets of the second derivatives.
    std::array<double, 4> uu_{}, vv_{};
    std::array<double, 3> uv_by_v_{}, uv_by_u_{};
};

/// A part of a patch whose triangles of parameters are searched together. The part is a rectangle
/// that trims leave whole, or the rest of a trimmed patch near its border. The rest has no
/// rectangle of its own.
struct patch_sheet {
    const bent_patch* patch;
    std::uint32_t index; ///< the number of the patch
    bool is_whole = false;
    patch_place least{0, 0}, most{1, 1}; ///< two opposite corners of the rectangle
};

/// The unit of an audit's search. It is a triangle of a mesh, or the part of a patch over a
/// triangle of parameters.
///
/// A place of the part and the place of the triangle `flat` with the same barycentric weights are
/// within `off` of each other. So each place of the part or of the triangle is within `off` of the
/// other shape. For a triangle of a mesh, `off` is 0.
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
    /// Cuts the part in two. The cut ends on the side from corner k to the next corner, at the
    /// share `share` of the side's length. It begins at the opposite corner.
    std::array<audit_part, 2> cut(std::size_t k, double share) const;
    /// The side that contributes most to `off`. Expects: a part of a patch.
    std::size_t bent_side() const;
    /// The longest side, in space.
    std::size_t longest_side() const;
    /// The length of the longest side, in space.
    double size() const;

    flat_triangle flat;
    std::array<place, 3> at{};          ///< parameters of the corners, for a part of a patch
    const patch_sheet* sheet = nullptr; ///< the sheet of the patch; null for a triangle of a mesh
    double off = 0;
    std::uint32_t index = 0; ///< the number of the triangle or patch

private:
    audit_part(const patch_sheet& of, const std::array<place, 3>& at_corners,
               const std::array<vector, 3>& corners);
    std::array<double, 3> weights() const;
};

} // namespace l3d_detail

#endif
