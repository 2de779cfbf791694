// SPDX-License-Identifier: MIT
// l3d_lit_shade_bound: how far colours are off where several lights or highlights show.
#ifndef L3D_SCENE_LIT_SHADE_BOUND_H
#define L3D_SCENE_LIT_SHADE_BOUND_H

#include "geom/material.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <span>

/// The errors of what a lit pixel's colour is made of.
struct l3d_lit_errors {
    double normal = 0; ///< length between the interpolated normal and the exact unit normal
    double way = 0;    ///< angle between the ways to the eye, of what is drawn and of what is exact
};

/// A bound of how far any channel of a lit pixel is from that of the exact surface at the same
/// parameters. NUMERICS, section 24.
///
/// A highlight is as steep as its sharpness makes it, and it begins abruptly where a light sets. A
/// light that shines from behind what is seen may so add all of its highlight.
/// Units:   levels of 255, at most 255.
/// Expects: `look` of the shading is that of a picture of this size.
double l3d_lit_shade_bound(const l3d_shading& shading, std::span<const l3d_material> materials,
                           l3d_size size, const l3d_lit_errors& errors);

#endif
