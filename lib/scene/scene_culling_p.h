// SPDX-License-Identifier: MIT
// cull_boxes: where boxes lie in the picture, many at a time.
#ifndef L3D_SCENE_SCENE_CULLING_P_H
#define L3D_SCENE_SCENE_CULLING_P_H

#include "geom/matrix.h"
#include "scene/box_lanes.h"
#include "scene/dice_view.h"

#include <array>
#include <cstddef>

namespace l3d_detail {

/// The terms that the points in boxes are summed up from when these are placed. They are
/// l3d_slanted_box::reach, plus `columns` times the largest coordinates of each box, plus `shift`.
struct placing_terms {
    l3d_vector<double, 3> columns{0.0, 0.0, 0.0};
    double shift = 0;
};

/// Where a row of boxes lies in the picture. Bounds hold for all that is in a box, and include
/// the error of the transform for points of such terms.
struct culled_boxes {
    using row = std::array<double, l3d_box_lanes::lanes>;

    row least, most; ///< bounds of w
    row inside;      ///< below 0: wholly beyond one side of the margin
    row share;       ///< share of the view's errors: l3d_dice_view::share_of
    row near;        ///< the near plane for that share

    /// Pixels from the picture's centre. Only where `least` is greater than `near`, and
    /// only written if there is such a box that is inside.
    row left, right, top, bottom;
};

/// Looks at boxes [first, first + lanes); what is said of those from boxes.count() on means
/// nothing.
///
/// Shape:   to_image takes the boxes' space to (x, y, -, w) in the view's units; `margin` is
///          l3d_dice_view::margin of the part of the picture that matters.
/// Expects: first is a multiple of l3d_box_lanes::lanes.
/// Cost:    some 190 operations a box, three of them divisions.
void cull_boxes(const l3d_box_lanes& boxes, std::size_t first, const l3d_matrix<double>& to_image,
                const placing_terms& terms, const l3d_dice_view& view, const l3d_image_box& margin,
                culled_boxes& result);

/// Where what is drawn of box i may be. The box holds the exact surface, whatever the transform's
/// error. A vertex is off that surface by its balance and by snapping. It is also off by the error
/// of its own net, at most l3d_dice_view::walk_allowance (or is evaluated).
/// Units:   pixels from the picture's centre.
/// Expects: boxes.least[i] is greater than boxes.near[i], and the box not wholly outside.
l3d_image_box drawn_box_of(const culled_boxes& boxes, std::size_t i, const l3d_dice_view& view);

} // namespace l3d_detail

#endif
