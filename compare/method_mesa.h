// SPDX-License-Identifier: MIT
// The method `mesa`: a scene as triangles in GL's memory.
#ifndef L3D_COMPARE_METHOD_MESA_H
#define L3D_COMPARE_METHOD_MESA_H

#include "pipeline/surface_method.h"

#include <memory>

/// Makes a method that draws as a program does that leaves curves to GL. Each patch is n x n quads
/// of two triangles, in world coordinates and in GL's memory. A frame sends GL a few matrices, and
/// reads the picture back.
///
/// n is the number for which the error bound of triangles keeps the tolerance in this view. It is
/// rounded up to a multiple of 4, so that a turning model seldom needs new meshes. The time that
/// new meshes take counts as `dice`. GL's roundings are not known, so there is no bound. `overlay`s
/// and windows are the same as with every other method.
/// Errors:  l3d_error(no_backend) if there is no software GL, or it cannot draw; from draw() if GL
///          cannot hold a picture of that size.
/// Expects: models do not change while the method lives.
/// Units:   all shades of GL but flat and gouraud. These look like lambert, since every pixel has a
///          normal. The mode error is red.
std::unique_ptr<l3d_surface_method> l3d_create_method_mesa();

#endif
