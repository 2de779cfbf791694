// SPDX-License-Identifier: MIT
// l3d_measured_place: a place of a surface with all that is measured there: normal and curvature.
#ifndef L3D_SCENE_MEASURED_PLACE_H
#define L3D_SCENE_MEASURED_PLACE_H

#include "base/public.h"
#include "geom/vector.h"
#include "scene/patch_scene.h"

#include <array>
#include <limits>
#include <string>

/// A place of a surface with its normal and its curvatures. Each value has an error: its largest
/// distance from the exact value, rounding included.
///
/// Units: those of the world; curvatures are 1 / radius.
struct L3D_PUBLIC l3d_measured_place {
    /// A place or a direction.
    using vector = l3d_vector<double, 3>;

    vector point{0.0, 0.0, 0.0};  ///< the place in the world
    double point_error = 0;       ///< the point's error
    vector normal{0.0, 0.0, 0.0}; ///< the unit normal, turned to the eye; zero if there is none
    double normal_error = 0;      ///< the length of the normal's difference from the exact one

    /// The principal curvatures, the larger one first. A curvature is positive where the surface
    /// bends towards the normal.
    std::array<double, 2> curvatures{};
    /// The error of both curvatures; infinite where the surface has no normal.
    double curvature_error = std::numeric_limits<double>::infinity();

    /// The radii of curvature with their error, for people: the smaller one first, and "flat" where
    /// the curvature may be 0. The text is "" where nothing is known.
    std::string radii() const;
};

/// Measures a surface at the patch and the parameters of a pick.
///
/// A curved model is measured on its exact pieces, not on the patches that approximate them. The
/// measured place has the pick's parameters, so it lies at most l3d_patch_model::surface_error()
/// beside the ray.
/// Expects: a pick of this scene, which has not been changed since.
/// Source:  the derivatives, as intervals; do Carmo, "Differential Geometry of Curves and
///          Surfaces": the curvatures are H +- sqrt(H^2 - K) with mean H and Gaussian K.
L3D_PUBLIC l3d_measured_place l3d_measured(const l3d_patch_scene& scene, const l3d_pick& pick);

#endif
