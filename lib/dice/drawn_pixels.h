// SPDX-License-Identifier: MIT
// l3d_add_drawn_pixels: which pixels may show what is in a box.
#ifndef L3D_DICE_DRAWN_PIXELS_H
#define L3D_DICE_DRAWN_PIXELS_H

#include "geom/matrix.h"
#include "dice/box_lanes.h"
#include "dice/dice_view.h"
#include "tool_2d/pixels.h"

#include <vector>

/// Adds, for each box that may be seen, the pixels that may be covered by what is drawn of patches
/// in it: wherever vertices are snapped, balanced or off. All of the picture for a box that reaches
/// the near plane.
///
/// Shape:   to_image takes the boxes' space to (x, y, -, w) in the view's units.
/// Cost:    l3d_detail::cull_boxes.
void l3d_add_drawn_pixels(const l3d_box_lanes& boxes, const l3d_matrix<double>& to_image,
                          const l3d_dice_view& view, std::vector<l3d_pixel_box>& result);

#endif
