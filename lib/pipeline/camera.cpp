// SPDX-License-Identifier: MIT
// l3d_camera: axes, image matrix and orbiting.
#include "pipeline/camera.h"

#include <cmath>
#include <numbers>

namespace {

using vector = l3d_camera::vector;

/// `v` turned about an axis through the origin. Units: radians.
vector turned(const vector& v, const vector& axis, double angle) {
    const auto m = l3d_rotation<double>(axis, angle);
    const auto r = m * l3d_vector<double, 4>(v[0], v[1], v[2], 0.0);
    return {r[0], r[1], r[2]};
}

} // namespace

l3d_camera::frame l3d_camera::axes() const {
    const vector forward = l3d_normalized(target - eye);
    const vector right = l3d_normalized(l3d_cross(forward, up));
    return {right, l3d_cross(right, forward), forward};
}

bool l3d_camera::is_valid() const {
    const frame f = axes();
    bool finite = std::isfinite(fov) && std::isfinite(near) && std::isfinite(far);
    for (int i = 0; i < 3; ++i)
        finite = finite && std::isfinite(f.right[i]) && std::isfinite(f.up[i]) &&
                 std::isfinite(f.forward[i]) && std::isfinite(eye[i]);
    return finite && l3d_dot(f.right, f.right) > 0.5 && l3d_dot(f.forward, f.forward) > 0.5 &&
           fov > 0 && fov < 180 && near > 0 && near < far;
}

double l3d_camera::focal_length(l3d_size size) const {
    return size.height / 2.0 / std::tan(fov * std::numbers::pi / 360);
}

l3d_matrix<double> l3d_camera::image_matrix(l3d_size size) const {
    const frame f = axes();
    const double focal = focal_length(size);
    l3d_matrix<double> m;
    const auto set_row = [&](int row, const vector& direction, double scale) {
        for (int i = 0; i < 3; ++i)
            m(row, i) = direction[i] * scale;
        m(row, 3) = -l3d_dot(direction, eye) * scale;
    };
    set_row(0, f.right, focal);
    set_row(1, f.up, -focal);
    set_row(2, f.forward, 0);
    set_row(3, f.forward, 1);
    return m;
}

void l3d_camera::orbit(double around_up, double around_right) {
    const frame f = axes();
    vector arm = turned(eye - target, up, around_up);
    const vector right = turned(f.right, up, around_up);
    arm = turned(arm, right, around_right);
    // Stop short of looking straight along `up`, where the picture has no upright direction.
    const vector axis = l3d_cross(arm, up);
    if (l3d_length(axis) > 0.02 * l3d_length(arm) * l3d_length(up))
        eye = target + arm;
}

void l3d_camera::approach(double factor) {
    eye = target + (eye - target) * factor;
}
