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

double length(double x, double y) {
    return std::sqrt(x * x + y * y);
}

/// A triangle over steps h errs by at most h^2 / 8 (|Suu| + 2 |Suv| + |Svv|) in place. A colour
/// that is bilinear errs by at most h^2 / 4 of its twist.
double steps_for(const l3d_mesh_patch& patch) {
    const auto& p = patch.points;
    double along = 0, down = 0, twist = 0;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) {
            const auto second = [](const l3d_point_2d& a, const l3d_point_2d& b,
                                   const l3d_point_2d& d) {
                return length(a.x - 2 * b.x + d.x, a.y - 2 * b.y + d.y);
            };
            if (c < 2)
                along = std::max(along, second(p[r][c], p[r][c + 1], p[r][c + 2]));
            if (r < 2)
                down = std::max(down, second(p[r][c], p[r + 1][c], p[r + 2][c]));
            if (r < 3 && c < 3)
                twist = std::max(
                    twist, length(p[r][c].x - p[r + 1][c].x - p[r][c + 1].x + p[r + 1][c + 1].x,
                                  p[r][c].y - p[r + 1][c].y - p[r][c + 1].y + p[r + 1][c + 1].y));
        }
    double of_color = 0;
    for (const int shift : {0, 8, 16}) {
        const auto level = [&](std::size_t i) { return int(patch.colors[i] >> shift & 255); };
        of_color = std::max<double>(of_color, std::abs(level(0) - level(1) - level(2) + level(3)));
    }
    const double places = (6 * along + 2 * 9 * twist + 6 * down) / (8 * place_error);
    return std::sqrt(std::max(places, of_color / (4 * level_error)));
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
