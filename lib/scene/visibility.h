// SPDX-License-Identifier: MIT
// l3d_left_out: patches that cannot be seen.
#ifndef L3D_SCENE_VISIBILITY_H
#define L3D_SCENE_VISIBILITY_H

#include "scene/counts.h"
#include "scene/dice_view.h"

/// Whether what is drawn of a surface that lies in `hull` covers no pixel's centre, even when
/// snapping moves it by half a sub-pixel.
bool l3d_holds_no_centre(const l3d_image_box& hull, const l3d_dice_view& view);

/// Whether a patch need not be diced, as its net shows that it covers no pixel's centre, and is not
/// to be kept; the reason is counted.
bool l3d_left_out(const l3d_image_patch& net, const l3d_dice_view& view, l3d_dice_counts& counts);

#endif
