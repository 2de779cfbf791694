// SPDX-License-Identifier: MIT
// Points of what the rasterizer would draw, each with the parameters whose exact point it stands
// for.
#ifndef L3D_TESTS_DICE_DRAWN_POINTS_H
#define L3D_TESTS_DICE_DRAWN_POINTS_H

#include "dice/diced_piece.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace dice_tests {

/// Units: x, y pixels from the picture's upper left corner; w distance along the view axis.
struct drawn_point {
    double x, y, w, u, v;
};

/// Hands out points of quads and triangles.
///
/// A drawn polygon is the picture of a polygon in homogeneous space with corners (w x, w y, w) and
/// parameters linear in that space. A convex quad is bilinear there, a folded one is four triangles
/// around its mean. Only drawn points inside the window count: of others nothing is claimed.
class drawn_points {
public:
    /// Looks only at every n-th quad or triangle of each batch. Expects: every >= 1.
    explicit drawn_points(l3d_size size, std::size_t every = 1, bool parallel = false)
        : size_(size), every_(every), parallel_(parallel) {}

    /// Calls visit(drawn_point) for points of the piece's grid.
    template <class Visit> void of_grid(const l3d_diced_piece& piece, Visit visit) const {
        const l3d_micro_grid& grid = piece.part.grid;
        std::size_t count = 0;
        for (int r = 0; r + 1 < grid.rows; ++r)
            for (int c = 0; c + 1 < grid.columns; ++c) {
                if (count++ % every_ != 0)
                    continue;
                const auto at = [&](int row, int column) {
                    return point_of(grid.vertex(row, column),
                                    piece.u[static_cast<std::size_t>(column)],
                                    piece.v[static_cast<std::size_t>(row)]);
                };
                const std::array<drawn_point, 4> corners{at(r, c), at(r, c + 1), at(r + 1, c + 1),
                                                         at(r + 1, c)};
                if (may_be_seen(corners))
                    quad(corners, visit);
            }
    }

    /// Calls visit(drawn_point) for points of the piece's loose triangles.
    /// Expects: the piece kept its parameters.
    template <class Visit> void of_triangles(const l3d_diced_piece& piece, Visit visit) const {
        const l3d_micro_triangles& triangles = piece.part.triangles;
        for (std::size_t i = 0; i < triangles.count; i += every_) {
            std::array<drawn_point, 3> three;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& [u, v] = piece.triangle_uv[k].at(i);
                three[k] = point_of(triangles.vertex(i, k), u, v);
            }
            if (may_be_seen(three))
                triangle(three, visit);
        }
    }

private:
    /// Corners, middles of the sides, the centre and two points of no symmetry.
    static constexpr std::array<std::array<double, 2>, 11> of_quad{{{0, 0},
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
    static constexpr std::array<std::array<double, 3>, 8> of_triangle{{{1, 0, 0},
                                                                       {0, 1, 0},
                                                                       {0, 0, 1},
                                                                       {0.5, 0.5, 0},
                                                                       {0, 0.5, 0.5},
                                                                       {0.5, 0, 0.5},
                                                                       {0.25, 0.25, 0.5},
                                                                       {0.2, 0.5, 0.3}}};

    /// In a parallel projection, w is the same everywhere.
    drawn_point point_of(const l3d_micro_vertex& vertex, double u, double v) const {
        return {vertex.x / double{l3d_subpixel_one}, vertex.y / double{l3d_subpixel_one},
                parallel_ ? 1 : 1 / static_cast<double>(vertex.inv_w), u, v};
    }

    static double turn(const drawn_point& a, const drawn_point& b, const drawn_point& c) {
        return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    }

    bool may_be_seen(std::span<const drawn_point> corners) const {
        const auto [left, right] = std::minmax_element(corners.begin(), corners.end(),
                                                       [](auto& a, auto& b) { return a.x < b.x; });
        const auto [top, bottom] = std::minmax_element(corners.begin(), corners.end(),
                                                       [](auto& a, auto& b) { return a.y < b.y; });
        return left->x <= size_.width && right->x >= 0 && top->y <= size_.height && bottom->y >= 0;
    }

    template <class Visit>
    void mean(std::span<const drawn_point> corners, std::span<const double> weights,
              Visit& visit) const {
        drawn_point at{0, 0, 0, 0, 0};
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
        visit(at);
    }

    template <class Visit> void triangle(const std::array<drawn_point, 3>& c, Visit& visit) const {
        if (turn(c[0], c[1], c[2]) == 0)
            return; // covers nothing
        for (const auto& weights : of_triangle)
            mean(c, weights, visit);
    }

    template <class Visit> void quad(const std::array<drawn_point, 4>& c, Visit& visit) const {
        bool right = false, left = false;
        for (std::size_t i = 0; i < 4; ++i) {
            const double at_corner = turn(c[i], c[(i + 1) % 4], c[(i + 2) % 4]);
            right = right || at_corner > 0;
            left = left || at_corner < 0;
        }
        if (right != left) {
            for (const auto& [s, t] : of_quad)
                mean(c, std::array{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t}, visit);
        } else if (right) {
            drawn_point centre{0, 0, 0, 0, 0};
            for (const drawn_point& p : c) {
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
                triangle({c[i], c[(i + 1) % 4], centre}, visit);
        }
    }

    l3d_size size_;
    std::size_t every_;
    bool parallel_;
};

} // namespace dice_tests

#endif
