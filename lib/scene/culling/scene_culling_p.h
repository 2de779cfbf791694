// SPDX-License-Identifier: MIT
// cull_boxes: places boxes in the picture, many at a time.
#ifndef L3D_SCENE_SCENE_CULLING_P_H
#define L3D_SCENE_SCENE_CULLING_P_H

#include "geom/matrix.h"
#include "scene/patch_scene.h"
#include "scene/dice_view.h"

#include <array>
#include <cstddef>

namespace l3d_detail {

/// Terms of a sum of magnitudes. Rounding errors of places are in proportion to this sum
/// (l3d_patch_instance::reach). For a box, the sum is its l3d_slanted_box::reach, plus `columns`
/// times the largest coordinates in the box, plus `shift`.
struct placing_terms {
    l3d_vector<double, 3> columns{0.0, 0.0, 0.0};
    double shift = 0;
};

/// Places in the picture of a row of boxes, one box in each element. Bounds hold for all points in
/// a box, and include the error of the transform.
struct culled_boxes {
    using row = std::array<double, l3d_box_lanes::lanes>;

    row least, most; ///< bounds of the w of each box
    row inside;      ///< below 0 if the box is wholly beyond one side of the margin
    row share;       ///< share of the view's errors: l3d_dice_view::share_of
    row near;        ///< the w of the near plane for this share of the errors

    /// The boxes' extents in the picture, in pixels from its centre. Extents are valid where
    /// `least` is greater than `near`. If no box with valid extents is inside the margin, they are
    /// not written.
    row left, right, top, bottom;
};

/// The input of cull_boxes that all boxes share: the matrix, the view and the wanted part of the
/// picture.
/// Lives: borrows all.
struct box_placing {
    const l3d_matrix<double>& to_image; ///< from the boxes' space to (x, y, -, w) in view's units
    const placing_terms& terms;
    const l3d_dice_view& view;
    const l3d_image_box& margin; ///< l3d_dice_view::margin of the wanted part of the picture
};

/// Finds the places in the picture of the boxes from `first` to first + lanes - 1. Results beyond
/// the last box have no meaning.
///
/// Expects: first is a multiple of l3d_box_lanes::lanes.
/// Cost:    some 190 operations a box, three of them divisions.
void cull_boxes(const l3d_box_lanes& boxes, std::size_t first, const box_placing& placing,
                culled_boxes& result);

/// The box in the picture that holds all drawn points of the surface in box i. The exact surface is
/// inside box i of `boxes`. Drawn vertices may lie beside it: they are balanced and snapped, and
/// walking errs by at most l3d_dice_view::walk_allowance.
/// Units:   pixels from the picture's centre.
/// Expects: boxes.least[i] is greater than boxes.near[i], and the box not wholly outside.
l3d_image_box drawn_box_of(const culled_boxes& boxes, std::size_t i, const l3d_dice_view& view);

} // namespace l3d_detail

#endif
