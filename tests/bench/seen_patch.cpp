// SPDX-License-Identifier: MIT
// seen_patch: exact image points, errors, and where a picture of a patch bends.
#include "bench/seen_patch.h"

#include <algorithm>
#include <cmath>

namespace {

/// Bending is counted this far around the window, so that pieces across its border are kept.
/// Units: pixels.
constexpr double margin = 32;

/// |(S / w)''| as chords see it: of (x, y) - X w with the point's own X held.
double second_seen(const l3d_image_point& h, const l3d_image_point& second,
                   const l3d_image_box& window) {
    const double x = h[0] / h[2], y = h[1] / h[2];
    const bool inside = x >= window.left - margin && x <= window.right + margin &&
                        y >= window.top - margin && y <= window.bottom + margin;
    return inside ? std::hypot(second[0] - x * second[2], second[1] - y * second[2]) / h[2] : 0;
}

/// Second derivative of a cubic.
l3d_image_point second_at(const l3d_image_curve& c, double t) {
    const auto& p = c.points;
    const l3d_image_point first = p[0] - p[1] * 2.0 + p[2], last = p[1] - p[2] * 2.0 + p[3];
    return (first * (1 - t) + last * t) * 6.0;
}

/// Integrates sqrt(second(t)); a little everywhere, so that knots never coincide.
template <class Second> seen_patch::growth integrated(Second second) {
    constexpr double least = 1e-3; // of sqrt(pixels): a chord of 1 then errs by 1e-6 / 8 pixels
    seen_patch::growth sum{};
    for (std::size_t k = 0; k < seen_patch::pieces; ++k) {
        const double middle = (static_cast<double>(k) + 0.5) / seen_patch::pieces;
        sum[k + 1] = sum[k] + (std::sqrt(second(middle)) + least) / seen_patch::pieces;
    }
    return sum;
}

bool beyond_one_side(const l3d_image_box& w, double least_x, double most_x, double least_y,
                     double most_y) {
    return most_x < w.left || least_x > w.right || most_y < w.top || least_y > w.bottom;
}

} // namespace

seen_world::seen_world(const l3d_camera& camera, l3d_size size)
    : matrix(camera.image_matrix(size)), window{-size.width / 2.0, -size.height / 2.0,
                                                size.width / 2.0, size.height / 2.0} {}

l3d_image_point seen_world::operator()(const l3d_vector<double, 3>& p) const {
    const l3d_vector<double, 4> h = matrix * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
    return {h[0], h[1], h[3]};
}

mesh_corner seen_world::corner(double u, double v, const l3d_vector<double, 3>& position) const {
    const l3d_image_point h = (*this)(position);
    return {u, v, position, h, h[0] / h[2], h[1] / h[2]};
}

seen_patch::seen_patch(const l3d_patch_model::patch& patch, const seen_world& world)
    : patch_(patch), world_(world) {
    for (std::size_t i = 0; i < net_.points.size(); ++i)
        net_.points[i] = world(patch.points[i]);
    transposed_ = net_.transposed();
    // Powers from control points, along u in each row, then along v.
    const auto powers = [](const std::array<l3d_image_point, 4>& b) {
        return std::array<l3d_image_point, 4>{b[0], (b[1] - b[0]) * 3.0,
                                              (b[0] - b[1] * 2.0 + b[2]) * 3.0,
                                              (b[1] - b[2]) * 3.0 + b[3] - b[0]};
    };
    std::array<std::array<l3d_image_point, 4>, 4> rows;
    for (std::size_t r = 0; r < 4; ++r)
        rows[r] = powers(net_.row(static_cast<int>(r)).points);
    for (std::size_t i = 0; i < 4; ++i)
        power_[i] = powers({rows[0][i], rows[1][i], rows[2][i], rows[3][i]});
}

l3d_image_point seen_patch::exact(double u, double v) const {
    l3d_image_point sum{0.0, 0.0, 0.0};
    for (std::size_t i = 4; i-- > 0;) {
        const auto& c = power_[i];
        sum = sum * u + (((c[3] * v + c[2]) * v + c[1]) * v + c[0]);
    }
    return sum;
}

mesh_corner seen_patch::corner(double u, double v) const {
    return world_.corner(u, v, patch_.evaluate(u, v));
}

double seen_patch::distance(double x, double y, const l3d_image_point& exact) const {
    return std::hypot(x - exact[0] / exact[2], y - exact[1] / exact[2]);
}

double seen_patch::point_error(const l3d_image_point& drawn, double u, double v) const {
    const double x = drawn[0] / drawn[2], y = drawn[1] / drawn[2];
    const l3d_image_box& w = world_.window;
    return x < w.left || x > w.right || y < w.top || y > w.bottom ? 0 : distance(x, y, exact(u, v));
}

double seen_patch::edge_error(const mesh_corner& a, const mesh_corner& b) const {
    if (beyond_one_side(world_.window, std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y),
                        std::max(a.y, b.y)))
        return 0;
    const l3d_image_point h = a.image + b.image;
    return distance(h[0] / h[2], h[1] / h[2], exact((a.u + b.u) / 2, (a.v + b.v) / 2));
}

double seen_patch::centre_error(const mesh_corner& a, const mesh_corner& b,
                                const mesh_corner& c) const {
    if (!visible(a, b, c))
        return 0;
    const l3d_image_point h = a.image + b.image + c.image;
    return distance(h[0] / h[2], h[1] / h[2], exact((a.u + b.u + c.u) / 3, (a.v + b.v + c.v) / 3));
}

double seen_patch::triangle_error(const mesh_corner& a, const mesh_corner& b,
                                  const mesh_corner& c) const {
    return std::max({edge_error(a, b), edge_error(b, c), edge_error(c, a), centre_error(a, b, c)});
}

bool seen_patch::visible(const mesh_corner& a, const mesh_corner& b, const mesh_corner& c) const {
    return !beyond_one_side(world_.window, std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}),
                            std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}));
}

seen_patch::growth seen_patch::growth_along_u() const {
    return integrated([this](double u) {
        constexpr int lines = 32;
        double most = 0;
        l3d_image_curve second; // the second derivative in u, as a curve in v
        for (int r = 0; r < 4; ++r)
            second.points[static_cast<std::size_t>(r)] = second_at(net_.row(r), u);
        const l3d_image_curve along = net_.curve_at_u(u);
        for (int k = 0; k <= lines; ++k) {
            const double v = static_cast<double>(k) / lines;
            most =
                std::max(most, second_seen(along.evaluate(v), second.evaluate(v), world_.window));
        }
        return most;
    });
}

seen_patch::growth seen_patch::growth_along_v() const {
    seen_patch other(*this);
    std::swap(other.net_, other.transposed_);
    return other.growth_along_u();
}

std::vector<double> knots(const seen_patch::growth& growth, int n) {
    std::vector<double> result{0};
    std::size_t k = 0;
    for (int i = 1; i < n; ++i) {
        const double wanted = growth.back() * i / n;
        while (growth[k + 1] < wanted)
            ++k;
        const double part = (wanted - growth[k]) / (growth[k + 1] - growth[k]);
        result.push_back((static_cast<double>(k) + part) / seen_patch::pieces);
    }
    result.push_back(1);
    return result;
}

seen_patch::growth growth_of(const l3d_bezier_curve<double, 3>& curve, const seen_world& world) {
    l3d_image_curve seen;
    for (std::size_t i = 0; i < 4; ++i)
        seen.points[i] = world(curve.points[i]);
    return integrated(
        [&](double t) { return second_seen(seen.evaluate(t), second_at(seen, t), world.window); });
}
