// SPDX-License-Identifier: MIT
// l3d_blinn_plotter: tracks edges from line to line, and solves pixels.
#include "compare/plotters/blinn_plotter.h"

#include "dice/normal_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// The number of samples of a border. A silhouette that runs into it is found between two of them.
constexpr int border_samples = 16;

/// The distance outside of a patch at which a silhouette still bounds its inside. It allows for
/// rounding.
constexpr double rim = 1e-6;

bool is_inside(const l3d_scan_root& at) {
    return at.u >= -rim && at.u <= 1 + rim && at.v >= -rim && at.v <= 1 + rim;
}

bool is_front(const l3d_scan_piece& piece, const l3d_scan_root& at) {
    return l3d_turn_at(piece, at.u, at.v).value > 0;
}

} // namespace

void l3d_blinn_plotter::fail(const l3d_plot_task& of, int rounds) {
    ++of.counts.failures;
    effort_.add(false, rounds);
}

void l3d_blinn_plotter::plot(const l3d_image_patch& net, const l3d_plot_task& of) {
    accuracy_ = of.view.tolerance / 8;
    ++of.counts.pieces;
    of.counts.bound_px = std::numeric_limits<double>::infinity();
    const l3d_scan_piece piece(net);
    const l3d_image_box hull = l3d_image_box_of(net.points);
    edges_.clear();
    l3d_add_scan_edges(net.row(0), {0, 0, 0}, {1, 0, 0}, edges_);
    l3d_add_scan_edges(net.row(3), {0, 1, 0}, {1, 1, 0}, edges_);
    l3d_add_scan_edges(net.column(0), {0, 0, 0}, {0, 1, 0}, edges_);
    l3d_add_scan_edges(net.column(3), {1, 0, 0}, {1, 1, 0}, edges_);
    borders_.clear();
    for (const l3d_scan_edge& edge : edges_)
        borders_.push_back({edge, 0});
    silhouettes_.clear();
    find_beginnings(piece, of);
    // Tracking begins at the patch's top, even above the window.
    const double middle = of.view.size.height / 2.0;
    const int end = std::min(of.view.size.height, l3d_first_centre(hull.bottom + middle) + 1);
    for (int row = l3d_first_centre(hull.top + middle); row < end; ++row) {
        const double y = row + 0.5 - middle;
        for (auto& side : crossings_)
            side.clear();
        meet_borders(piece, y, of);
        meet_silhouettes(piece, y, of);
        for (const bool front : {false, true})
            scan_side(piece, row, front, of);
    }
}

void l3d_blinn_plotter::find_beginnings(const l3d_scan_piece& piece, const l3d_plot_task& of) {
    beginnings_.clear();
    begun_ = 0;
    for (const l3d_border_turn& turn : l3d_border_turns(piece, border_samples)) {
        const auto s = piece.at(turn.root.u, turn.root.v);
        beginnings_.push_back({s.value[1] / s.value[2], turn.root, false});
    }
    int rounds = 0;
    for (const l3d_scan_root& at : l3d_level_points(piece, rounds)) {
        const auto s = piece.at(at.u, at.v);
        beginnings_.push_back({s.value[1] / s.value[2], at, true});
    }
    of.counts.samples += rounds;
    std::sort(beginnings_.begin(), beginnings_.end(),
              [](const beginning& a, const beginning& b) { return a.y < b.y; });
}

/// Begins a silhouette, whose direction is (-J_v, J_u). From a border it leads inside, if at all.
/// From a level point it leads both ways, by a step h with y'' h^2 / 2 as the way to the line.
void l3d_blinn_plotter::begin_at(const beginning& from, const l3d_scan_piece& piece, double y,
                                 const l3d_plot_task& of) {
    const l3d_scan_turn turn = l3d_turn_at(piece, from.at.u, from.at.v);
    const double size = std::hypot(turn.by_u, turn.by_v);
    if (!(size > 0))
        return fail(of, 1);
    const double du = -turn.by_v / size, dv = turn.by_u / size;
    const auto height = [&](double step) {
        const auto s = piece.at(from.at.u + step * du, from.at.v + step * dv);
        return s.value[1] / s.value[2] - from.y;
    };
    constexpr double probe = 1e-3; // step in the parameters
    if (from.is_level) {
        const double bend = (height(probe) + height(-probe)) / (probe * probe);
        if (!(bend > 0))
            return; // two silhouettes end here
        const double step = std::sqrt(2 * (y - from.y) / bend);
        for (const double side : {-step, step})
            add_silhouette(piece, y, {from.at.u + side * du, from.at.v + side * dv, 0}, of);
        return;
    }
    const bool leads_in = is_inside({from.at.u + probe * du, from.at.v + probe * dv, 0});
    const double inward = leads_in ? probe : -probe;
    const double rise = height(inward);
    if (rise > 0)
        add_silhouette(piece, y,
                       {from.at.u + inward * du * (y - from.y) / rise,
                        from.at.v + inward * dv * (y - from.y) / rise, 0},
                       of);
}

void l3d_blinn_plotter::add_silhouette(const l3d_scan_piece& piece, double y, l3d_scan_root start,
                                       const l3d_plot_task& of) {
    constexpr double far = 0.25; // in the parameters: no line is so far from the next
    const l3d_scan_root near{std::clamp(start.u, 0.0, 1.0), std::clamp(start.v, 0.0, 1.0), 0};
    int rounds = 0;
    const auto root = l3d_silhouette_on_line(piece, y, near, accuracy_, rounds);
    of.counts.samples += rounds;
    if (!root || std::hypot(root->u - near.u, root->v - near.v) > far)
        return fail(of, rounds);
    effort_.add(true, rounds);
    if (!is_inside(*root))
        return; // the silhouette ends before this line
    silhouettes_.push_back({*root});
}

void l3d_blinn_plotter::meet_borders(const l3d_scan_piece& piece, double y,
                                     const l3d_plot_task& of) {
    for (border& b : borders_) {
        if (b.is_lost || !b.edge.meets(y))
            continue;
        const double start = b.is_new ? l3d_chord_start(b.edge, y) : b.t;
        b.is_new = false;
        int rounds = 0;
        const auto t = l3d_newton_crossing(b.edge, y, start, accuracy_, rounds);
        of.counts.samples += rounds;
        if (!t) {
            fail(of, rounds);
            b.is_new = true; // on the next line, the search begins at the chord
            continue;
        }
        effort_.add(true, rounds);
        b.t = *t;
        const l3d_image_point h = b.edge.curve.evaluate(*t);
        const l3d_scan_root root = l3d_between(b.edge.from, b.edge.to, *t);
        crossings_[is_front(piece, root)].push_back({h[0] / h[2], root});
    }
}

void l3d_blinn_plotter::meet_silhouettes(const l3d_scan_piece& piece, double y,
                                         const l3d_plot_task& of) {
    for (silhouette& s : silhouettes_) {
        int rounds = 0;
        const auto next =
            l3d_silhouette_on_line(piece, y, {s.at.u + s.du, s.at.v + s.dv, 0}, accuracy_, rounds);
        of.counts.samples += rounds;
        s.is_lost = !next || !is_inside(*next);
        if (!next) {
            // The silhouette ends at a level point below, where no iteration can follow it.
            const bool ends = std::any_of(beginnings_.begin(), beginnings_.end(), [&](auto& b) {
                constexpr double beside = 0.1; // in the parameters
                return b.y < y && b.y > y - 1 &&
                       std::hypot(b.at.u - s.at.u, b.at.v - s.at.v) < beside;
            });
            if (ends)
                effort_.add(true, rounds);
            else
                fail(of, rounds);
            continue;
        }
        effort_.add(true, rounds);
        s = {*next, next->u - s.at.u, next->v - s.at.v, s.is_lost};
    }
    std::erase_if(silhouettes_, [](const silhouette& s) { return s.is_lost; });
    for (; begun_ < beginnings_.size() && beginnings_[begun_].y < y; ++begun_)
        begin_at(beginnings_[begun_], piece, y, of);
    for (const silhouette& s : silhouettes_) {
        const auto h = piece.at(s.at.u, s.at.v).value;
        for (auto& side : crossings_)
            side.push_back({h[0] / h[2], s.at});
    }
}

void l3d_blinn_plotter::scan_side(const l3d_scan_piece& piece, int row, bool front,
                                  const l3d_plot_task& of) {
    if (row < 0)
        return;
    auto& crossings = crossings_[front];
    std::sort(crossings.begin(), crossings.end(),
              [](const l3d_scan_crossing& a, const l3d_scan_crossing& b) { return a.x < b.x; });
    if (crossings.size() % 2 == 1)
        fail(of, 0);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        scan_span(piece, row, front, crossings[i], crossings[i + 1], of);
}

void l3d_blinn_plotter::scan_span(const l3d_scan_piece& piece, int row, bool front,
                                  const l3d_scan_crossing& left, const l3d_scan_crossing& right,
                                  const l3d_plot_task& of) {
    const double centre_x = of.view.size.width / 2.0;
    const double y = row + 0.5 - of.view.size.height / 2.0;
    const int end = std::min(of.view.size.width, l3d_first_centre(right.x + centre_x));
    l3d_scan_root last{}, before{};
    int known = 0; // pixels solved in a row; two predict the third
    for (int column = std::max(0, l3d_first_centre(left.x + centre_x)); column < end; ++column) {
        const double x = column + 0.5 - centre_x;
        const l3d_scan_root start =
            known > 1    ? l3d_between(before, last, 2)
            : known == 1 ? last
                         : l3d_between(left.root, right.root, (x - left.x) / (right.x - left.x));
        int rounds = 0;
        const auto root = piece.find(x, y, start, accuracy_, rounds);
        of.counts.samples += rounds;
        if (!root || is_front(piece, *root) != front) {
            fail(of, rounds);
            known = 0;
            continue;
        }
        effort_.add(true, rounds);
        before = last;
        last = *root;
        ++known;
        const auto inv_w = of.view.depth_at(root->w);
        if (of.canvas.is_nearest(column, row, inv_w))
            of.canvas.put(column, row, inv_w,
                          l3d_unit_normal(of.normals.evaluate(root->u, root->v)));
    }
}
