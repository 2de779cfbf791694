// SPDX-License-Identifier: MIT
// Exact shapes: control points and weights of circles and lines.
#include "geom/nurbs_surface.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <utility>

namespace {

using vector = l3d_vector<double, 3>;

constexpr std::size_t around = 9; // control points of a circle

struct named_shape {
    std::string_view name;
    std::vector<l3d_nurbs_surface> (*make)();
};
constexpr std::array<named_shape, 5> shapes{{{"cone", l3d_cone_surfaces},
                                             {"cylinder", l3d_cylinder_surfaces},
                                             {"disc", l3d_disc_surfaces},
                                             {"sphere", l3d_sphere_surfaces},
                                             {"torus", l3d_torus_surfaces}}};

/// Knots of degree 1 with parameters from 0 to 1, for v of a ruled surface from one curve to
/// another.
l3d_bspline_direction from_0_to_1() {
    return l3d_bspline_direction::clamped(1, 2);
}

double corner_weight() {
    return std::numbers::sqrt2 / 2; // the cosine of 45 degrees, where two tangents meet
}

/// Inserts knots of `to` until each occurs in the curve as often as in `to`.
l3d_nurbs_curve with_knots_of(l3d_nurbs_curve curve, const l3d_nurbs_curve& to) {
    const l3d_bspline_direction& wanted = to.along();
    for (const double t : wanted.knots)
        while (t >= wanted.from && t < wanted.to &&
               std::ranges::count(curve.along().knots, t) < std::ranges::count(wanted.knots, t))
            curve = curve.with_knot(t);
    return curve;
}

/// The surface of a line that turns about the y axis: a cone, a cylinder or a disc.
l3d_nurbs_surface turned_line(const vector& from, const vector& to) {
    return l3d_revolved(l3d_nurbs_curve::polyline({from, to}));
}

} // namespace

l3d_nurbs_surface l3d_revolved(const l3d_nurbs_curve& curve) {
    std::vector<vector> points;
    std::vector<double> weights;
    for (std::size_t row = 0; row < curve.points().size(); ++row) {
        const vector& p = curve.points()[row];
        // A quarter turn maps (x, z) to (z, -x). The tangents at its ends meet at the ends' sum.
        std::array<vector, around> circle{};
        vector now = p;
        for (std::size_t i = 0; i < around; i += 2) {
            const vector next{now[2], now[1], -now[0]};
            circle[i] = now;
            if (i + 1 < around)
                circle[i + 1] = vector{now[0] + next[0], now[1], now[2] + next[2]};
            now = next;
        }
        for (std::size_t i = 0; i < around; ++i) {
            for (int k = 0; k < 3; ++k)
                circle[i][k] += 0.0; // turns -0 into 0
            points.push_back(circle[i]);
            weights.push_back(curve.weight(row) * (i % 2 == 0 ? 1 : corner_weight()));
        }
    }
    return {l3d_nurbs_curve::circle(1).along(), curve.along(), std::move(points),
            std::move(weights)};
}

l3d_nurbs_surface l3d_extruded(const l3d_nurbs_curve& curve, const vector& by) {
    std::vector<vector> moved = curve.points();
    for (vector& p : moved)
        p += by;
    return l3d_ruled(curve, {curve.along(), std::move(moved), curve.weights()});
}

l3d_nurbs_surface l3d_ruled(l3d_nurbs_curve first, l3d_nurbs_curve second) {
    const auto same = [](const l3d_bspline_direction& a, const l3d_bspline_direction& b) {
        return a.degree == b.degree && a.from == b.from && a.to == b.to;
    };
    if (!same(first.along(), second.along()))
        throw l3d_error(l3d_exit::bad_input,
                        "ruled surface: the curves differ in their degrees or ranges");
    first = with_knots_of(std::move(first), second);
    second = with_knots_of(std::move(second), first);
    if (first.along().knots != second.along().knots)
        throw l3d_error(l3d_exit::bad_input,
                        "ruled surface: the curves' knots differ outside of their range");
    std::vector<vector> points = first.points();
    points.insert(points.end(), second.points().begin(), second.points().end());
    std::vector<double> weights;
    if (!first.weights().empty() || !second.weights().empty())
        for (const l3d_nurbs_curve* curve : {&first, &second})
            for (std::size_t i = 0; i < curve->points().size(); ++i)
                weights.push_back(curve->weight(i));
    return {first.along(), from_0_to_1(), std::move(points), std::move(weights)};
}

std::vector<l3d_nurbs_surface> l3d_sphere_surfaces() {
    const double w = corner_weight();
    const l3d_nurbs_curve half({2, {0, 0, 0, 1, 1, 2, 2, 2}, 0, 2},
                               {{0, -1, 0}, {1, -1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                               {1, w, 1, w, 1});
    return {l3d_revolved(half)};
}

std::vector<l3d_nurbs_surface> l3d_cylinder_surfaces() {
    return {turned_line({0, -1, 0}, {1, -1, 0}), turned_line({1, -1, 0}, {1, 1, 0}),
            turned_line({1, 1, 0}, {0, 1, 0})};
}

std::vector<l3d_nurbs_surface> l3d_cone_surfaces() {
    return {turned_line({0, -1, 0}, {1, -1, 0}), turned_line({1, -1, 0}, {0, 1, 0})};
}

std::vector<l3d_nurbs_surface> l3d_torus_surfaces() {
    const l3d_nurbs_curve circle = l3d_nurbs_curve::circle(0.4);
    std::vector<vector> points = circle.points();
    for (vector& p : points)
        p[0] += 1;
    return {l3d_revolved({circle.along(), std::move(points), circle.weights()})};
}

std::vector<l3d_nurbs_surface> l3d_disc_surfaces() {
    return {turned_line({1, 0, 0}, {0, 0, 0})};
}

std::vector<std::string_view> l3d_exact_shape_names() {
    std::vector<std::string_view> names;
    for (const named_shape& shape : shapes)
        names.push_back(shape.name);
    return names;
}

std::optional<std::vector<l3d_nurbs_surface>> l3d_exact_shape(std::string_view name) {
    const auto found = std::ranges::find(shapes, name, &named_shape::name);
    return found == shapes.end() ? std::nullopt : std::optional(found->make());
}
