// SPDX-License-Identifier: MIT
// l3d_scanline_plotter: cuts patches into pieces, and fills spans between their borders.
#include "compare/plotters/scanline_plotter.h"

#include "dice/normal_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// The size in pixels to which pieces with silhouettes are cut. Few pieces of that size hold more
/// than one centre.
constexpr double smallest = 1;

/// The most halvings of a patch in all.
constexpr int deepest = 40;

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
    if (seen.empty() || l3d_first_centre(seen.left + centre_x) > seen.right + centre_x - 0.5 ||
        l3d_first_centre(seen.top + centre_y) > seen.bottom + centre_y - 0.5)
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

void l3d_scanline_plotter::scan(const piece& p, const l3d_image_box& hull,
                                const l3d_plot_task& of) {
    edges_.clear();
    l3d_add_scan_edges(p.net.row(0), {0, 0, 0}, {1, 0, 0}, edges_);
    l3d_add_scan_edges(p.net.row(3), {0, 1, 0}, {1, 1, 0}, edges_);
    l3d_add_scan_edges(p.net.column(0), {0, 0, 0}, {0, 1, 0}, edges_);
    l3d_add_scan_edges(p.net.column(3), {1, 0, 0}, {1, 1, 0}, edges_);
    const l3d_scan_piece powers(p.net);
    const double middle = of.view.size.height / 2.0;
    const int end = std::min(of.view.size.height, l3d_first_centre(hull.bottom + middle) + 1);
    for (int row = std::max(0, l3d_first_centre(hull.top + middle)); row < end; ++row) {
        const double y = row + 0.5 - middle;
        crossings_.clear();
        for (const l3d_scan_edge& edge : edges_)
            if (edge.meets(y))
                crossings_.push_back(l3d_guarded_crossing(edge, y));
        std::sort(crossings_.begin(), crossings_.end(),
                  [](const l3d_scan_crossing& a, const l3d_scan_crossing& b) { return a.x < b.x; });
        for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2)
            scan_span(p, powers, row, crossings_[i], crossings_[i + 1], of);
    }
}

void l3d_scanline_plotter::scan_span(const piece& p, const l3d_scan_piece& powers, int row,
                                     const l3d_scan_crossing& left, const l3d_scan_crossing& right,
                                     const l3d_plot_task& of) {
    const double centre_x = of.view.size.width / 2.0;
    const double y = row + 0.5 - of.view.size.height / 2.0;
    const int end = std::min(of.view.size.width, l3d_first_centre(right.x + centre_x));
    // Two solved pixels predict the third.
    l3d_scan_root last = left.root, before = left.root;
    bool straight_on = false;
    for (int column = std::max(0, l3d_first_centre(left.x + centre_x)); column < end; ++column) {
        const double x = column + 0.5 - centre_x;
        const l3d_scan_root start =
            straight_on ? l3d_between(before, last, 2)
                        : l3d_between(left.root, right.root, (x - left.x) / (right.x - left.x));
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
    const int right = std::min(of.view.size.width, l3d_first_centre(hull.right + centre_x) + 1);
    const int bottom = std::min(of.view.size.height, l3d_first_centre(hull.bottom + centre_y) + 1);
    for (int row = std::max(0, l3d_first_centre(hull.top + centre_y)); row < bottom; ++row)
        for (int column = std::max(0, l3d_first_centre(hull.left + centre_x)); column < right;
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
    const auto inv_w = of.view.depth_at(root.w);
    if (of.canvas.is_nearest(column, row, inv_w))
        of.canvas.put(column, row, inv_w,
                      l3d_unit_normal(of.normals.evaluate(p.u0 + (p.u1 - p.u0) * root.u,
                                                          p.v0 + (p.v1 - p.v0) * root.v)));
}
