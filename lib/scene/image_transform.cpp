// SPDX-License-Identifier: MIT
// l3d_image_transform: scales the camera's matrix, and bounds its error.
#include "scene/image_transform.h"

#include <algorithm>
#include <cmath>

namespace {

/// The largest power of two not above value. Expects: value > 0.
double power_below(double value) {
    return std::exp2(std::floor(std::log2(value)));
}

/// A bound that mostly stays the same while the value changes a little. It is the value rounded up
/// to 4 bits, by at most a 16th. Otherwise an object that moves at the end of a scene would change
/// the errors by which all other objects are diced. Then the pictures of the other objects would
/// change by a bit.
double steady_bound(double value) {
    if (!(value > 0))
        return value;
    const double unit = power_below(value) / 16;
    return std::ceil(value / unit) * unit;
}

/// Bound of the rounding of a point's coordinates. The matrix (axes, products) is good to some 16
/// ulps of |direction| (|p| + |eye|). Multiplying it with a placement adds 8; four products and
/// three sums add at most 8. Each of up to 50 halvings of a patch adds 3 midpoints, which are
/// rounded in proportion to the patch, not to its pieces.
constexpr double roundings = (16 + 8 + 8 + 3 * 50) * 0x1p-53;

/// Rounding turns the picture's axes to the right and down by at most this angle, divided by the
/// sine of the angle between the line of sight and `up`. The angle is 4 ulps, for the line of sight
/// and its product with `up`.
constexpr double turning = 4 * 0x1p-53;

/// Bound of the distance between a place and any control point. It is the sum of the largest
/// distances along the axes.
double farthest_from(const l3d_camera::vector& place, const l3d_patch_scene& scene) {
    double result = 0;
    for (int i = 0; i < 3; ++i)
        result +=
            std::max(std::abs(scene.least()[i] - place[i]), std::abs(scene.most()[i] - place[i]));
    return steady_bound(result);
}

} // namespace

l3d_image_transform::l3d_image_transform(const l3d_camera& camera, l3d_size size,
                                         const l3d_patch_scene& scene)
    : size_(size), near_(camera.near_z), far_(camera.far_z) {
    for (int i = 0; i < 3; ++i)
        eye_terms_ += std::abs(camera.eye[i]);
    terms_ = steady_bound(scene.reach() + eye_terms_);
    if (camera.is_parallel()) {
        set_parallel(camera, scene);
        return;
    }
    const double focal = camera.focal_length(size);
    focal_ = focal;
    const double farthest = farthest_from(camera.eye, scene);
    depth_scale_ = power_below(std::min(0x1p8, 0x1p28 / focal) / std::max(farthest, 1e-30));
    matrix_ = camera.image_matrix(size);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix_(row, column) *= depth_scale_;

    error_w_ = roundings * terms_ * depth_scale_;
    // A point's distance from the eye is at most the sum of the point's terms and of the eye's. So
    // all errors are proportional to that sum.
    error_xy_ = focal * (error_w_ + turning / camera.up_sine() * terms_ * depth_scale_);
}

/// Sets the transform for a parallel projection. The transform shows the scene in perspective, from
/// a far eye. The eye's distance is 1 / l3d_parallel_part to 2 / l3d_parallel_part times half of
/// the scene's depth. x and y are those of the parallel projection, exactly.
void l3d_image_transform::set_parallel(const l3d_camera& camera, const l3d_patch_scene& scene) {
    const l3d_camera::frame axes = camera.axes();
    const double scale = camera.scale_at_target(size_);
    double depth = 0; // bound of the distance of any control point from the target's plane
    for (int i = 0; i < 3; ++i)
        depth += std::abs(axes.forward[i]) * std::max(std::abs(scene.least()[i] - camera.target[i]),
                                                      std::abs(scene.most()[i] - camera.target[i]));
    const double distance = 2 * power_below(std::max(depth, 1e-30)) / l3d_parallel_part;
    const double farthest = std::max(farthest_from(camera.eye, scene), 1e-30);
    w_middle_ = power_below(std::min(0x1p8, 0x1p28 / (scale * farthest)));
    depth_scale_ = w_middle_ / distance;
    focal_ = scale * distance;
    const auto set_row = [&](int row, const l3d_camera::vector& direction, double by,
                             const l3d_camera::vector& from, double more) {
        for (int i = 0; i < 3; ++i)
            matrix_(row, i) = direction[i] * by;
        matrix_(row, 3) = more - l3d_dot(direction, from) * by;
    };
    set_row(0, axes.right, scale * w_middle_, camera.eye, 0);
    set_row(1, axes.up, -scale * w_middle_, camera.eye, 0);
    set_row(2, axes.forward, 0, camera.eye, 0);
    set_row(3, axes.forward, depth_scale_, camera.target, w_middle_);
    to_target_ = l3d_length(camera.target - camera.eye);
    near_ = w_middle_ / 2 / depth_scale_; // near and far cut nothing
    far_ = 2 * w_middle_ / depth_scale_;

    // w is a sum of scaled terms and of w_middle.
    for (int i = 0; i < 3; ++i)
        terms_ = std::max(terms_, scene.reach() + eye_terms_ + 2 * std::abs(camera.target[i]));
    error_w_ = roundings * (terms_ * depth_scale_ + w_middle_);
    // A place is drawn at x / w instead of x / w_middle, in the window or a pixel beside it.
    const double seen = std::hypot(size_.width / 2.0 + 2, size_.height / 2.0 + 2);
    error_xy_ = w_middle_ * (scale * terms_ * (roundings + turning / camera.up_sine()) +
                             seen * l3d_parallel_part);
    terms_ = 0; // every patch has these errors in full
}

void l3d_image_transform::set_depths(l3d_shading& shading) const {
    if (w_middle_ == 0)
        return;
    shading.depth_step = view(0).depth_slope() * depth_scale_;
    shading.depth_base = l3d_dice_view::middle_depth - shading.depth_step * to_target_;
}

/// For a place p of the world, let h = A p + t be the transformed point. Then the distance n.p + d
/// is (A^-T n).h + (d - (A^-T n).t). The columns of A^-T are cross products of rows of A over the
/// determinant of A.
l3d_image_section l3d_image_transform::section(const l3d_plane<double>& plane) const {
    using vector = l3d_vector<double, 3>;
    const auto row = [&](int i) { return vector{matrix_(i, 0), matrix_(i, 1), matrix_(i, 2)}; };
    const vector x = row(0), y = row(1), w = row(3);
    const double determinant = l3d_dot(x, l3d_cross(y, w));
    l3d_image_section result;
    result.normal = {l3d_dot(plane.normal, l3d_cross(y, w)) / determinant,
                     l3d_dot(plane.normal, l3d_cross(w, x)) / determinant,
                     l3d_dot(plane.normal, l3d_cross(x, y)) / determinant};
    result.d = plane.d - l3d_dot(result.normal, {matrix_(0, 3), matrix_(1, 3), matrix_(3, 3)});
    return result;
}

l3d_dice_view l3d_image_transform::view(double tolerance) const {
    l3d_dice_view view;
    view.size = size_;
    view.far = far_ * depth_scale_;
    view.tolerance = tolerance;
    view.depth_scale = depth_scale_;
    view.w_middle = w_middle_;
    view.focal = focal_;
    view.error_xy = error_xy_;
    view.error_w = error_w_;
    view.terms = terms_;
    view.eye_terms = eye_terms_;
    view.camera_near = near_ * depth_scale_;
    view.near = view.near_of(1);
    return view;
}
