// SPDX-License-Identifier: MIT
// l3d_surface_jet: point, normal and curvature of a patch, at parameters with an error.
#ifndef L3D_SCENE_PICKS_SURFACE_JET_H
#define L3D_SCENE_PICKS_SURFACE_JET_H

#include "geom/bezier_patch.h"
#include "scene/picks/interval.h"

#include <array>
#include <optional>

/// Bounds of point, normal and curvature of a patch, at all parameters within u_error and v_error
/// of (u, v).
///
/// Source: do Carmo, "Differential Geometry of Curves and Surfaces": K = (e g - f^2) / (E G - F^2)
///         and H = (e G - 2 f F + g E) / (2 (E G - F^2)).
struct l3d_surface_jet {
    using vector = std::array<l3d_interval, 3>;

    vector point;
    /// The unit normal along dS/du x dS/dv; nothing if that may vanish.
    std::optional<vector> normal;
    /// Bounds of the Gaussian and the mean curvature; meaningful if there is a normal.
    l3d_interval gaussian, mean;

    /// A point and the derivatives there, each with its error.
    struct derivatives {
        vector point, by_u, by_v, by_uu, by_uv, by_vv;
    };

    explicit l3d_surface_jet(const derivatives& of);

    /// `rounding` bounds the errors of the control points' coordinates.
    l3d_surface_jet(const l3d_bezier_patch<double, 3>& patch, double u, double v, double u_error,
                    double v_error, double rounding);
};

/// The middle of each coordinate's bounds.
l3d_vector<double, 3> l3d_middle(const l3d_surface_jet::vector& v);

/// A bound of the distance between the vector and its l3d_middle.
double l3d_radius(const l3d_surface_jet::vector& v);

#endif
