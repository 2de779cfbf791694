// SPDX-License-Identifier: MIT
// One point of the exact surface, by repeated interpolation in long double.
#include "reference/exact.h"

#include <cmath>
#include <numbers>

namespace reference {
namespace {

using real = long double;
using column = std::array<real, 3>;

column mix(const column& a, const column& b, real t) {
    column result{};
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = (1 - t) * a[k] + t * b[k];
    return result;
}

struct curve_point {
    column value, derivative;
};

curve_point de_casteljau(std::array<column, 4> p, real t) {
    for (std::size_t left = 3; left > 1; --left)
        for (std::size_t i = 0; i < left; ++i)
            p[i] = mix(p[i], p[i + 1], t);
    curve_point result{mix(p[0], p[1], t), {}};
    for (std::size_t k = 0; k < 3; ++k)
        result.derivative[k] = 3 * (p[1][k] - p[0][k]);
    return result;
}

struct world_point {
    column value, by_u, by_v;
};

world_point evaluate_world(const patch& surface, real u, real v) {
    std::array<column, 4> values{}, slopes{};
    for (std::size_t row = 0; row < 4; ++row) {
        std::array<column, 4> points{};
        for (std::size_t i = 0; i < 4; ++i) {
            const vec3& p = surface.points[4 * row + i];
            points[i] = {p.x, p.y, p.z};
        }
        const curve_point at = de_casteljau(points, u);
        values[row] = at.value;
        slopes[row] = at.derivative;
    }
    const curve_point across = de_casteljau(values, v);
    return {across.value, de_casteljau(slopes, v).value, across.derivative};
}

column cross(const column& a, const column& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

real length(const column& a) {
    return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

column unit(const column& a) {
    const real size = length(a);
    return {a[0] / size, a[1] / size, a[2] / size};
}

/// Where an edge is collapsed the normal exists as a limit only: it is taken a little further
/// inside. 1e-6 of the way keeps 13 of the 19 digits of a long double.
vec3 normal_at(const patch& surface, real u, real v) {
    for (const real step : {0.0L, 1e-6L, 1e-3L}) {
        const world_point at =
            evaluate_world(surface, u + step * (0.5L - u), v + step * (0.5L - v));
        const column n = cross(at.by_u, at.by_v);
        const real scale = length(at.by_u) * length(at.by_v);
        if (length(n) > 1e-12L * scale && scale > 0) {
            const column result = unit(n);
            return {static_cast<double>(result[0]), static_cast<double>(result[1]),
                    static_cast<double>(result[2])};
        }
    }
    return {};
}

column difference(const vec3& a, const vec3& b) {
    return {real(a.x) - b.x, real(a.y) - b.y, real(a.z) - b.z};
}

void store(const column& from, real (&to)[3]) {
    for (std::size_t k = 0; k < 3; ++k)
        to[k] = from[k];
}

} // namespace

camera_frame::camera_frame(const camera& view, picture_size size) {
    const column axis = unit(difference(view.target, view.eye));
    const column side = unit(cross(axis, {view.up.x, view.up.y, view.up.z}));
    store({view.eye.x, view.eye.y, view.eye.z}, eye);
    store(axis, forward);
    store(side, right);
    store(cross(side, axis), up);
    const real half_angle = real(view.fov_degrees) / 360 * std::numbers::pi_v<real>;
    focal = real(size.height) / 2 / std::tan(half_angle);
    center_x = real(size.width) / 2;
    center_y = real(size.height) / 2;
    parallel = view.parallel;
    if (parallel)
        focal /= length(difference(view.target, view.eye));
}

homogeneous_point camera_frame::project(const long double (&world)[3]) const {
    real along_right = 0, along_up = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const real d = world[k] - eye[k];
        along_right += d * right[k];
        along_up += d * up[k];
    }
    const real w = parallel ? 1 : distance(world);
    return {center_x * w + focal * along_right, center_y * w - focal * along_up, w};
}

long double camera_frame::distance(const long double (&world)[3]) const {
    real w = 0;
    for (std::size_t k = 0; k < 3; ++k)
        w += (world[k] - eye[k]) * forward[k];
    return w;
}

vec3 camera_frame::unproject(double x, double y, double w) const {
    const real unit = parallel ? 1 : w;
    const real along_right = (x - center_x) / focal * unit;
    const real along_up = (center_y - y) / focal * unit;
    double result[3];
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = static_cast<double>(eye[k] + along_right * right[k] + along_up * up[k] +
                                        w * forward[k]);
    return {result[0], result[1], result[2]};
}

homogeneous_point exact_homogeneous(const patch& surface, const camera_frame& frame, real u,
                                    real v) {
    const column at = evaluate_world(surface, u, v).value;
    return frame.project({at[0], at[1], at[2]});
}

surface_point exact_point(const patch& surface, const camera_frame& frame, real u, real v) {
    const column at = evaluate_world(surface, u, v).value;
    const homogeneous_point h = frame.project({at[0], at[1], at[2]});
    const vec3 world{static_cast<double>(at[0]), static_cast<double>(at[1]),
                     static_cast<double>(at[2])};
    return {h.x / h.w, h.y / h.w, frame.distance({at[0], at[1], at[2]}), world,
            normal_at(surface, u, v)};
}

surface_point exact_point(const patch& surface, const camera& view, picture_size size, real u,
                          real v) {
    return exact_point(surface, camera_frame(view, size), u, v);
}

} // namespace reference
