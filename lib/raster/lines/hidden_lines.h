// SPDX-License-Identifier: MIT
// l3d_fix_facing: triangles as lines, where nothing in a depth buffer is in front of them.
#ifndef L3D_RASTER_LINES_HIDDEN_LINES_H
#define L3D_RASTER_LINES_HIDDEN_LINES_H

#include "raster/depth_buffer.h"
#include "raster/zsort/painter.h"
#include "tool_2d/pixels.h"

#include <span>

/// Clears the picture and draws the sides of triangles whose surface has been filled into a depth
/// buffer.
///
/// A line's pixel is up to a pixel away from where its depth is meant. Therefore the depth that
/// hides it is lessened by the rise of the triangle's own plane over a pixel in x and in y. A thing
/// nearer than that in front of a line does not hide it.
///
/// A plane seen nearly from its edge rises without limit. But no point of a triangle is nearer than
/// its nearest corner, so whatever is nearer than that corner hides the line.
///
/// Of the shading, lines have the background and the fog.
/// Expects: target and depth of equal size; the depth has been filled by the same triangles.
void l3d_fix_facing(l3d_pixels target, const l3d_depth_buffer& depth,
                    std::span<const l3d_painter_triangle> triangles, const l3d_shading& shading,
                    const l3d_line_look& look);

#endif
