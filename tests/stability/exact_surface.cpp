// SPDX-License-Identifier: MIT
// Projection and evaluation by their definitions.
#include "exact_surface.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <cstddef>
#include <limits>

namespace stability {
namespace {

using point = exact_camera::point;

point point_of(const reference::vec3& v) {
    return {digits(v.x), digits(v.y), digits(v.z)};
}

digits dot(const point& a, const point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

point cross(const point& a, const point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

point unit(const point& a) {
    const digits length = sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

/// Bernstein's cubics.
template <class Number> std::array<Number, 4> weights(double parameter) {
    const Number t(parameter), s = Number(1) - t;
    return {s * s * s, Number(3) * s * s * t, Number(3) * s * t * t, t * t * t};
}

/// Homogeneous point of a net at (u, v).
template <class Number, class Net> std::array<Number, 3> value(const Net& net, double u, double v) {
    const auto a = weights<Number>(u), b = weights<Number>(v);
    std::array<Number, 3> sum{Number(0), Number(0), Number(0)};
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            const Number weight = a[column] * b[row];
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += weight * net[4 * row + column][k];
        }
    return sum;
}

} // namespace

exact_camera::exact_camera(const reference::camera& view, reference::picture_size size)
    : eye_(point_of(view.eye)), centre_x_(digits(size.width) / 2),
      centre_y_(digits(size.height) / 2) {
    point forward = point_of(view.target);
    for (std::size_t k = 0; k < 3; ++k)
        forward[k] -= eye_[k];
    forward = unit(forward);
    const point right = unit(cross(forward, point_of(view.up)));
    axes_ = {right, cross(forward, right), forward};
    const digits half_angle = digits(view.fov_degrees) * boost::math::constants::pi<digits>() / 360;
    focal_ = centre_y_ / tan(half_angle);
    is_parallel_ = view.parallel;
    if (is_parallel_) { // a unit has as many pixels everywhere as at the target
        point arm = point_of(view.target);
        for (std::size_t k = 0; k < 3; ++k)
            arm[k] -= eye_[k];
        focal_ /= sqrt(dot(arm, arm));
    }
}

exact_camera::point exact_camera::project(const reference::vec3& world) const {
    point from_eye = point_of(world);
    for (std::size_t k = 0; k < 3; ++k)
        from_eye[k] -= eye_[k];
    const digits w = is_parallel_ ? digits(1) : dot(axes_[2], from_eye);
    return {focal_ * dot(axes_[0], from_eye) + centre_x_ * w,
            focal_ * dot(axes_[1], from_eye) + centre_y_ * w, w};
}

exact_surface::exact_surface(const reference::patch& surface, const exact_camera& camera) {
    for (std::size_t i = 0; i < 16; ++i) {
        net_[i] = camera.project(surface.points[i]);
        for (std::size_t k = 0; k < 3; ++k)
            rounded_[i][k] = static_cast<long double>(net_[i][k]);
    }
}

double exact_surface::distance(double x, double y, double u, double v) const {
    const auto at = value<digits>(net_, u, v);
    if (at[2] <= 0)
        return std::numeric_limits<double>::infinity();
    const digits dx = at[0] / at[2] - digits(x), dy = at[1] / at[2] - digits(y);
    return static_cast<double>(sqrt(dx * dx + dy * dy));
}

double exact_surface::about(double x, double y, double u, double v) const {
    const auto at = value<long double>(rounded_, u, v);
    const long double dx = at[0] / at[2] - x, dy = at[1] / at[2] - y;
    return at[2] > 0 ? static_cast<double>(std::sqrt(dx * dx + dy * dy))
                     : std::numeric_limits<double>::infinity();
}

} // namespace stability
