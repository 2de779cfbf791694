// SPDX-License-Identifier: MIT
// l3d_scanline_plotter: pieces, borders, spans.
#include "compare/scanline_plotter.h"

#include "dice/normal_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// Pieces with silhouettes are cut to this size, in pixels: then few hold more than one centre.
constexpr double smallest = 1;

/// Halvings of a patch in all, and of a border until it rises or falls from end to end.
constexpr int deepest = 40, deepest_stretch = 16;

/// First pixel centre, x + 1/2, at or after a position.
int first_centre(double position) {
    return static_cast<int>(std::ceil(position - 0.5));
}

/// Whether a curve's control points say that it rises, or falls, from end to end: y' has the sign
/// of y_t - Y w_t at the curve's own Y, which lies between `top` and `bottom`.
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

l3d_scan_root between(const l3d_scan_root& a, const l3d_scan_root& b, double t) {
    return {a.u + (b.u - a.u) * t, a.v + (b.v - a.v) * t, 0};
}

} // namespace

void l3d_scanline_plotter::plot(const l3d_image_patch& net, const l3d_plot_task& of) {
    accuracy_ = of.view.tolerance / 8;
    divide({net}, of);
    of.counts.bound_px = std::numeric_limits<double>::infinity();
}

void l3d_scanline_plotter::divide(const piece& p, const l3d_plot_task& of) {
    const l3d_image_box hull = l3d_image_box_of(p.net.points);
    const l3d_image_box seen = hull.intersected(of.view.window());
    const double centre_x = of.view.size.width / 2.0, centre_y = of.view.size.height / 2.0;
    if (seen.empty() || first_centre(seen.left + centre_x) > seen.right + centre_x - 0.5 ||
        first_centre(seen.top + centre_y) > seen.bottom + centre_y - 0.5)
        return;
    ++of.counts.pieces;
    if (l3d_is_one_to_one(p.net, hull))
        return scan(p, hull, of);
    if (std::max(hull.width(), hull.height()) <= smallest || p.depth == deepest)
        return try_pixels(p, hull, of);
    const auto length = [&](int line, bool along_u) {
        double sum = 0;
        for (int i = 0; i < 3; ++i) {
            const auto& a = along_u ? p.net.at(line, i) : p.net.at(i, line);
            const auto& b = along_u ? p.net.at(line, i + 1) : p.net.at(i + 1, line);
            sum += std::hypot(a[0] / a[2] - b[0] / b[2], a[1] / a[2] - b[1] / b[2]);
        }
        return sum;
    };
    const auto longest = [&](bool along_u) {
        return std::max(
            {length(0, along_u), length(1, along_u), length(2, along_u), length(3, along_u)});
    };
    for (const piece& half : l3d_halves(p, longest(true) >= longest(false)))
        divide(half, of);
}

void l3d_scanline_plotter::add_stretches(const l3d_image_curve& curve, l3d_scan_root from,
                                         l3d_scan_root to, int depth) {
    const l3d_image_box hull = l3d_image_box_of(curve.points);
    if (is_monotone(curve, hull.top, hull.bottom) || depth == deepest_stretch) {
        const double first = curve.points[0][1] / curve.points[0][2];
        const double last = curve.points[3][1] / curve.points[3][2];
        if (first < last)
            stretches_.push_back({curve, first, last, from, to});
        else if (last < first)
            stretches_.push_back({curve.reversed(), last, first, to, from});
        return;
    }
    const auto [low, high] = curve.split();
    const l3d_scan_root middle = between(from, to, 0.5);
    add_stretches(low, from, middle, depth + 1);
    add_stretches(high, middle, to, depth + 1);
}

/// Newton's iteration for y(t) - Y w(t) = 0, with halving where it would leave the bracket.
l3d_scanline_plotter::crossing l3d_scanline_plotter::meet(const stretch& s, double y) {
    constexpr double accuracy = 1e-9; // of the parameter
    constexpr int most_rounds = 60;
    const auto& p = s.curve.points;
    const auto height = [y](const l3d_image_point& h) { return h[1] - y * h[2]; };
    const double b0 = height(p[0]), b1 = height(p[1]), b2 = height(p[2]), b3 = height(p[3]);
    const double a1 = 3 * (b1 - b0), a2 = 3 * (b2 - b1) - a1, a3 = b3 - b0 - a1 - a2;
    double low = 0, high = 1, t = (y - s.top) / (s.bottom - s.top);
    for (int round = 0; round < most_rounds; ++round) {
        const double value = ((a3 * t + a2) * t + a1) * t + b0;
        (value < 0 ? low : high) = t;
        const double slope = (3 * a3 * t + 2 * a2) * t + a1;
        const double newton = t - value / slope;
        const double next = newton > low && newton < high ? newton : (low + high) / 2;
        const bool rests = std::abs(next - t) <= accuracy;
        t = next;
        if (rests)
            break;
    }
    const l3d_image_point h = s.curve.evaluate(t);
    return {h[0] / h[2], between(s.from, s.to, t)};
}

void l3d_scanline_plotter::scan(const piece& p, const l3d_image_box& hull,
                                const l3d_plot_task& of) {
    stretches_.clear();
    add_stretches(p.net.row(0), {0, 0, 0}, {1, 0, 0}, 0);
    add_stretches(p.net.row(3), {0, 1, 0}, {1, 1, 0}, 0);
    add_stretches(p.net.column(0), {0, 0, 0}, {0, 1, 0}, 0);
    add_stretches(p.net.column(3), {1, 0, 0}, {1, 1, 0}, 0);
    const l3d_scan_piece powers(p.net);
    const double middle = of.view.size.height / 2.0;
    const int end = std::min(of.view.size.height, first_centre(hull.bottom + middle) + 1);
    for (int row = std::max(0, first_centre(hull.top + middle)); row < end; ++row) {
        const double y = row + 0.5 - middle;
        crossings_.clear();
        for (const stretch& s : stretches_)
            if (s.top <= y && y < s.bottom)
                crossings_.push_back(meet(s, y));
        std::sort(crossings_.begin(), crossings_.end(),
                  [](const crossing& a, const crossing& b) { return a.x < b.x; });
        for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2)
            scan_span(p, powers, row, crossings_[i], crossings_[i + 1], of);
    }
}

void l3d_scanline_plotter::scan_span(const piece& p, const l3d_scan_piece& powers, int row,
                                     const crossing& left, const crossing& right,
                                     const l3d_plot_task& of) {
    const double centre_x = of.view.size.width / 2.0;
    const double y = row + 0.5 - of.view.size.height / 2.0;
    const int end = std::min(of.view.size.width, first_centre(right.x + centre_x));
    // Two solved pixels foretell the third.
    l3d_scan_root last = left.root, before = left.root;
    bool straight_on = false;
    for (int column = std::max(0, first_centre(left.x + centre_x)); column < end; ++column) {
        const double x = column + 0.5 - centre_x;
        const l3d_scan_root start =
            straight_on ? between(before, last, 2)
                        : between(left.root, right.root, (x - left.x) / (right.x - left.x));
        ++of.counts.samples;
        std::optional<l3d_scan_root> root = powers.find(x, y, start, accuracy_);
        if (!root)
            root = powers.find(x, y, left.root, accuracy_);
        if (!root)
            root = powers.find(x, y, right.root, accuracy_);
        if (!root) {
            ++of.counts.failures;
            straight_on = false;
            continue;
        }
        straight_on = column > 0 && last.w > 0;
        before = last;
        last = *root;
        put(p, column, row, *root, of);
    }
}

void l3d_scanline_plotter::try_pixels(const piece& p, const l3d_image_box& hull,
                                      const l3d_plot_task& of) {
    const l3d_scan_piece powers(p.net);
    const double centre_x = of.view.size.width / 2.0, centre_y = of.view.size.height / 2.0;
    const int right = std::min(of.view.size.width, first_centre(hull.right + centre_x) + 1);
    const int bottom = std::min(of.view.size.height, first_centre(hull.bottom + centre_y) + 1);
    for (int row = std::max(0, first_centre(hull.top + centre_y)); row < bottom; ++row)
        for (int column = std::max(0, first_centre(hull.left + centre_x)); column < right;
             ++column) {
            ++of.counts.samples;
            for (const auto& [u, v] :
                 {std::pair{0.5, 0.5}, {0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}})
                if (const auto root = powers.find(column + 0.5 - centre_x, row + 0.5 - centre_y,
                                                  {u, v, 0}, accuracy_))
                    put(p, column, row, *root, of);
        }
}

void l3d_scanline_plotter::put(const piece& p, int column, int row, const l3d_scan_root& root,
                               const l3d_plot_task& of) {
    const auto inv_w = static_cast<float>(of.view.depth_scale / root.w);
    if (of.canvas.is_nearest(column, row, inv_w))
        of.canvas.put(column, row, inv_w,
                      l3d_unit_normal(of.normals.evaluate(p.u0 + (p.u1 - p.u0) * root.u,
                                                          p.v0 + (p.v1 - p.v0) * root.v)));
}
