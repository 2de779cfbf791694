// SPDX-License-Identifier: MIT
// l3d_scan_edge: cuts curves, and finds where they cross scan lines.
#include "compare/plotters/scan_edges.h"

#include <algorithm>

namespace {

/// The most halvings of a curve until it rises or falls from end to end.
constexpr int deepest = 16;

/// Whether control points prove that a curve rises, or falls, from end to end. Its derivative has
/// the sign of y_t - Y w_t at the curve's own Y, which lies between `top` and `bottom`.
bool is_monotone(const l3d_image_curve& curve, double top, double bottom) {
    bool rises = true, falls = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const l3d_image_point d = curve.points[i + 1] - curve.points[i];
        const double at_top = d[1] - top * d[2], at_bottom = d[1] - bottom * d[2];
        rises = rises && at_top >= 0 && at_bottom >= 0;
        falls = falls && at_top <= 0 && at_bottom <= 0;
    }
    return rises || falls;
}

void add(const l3d_image_curve& curve, l3d_scan_root from, l3d_scan_root to, int depth,
         std::vector<l3d_scan_edge>& edges) {
    const l3d_image_box hull = l3d_image_box_of(curve.points);
    if (is_monotone(curve, hull.top, hull.bottom) || depth == deepest) {
        const double first = curve.points[0][1] / curve.points[0][2];
        const double last = curve.points[3][1] / curve.points[3][2];
        if (first < last)
            edges.push_back({curve, first, last, from, to});
        else if (last < first)
            edges.push_back({curve.reversed(), last, first, to, from});
        return;
    }
    const auto [low, high] = curve.split();
    const l3d_scan_root middle = l3d_between(from, to, 0.5);
    add(low, from, middle, depth + 1, edges);
    add(high, middle, to, depth + 1, edges);
}

/// The function y(t) - Y w(t) as a polynomial. It is 0 where the curve crosses the scan line Y.
struct height {
    height(const l3d_scan_edge& edge, double y) {
        const auto& p = edge.curve.points;
        const auto above = [y](const l3d_image_point& h) { return h[1] - y * h[2]; };
        const double b1 = above(p[1]), b2 = above(p[2]), b3 = above(p[3]);
        b0 = above(p[0]);
        a1 = 3 * (b1 - b0);
        a2 = 3 * (b2 - b1) - a1;
        a3 = b3 - b0 - a1 - a2;
    }
    double at(double t) const { return ((a3 * t + a2) * t + a1) * t + b0; }
    double slope(double t) const { return (3 * a3 * t + 2 * a2) * t + a1; }

    double b0, a1, a2, a3;
};

} // namespace

void l3d_add_scan_edges(const l3d_image_curve& curve, l3d_scan_root from, l3d_scan_root to,
                        std::vector<l3d_scan_edge>& edges) {
    add(curve, from, to, 0, edges);
}

double l3d_chord_start(const l3d_scan_edge& edge, double y) {
    return (y - edge.top) / (edge.bottom - edge.top);
}

l3d_scan_crossing l3d_guarded_crossing(const l3d_scan_edge& edge, double y) {
    constexpr double accuracy = 1e-9; // in the parameter
    constexpr int most_rounds = 60;
    const height of(edge, y);
    double low = 0, high = 1, t = l3d_chord_start(edge, y);
    for (int round = 0; round < most_rounds; ++round) {
        const double value = of.at(t);
        (value < 0 ? low : high) = t;
        const double newton = t - value / of.slope(t);
        const double next = newton > low && newton < high ? newton : (low + high) / 2;
        const bool rests = std::abs(next - t) <= accuracy;
        t = next;
        if (rests)
            break;
    }
    const l3d_image_point h = edge.curve.evaluate(t);
    return {h[0] / h[2], l3d_between(edge.from, edge.to, t)};
}

std::optional<double> l3d_newton_crossing(const l3d_scan_edge& edge, double y, double start,
                                          double accuracy, int& rounds) {
    constexpr double rim = 1e-9; // in the parameter: a rounding
    const height of(edge, y);
    const auto& p = edge.curve.points;
    const double least = std::min({p[0][2], p[1][2], p[2][2], p[3][2]});
    double t = start;
    for (int round = 0; round < l3d_scan_piece::most_rounds; ++round) {
        ++rounds;
        const double value = of.at(t);
        if (std::abs(value) <= accuracy * least)
            return t >= -rim && t <= 1 + rim ? std::optional(t) : std::nullopt;
        const double slope = of.slope(t);
        if (!(slope != 0))
            return std::nullopt;
        // Steps that leave the edge by more than its own length lead nowhere, so they are clamped.
        t = std::clamp(t - value / slope, -1.0, 2.0);
    }
    return std::nullopt;
}

/// Finds the control points of a part by blossoms: point k has the parameters `from` 3 - k times
/// and `to` k times.
l3d_image_curve l3d_curve_part(const l3d_image_curve& curve, double from, double to) {
    l3d_image_curve result;
    for (std::size_t k = 0; k < 4; ++k) {
        auto p = curve.points;
        for (std::size_t level = 3; level > 0; --level)
            for (std::size_t i = 0; i < level; ++i)
                p[i] = l3d_lerp<double, 3>(p[i], p[i + 1], level <= k ? to : from);
        result.points[k] = p[0];
    }
    return result;
}
