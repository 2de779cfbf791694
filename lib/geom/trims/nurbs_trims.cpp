// SPDX-License-Identifier: MIT
// Trims of l3d_nurbs_surface: makes loops of NURBS curves, unrolls them, and finds their part in
// each piece.
#include "geom/nurbs_surface.h"

#include "base/error.h"
#include "geom/trims/trim_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
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

l3d_trim_box hull_of(const l3d_trim_loop& loop) {
    l3d_trim_box hull = hull_of(loop.front());
    for (const l3d_trim_curve& curve : loop) {
        const l3d_trim_box more = hull_of(curve);
        for (std::size_t k = 0; k < 2; ++k) {
            hull.least[k] = std::min(hull.least[k], more.least[k]);
            hull.most[k] = std::max(hull.most[k], more.most[k]);
        }
    }
    return hull;
}

l3d_trim_loop shifted(l3d_trim_loop loop, const l3d_trim_place& by) {
    for (l3d_trim_curve& one : loop)
        for (auto& p : one.points)
            for (std::size_t k = 0; k < 2; ++k)
                p[k] += by[k];
    return loop;
}

/// Moves the curves of a loop by whole turns around a closed surface, so that each curve begins
/// where the one before ends. Returns the loop, and how often the loop goes around along u and
/// along v.
std::pair<l3d_trim_loop, std::array<double, 2>>
unroll(const l3d_trim_loop& loop, const l3d_trim_box& box, const std::array<bool, 2>& is_closed) {
    std::pair<l3d_trim_loop, std::array<double, 2>> result;
    auto& [way, turns] = result;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto &curve = loop[i].points, &next = loop[i + 1 < loop.size() ? i + 1 : 0].points;
        l3d_trim_place by{};
        for (std::size_t k = 0; k < 2; ++k)
            by[k] = turns[k] * (box.most[k] - box.least[k]);
        way.push_back(shifted({loop[i]}, by).front());
        for (std::size_t k = 0; k < 2; ++k) {
            constexpr double rounding = 0x1p-20; // a share of a turn; wider gaps are faults
            const double gap = (curve.back()[k] - next.front()[k]) / (box.most[k] - box.least[k]);
            if (is_closed[k] && std::abs(gap - std::round(gap)) <= rounding)
                turns[k] += std::round(gap);
        }
    }
    return result;
}

/// Closes a loop that goes around once along one direction. The loop continues over the whole box,
/// and returns beyond the box.
void close_around(l3d_trim_loop& way, std::size_t along, double turns, const l3d_trim_box& box) {
    const double period = box.most[along] - box.least[along];
    const l3d_trim_box hull = hull_of(way);
    const l3d_trim_loop once = way;
    way.clear();
    // The copies run from beyond one side of the box to beyond the other.
    const double first = std::floor((box.least[along] - hull.most[along]) / period);
    const double last = std::ceil((box.most[along] - hull.least[along]) / period);
    for (double i = first; i <= last; ++i) {
        l3d_trim_place by{};
        by[along] = (turns > 0 ? i : first + last - i) * period;
        const l3d_trim_loop copy = shifted(once, by);
        way.insert(way.end(), copy.begin(), copy.end());
    }
    const auto &end = way.back().points.back(), &begin = way.front().points.front();
    const double beyond = std::max(box.most[1 - along], hull.most[1 - along]);
    std::array<double, 3> up{end[0], end[1], 1}, back{begin[0], begin[1], 1};
    const std::array<double, 3> from{end[0], end[1], 1}, to{begin[0], begin[1], 1};
    up[1 - along] = back[1 - along] = beyond;
    way.push_back({{from, up}});
    way.push_back({{up, back}});
    way.push_back({{back, to}});
}

bool meet(const l3d_trim_box& a, const l3d_trim_box& b) {
    return a.least[0] <= b.most[0] && a.most[0] >= b.least[0] && a.least[1] <= b.most[1] &&
           a.most[1] >= b.least[1];
}

/// Whether a loop winds an odd number of times around a place. Expects: the place is outside of the
/// hulls of the loop's curves.
bool winds_around(const l3d_trim_loop& loop, const l3d_trim_place& at) {
    l3d_trim_region chords;
    for (const l3d_trim_curve& curve : loop)
        (chords.polygons.empty() ? chords.polygons.emplace_back() : chords.polygons.front())
            .push_back({{curve.points.front()[0], curve.points.front()[1]}});
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

/// Finds the loops for a piece. If none of the hulls of a loop's curves meets the box, the chords
/// of these curves wind around the box as often as the curves themselves.
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
    // A loop around nothing makes sure that a piece outside of all loops still counts as trimmed.
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
        // Takes the curve as a surface that is the same all along v, so that one function cuts both
        // into Bezier pieces.
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

std::array<bool, 2> l3d_closed_ways(const l3d_nurbs_surface& surface) {
    constexpr double rounding =
        0x1p-30; // relative to the largest coordinate, since files round numbers
    constexpr int places = 16;
    double largest = 0;
    for (const auto& p : surface.points())
        for (int k = 0; k < 3; ++k)
            largest = std::max(largest, std::abs(p[k]));
    std::array<bool, 2> result{true, true};
    const l3d_bspline_direction &u = surface.u(), &v = surface.v();
    for (int i = 0; i <= places; ++i) {
        const auto at = [&](const l3d_bspline_direction& d) {
            return d.from + (d.to - d.from) * i / places;
        };
        const auto off = [&](double u0, double v0, double u1, double v1) {
            return l3d_length(surface.evaluate(u0, v0) - surface.evaluate(u1, v1));
        };
        if (!(off(u.from, at(v), u.to, at(v)) <= rounding * largest))
            result[0] = false;
        if (!(off(at(u), v.from, at(u), v.to) <= rounding * largest))
            result[1] = false;
    }
    return result;
}

std::optional<std::vector<l3d_trim_loop>> l3d_unrolled(std::span<const l3d_trim_loop> loops,
                                                       const l3d_trim_box& box,
                                                       const std::array<bool, 2>& is_closed,
                                                       std::string& why) {
    why = l3d_trim_curves_complaint(loops);
    if (!why.empty())
        return std::nullopt;
    std::vector<l3d_trim_loop> result;
    std::array<bool, 2> is_around{}; // whether any loop goes around along u, and along v
    double least = HUGE_VAL;         // the least value across its way on any loop around
    bool is_flipped = false;         // whether that loop leaves the part below it
    for (const l3d_trim_loop& loop : loops) {
        auto [way, turns] = unroll(loop, box, is_closed);
        for (const std::size_t k : {0U, 1U}) {
            is_around[k] = is_around[k] || turns[k] != 0;
            if (turns[k] == 0)
                continue;
            if (std::abs(turns[k]) > 1) {
                why = "a trim goes around the surface more than once";
                return std::nullopt;
            }
            const l3d_trim_box hull = hull_of(way);
            if (hull.least[1 - k] < least) {
                least = hull.least[1 - k];
                is_flipped = (turns[k] > 0) != (k == 0);
            }
            close_around(way, k, turns[k], box);
        }
        if (is_around[0] && is_around[1]) {
            why = "trims go around the surface along u and along v";
            return std::nullopt;
        }
        // Adds the copies of the loop that meet the box.
        const l3d_trim_box hull = hull_of(way);
        const auto copies = [&, &turns = turns](std::size_t k) {
            const double period = box.most[k] - box.least[k];
            constexpr double rounding = 1e-9; // a loop along the box's border has no copies
            if (!is_closed[k] || turns[k] != 0)
                return std::array{0.0, 0.0};
            return std::array{std::floor((box.least[k] - hull.most[k]) / period + rounding) + 1,
                              std::ceil((box.most[k] - hull.least[k]) / period - rounding) - 1};
        };
        const auto [first_u, last_u] = copies(0);
        const auto [first_v, last_v] = copies(1);
        for (double i = first_u; i <= last_u; ++i)
            for (double j = first_v; j <= last_v; ++j)
                result.push_back(shifted(
                    way, {i * (box.most[0] - box.least[0]), j * (box.most[1] - box.least[1])}));
    }
    if (is_flipped)
        result.push_back(l3d_trim_around(box));
    if (why = l3d_trims_complaint(result); !why.empty())
        return std::nullopt;
    return result;
}

l3d_nurbs_surface l3d_nurbs_surface::trimmed(std::span<const l3d_trim_loop> loops) const {
    std::string why;
    auto unrolled =
        l3d_unrolled(loops, {{u_.from, v_.from}, {u_.to, v_.to}}, l3d_closed_ways(*this), why);
    if (!unrolled)
        throw l3d_error(l3d_exit::bad_input, "surface: " + why);
    l3d_nurbs_surface result = *this;
    result.trims_ = *std::move(unrolled);
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
