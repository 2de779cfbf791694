// SPDX-License-Identifier: MIT
// l3d_left_out: tells which patches cannot be seen.
#ifndef L3D_SCENE_VISIBILITY_H
#define L3D_SCENE_VISIBILITY_H

#include "scene/counts.h"
#include "scene/dice_view.h"

#include <cstdint>

/// Whether a surface whose exact points are in `hull` covers no pixel's centre when it is drawn.
/// Snapping may move it by half a sub-pixel.
bool l3d_holds_no_centre(const l3d_image_box& hull, const l3d_dice_view& view);

/// Finds the reason why a thing at these depths is left out. Returns the counter for the reason, or
/// null if the thing may be seen. `is_outside` and `holds_no_centre` are called only if depth gives
/// no reason.
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

/// Whether a patch need not be diced, since its net proves that the patch is not seen. A patch that
/// a switch of view.keep asks for is always diced. The reason is counted in `counts`.
bool l3d_left_out(const l3d_image_net& net, const l3d_dice_view& view, l3d_dice_counts& counts);

#endif
