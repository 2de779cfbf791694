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

/// Bernstein's polynomials.
template <class Number>
std::array<Number, l3d_bpt_largest_degree + 1> weights(int degree, double parameter) {
    const Number t(parameter), s = Number(1) - t;
    std::array<Number, l3d_bpt_largest_degree + 1> result{Number(1)};
    for (std::size_t level = 0; level < static_cast<std::size_t>(degree); ++level) {
        result[level + 1] = result[level] * t;
        for (std::size_t k = level; k > 0; --k)
            result[k] = result[k] * s + result[k - 1] * t;
        result[0] *= s;
    }
    return result;
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
    for (const reference::vec3& point : surface.points)
        append(point, 1, camera);
}

exact_surface::exact_surface(const l3d_patch_points& surface, const exact_camera& camera)
    : degree_u_(surface.degree_u), degree_v_(surface.degree_v) {
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const auto& [x, y, z] = surface.points[i];
        append({x, y, z}, surface.weights.empty() ? 1 : surface.weights[i], camera);
    }
}

void exact_surface::append(const reference::vec3& point, double weight,
                           const exact_camera& camera) {
    exact_camera::point seen = camera.project(point);
    std::array<long double, 3> rounded{};
    for (std::size_t k = 0; k < 3; ++k) {
        seen[k] *= digits(weight);
        rounded[k] = static_cast<long double>(seen[k]);
    }
    net_.push_back(seen);
    rounded_.push_back(rounded);
}

/// Homogeneous point of a net at (u, v).
template <class Number>
std::array<Number, 3> exact_surface::value(const std::vector<std::array<Number, 3>>& net, double u,
                                           double v) const {
    const auto a = weights<Number>(degree_u_, u), b = weights<Number>(degree_v_, v);
    std::array<Number, 3> sum{Number(0), Number(0), Number(0)};
    const auto columns = static_cast<std::size_t>(degree_u_ + 1);
    for (std::size_t i = 0; i < net.size(); ++i) {
        const Number weight = a[i % columns] * b[i / columns];
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += weight * net[i][k];
    }
    return sum;
}

double exact_surface::distance(double x, double y, double u, double v) const {
    const auto at = value(net_, u, v);
    if (at[2] <= 0)
        return std::numeric_limits<double>::infinity();
    const digits dx = at[0] / at[2] - digits(x), dy = at[1] / at[2] - digits(y);
    return static_cast<double>(sqrt(dx * dx + dy * dy));
}

double exact_surface::about(double x, double y, double u, double v) const {
    const auto at = value(rounded_, u, v);
    const long double dx = at[0] / at[2] - x, dy = at[1] / at[2] - y;
    return at[2] > 0 ? static_cast<double>(std::sqrt(dx * dx + dy * dy))
                     : std::numeric_limits<double>::infinity();
}

} // namespace stability
