// SPDX-License-Identifier: MIT
// l3d_shared_edges: finds the edges of a file, with the stops and the places that their faces need.
#include "scene/sides/shared_edges.h"

#include "geom/trims/trim_region.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace {

using vector = l3d_vector<double, 3>;

/// The parameters that divide an edge into spans. Each face follows all of a span, or nothing of
/// it.
using stops = std::vector<double>;

/// Parameters of an edge that differ by less than this part of the edge are one stop, since files
/// round them.
constexpr double same_stop = 0x1p-30;

double range_of(const l3d_nurbs_curve& curve) {
    return curve.along().to - curve.along().from;
}

/// Adds to an edge's stops the parameters at which a loop begins or ends to follow the edge.
void add_stops(const l3d_trim_loop& loop, std::span<const l3d_model_edge> edges,
               std::vector<stops>& to) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const l3d_trim_curve &one = loop[i], &next = loop[i + 1 < loop.size() ? i + 1 : 0];
        if (one.edge == next.edge && one.to == next.from)
            continue;
        for (const auto& [edge, at] : {std::pair{one.edge, one.to}, {next.edge, next.from}})
            if (edge < edges.size())
                to[edge].push_back(at);
    }
}

void unite(stops& of, const l3d_nurbs_curve& curve) {
    const l3d_bspline_direction& along = curve.along();
    const double same = same_stop * range_of(curve);
    std::erase_if(of, [&](double t) { return !(t > along.from + same && t < along.to - same); });
    of.insert(of.end(), {along.from, along.to});
    std::ranges::sort(of);
    const auto is_same = [&](double a, double b) { return b - a <= same; };
    of.erase(std::unique(of.begin(), of.end(), is_same), of.end());
}

void move_to_stop(double& t, const stops& all, double same) {
    const auto above = std::ranges::lower_bound(all, t);
    if (above != all.end() && *above - t <= same)
        t = *above;
    else if (above != all.begin() && t - above[-1] <= same)
        t = above[-1];
}

std::vector<l3d_shared_edge::span> spans_of(const l3d_nurbs_curve& curve, const stops& at) {
    std::vector<l3d_shared_edge::span> result;
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        l3d_bspline_direction along = curve.along();
        along.from = at[i];
        along.to = at[i + 1];
        const auto ranges = l3d_spans_of(along);
        const l3d_space_curve part(l3d_nurbs_curve(along, curve.points(), curve.weights()));
        for (std::size_t k = 0; k < ranges.size(); ++k)
            result.push_back({ranges[k][0], ranges[k][1], part.spans()[k]});
    }
    return result;
}

/// Moves ends of edges to one place if they are near enough. They are near enough if their distance
/// is at most the sum of both edges' allowances. An edge's allowance is its tolerance, or its
/// distance from its faces if that is larger. The common place is the end of the most exact edge.
/// So a loose edge never moves the end of a tighter edge.
void join_ends(std::vector<l3d_shared_edge>& edges) {
    struct end {
        vector at;
        double near;
        std::size_t edge, side;
    };
    constexpr double rounding = 0x1p-40; // error of evaluated ends
    std::vector<end> all;
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (const std::size_t side : {0U, 1U})
            all.push_back({edges[i].ends[side],
                           std::max(edges[i].tolerance, edges[i].off) +
                               rounding * l3d_length(edges[i].ends[side]),
                           i, side});
    const auto x = [](const end& e) { return e.at[0]; };
    std::ranges::stable_sort(all, {}, x);
    // Goes from the most exact end to the least exact one; among equals, by x.
    std::vector<std::size_t> order(all.size()), place_in_order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return all[i].near; });
    for (std::size_t i = 0; i < order.size(); ++i)
        place_in_order[order[i]] = i;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const end& one = all[order[i]];
        std::size_t first = i; // the first in this order of those that are near enough
        // Ends before this one are at least as exact.
        for (auto other = std::ranges::lower_bound(all, one.at[0] - 2 * one.near, {}, x);
             other != all.end() && other->at[0] - one.at[0] <= 2 * one.near; ++other)
            if (l3d_length(other->at - one.at) <= other->near + one.near)
                first =
                    std::min(first, place_in_order[static_cast<std::size_t>(other - all.begin())]);
        const end& joined = all[order[first]];
        edges[one.edge].ends[one.side] = edges[joined.edge].ends[joined.side];
    }
}

/// Measures how far a piece is off the edges that its trims follow, at places along each edge.
void measure(const l3d_patch_points& piece, std::span<const l3d_model_edge> edges,
             std::vector<l3d_shared_edge>& to) {
    constexpr int places = 8;
    const l3d_nurbs_surface surface = l3d_nurbs_surface::of_patch(piece);
    for (const l3d_trim_loop& loop : piece.trims)
        for (const l3d_trim_curve& one : loop) {
            if (one.edge >= edges.size())
                continue;
            std::vector<vector> points;
            std::vector<double> weights;
            for (const auto& [u, v, weight] : one.points) {
                points.push_back({u, v, 0.0});
                weights.push_back(weight);
            }
            const l3d_nurbs_curve curve(
                l3d_bspline_direction::clamped(static_cast<int>(points.size()) - 1, points.size()),
                points, weights);
            for (int i = 0; i <= places; ++i) {
                const double part = static_cast<double>(i) / places;
                const vector at = curve.evaluate(part);
                if (!(at[0] >= 0 && at[0] <= 1 && at[1] >= 0 && at[1] <= 1))
                    continue;
                const l3d_nurbs_curve& edge = edges[one.edge].curve;
                const double t = std::clamp(one.from + (one.to - one.from) * part,
                                            edge.along().from, edge.along().to);
                to[one.edge].note(l3d_length(surface.evaluate(at[0], at[1]) - edge.evaluate(t)),
                                  edge.evaluate(t));
            }
        }
}

} // namespace

std::vector<l3d_shared_edge> l3d_shared_edges(std::span<const l3d_model_edge> edges,
                                              std::span<l3d_patch_points> pieces) {
    if (edges.empty())
        return {};
    std::vector<stops> all(edges.size());
    for (const l3d_patch_points& piece : pieces)
        for (const l3d_trim_loop& loop : piece.trims)
            add_stops(loop, edges, all);
    std::vector<l3d_shared_edge> result;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const l3d_nurbs_curve& curve = edges[i].curve;
        unite(all[i], curve);
        result.push_back(
            {.curve = curve,
             .spans = spans_of(curve, all[i]),
             .ends = {curve.evaluate(curve.along().from), curve.evaluate(curve.along().to)},
             .tolerance = edges[i].tolerance});
    }
    for (l3d_patch_points& piece : pieces) {
        for (l3d_trim_loop& loop : piece.trims)
            for (l3d_trim_curve& one : loop)
                if (one.edge < edges.size()) {
                    const double same = same_stop * range_of(edges[one.edge].curve);
                    move_to_stop(one.from, all[one.edge], same);
                    move_to_stop(one.to, all[one.edge], same);
                }
        measure(piece, edges, result);
    }
    join_ends(result);
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (const std::size_t side : {0U, 1U}) {
            const l3d_bspline_direction& along = edges[i].curve.along();
            const vector exact = edges[i].curve.evaluate(side == 0 ? along.from : along.to);
            result[i].note(l3d_length(result[i].ends[side] - exact), exact);
        }
    return result;
}
