// SPDX-License-Identifier: MIT
// l3d_whitted_plotter: cuts patches into pieces, finds their edges, and fills the spans between.
#include "compare/plotters/whitted_plotter.h"

#include "dice/normal_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace {

/// The number of samples of a border. A silhouette that runs into it is found between two of them.
constexpr int border_samples = 8;

/// The most cuts of a patch, and the size in pixels below which a piece is not cut any more.
constexpr int deepest = 24;
constexpr double smallest = 1;

} // namespace

void l3d_whitted_plotter::fail(const l3d_plot_task& of, int rounds) {
    ++of.counts.failures;
    effort_.add(false, rounds);
}

void l3d_whitted_plotter::plot(const l3d_image_patch& net, const l3d_plot_task& of) {
    accuracy_ = of.view.tolerance / 8;
    of.counts.bound_px = std::numeric_limits<double>::infinity();
    divide({net}, of);
}

/// Whether a piece's depth is nearly a plane's: w bends little within it, measured in pixels at its
/// depth.
bool l3d_whitted_plotter::is_nearly_flat(const piece& p, const l3d_plot_task& of) const {
    const double least = l3d_depth_range_of(p.net.points).least;
    return l3d_depth_bounds_of(p.net).triangle_error(1, 1) * of.view.focal <=
           of.view.tolerance * least;
}

void l3d_whitted_plotter::cut(const piece& p, const l3d_plot_task& of) {
    const l3d_second_bounds bends = l3d_depth_bounds_of(p.net);
    const bool along_u = bends.uu != bends.vv ? bends.uu > bends.vv : p.depth % 2 == 0;
    for (const piece& half : l3d_halves(p, along_u))
        divide(half, of);
}

void l3d_whitted_plotter::divide(const piece& p, const l3d_plot_task& of) {
    const l3d_image_box hull = l3d_image_box_of(p.net.points);
    if (hull.intersected(of.view.window()).empty())
        return;
    const bool is_small = std::max(hull.width(), hull.height()) <= smallest || p.depth == deepest;
    if (!is_small && !is_nearly_flat(p, of))
        return cut(p, of);
    const l3d_scan_piece powers(p.net);
    auto turns = l3d_border_turns(powers, border_samples);
    if (turns.size() > 2) {
        if (!is_small)
            return cut(p, of);
        fail(of, 0);
        turns.resize(2);
    }
    if (turns.size() == 1) // its other end is in a corner
        turns.clear();
    ++of.counts.pieces;
    for (auto& edges : edges_)
        edges.clear();
    add_borders(p, powers, turns);
    if (turns.size() == 2)
        add_silhouette(powers, turns);
    for (auto& edges : edges_)
        scan(p, edges, of);
}

/// Adds each border to the side of the surface that it bounds; ends of silhouettes cut it into
/// parts.
void l3d_whitted_plotter::add_borders(const piece& p, const l3d_scan_piece& powers,
                                      const std::vector<l3d_border_turn>& turns) {
    for (int side = 0; side < 4; ++side) {
        const l3d_image_curve curve =
            side < 2 ? p.net.row(side == 0 ? 0 : 3) : p.net.column(side == 2 ? 0 : 3);
        std::array<double, 4> stops{0}; // 0, 1, and two turns at most
        std::size_t count = 1;
        for (const l3d_border_turn& turn : turns)
            if (turn.side == side)
                stops[count++] = turn.t;
        stops[count++] = 1;
        if (stops[1] > stops[2] && count == stops.size())
            std::swap(stops[1], stops[2]);
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const l3d_scan_root middle = l3d_on_side(side, (stops[i] + stops[i + 1]) / 2);
            const bool is_front = turns.empty() ? l3d_turn_at(powers, 0.5, 0.5).value > 0
                                                : l3d_turn_at(powers, middle.u, middle.v).value > 0;
            found_.clear();
            const bool is_whole = stops[i] == 0 && stops[i + 1] == 1;
            l3d_add_scan_edges(is_whole ? curve : l3d_curve_part(curve, stops[i], stops[i + 1]),
                               l3d_on_side(side, stops[i]), l3d_on_side(side, stops[i + 1]),
                               found_);
            for (const l3d_scan_edge& edge : found_)
                edges_[is_front].push_back({edge, 0});
        }
    }
}

/// Adds a silhouette as a cubic from end to end. At its ends it has the silhouette's direction,
/// (-J_v, J_u). These tangents are as long as the distance of the ends.
void l3d_whitted_plotter::add_silhouette(const l3d_scan_piece& powers,
                                         const std::vector<l3d_border_turn>& turns) {
    const l3d_scan_root &from = turns[0].root, &to = turns[1].root;
    const double way_u = to.u - from.u, way_v = to.v - from.v, way = std::hypot(way_u, way_v);
    const auto along = [&](const l3d_scan_root& at) {
        const l3d_scan_turn turn = l3d_turn_at(powers, at.u, at.v);
        const auto s = powers.at(at.u, at.v);
        double du = -turn.by_v, dv = turn.by_u;
        const double size = std::hypot(du, dv);
        const double scale = size > 0 ? (du * way_u + dv * way_v < 0 ? -way : way) / size : 0;
        return (s.by_u * du + s.by_v * dv) * (scale / 3);
    };
    const l3d_image_point first = powers.at(from.u, from.v).value;
    const l3d_image_point last = powers.at(to.u, to.v).value;
    found_.clear();
    l3d_add_scan_edges({{first, first + along(from), last - along(to), last}}, from, to, found_);
    for (auto& edges : edges_)
        for (const l3d_scan_edge& edge : found_)
            edges.push_back({edge, 0});
}

void l3d_whitted_plotter::meet(const piece& p, std::vector<tracked>& edges, double y,
                               const l3d_plot_task& of) {
    ends_.clear();
    for (tracked& each : edges) {
        if (!each.edge.meets(y))
            continue;
        const double start = each.is_new ? l3d_chord_start(each.edge, y) : each.t;
        int rounds = 0;
        const auto t = l3d_newton_crossing(each.edge, y, start, accuracy_, rounds);
        of.counts.samples += rounds;
        each.is_new = !t;
        if (!t) {
            fail(of, rounds);
            continue;
        }
        effort_.add(true, rounds);
        each.t = *t;
        const l3d_image_point h = each.edge.curve.evaluate(*t);
        const l3d_scan_root at = l3d_between(each.edge.from, each.edge.to, *t);
        ends_.push_back({h[0] / h[2], double{of.view.depth_at(h[2])},
                         l3d_unit_normal(of.normals.evaluate(p.u0 + (p.u1 - p.u0) * at.u,
                                                             p.v0 + (p.v1 - p.v0) * at.v))});
    }
    std::sort(ends_.begin(), ends_.end(), [](const end& a, const end& b) { return a.x < b.x; });
}

void l3d_whitted_plotter::scan(const piece& p, std::vector<tracked>& edges,
                               const l3d_plot_task& of) {
    if (edges.empty())
        return;
    double top = edges[0].edge.top, bottom = edges[0].edge.bottom;
    for (const tracked& each : edges) {
        top = std::min(top, each.edge.top);
        bottom = std::max(bottom, each.edge.bottom);
    }
    const double middle = of.view.size.height / 2.0;
    const int end_row = std::min(of.view.size.height, l3d_first_centre(bottom + middle) + 1);
    for (int row = std::max(0, l3d_first_centre(top + middle)); row < end_row; ++row) {
        meet(p, edges, row + 0.5 - middle, of);
        if (ends_.size() % 2 == 1)
            fail(of, 0);
        for (std::size_t i = 0; i + 1 < ends_.size(); i += 2)
            fill(row, ends_[i], ends_[i + 1], of);
    }
}

void l3d_whitted_plotter::fill(int row, const end& left, const end& right,
                               const l3d_plot_task& of) {
    const double centre_x = of.view.size.width / 2.0;
    const int last = std::min(of.view.size.width, l3d_first_centre(right.x + centre_x));
    for (int column = std::max(0, l3d_first_centre(left.x + centre_x)); column < last; ++column) {
        const double part = (column + 0.5 - centre_x - left.x) / (right.x - left.x);
        const auto inv_w = static_cast<float>(left.inv_w + (right.inv_w - left.inv_w) * part);
        if (!of.canvas.is_nearest(column, row, inv_w))
            continue;
        l3d_normal_net::vector normal;
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            normal[i] =
                double(left.normal[k]) + (double(right.normal[k]) - double(left.normal[k])) * part;
        }
        of.canvas.put(column, row, inv_w, l3d_unit_normal(normal));
    }
}
