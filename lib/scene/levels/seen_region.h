// SPDX-License-Identifier: MIT
// l3d_seen_region: the part of space that nearly equal views may show.
#ifndef L3D_SCENE_SEEN_REGION_H
#define L3D_SCENE_SEEN_REGION_H

#include "geom/matrix.h"
#include "geom/vector.h"
#include "scene/camera.h"
#include "tool_2d/pixels.h"

#include <array>
#include <optional>
#include <span>

/// The part of space that a picture shows, with some space around it. The region is a pyramid, or a
/// square column in a parallel projection. Cells of curved models outside of the region are not
/// needed.
///
/// The region depends on the view alone. The eye and the direction of sight are rounded to grids,
/// so the region stays the same while the camera moves a little.
class l3d_seen_region {
public:
    using vector = l3d_vector<double, 3>;

    /// Makes the region of a view. Returns nothing if the region's numbers would be too small or
    /// too large.
    ///
    /// Units:   `least_depth` is the least distance along the view axis of anything drawn. `reach`
    ///          is the largest distance of anything drawn from the target; it matters in a parallel
    ///          projection only.
    /// Expects: a valid camera, least_depth > 0.
    static std::optional<l3d_seen_region> of(const l3d_camera& camera, l3d_size size,
                                             double least_depth, double reach);

    /// The same region in the coordinates of a model with this placement.
    l3d_seen_region in(const l3d_matrix<double>& placement) const;

    /// Whether the hull of some points lies outside, beyond one of the four sides. Points are (x w,
    /// y w, z w, w) with positive weights w.
    bool hides(std::span<const l3d_vector<double, 4>> points) const;
    /// A lower bound of the depth of some points' hull, for every view with this region. Points are
    /// as in hides(). The depth is the distance along the view axis, or 1 in a parallel projection.
    /// The bound may be negative.
    double least_depth(std::span<const l3d_vector<double, 4>> points) const;
    /// Whether a box, from its least to its largest coordinates, lies inside the region.
    bool holds(const vector& least, const vector& most) const;

    friend bool operator==(const l3d_seen_region&, const l3d_seen_region&) = default;

private:
    /// A linear function of a place: the factors of x, y, z and 1.
    using sum = std::array<double, 4>;
    std::array<sum, 4> sides_{}; ///< a function for each side, which is not negative in the region
    /// A function that is nowhere larger than the depth of a place in the region.
    sum depth_{};
};

#endif
