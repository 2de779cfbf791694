// SPDX-License-Identifier: MIT
// l3d_nurbs_curve: de Boor's scheme on homogeneous points.
#include "geom/nurbs_surface.h"

#include "base/error.h"
#include "geom/bezier_patch.h"
#include "geom/nurbs/spline_lines_p.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

std::string l3d_detail::knot_complaint(const l3d_bspline_direction& d, double t) {
    if (!(t >= d.from && t < d.to))
        return "knot " + std::to_string(t) + " is outside of the range of the parameter";
    return std::ranges::count(d.knots, t) < d.degree
               ? ""
               : "knot " + std::to_string(t) + " is there as often as the degree says";
}

std::string l3d_detail::points_complaint(const std::vector<l3d_vector<double, 3>>& points,
                                         const std::vector<double>& weights, std::size_t wanted) {
    if (points.size() != wanted)
        return std::to_string(points.size()) + " control points; the knots ask for " +
               std::to_string(wanted);
    if (!weights.empty() && weights.size() != wanted)
        return std::to_string(weights.size()) + " weights for " + std::to_string(wanted) +
               " control points";
    for (std::size_t i = 0; i < wanted; ++i) {
        const std::string name = "control point " + std::to_string(i + 1);
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(points[i][k]) <= l3d_bpt_largest_coordinate))
                return name + " is not finite, or beyond 1e12";
        if (!weights.empty() && !l3d_is_weight(weights[i]))
            return name + " has the weight " + std::to_string(weights[i]) +
                   ", which is not from 1e-100 to 1e12";
    }
    return "";
}

l3d_nurbs_curve::l3d_nurbs_curve(l3d_bspline_direction along, std::vector<vector> points,
                                 std::vector<double> weights)
    : along_(std::move(along)), points_(std::move(points)), weights_(std::move(weights)) {
    const std::string why = complaint(along_, points_, weights_);
    if (!why.empty())
        throw l3d_error(l3d_exit::bad_input, why);
}

std::string l3d_nurbs_curve::complaint(const l3d_bspline_direction& along,
                                       const std::vector<vector>& points,
                                       const std::vector<double>& weights) {
    std::string why = along.complaint();
    if (why.empty())
        why = l3d_detail::points_complaint(points, weights, along.points());
    return why.empty() ? why : "curve: " + why;
}

l3d_nurbs_curve l3d_nurbs_curve::polyline(std::vector<vector> points) {
    if (points.size() < 2)
        throw l3d_error(l3d_exit::bad_input, "curve: a polyline of fewer than 2 points");
    const auto along = l3d_bspline_direction::clamped(1, points.size());
    return {along, std::move(points)};
}

l3d_nurbs_curve l3d_nurbs_curve::circle(double radius) {
    // Four quarter circles of degree 2. The weight where tangents meet is the cosine of 45 degrees.
    constexpr double x[9] = {1, 1, 0, -1, -1, -1, 0, 1, 1};
    constexpr double y[9] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    std::vector<vector> points;
    std::vector<double> weights;
    for (std::size_t i = 0; i < 9; ++i) {
        points.push_back({radius * x[i], radius * y[i], 0.0});
        weights.push_back(i % 2 == 0 ? 1 : std::numbers::sqrt2 / 2);
    }
    return {{2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, 0, 4}, std::move(points), std::move(weights)};
}

l3d_vector<double, 4> l3d_nurbs_curve::homogeneous(std::size_t index) const {
    const vector& p = points_[index];
    const double w = weight(index);
    return {p[0] * w, p[1] * w, p[2] * w, w};
}

l3d_nurbs_curve::vector l3d_nurbs_curve::evaluate(double t) const {
    return l3d_projected<double, 4>(l3d_detail::spline_derivative(
        along_, t, 0, [this](std::size_t i) { return homogeneous(i); }));
}

/// Finds derivatives by the product rule. S w = P gives S' = (P' - S w') / w and S'' = (P'' - 2 S'
/// w' - S w'') / w.
l3d_curve_jet l3d_nurbs_curve::derivatives(double t) const {
    l3d_vector<double, 4> p[3];
    for (int order = 0; order < 3; ++order)
        p[order] = l3d_detail::spline_derivative(along_, t, order,
                                                 [this](std::size_t i) { return homogeneous(i); });
    l3d_curve_jet result;
    const double w = p[0][3];
    for (int k = 0; k < 3; ++k) {
        result.place[k] = p[0][k] / w;
        result.first[k] = (p[1][k] - result.place[k] * p[1][3]) / w;
        result.second[k] =
            (p[2][k] - 2 * result.first[k] * p[1][3] - result.place[k] * p[2][3]) / w;
    }
    return result;
}

l3d_nurbs_curve l3d_nurbs_curve::with_knot(double t) const {
    const std::string why = l3d_detail::knot_complaint(along_, t);
    if (!why.empty())
        throw l3d_error(l3d_exit::bad_input, "curve: " + why);
    std::vector<vector> points;
    std::vector<double> weights;
    for (const auto& p :
         l3d_detail::with_knot(along_, t, [this](std::size_t i) { return homogeneous(i); })) {
        points.push_back(l3d_projected<double, 4>(p));
        if (!weights_.empty())
            weights.push_back(p[3]);
    }
    return {l3d_detail::with_knot(along_, t), std::move(points), std::move(weights)};
}
