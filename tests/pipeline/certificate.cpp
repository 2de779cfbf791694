// SPDX-License-Identifier: MIT
// Sampling of drawn quads and triangles.
#include "certificate.h"

#include <algorithm>
#include <cmath>

namespace pipeline_tests {
namespace {

/// Corners, middles of the sides, the centre and two points of no symmetry.
constexpr std::array<std::array<double, 2>, 11> quad_samples{{{0, 0},
                                                              {1, 0},
                                                              {1, 1},
                                                              {0, 1},
                                                              {0.5, 0},
                                                              {1, 0.5},
                                                              {0.5, 1},
                                                              {0, 0.5},
                                                              {0.5, 0.5},
                                                              {0.27, 0.31},
                                                              {0.64, 0.81}}};
constexpr std::array<std::array<double, 3>, 8> triangle_samples{{{1, 0, 0},
                                                                 {0, 1, 0},
                                                                 {0, 0, 1},
                                                                 {0.5, 0.5, 0},
                                                                 {0, 0.5, 0.5},
                                                                 {0.5, 0, 0.5},
                                                                 {0.25, 0.25, 0.5},
                                                                 {0.2, 0.5, 0.3}}};

std::array<double, 4> bernstein(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

double turn(const auto& a, const auto& b, const auto& c) {
    return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

} // namespace

reference::hpoint value_of(const reference::net& net, double u, double v) {
    const auto a = bernstein(u), b = bernstein(v);
    reference::hpoint result;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) {
            const reference::hpoint& p = net.points[4 * r + c];
            const double weight = a[c] * b[r];
            result.x += weight * p.x;
            result.y += weight * p.y;
            result.w += weight * p.w;
        }
    return result;
}

certificate::corner certificate::corner_of(const l3d_micro_vertex& vertex, double u,
                                           double v) const {
    return {vertex.x / double{l3d_subpixel_one}, vertex.y / double{l3d_subpixel_one},
            1 / static_cast<double>(vertex.inv_w), u, v};
}

bool certificate::may_be_seen(std::span<const corner> corners) const {
    const auto [left, right] = std::minmax_element(corners.begin(), corners.end(),
                                                   [](auto& a, auto& b) { return a.x < b.x; });
    const auto [top, bottom] = std::minmax_element(corners.begin(), corners.end(),
                                                   [](auto& a, auto& b) { return a.y < b.y; });
    return left->x <= size_.width && right->x >= 0 && top->y <= size_.height && bottom->y >= 0;
}

void certificate::sample(std::span<const corner> corners, std::span<const double> weights) {
    corner at{0, 0, 0, 0, 0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        at.x += weights[i] * corners[i].w * corners[i].x;
        at.y += weights[i] * corners[i].w * corners[i].y;
        at.w += weights[i] * corners[i].w;
        at.u += weights[i] * corners[i].u;
        at.v += weights[i] * corners[i].v;
    }
    at.x /= at.w;
    at.y /= at.w;
    if (at.x < 0 || at.x > size_.width || at.y < 0 || at.y > size_.height)
        return;
    const reference::hpoint exact = value_of(net_, at.u, at.v);
    const double measured = std::hypot(exact.x / exact.w - at.x, exact.y / exact.w - at.y);
    ++samples;
    sum += measured;
    largest = std::max(largest, measured);
    // !(<=), so that a distance which is no number is a violation too.
    const bool kept = measured <= bound_ && exact.w > 0;
    violations += !kept;
    const double ratio = kept ? measured / bound_ : std::max(1.0, measured / bound_);
    if (ratio > worst_ratio || (!kept && !(worst_ratio >= 1))) {
        worst_ratio = ratio;
        worst_u = at.u;
        worst_v = at.v;
        worst_measured = measured;
        worst_bound = bound_;
        worst_is_grid = grid_;
    }
}

void certificate::triangle(const std::array<corner, 3>& c) {
    if (turn(c[0], c[1], c[2]) == 0)
        return; // covers nothing
    for (const auto& weights : triangle_samples)
        sample(c, weights);
}

void certificate::quad(const std::array<corner, 4>& c) {
    bool right = false, left = false;
    for (std::size_t i = 0; i < 4; ++i) {
        const double at_corner = turn(c[i], c[(i + 1) % 4], c[(i + 2) % 4]);
        right = right || at_corner > 0;
        left = left || at_corner < 0;
    }
    if (right != left) {
        for (const auto& [s, t] : quad_samples)
            sample(c, std::array{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t});
    } else if (right) {
        corner centre{0, 0, 0, 0, 0};
        for (const corner& p : c) {
            centre.x += p.w * p.x;
            centre.y += p.w * p.y;
            centre.w += p.w;
            centre.u += p.u / 4;
            centre.v += p.v / 4;
        }
        centre.x = std::rint(centre.x / centre.w * l3d_subpixel_one) / l3d_subpixel_one;
        centre.y = std::rint(centre.y / centre.w * l3d_subpixel_one) / l3d_subpixel_one;
        centre.w /= 4;
        for (std::size_t i = 0; i < 4; ++i)
            triangle({c[i], c[(i + 1) % 4], centre});
    }
}

void certificate::draw(std::span<const l3d_diced_piece> pieces, double frame_bound) {
    for (const l3d_diced_piece& piece : pieces) {
        draw_grid(piece);
        draw_triangles(piece, frame_bound);
    }
}

void certificate::draw_grid(const l3d_diced_piece& piece) {
    const l3d_micro_grid& grid = piece.part.grid;
    bound_ = piece.bound;
    grid_ = true;
    largest_promise = std::max(largest_promise, piece.bound);
    std::size_t count = 0;
    for (int r = 0; r + 1 < grid.rows; ++r)
        for (int c = 0; c + 1 < grid.columns; ++c) {
            if (count++ % every_ != 0)
                continue;
            const auto at = [&](int row, int column) {
                return corner_of(grid.vertex(row, column),
                                 piece.u[static_cast<std::size_t>(column)],
                                 piece.v[static_cast<std::size_t>(row)]);
            };
            const std::array<corner, 4> corners{at(r, c), at(r, c + 1), at(r + 1, c + 1),
                                                at(r + 1, c)};
            if (may_be_seen(corners))
                quad(corners);
        }
}

void certificate::draw_triangles(const l3d_diced_piece& piece, double frame_bound) {
    const l3d_micro_triangles& triangles = piece.part.triangles;
    bound_ = frame_bound;
    grid_ = false;
    largest_promise = std::max(largest_promise, frame_bound);
    for (std::size_t i = 0; i < triangles.count; i += every_) {
        std::array<corner, 3> three;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [u, v] = piece.triangle_uv[k].at(i);
            three[k] = corner_of(triangles.vertex(i, k), u, v);
        }
        if (may_be_seen(three))
            triangle(three);
    }
}

} // namespace pipeline_tests
