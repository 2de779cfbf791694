// SPDX-License-Identifier: MIT
// l3d_camera: makes axes and the image matrix, and moves in orbits.
#include "scene/camera.h"

#include "base/formatted_p.h"
#include "geom/files/patch_file.h"
#include "geom/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace {

using vector = l3d_camera::vector;

/// A vector turned about an axis through the origin. Units: degrees.
vector turned(const vector& v, const vector& axis, double degrees) {
    return l3d_transformed(l3d_rotation<double>(axis, degrees), v);
}

/// The unit vector of a vector of any length. Squares of very long or short vectors would leave a
/// double's range.
vector unit_of_any_length(const vector& v) {
    const double longest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    return l3d_normalized(vector{v[0] / longest, v[1] / longest, v[2] / longest});
}

std::string text_of(double value) {
    return l3d_detail::formatted("%g", value);
}

std::string text_of(const vector& v) {
    return text_of(v[0]) + ',' + text_of(v[1]) + ',' + text_of(v[2]);
}

} // namespace

l3d_upright::l3d_upright(const vector& upwards) : up(unit_of_any_length(upwards)) {
    const bool z_is_up = std::abs(up[2]) > 0.9;
    const vector across = z_is_up ? vector{0.0, -1.0, 0.0} : vector{0.0, 0.0, 1.0};
    right = l3d_normalized(l3d_cross(up, across));
    front = l3d_cross(right, up);
}

l3d_camera::frame l3d_camera::axes() const {
    const vector forward = l3d_normalized(target - eye);
    const vector right = l3d_normalized(l3d_cross(forward, unit_of_any_length(up)));
    return {right, l3d_cross(right, forward), forward};
}

double l3d_camera::up_sine() const {
    return l3d_length(l3d_cross(l3d_normalized(target - eye), unit_of_any_length(up)));
}

std::string l3d_camera::complaint() const {
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(eye[i]) <= l3d_farthest_eye))
            return "camera: eye " + text_of(eye) + " is not within 1e15 of the origin";
        if (!(std::abs(target[i]) <= l3d_bpt_largest_coordinate))
            return "camera: target " + text_of(target) + " is not within 1e12 of the origin";
    }
    if (!(l3d_length(target - eye) >= l3d_least_distance))
        return "camera: target " + text_of(target) + " is within 1e-32 of the eye";
    if (!(up_sine() >= l3d_least_up_sine))
        return "camera: up " + text_of(up) + " is zero, not finite or along the line of sight";
    if (!(fov > 0 && fov < 180))
        return "camera: fov " + text_of(fov) + " is not between 0 and 180 degrees";
    if (!(near_z >= l3d_least_distance && near_z < far_z && std::isfinite(far_z)))
        return "camera: near " + text_of(near_z) + " and far " + text_of(far_z) +
               " are not 1e-32 <= near < far, finite";
    return "";
}

double l3d_camera::focal_length(l3d_size size) const {
    return size.height / 2.0 / std::tan(fov * std::numbers::pi / 360);
}

double l3d_camera::scale_at_target(l3d_size size) const {
    return focal_length(size) / l3d_length(target - eye);
}

l3d_matrix<double> l3d_camera::image_matrix(l3d_size size) const {
    const frame f = axes();
    const double focal = is_parallel() ? scale_at_target(size) : focal_length(size);
    l3d_matrix<double> m;
    const auto set_row = [&](int row, const vector& direction, double scale) {
        for (int i = 0; i < 3; ++i)
            m(row, i) = direction[i] * scale;
        m(row, 3) = -l3d_dot(direction, eye) * scale;
    };
    set_row(0, f.right, focal);
    set_row(1, f.up, -focal);
    set_row(2, f.forward, 0);
    set_row(3, f.forward, is_parallel() ? 0 : 1);
    if (is_parallel())
        m(3, 3) = 1;
    return m;
}

void l3d_camera::orbit(double around_up, double around_right) {
    const frame f = axes();
    vector arm = turned(eye - target, up, around_up);
    const vector right = turned(f.right, up, around_up);
    arm = turned(arm, right, around_right);
    // Stops short of looking straight along `up`, where the picture has no upright direction.
    const vector axis = l3d_cross(arm, up);
    if (l3d_length(axis) > 0.02 * l3d_length(arm) * l3d_length(up))
        eye = target + arm;
}

void l3d_camera::approach(double factor, const vector& place) {
    eye = place + (eye - place) * factor;
    target = place + (target - place) * factor;
}

double l3d_camera::depth_of(const vector& place) const {
    return l3d_dot(place - eye, l3d_normalized(target - eye));
}

vector l3d_camera::place_at(double x, double y, double depth, l3d_size size) const {
    const frame f = axes();
    const double pixel = is_parallel() ? 1 / scale_at_target(size) : depth / focal_length(size);
    return eye + f.forward * depth + f.right * ((x - size.width / 2.0) * pixel) -
           f.up * ((y - size.height / 2.0) * pixel);
}
