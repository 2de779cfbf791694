// SPDX-License-Identifier: MIT
// Trims of l3d_nurbs_surface: loops of NURBS curves, and what each piece has of them.
#include "geom/nurbs_surface.h"

#include "base/error.h"
#include "geom/trim_region.h"

#include <algorithm>
#include <array>
#include <utility>

namespace {

/// The box of a curve's control points, which holds the curve.
l3d_trim_box hull_of(const l3d_trim_curve& curve) {
    const auto& first = curve.points.front();
    l3d_trim_box hull{{first[0], first[1]}, {first[0], first[1]}};
    for (const auto& p : curve.points)
        for (std::size_t k = 0; k < 2; ++k) {
            hull.least[k] = std::min(hull.least[k], p[k]);
            hull.most[k] = std::max(hull.most[k], p[k]);
        }
    return hull;
}

bool meet(const l3d_trim_box& a, const l3d_trim_box& b) {
    return a.least[0] <= b.most[0] && a.most[0] >= b.least[0] && a.least[1] <= b.most[1] &&
           a.most[1] >= b.least[1];
}

/// Whether a loop winds around a place an odd number of times that lies in no curve's hull.
bool winds_around(const l3d_trim_loop& loop, const l3d_trim_place& at) {
    l3d_trim_region chords;
    for (const l3d_trim_curve& curve : loop)
        (chords.polygons.empty() ? chords.polygons.emplace_back() : chords.polygons.front())
            .push_back({curve.points.front()[0], curve.points.front()[1]});
    return chords.contains(at);
}

l3d_trim_loop in_box(l3d_trim_loop loop, const l3d_trim_box& box) {
    for (l3d_trim_curve& one : loop)
        for (auto& p : one.points)
            for (std::size_t k = 0; k < 2; ++k)
                p[k] = (p[k] - box.least[k]) / (box.most[k] - box.least[k]);
    return loop;
}

} // namespace

std::vector<std::array<double, 2>> l3d_spans_of(const l3d_bspline_direction& d) {
    std::vector<std::array<double, 2>> result;
    for (auto i = static_cast<std::size_t>(d.degree); i < d.points(); ++i) {
        const double from = std::max(d.knots[i], d.from), to = std::min(d.knots[i + 1], d.to);
        if (from < to)
            result.push_back({from, to});
    }
    return result;
}

/// Where no curve's hull meets the box, chords in the curves' place wind around it as often.
std::vector<l3d_trim_loop> l3d_trims_in(std::span<const l3d_trim_loop> loops,
                                        const l3d_trim_box& box) {
    std::vector<l3d_trim_loop> result;
    bool is_odd = false;
    for (const l3d_trim_loop& loop : loops) {
        const bool is_near = std::ranges::any_of(
            loop, [&](const l3d_trim_curve& curve) { return meet(hull_of(curve), box); });
        if (is_near)
            result.push_back(in_box(loop, box));
        else
            is_odd = is_odd != winds_around(loop, box.least);
    }
    if (is_odd)
        result.push_back(l3d_trim_around({}));
    // A loop that winds around nothing keeps a piece trimmed that lies outside.
    if (result.empty())
        result.push_back({{{{0, 0, 1}, {0, 0, 1}}}});
    return result;
}

l3d_trim_loop l3d_trim_around(const l3d_trim_box& box) {
    const auto [u0, v0] = box.least;
    const auto [u1, v1] = box.most;
    return {{{{u0, v0, 1}, {u1, v0, 1}}},
            {{{u1, v0, 1}, {u1, v1, 1}}},
            {{{u1, v1, 1}, {u0, v1, 1}}},
            {{{u0, v1, 1}, {u0, v0, 1}}}};
}

l3d_trim_loop l3d_trim_loop_of(std::span<const l3d_nurbs_curve> curves,
                               std::span<const l3d_edge_use> edges) {
    l3d_trim_loop result;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const l3d_nurbs_curve& curve = curves[k];
        const l3d_bspline_direction& along = curve.along();
        const l3d_edge_use use = k < edges.size() ? edges[k] : l3d_edge_use();
        const auto on_edge = [&](double t) {
            return t == along.to ? use.to
                                 : use.from + (use.to - use.from) *
                                                  ((t - along.from) / (along.to - along.from));
        };
        // The curve as a surface that is the same all along v.
        std::vector<std::array<double, 3>> points;
        std::vector<double> weights;
        for (int row = 0; row < 2; ++row) {
            for (const auto& p : curve.points())
                points.push_back({p[0], p[1], 0});
            weights.insert(weights.end(), curve.weights().begin(), curve.weights().end());
        }
        const auto spans = l3d_spans_of(along);
        std::size_t span = 0;
        for (const l3d_patch_points& piece :
             l3d_bezier_patches(along, l3d_bspline_direction::clamped(1, 2), points, weights)) {
            l3d_trim_curve& one = result.emplace_back();
            if (use.edge != l3d_no_edge) {
                one.edge = use.edge;
                one.from = on_edge(spans[span][0]);
                one.to = on_edge(spans[span][1]);
            }
            ++span;
            for (std::size_t i = 0; i <= static_cast<std::size_t>(piece.degree_u); ++i)
                one.points.push_back({piece.points[i][0], piece.points[i][1],
                                      piece.weights.empty() ? 1 : piece.weights[i]});
        }
    }
    return result;
}

l3d_nurbs_surface l3d_nurbs_surface::trimmed(std::vector<l3d_trim_loop> loops) const {
    const std::string why = l3d_trims_complaint(loops);
    if (!why.empty())
        throw l3d_error(l3d_exit::bad_input, "surface: " + why);
    l3d_nurbs_surface result = *this;
    result.trims_ = std::move(loops);
    return result;
}

std::vector<l3d_patch_points> l3d_nurbs_surface::pieces() const {
    std::vector<std::array<double, 3>> points;
    points.reserve(points_.size());
    for (const vector& p : points_)
        points.push_back({p[0], p[1], p[2]});
    std::vector<l3d_patch_points> result = l3d_bezier_patches(u_, v_, points, weights_);
    if (trims_.empty())
        return result;
    const auto in_u = l3d_spans_of(u_), in_v = l3d_spans_of(v_);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const auto [u0, u1] = in_u[i % in_u.size()];
        const auto [v0, v1] = in_v[i / in_u.size()];
        result[i].trims = l3d_trims_in(trims_, {{u0, v0}, {u1, v1}});
    }
    return result;
}
