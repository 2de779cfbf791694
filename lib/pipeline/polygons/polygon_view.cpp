// SPDX-License-Identifier: MIT
// l3d_polygon_view: makes the one matrix from the model to the picture.
#include "pipeline/polygons/polygon_view.h"

#include "geom/transform.h"
#include "scene/camera_shading.h"

#include <algorithm>

namespace {

using vector = l3d_polygon_view::vector;

/// Turns a vector by the inverse of a rotation: its transpose.
vector turned_back(const l3d_matrix<double>& placement, const vector& v) {
    vector result{0.0, 0.0, 0.0};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            result[i] += placement(k, i) * v[k];
    return result;
}

} // namespace

l3d_matrix<double> l3d_euler_rotation(const l3d_vector<double, 3>& degrees,
                                      const l3d_vector<double, 3>& centre,
                                      l3d_rotation_order order) {
    const l3d_matrix<double> x = l3d_rotation_x<double>(degrees[0]);
    const l3d_matrix<double> y = l3d_rotation_y<double>(degrees[1]);
    const l3d_matrix<double> z = l3d_rotation_z<double>(degrees[2]);
    const auto turn = [&] {
        switch (order) {
        case l3d_rotation_order::xzy:
            return y * z * x;
        case l3d_rotation_order::yxz:
            return z * x * y;
        case l3d_rotation_order::yzx:
            return x * z * y;
        case l3d_rotation_order::zxy:
            return y * x * z;
        case l3d_rotation_order::zyx:
            return x * y * z;
        default:
            return z * y * x;
        }
    };
    return l3d_about({centre[0], centre[1], centre[2]}, turn());
}

l3d_polygon_view::l3d_polygon_view(const l3d_camera& camera, l3d_size size,
                                   const l3d_matrix<double>& placement, const l3d_picture_fit& fit)
    : camera_(camera), size_(size), fit_(fit), placement_(placement) {
    l3d_matrix<double> image = camera.image_matrix(size);
    const vector forward = camera.axes().forward;
    for (int i = 0; i < 3; ++i)
        image(2, i) = forward[i];
    image(2, 3) = -l3d_dot(forward, camera.eye);
    for (int i = 0; i < 4; ++i) {
        image(0, i) = image(0, i) * fit.stretch + image(3, i) * fit.shift;
        image(1, i) += image(3, i) * fit.shift;
    }
    matrix_ = image * placement;
    const vector moved{placement(0, 3), placement(1, 3), placement(2, 3)};
    eye_ = turned_back(placement, camera.eye - moved);
    forward_ = turned_back(placement, camera.axes().forward);
}

/// Tests the plane through `middle` with the normal `axis`, with a margin for all other planes of
/// the group. Let n and q be the differences of a normal and of a point from `axis` and `middle`.
/// Then N . (eye - p) = axis . (eye - middle) + n . (eye - middle) - N . q. The last two terms are
/// at most spread |eye - middle| + reach. Rounding adds less than 2^-50 of these lengths, and a
/// unit vector in floats may be 2^-22 too long; `added` is many times as much.
bool l3d_polygon_view::all_face(const vector& axis, double spread, const vector& middle,
                                double reach, bool front) const {
    constexpr double added = 1e-6;
    const double distance = is_parallel() ? 1 : l3d_length(eye_ - middle);
    const double moved = is_parallel() ? 0 : reach;
    const double most = (spread + added) * distance + moved * (1 + added);
    const double facing = faces_eye(axis, middle);
    return front ? facing > most : facing < -most;
}

l3d_view_depths l3d_polygon_view::depths(const vector& middle, double radius) const {
    if (!is_parallel())
        return {};
    const double step = -0.5 / (std::max(radius, 1e-300) * (1 + 1e-9));
    const double distance = (matrix_ * l3d_vector<double, 4>(middle, 1.0))[2];
    return {1.5 - step * distance, step};
}

l3d_shading l3d_polygon_view::shading(l3d_shade mode, const vector& light,
                                      const l3d_lighting& lighting) const {
    l3d_shading result = l3d_camera_shading(camera_, size_, mode, light, lighting);
    result.ray = result.ray_right = result.ray_down = {0, 0, 0};
    // In the stretched picture, a column is 1 / stretch as wide, and the middle lies `shift` to the
    // right and down.
    const double left = size_.width / 2.0 * (1 - 1 / fit_.stretch) - fit_.shift / fit_.stretch;
    for (std::size_t i = 0; i < 3; ++i) {
        result.look[i] +=
            static_cast<float>(left * result.look_right[i] - fit_.shift * result.look_down[i]);
        result.look_right[i] = static_cast<float>(result.look_right[i] / fit_.stretch);
        result.aside[i] +=
            static_cast<float>(left * result.aside_right[i] - fit_.shift * result.aside_down[i]);
        result.aside_right[i] = static_cast<float>(result.aside_right[i] / fit_.stretch);
    }
    return result;
}
