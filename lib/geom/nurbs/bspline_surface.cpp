// SPDX-License-Identifier: MIT
// l3d_bspline_surface: Bezier points by blossoming.
#include "geom/nurbs_surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace {

/// A control point, as given and in homogeneous coordinates. A point that `between` does not change
/// keeps its given coordinates exactly.
struct control_point {
    std::array<double, 3> place{};
    std::array<double, 4> weighted{}; ///< homogeneous: x w, y w, z w, w

    friend bool operator==(const control_point&, const control_point&) = default;
};
using curve = std::vector<control_point>;

/// A line of control points with a stride. The first `absent` points were not computed, as no
/// wanted segment depends on them.
struct control_line {
    const control_point* first;
    std::size_t stride, absent;
    const control_point& operator[](std::size_t i) const { return first[(i - absent) * stride]; }
};

/// Whether the knot span that begins at knots[span] overlaps the wanted range.
bool is_wanted(const l3d_bspline_direction& d, std::size_t span) {
    return std::max(d.knots[span], d.from) < std::min(d.knots[span + 1], d.to);
}

/// The control points on which wanted spans depend: the first index, and the end.
std::pair<std::size_t, std::size_t> needed_points(const l3d_bspline_direction& d) {
    const auto n = static_cast<std::size_t>(d.degree);
    std::size_t first = n;
    while (!is_wanted(d, first))
        ++first;
    std::size_t last = d.points() - 1;
    while (!is_wanted(d, last))
        --last;
    return {first - n, last + 1};
}

/// The weighted mean of two control points: exactly a or b if the other's weight is 0. The mean is
/// clamped between a and b, so that coordinates stay below their limit.
control_point between(const control_point& a, const control_point& b, double weight_a,
                      double weight_b) {
    if (weight_b == 0 || a == b)
        return a;
    if (weight_a == 0)
        return b;
    control_point result;
    const auto clamped = [](double value, double at_a, double at_b) {
        return std::clamp(value, std::min(at_a, at_b), std::max(at_a, at_b));
    };
    for (std::size_t k = 0; k < 4; ++k)
        result.weighted[k] =
            clamped((weight_a * a.weighted[k] + weight_b * b.weighted[k]) / (weight_a + weight_b),
                    a.weighted[k], b.weighted[k]);
    for (std::size_t k = 0; k < 3; ++k)
        result.place[k] = clamped(result.weighted[k] / result.weighted[3], a.place[k], b.place[k]);
    return result;
}

/// Bezier point `index` of the segment over [a, b], which lies in the knot span that begins at
/// knots[span].
control_point blossom(const l3d_bspline_direction& d, const control_line& points, std::size_t span,
                      double a, double b, std::size_t index) {
    const auto n = static_cast<std::size_t>(d.degree);
    curve level(n + 1);
    for (std::size_t i = 0; i <= n; ++i)
        level[i] = points[span - n + i];
    for (std::size_t step = 1; step <= n; ++step) {
        const double t = step <= n - index ? a : b;
        for (std::size_t i = n; i >= step; --i) {
            const double low = d.knots[span - n + i];
            const double high = d.knots[span + 1 + i - step];
            level[i] = between(level[i - 1], level[i], high - t, t - low);
        }
    }
    return level[n];
}

/// Appends the Bezier points of all wanted segments, one segment after another.
void append_segments(const l3d_bspline_direction& d, const control_line& points, curve& result) {
    const auto n = static_cast<std::size_t>(d.degree);
    for (std::size_t span = n; span < d.points(); ++span) {
        if (!is_wanted(d, span))
            continue;
        const double a = std::max(d.knots[span], d.from);
        const double b = std::min(d.knots[span + 1], d.to);
        // Neighbours compute their common point from the same control points by the same
        // operations, and weights of zero pick a point without rounding. So the point agrees bit
        // for bit.
        for (std::size_t index = 0; index <= n; ++index)
            result.push_back(blossom(d, points, span, a, b, index));
    }
}

} // namespace

std::size_t l3d_bspline_direction::segments() const {
    std::size_t result = 0;
    for (auto span = static_cast<std::size_t>(degree); span < points(); ++span)
        result += is_wanted(*this, span) ? 1 : 0;
    return result;
}

std::string l3d_bspline_direction::complaint() const {
    if (degree < 1 || degree > l3d_bpt_largest_degree)
        return "degree " + std::to_string(degree) + " is not from 1 to " +
               std::to_string(l3d_bpt_largest_degree);
    const auto n = static_cast<std::size_t>(degree);
    if (knots.size() < 2 * (n + 1))
        return std::to_string(knots.size()) + " knots are fewer than twice the degree and 2";
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const std::string name = "knot " + std::to_string(i + 1);
        if (!(std::abs(knots[i]) <= l3d_bpt_largest_coordinate))
            return name + " is not finite, or beyond 1e12";
        if (i > 0 && knots[i] < knots[i - 1])
            return name + " is less than the one before";
        if (i > n && knots[i] == knots[i - n] && knots[i] > knots[n] && knots[i] < knots[points()])
            return name + " is there more often than the degree";
    }
    if (!(knots[n] <= from && from < to && to <= knots[points()]))
        return "the range of the parameter is empty, or the knots do not cover it";
    return "";
}

l3d_bspline_direction l3d_bspline_direction::clamped(int degree, std::size_t points) {
    const auto n = static_cast<std::size_t>(degree);
    assert(degree >= 1 && points > n);
    l3d_bspline_direction result{degree, std::vector<double>(n + 1, 0.0), 0, 1};
    const std::size_t spans = points - n;
    for (std::size_t i = 1; i < spans; ++i)
        result.knots.push_back(static_cast<double>(i) / static_cast<double>(spans));
    result.knots.insert(result.knots.end(), n + 1, 1.0);
    return result;
}

l3d_bspline_direction l3d_bspline_direction::periodic(int degree, std::size_t points) {
    const auto n = static_cast<std::size_t>(degree);
    assert(degree >= 1 && points > 2 * n);
    l3d_bspline_direction result{degree, {}, 0, 1};
    for (std::size_t i = 0; i < points + n + 1; ++i)
        result.knots.push_back((static_cast<double>(i) - static_cast<double>(n)) /
                               static_cast<double>(points - n));
    return result;
}

std::vector<l3d_patch_points> l3d_bezier_patches(const l3d_bspline_direction& u,
                                                 const l3d_bspline_direction& v,
                                                 const std::vector<std::array<double, 3>>& points,
                                                 std::span<const double> weights) {
    assert(points.size() == u.points() * v.points());
    assert(weights.empty() || weights.size() == points.size());
    const auto columns = static_cast<std::size_t>(u.degree) + 1; // control points across a patch
    const auto rows = static_cast<std::size_t>(v.degree) + 1;
    const std::size_t width = u.segments() * columns;
    const std::size_t height = v.segments() * rows;

    curve net(points.size());
    for (std::size_t i = 0; i < net.size(); ++i) {
        const double w = weights.empty() ? 1 : weights[i];
        net[i] = {points[i], {points[i][0] * w, points[i][1] * w, points[i][2] * w, w}};
    }
    const auto [first_row, end_row] = needed_points(v);
    curve wide; // Bezier points along u, control points along v
    wide.reserve(width * (end_row - first_row));
    for (std::size_t row = first_row; row < end_row; ++row)
        append_segments(u, {&net[row * u.points()], 1, 0}, wide);
    curve lines; // Bezier points along u and v, column by column
    lines.reserve(width * height);
    for (std::size_t column = 0; column < width; ++column)
        append_segments(v, {&wide[column], width, first_row}, lines);

    std::vector<l3d_patch_points> result(u.segments() * v.segments());
    for (l3d_patch_points& patch : result) {
        const auto index = static_cast<std::size_t>(&patch - result.data());
        const std::size_t left = index % u.segments() * columns;
        const std::size_t top = index / u.segments() * rows;
        patch = {u.degree, v.degree, {}};
        patch.points.reserve(columns * rows);
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t column = 0; column < columns; ++column) {
                const control_point& p = lines[(left + column) * height + top + row];
                patch.points.push_back(p.place);
                if (!weights.empty())
                    patch.weights.push_back(p.weighted[3]);
            }
    }
    return result;
}
