// SPDX-License-Identifier: MIT
// The needs of steps of a patch, its blocks side by side in SIMD lanes.
#ifndef L3D_DICE_LANES_LANE_BOUNDS_P_H
#define L3D_DICE_LANES_LANE_BOUNDS_P_H

#include "scene/dice_view.h"
#include "dice/step_plan.h"

#include <cstdint>

namespace l3d_detail {

/// A net around a point (X, Y) of its own: x' = x - X w, y' = y - Y w. So x' / w is small where the
/// patch is small, wherever it lies in the picture.
///
/// Shape: [component][4 * row + column].
struct centred_net {
    alignas(64) double points[3][16];
    std::int32_t x = 0, y = 0; ///< X, Y: whole pixels from the picture's centre
    double largest_xy = 0;     ///< largest |x'|, |y'| of the points
};

/// The data of a patch for the choice of steps and the errors of its vertices.
struct lane_bounds {
    /// Whether the patch lies between the near and the far plane and within the guard band. If not,
    /// nothing else is valid.
    bool ordinary = false;
    l3d_image_box hull,
        seen; ///< boxes of the net and of its visible part, in pixels from the picture's centre
    double least_w = 0, most_w = 0;
    centred_net net;
    l3d_block_needs needs; ///< needs of one block if the net is small, else of sixteen
};

/// Finds the needs of a patch in lanes. The slow twin is l3d_needs_of. The needs here exceed its
/// needs by at most the rounding of floats, so they are bounds, too.
/// Cost: at most that of one block in scalar code.
void bounds_in_lanes(const l3d_image_patch& patch, const l3d_dice_view& view, lane_bounds& out);

} // namespace l3d_detail

#endif
