// SPDX-License-Identifier: MIT
// l3d_lit_shade_bound: the error of colours under several lights or highlights.
#ifndef L3D_SCENE_LIT_SHADE_BOUND_H
#define L3D_SCENE_LIT_SHADE_BOUND_H

#include "geom/material.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <span>

/// The errors of geometry from which l3d_lit_shade_bound finds the error of a lit pixel's colour.
struct l3d_lit_errors {
    /// Length of the difference of the interpolated normal and the exact unit normal.
    double normal = 0;
    /// Angle between the direction from the drawn point to the eye and the direction from the exact
    /// point to the eye.
    /// Units: radians.
    double way = 0;
};

/// A bound of the error of any channel of a lit pixel, against the exact surface at the same
/// parameters. NUMERICS, section 24.
///
/// A highlight begins abruptly where a light rises above the surface. So the bound counts all of
/// the highlight of a light that may be behind the surface.
/// Units:   levels of 255, at most 255.
/// Expects: `look` of the shading is that of a picture of this size.
double l3d_lit_shade_bound(const l3d_shading& shading, std::span<const l3d_material> materials,
                           l3d_size size, const l3d_lit_errors& errors);

#endif
