// SPDX-License-Identifier: MIT
// bounds_in_lanes: finds how many steps a patch needs, its blocks side by side in SIMD lanes.
#ifndef L3D_DICE_LANES_LANE_BOUNDS_P_H
#define L3D_DICE_LANES_LANE_BOUNDS_P_H

#include "scene/dice_view.h"
#include "dice/step_plan.h"

#include <cstdint>

namespace l3d_detail {

/// A net moved so that a point (X, Y) of the picture becomes its origin: x' = x - X w, y' = y - Y
/// w. So x' / w is no larger than the patch, wherever the patch lies in the picture. Rounding is in
/// proportion to the patch's size, too.
///
/// Shape: [component][4 * row + column].
struct centred_net {
    alignas(64) double points[3][16];
    std::int32_t x = 0, y = 0; ///< X and Y: whole pixels from the picture's centre
    double largest_xy = 0;     ///< largest |x'| or |y'| of the control points
};

/// The facts about a patch from which l3d_lane_dicer chooses steps and bounds errors of vertices.
struct lane_bounds {
    /// Whether the patch lies between the near and the far plane, within the guard band and on the
    /// kept side of a section. If not, nothing else is valid.
    bool ordinary = false;
    /// The boxes of the net and of its visible part, in pixels from the picture's centre.
    l3d_image_box hull, seen;
    double least_w = 0, most_w = 0;
    centred_net net;
    /// The needs of the net's one block or sixteen blocks (l3d_is_one_block).
    l3d_block_needs needs;
};

/// Finds the needs of a patch, with its blocks in lanes. The slow twin is l3d_needs_of. The needs
/// found here exceed the twin's needs by at most the rounding of floats, so they are bounds, too.
/// Cost: at most the cost of one block in scalar code.
void bounds_in_lanes(const l3d_image_patch& patch, const l3d_dice_view& view, lane_bounds& out);

} // namespace l3d_detail

#endif
