// SPDX-License-Identifier: MIT
// l3d_draw_seen_sides: draws triangles as lines, where nothing in a depth buffer hides them.
#ifndef L3D_RASTER_LINES_HIDDEN_LINES_H
#define L3D_RASTER_LINES_HIDDEN_LINES_H

#include "raster/depth_buffer.h"
#include "raster/zsort/painter.h"
#include "tool_2d/pixels.h"

#include <span>

/// Clears the picture and draws the sides of triangles whose surface has been filled into a depth
/// buffer.
///
/// A line's pixel is up to a pixel away from the place that its depth belongs to. Therefore a
/// surface hides the pixel only if it is nearer by the rise of the triangle's plane over a pixel in
/// x and in y.
///
/// A plane seen nearly from its edge rises without limit. But no point of a triangle is nearer than
/// its nearest corner, so all surfaces nearer than that corner hide the line.
///
/// Lines take the background and the fog from the shading.
/// Expects: target and depth of equal size; the depth has been filled by the same triangles.
void l3d_draw_seen_sides(l3d_pixels target, const l3d_depth_buffer& depth,
                         std::span<const l3d_painter_triangle> triangles,
                         const l3d_shading& shading, const l3d_line_look& look);

#endif
