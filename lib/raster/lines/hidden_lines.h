// SPDX-License-Identifier: MIT
// l3d_draw_seen_sides: draws triangles as lines, where nothing in a depth buffer hides them.
#ifndef L3D_RASTER_LINES_HIDDEN_LINES_H
#define L3D_RASTER_LINES_HIDDEN_LINES_H

#include "raster/depth_buffer.h"
#include "raster/zsort/painter.h"
#include "tool_2d/pixels.h"

#include <span>

/// Clears the picture to the background, and draws the visible sides of triangles.
///
/// A pixel of a line is up to a pixel away from the place to which its depth belongs. Therefore a
/// surface hides the pixel only if it is nearer by more than a margin. The margin is the rise of
/// the triangle's plane over a pixel in x and in y.
///
/// The plane of a triangle that is seen nearly edge-on rises without limit. But no point of the
/// triangle is nearer than its nearest corner. So surfaces nearer than this corner hide the line in
/// any case.
///
/// The background and the lines' fog are those of the shading.
/// Expects: target and depth of equal size; the depth has been filled by the same triangles.
void l3d_draw_seen_sides(l3d_pixels target, const l3d_depth_buffer& depth,
                         std::span<const l3d_painter_triangle> triangles,
                         const l3d_shading& shading, const l3d_line_look& look);

#endif
