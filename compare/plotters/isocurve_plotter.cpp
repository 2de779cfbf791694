// SPDX-License-Identifier: MIT
// l3d_isocurve_plotter: chooses curves, and walks along them.
#include "compare/plotters/isocurve_plotter.h"

#include "geom/forward_difference.h"
#include "geom/real.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace {

/// A stripe that is longer than this is cut across, so that a part of it can be narrow. A shorter
/// curve would cost more to begin than to walk.
constexpr double least_length = 8;

/// The most halvings of a patch in all, and of a curve's step: 2^-20 of a curve would be a million
/// points.
constexpr int deepest = 40, most_halvings = 20;

/// Bound of a piece's extent along u in the picture, the larger of its width and height. Let (X, Y)
/// be the middle of its box and r half its larger side. Then dX/du = (x_u - X w_u) / w, and x_u is
/// three times a mean of the net's differences.
double width_bound(const l3d_image_patch& net, const l3d_image_box& hull) {
    const double x = (hull.left + hull.right) / 2, y = (hull.top + hull.bottom) / 2;
    const double r = std::max(hull.width(), hull.height()) / 2;
    double widest = 0, least_w = std::numeric_limits<double>::infinity();
    for (int row = 0; row < 4; ++row)
        for (int c = 0; c < 4; ++c) {
            least_w = std::min(least_w, net.at(row, c)[2]);
            if (c == 3)
                continue;
            const l3d_image_point d = net.at(row, c + 1) - net.at(row, c);
            const double across = std::max(std::abs(d[0] - x * d[2]), std::abs(d[1] - y * d[2]));
            widest = std::max(widest, across + r * std::abs(d[2]));
        }
    return std::min(3 * widest / least_w, 2 * r);
}

struct place {
    double x, y;
};

place place_of(double x, double y, double w) {
    return {x / w, y / w};
}

double distance(const place& a, const place& b) {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

} // namespace

template <class T>
void l3d_isocurve_plotter<T>::plot(const l3d_image_patch& net, const l3d_plot_task& of) {
    normals_.resize(1);
    draw_curve(net.column(0), 0, 0, 1, of);
    draw_curve(net.column(3), 1, 0, 1, of);
    fill({net}, of);
    of.counts.bound_px = std::numeric_limits<double>::infinity();
}

template <class T>
void l3d_isocurve_plotter<T>::fill(const stripe& between, const l3d_plot_task& of) {
    const l3d_image_box hull = l3d_image_box_of(between.net.points);
    if (hull.intersected(of.view.margin()).empty())
        return;
    if (width_bound(between.net, hull) <= spacing_ || between.depth == deepest)
        return;
    if (std::max(hull.width(), hull.height()) > least_length) {
        const auto [low, high] = l3d_halves(between, false);
        const auto width_of = [](const l3d_image_patch& net) {
            return width_bound(net, l3d_image_box_of(net.points));
        };
        // A cut is worth while if one half needs no more curves, or fewer.
        const double first = width_of(low.net), second = width_of(high.net);
        if (std::min(first, second) < 0.75 * std::max(first, second)) {
            fill(low, of);
            fill(high, of);
            return;
        }
    }
    const auto [low, high] = l3d_halves(between, true);
    draw_curve(low.net.column(3), low.u1, between.v0, between.v1, of);
    fill(low, of);
    fill(high, of);
}

/// Walks a curve. The parameter is counted in units of 2^-most_halvings of the curve.
template <class T>
void l3d_isocurve_plotter<T>::draw_curve(const l3d_image_curve& curve, double u, double v0,
                                         double v1, const l3d_plot_task& of) {
    normals_.set(0, of.normals, u);
    std::array<l3d_forward_difference<T, 3>, 3> walk;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<int>(k);
        const auto& p = curve.points;
        walk[k] = l3d_forward_difference<T, 3>::build({p[0][i], p[1][i], p[2][i], p[3][i]}, 1);
    }
    constexpr std::int64_t end = std::int64_t{1} << most_halvings;
    std::int64_t time = 0, step = end;
    const auto value = [&](std::size_t k) { return l3d_to_double(walk[k].d[0]); };
    const auto next = [&](std::size_t k) { return l3d_to_double(walk[k].d[0] + walk[k].d[1]); };
    place here = place_of(value(0), value(1), value(2));
    put({value(0), value(1), value(2)}, v0, of);
    while (time < end) {
        const place there = place_of(next(0), next(1), next(2));
        const double length = distance(here, there);
        if (!(length <= spacing_) && step > 1) {
            for (auto& coordinate : walk)
                coordinate.halve();
            step /= 2;
            continue;
        }
        for (auto& coordinate : walk)
            coordinate.step();
        time += step;
        here = there;
        put({value(0), value(1), value(2)},
            v0 + (v1 - v0) * static_cast<double>(time) / static_cast<double>(end), of);
        if (length < spacing_ / 2 && time < end && time % (2 * step) == 0 &&
            time + 2 * step <= end) {
            for (auto& coordinate : walk)
                coordinate.double_step();
            step *= 2;
        }
    }
}

template <class T>
void l3d_isocurve_plotter<T>::put(const l3d_image_point& h, double v, const l3d_plot_task& of) {
    ++of.counts.samples;
    const l3d_size size = of.canvas.size();
    const double x = h[0] / h[2] + size.width / 2.0, y = h[1] / h[2] + size.height / 2.0;
    // The condition is written so that NaN counts as outside.
    if (!(x >= 0 && y >= 0 && x < size.width && y < size.height && h[2] > 0))
        return;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const auto inv_w = static_cast<float>(of.view.depth_scale / h[2]);
    if (!of.canvas.is_nearest(column, row, inv_w))
        return;
    std::array<float, 3> normal;
    normals_.emit(v, &normal[0], &normal[1], &normal[2]);
    of.canvas.put(column, row, inv_w, normal);
}

template class l3d_isocurve_plotter<float>;
template class l3d_isocurve_plotter<double>;
template class l3d_isocurve_plotter<l3d_fixed<std::int64_t, 32>>;
