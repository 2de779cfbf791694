// SPDX-License-Identifier: MIT
// cull_boxes: where boxes lie in the picture, many at a time.
#ifndef L3D_DICE_SCENE_CULLING_P_H
#define L3D_DICE_SCENE_CULLING_P_H

#include "geom/matrix.h"
#include "dice/box_lanes.h"
#include "dice/dice_view.h"

#include <array>
#include <cstddef>

namespace l3d_detail {

/// Where a row of boxes lies in the picture. Bounds hold for all that is in a box, and include
/// the view's error of the transform.
struct culled_boxes {
    using row = std::array<double, l3d_box_lanes::lanes>;

    row least, most; ///< of w
    row inside;      ///< below 0: wholly beyond one side of the view's margin

    /// Pixels from the picture's centre. Only where `least` is greater than the view's near, and
    /// only written if there is such a box that is inside.
    row left, right, top, bottom;
};

/// Looks at boxes [first, first + lanes); what is said of those from boxes.count() on means
/// nothing.
///
/// Shape:   to_image takes the boxes' space to (x, y, -, w) in the view's units.
/// Expects: first is a multiple of l3d_box_lanes::lanes.
/// Cost:    some 160 operations a box, two of them divisions.
void cull_boxes(const l3d_box_lanes& boxes, std::size_t first, const l3d_matrix<double>& to_image,
                const l3d_dice_view& view, culled_boxes& result);

} // namespace l3d_detail

#endif
