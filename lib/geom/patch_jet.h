// SPDX-License-Identifier: MIT
// l3d_patch_jet: a patch's derivatives up to the second order, and the curvatures they give.
#ifndef L3D_GEOM_PATCH_JET_H
#define L3D_GEOM_PATCH_JET_H

#include "geom/bezier_patch.h"

#include <optional>

/// A point of a patch and its first derivatives, which give the patch's normal there.
struct l3d_patch_place {
    using vector = l3d_vector<double, 3>;
    vector point, along_u, along_v;
};

/// A point of a patch, with its first and second derivatives, which give the patch's curvature
/// there.
struct l3d_patch_jet : l3d_patch_place {
    vector along_uu, along_uv, along_vv;
};

/// The normal and the curvature of a patch at a place where it has a normal.
struct l3d_patch_bend {
    using vector = l3d_vector<double, 3>;
    vector normal;             ///< the unit vector along dS/du x dS/dv
    vector normal_u, normal_v; ///< derivatives of the normal by u and by v
    double gaussian = 0;       ///< Gaussian curvature
    double mean = 0; ///< mean curvature, positive where the patch bends towards the normal
};

/// A patch's point and first derivatives. Expects: u and v from 0 to 1. Cost: some 50 ns.
l3d_patch_place l3d_place_of(const l3d_bezier_patch<double, 3>& patch, double u, double v);

/// A patch's point and derivatives up to the second order, rounded to double. l3d_surface_jet is
/// slower, and bounds the errors by intervals.
l3d_patch_jet l3d_jet_of(const l3d_bezier_patch<double, 3>& patch, double u, double v);

/// Normal and curvature of a patch from its derivatives. Nothing where dS/du and dS/dv are zero, or
/// parallel to within rounding.
/// Source: do Carmo, "Differential Geometry of Curves and Surfaces".
std::optional<l3d_patch_bend> l3d_bend_of(const l3d_patch_jet& jet);

#endif
