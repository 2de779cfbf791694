// SPDX-License-Identifier: MIT
// l3d_image_transform: scaling and error bound of the transform.
#include "scene/image_transform.h"

#include <algorithm>
#include <cmath>

namespace {

/// The largest power of two not above value. Expects: value > 0.
double power_below(double value) {
    return std::exp2(std::floor(std::log2(value)));
}

/// A bound that stays the same while the value changes a little: the value rounded up to 4 bits,
/// by a 16th of itself at most. What moves at the end of a scene would else change the errors that
/// all others are diced by, and with them, by a bit, their pictures.
double steady_bound(double value) {
    if (!(value > 0))
        return value;
    const double unit = power_below(value) / 16;
    return std::ceil(value / unit) * unit;
}

} // namespace

l3d_image_transform::l3d_image_transform(const l3d_camera& camera, l3d_size size,
                                         const l3d_patch_scene& scene)
    : size_(size), near_(camera.near), far_(camera.far) {
    const double focal = camera.focal_length(size);
    focal_ = focal;
    double farthest = 0; // bound of the distance of any control point from the eye
    for (int i = 0; i < 3; ++i) {
        farthest += std::max(std::abs(scene.least()[i] - camera.eye[i]),
                             std::abs(scene.most()[i] - camera.eye[i]));
    }
    farthest = steady_bound(farthest);
    depth_scale_ = power_below(std::min(0x1p8, 0x1p28 / focal) / std::max(farthest, 1e-30));
    matrix_ = camera.image_matrix(size);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix_(row, column) *= depth_scale_;

    // The matrix (axes, products) is good to some 16 ulps of |direction| (|p| + |eye|). With a
    // placement multiplied in it is good to 8 more; four products and three sums add at most 8. A
    // patch cut in 50 halvings is rounded at its own size first, not at that of its pieces, at 3
    // midpoints each.
    for (int i = 0; i < 3; ++i)
        eye_terms_ += std::abs(camera.eye[i]);
    terms_ = steady_bound(scene.reach() + eye_terms_);
    constexpr double roundings = (16 + 8 + 8 + 3 * 50) * 0x1p-53;
    error_w_ = roundings * terms_ * depth_scale_;
    // The axes to the right and down are turned by the rounding of the line of sight and of the
    // product with `up`, 4 ulps, over the sine between them. A point's distance from the eye is at
    // most the sum of its terms and the eye's, so that all errors are in proportion to these.
    constexpr double turning = 4 * 0x1p-53;
    error_xy_ = focal * (error_w_ + turning / camera.up_sine() * terms_ * depth_scale_);
}

l3d_dice_view l3d_image_transform::view(double tolerance) const {
    l3d_dice_view view;
    view.size = size_;
    view.far = far_ * depth_scale_;
    view.tolerance = tolerance;
    view.depth_scale = depth_scale_;
    view.focal = focal_;
    view.error_xy = error_xy_;
    view.error_w = error_w_;
    view.terms = terms_;
    view.eye_terms = eye_terms_;
    view.camera_near = near_ * depth_scale_;
    view.near = view.near_of(1);
    return view;
}
