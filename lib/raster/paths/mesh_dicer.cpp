// SPDX-License-Identifier: MIT
// mesh_dicer: how fine, and where the corners are.
#include "raster/paths/mesh_dicer_p.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace l3d_detail {

namespace {

/// How far a place may be from where the patch has the colour, in pixels; how far a colour may be
/// from the bilinear one, in levels.
constexpr double place_error = 1.0 / 16, level_error = 1.0 / 16;
/// A patch is never finer: then its triangles cover some 2^-5 pixels in pictures of 2^14.
constexpr int most_steps = 512;

/// The Bernstein polynomials at i / n; those at (n - i) / n are the same numbers backwards.
std::array<double, 4> weights(int i, int n) {
    const double t = static_cast<double>(i) / n, s = static_cast<double>(n - i) / n;
    return {s * s * s, 3 * (s * s * t), 3 * (t * t * s), t * t * t};
}

l3d_point_2d mixed(const std::array<l3d_point_2d, 4>& p, const std::array<double, 4>& w) {
    return {(p[0].x * w[0] + p[3].x * w[3]) + (p[1].x * w[1] + p[2].x * w[2]),
            (p[0].y * w[0] + p[3].y * w[3]) + (p[1].y * w[1] + p[2].y * w[2])};
}

/// Control points; or, of a second derivative, control vectors as a bicubic patch has them.
using net = std::array<std::array<l3d_point_2d, 4>, 4>;

l3d_point_2d sum(const l3d_point_2d& a, double of_b, const l3d_point_2d& b) {
    return {a.x + of_b * b.x, a.y + of_b * b.y};
}

/// The control vectors of a curve of lower degree as those of a cubic.
std::array<l3d_point_2d, 4> as_cubic(const l3d_point_2d& a, const l3d_point_2d& b) {
    const l3d_point_2d step{(b.x - a.x) / 3, (b.y - a.y) / 3};
    return {a, sum(a, 1, step), sum(a, 2, step), b};
}
std::array<l3d_point_2d, 4> as_cubic(const l3d_point_2d& a, const l3d_point_2d& b,
                                     const l3d_point_2d& c) {
    return {a, sum({a.x / 3, a.y / 3}, 2.0 / 3, b), sum({c.x / 3, c.y / 3}, 2.0 / 3, b), c};
}

l3d_point_2d bend(const l3d_point_2d& a, const l3d_point_2d& b, const l3d_point_2d& c) {
    return {6 * (a.x - 2 * b.x + c.x), 6 * (a.y - 2 * b.y + c.y)};
}

net turned(const net& p) {
    net result;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            result[r][c] = p[c][r];
    return result;
}

/// Suu, and of a turned net Svv, turned.
net along_rows(const net& p) {
    net result;
    for (std::size_t r = 0; r < 4; ++r)
        result[r] = as_cubic(bend(p[r][0], p[r][1], p[r][2]), bend(p[r][1], p[r][2], p[r][3]));
    return result;
}

/// Suv.
net twist_of(const net& p) {
    net columns; // of three rows; cubics along u
    for (std::size_t r = 0; r < 3; ++r) {
        const auto twist = [&](std::size_t c) {
            const auto part = [&](double l3d_point_2d::*x) {
                return 9 * (p[r][c].*x - p[r + 1][c].*x - p[r][c + 1].*x + p[r + 1][c + 1].*x);
            };
            return l3d_point_2d{part(&l3d_point_2d::x), part(&l3d_point_2d::y)};
        };
        columns[r] = as_cubic(twist(0), twist(1), twist(2));
    }
    net result;
    for (std::size_t c = 0; c < 4; ++c)
        result[c] = as_cubic(columns[0][c], columns[1][c], columns[2][c]);
    return turned(result);
}

/// No vector of the patch is longer.
double longest(const net& of) {
    double result = 0;
    for (const auto& row : of)
        for (const l3d_point_2d& v : row)
            result = std::max(result, std::sqrt(v.x * v.x + v.y * v.y));
    return result;
}

/// The largest x y a + y z b + z x c of all x + y + z = 1 that are not negative. If one number is
/// not below the sum of the others, it is in the middle of that one's side; else it is inside.
double largest_mix(double a, double b, double c) {
    const double most = std::max({a, b, c});
    if (2 * most >= a + b + c)
        return most / 4;
    a /= most; // lest products overflow
    b /= most;
    c /= most;
    return most * (a * b * c / (2 * (a * b + b * c + c * a) - a * a - b * b - c * c));
}

/// A linear triangle errs by at most the largest_mix of its sides' second derivatives, halved.
/// Those of a cell of h are h^2 times Suu, Svv and, for its diagonal, Suu + 2 Suv + Svv. A colour
/// that is bilinear errs by at most h^2 / 4 of its twist.
///
/// Source:  Waldron: The error in linear interpolation at the vertices of a simplex (SIAM J.
///          Numerical Analysis 35, 1998).
double steps_for(const l3d_mesh_patch& patch) {
    const net along = along_rows(patch.points), twist = twist_of(patch.points),
              down = turned(along_rows(turned(patch.points)));
    net diagonal;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            diagonal[r][c] = sum(sum(along[r][c], 1, down[r][c]), 2, twist[r][c]);
    double of_color = 0;
    for (const int shift : {0, 8, 16}) {
        const auto level = [&](std::size_t i) { return int(patch.colors[i] >> shift & 255); };
        of_color = std::max<double>(of_color, std::abs(level(0) - level(1) - level(2) + level(3)));
    }
    const double places = largest_mix(longest(along), longest(down), longest(diagonal)) / 2;
    return std::sqrt(std::max(places / place_error, of_color / (4 * level_error)));
}

} // namespace

bool is_finite(const l3d_mesh_patch& patch) {
    return std::ranges::all_of(patch.points, [](const auto& row) {
        return std::ranges::all_of(
            row, [](const l3d_point_2d& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
    });
}

void mesh_row::resize(std::size_t count) {
    size = count;
    for (std::vector<double>* of : {&x, &y, &color[0], &color[1], &color[2]})
        of->assign(count + room, 0);
}

mesh_dicer::mesh_dicer(std::span<const l3d_mesh_patch> patches) {
    double needed = 1;
    for (const l3d_mesh_patch& patch : patches)
        if (is_finite(patch))
            needed = std::max(needed, steps_for(patch));
    steps_ = static_cast<int>(std::ceil(std::min<double>(needed, most_steps)));
    for (int i = 0; i <= steps_; ++i)
        weights_.push_back(weights(i, steps_));
    above_.resize(weights_.size());
    below_.resize(weights_.size());
}

void mesh_dicer::set_row(const l3d_mesh_patch& patch, int row) {
    const double v = static_cast<double>(row) / steps_;
    const std::array<double, 4>& down = weights_[static_cast<std::size_t>(row)];
    std::array<l3d_point_2d, 4> curve;
    for (std::size_t c = 0; c < 4; ++c)
        curve[c] = mixed(
            {patch.points[0][c], patch.points[1][c], patch.points[2][c], patch.points[3][c]}, down);
    std::array<std::array<double, 3>, 2> ends;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t side = 0; side < 2; ++side) {
            const auto level = [&](std::size_t i) {
                return static_cast<double>(patch.colors[i] >> (16 - 8 * k) & 255);
            };
            ends[side][k] = level(side) * (1 - v) + level(side + 2) * v;
        }
    for (std::size_t i = 0; i < below_.size; ++i) {
        const double u = static_cast<double>(i) / steps_;
        const l3d_point_2d at = mixed(curve, weights_[i]);
        below_.x[i] = at.x;
        below_.y[i] = at.y;
        for (std::size_t k = 0; k < 3; ++k)
            below_.color[k][i] = ends[0][k] * (1 - u) + ends[1][k] * u;
    }
}

} // namespace l3d_detail
