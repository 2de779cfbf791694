// SPDX-License-Identifier: MIT
// l3d_drawn_pixels: finds the pixels that may show the contents of some boxes.
#ifndef L3D_SCENE_DRAWN_PIXELS_H
#define L3D_SCENE_DRAWN_PIXELS_H

#include "geom/matrix.h"
#include "scene/patch_scene.h"
#include "scene/dice_view.h"
#include "tool_2d/pixel_boxes.h"

#include <cstdint>
#include <limits>

/// Adds to `result` the pixels that patches in the boxes may cover when they are drawn. Room for
/// the snapping, balancing and errors of vertices is included. Adds the whole picture if a box
/// reaches the near plane.
///
/// Once the result has more than `enough` pixels, no more boxes are looked at.
/// Shape:   to_image takes the boxes' space to (x, y, -, w) in the view's units.
/// Cost:    that of l3d_detail::cull_boxes.
void l3d_drawn_pixels(const l3d_box_lanes& boxes, const l3d_matrix<double>& to_image,
                      const l3d_dice_view& view, l3d_pixel_boxes& result,
                      std::int64_t enough = std::numeric_limits<std::int64_t>::max());

#endif
