// SPDX-License-Identifier: MIT
// l3d_left_out: patches that cannot be seen.
#ifndef L3D_SCENE_VISIBILITY_H
#define L3D_SCENE_VISIBILITY_H

#include "scene/counts.h"
#include "scene/dice_view.h"

#include <cstdint>

/// Whether what is drawn of a surface that lies in `hull` covers no pixel's centre, even when
/// snapping moves it by half a sub-pixel.
bool l3d_holds_no_centre(const l3d_image_box& hull, const l3d_dice_view& view);

/// The count of what is left out for the same reason as something whose points are at those depths;
/// null if it may be seen. `is_outside` and `holds_no_centre` are asked only if depth leaves it
/// open.
template <class Outside, class Centreless>
std::int64_t* l3d_reason_to_leave_out(const l3d_depth_range& depth, const l3d_dice_view& view,
                                      const Outside& is_outside, const Centreless& holds_no_centre,
                                      l3d_dice_counts& counts) {
    if (!view.keep.outside) {
        if (depth.most <= view.near)
            return &counts.behind;
        if (depth.least >= view.far)
            return &counts.beyond;
        if (is_outside())
            return &counts.offscreen;
    }
    return !view.keep.centreless && holds_no_centre() ? &counts.subpixel : nullptr;
}

/// Whether a patch need not be diced, as its net shows that it covers no pixel's centre, and is not
/// to be kept; the reason is counted.
bool l3d_left_out(const l3d_image_patch& net, const l3d_dice_view& view, l3d_dice_counts& counts);

#endif
