// SPDX-License-Identifier: MIT
// l3d_nurbs_surface: de Boor's scheme on homogeneous points, along u and then along v.
#include "geom/nurbs_surface.h"

#include "base/error.h"
#include "geom/bezier_patch.h"
#include "geom/nurbs/spline_lines_p.h"

#include <array>
#include <utility>

using weighted = l3d_detail::weighted;

l3d_nurbs_surface::l3d_nurbs_surface(l3d_bspline_direction u, l3d_bspline_direction v,
                                     std::vector<vector> points, std::vector<double> weights)
    : u_(std::move(u)), v_(std::move(v)), points_(std::move(points)), weights_(std::move(weights)) {
    const std::string why = complaint(u_, v_, points_, weights_);
    if (!why.empty())
        throw l3d_error(l3d_exit::bad_input, why);
}

l3d_nurbs_surface l3d_nurbs_surface::of_patch(const l3d_patch_points& patch) {
    const auto along = [](int degree) {
        return l3d_bspline_direction::clamped(degree, static_cast<std::size_t>(degree) + 1);
    };
    std::vector<vector> points;
    for (const auto& [x, y, z] : patch.points)
        points.push_back({x, y, z});
    l3d_nurbs_surface result{along(patch.degree_u), along(patch.degree_v), std::move(points),
                             patch.weights};
    result.trims_ = patch.trims;
    return result;
}

void l3d_nurbs_surface::set_point(std::size_t index, const vector& place, double weight) {
    points_[index] = place;
    if (weights_.empty() && weight != 1)
        weights_.assign(points_.size(), 1);
    if (!weights_.empty())
        weights_[index] = weight;
}

std::string l3d_nurbs_surface::complaint(const l3d_bspline_direction& u,
                                         const l3d_bspline_direction& v,
                                         const std::vector<vector>& points,
                                         const std::vector<double>& weights) {
    if (const std::string why = u.complaint(); !why.empty())
        return "surface: along u: " + why;
    if (const std::string why = v.complaint(); !why.empty())
        return "surface: along v: " + why;
    const std::string why = l3d_detail::points_complaint(points, weights, u.points() * v.points());
    return why.empty() ? why : "surface: " + why;
}

weighted l3d_nurbs_surface::homogeneous(std::size_t column, std::size_t row) const {
    const std::size_t index = row * u_.points() + column;
    const vector& p = points_[index];
    const double w = weights_.empty() ? 1 : weights_[index];
    return {p[0] * w, p[1] * w, p[2] * w, w};
}

weighted l3d_nurbs_surface::derivative(double u, double v, int by_u, int by_v) const {
    const auto row = [&](std::size_t r) {
        return l3d_detail::spline_derivative(
            u_, u, by_u, [&](std::size_t column) { return homogeneous(column, r); });
    };
    return l3d_detail::spline_derivative(v_, v, by_v, row);
}

l3d_nurbs_surface::vector l3d_nurbs_surface::evaluate(double u, double v) const {
    return l3d_projected<double, 4>(derivative(u, v, 0, 0));
}

/// Finds derivatives by the product rule. S w = P gives S_a = (P_a - S w_a) / w and S_ab = (P_ab -
/// S_a w_b - S_b w_a - S w_ab) / w.
l3d_surface_derivatives l3d_nurbs_surface::derivatives(double u, double v) const {
    const weighted p = derivative(u, v, 0, 0);
    const weighted pu = derivative(u, v, 1, 0), pv = derivative(u, v, 0, 1);
    const weighted puu = derivative(u, v, 2, 0), puv = derivative(u, v, 1, 1);
    const weighted pvv = derivative(u, v, 0, 2);
    l3d_surface_derivatives s;
    for (int k = 0; k < 3; ++k) {
        s.place[k] = p[k] / p[3];
        const auto first = [&](const weighted& a) { return (a[k] - s.place[k] * a[3]) / p[3]; };
        s.by_u[k] = first(pu);
        s.by_v[k] = first(pv);
        const auto second = [&](const weighted& ab, double a, double b, double wa, double wb) {
            return (ab[k] - a * wb - b * wa - s.place[k] * ab[3]) / p[3];
        };
        s.by_uu[k] = second(puu, s.by_u[k], s.by_u[k], pu[3], pu[3]);
        s.by_uv[k] = second(puv, s.by_u[k], s.by_v[k], pu[3], pv[3]);
        s.by_vv[k] = second(pvv, s.by_v[k], s.by_v[k], pv[3], pv[3]);
    }
    return s;
}

void l3d_nurbs_surface::append(const weighted& p) {
    points_.push_back(l3d_projected<double, 4>(p));
    weights_.push_back(p[3]);
}

l3d_nurbs_surface l3d_nurbs_surface::with_knot_u(double u) const {
    const std::string why = l3d_detail::knot_complaint(u_, u);
    if (!why.empty())
        throw l3d_error(l3d_exit::bad_input, "surface: along u: " + why);
    l3d_nurbs_surface result = *this;
    result.u_ = l3d_detail::with_knot(u_, u);
    result.points_.clear();
    result.weights_.clear();
    for (std::size_t row = 0; row < v_.points(); ++row)
        for (const weighted& p : l3d_detail::with_knot(
                 u_, u, [&](std::size_t column) { return homogeneous(column, row); }))
            result.append(p);
    if (weights_.empty())
        result.weights_.clear();
    return result;
}

l3d_nurbs_surface l3d_nurbs_surface::with_knot_v(double v) const {
    const std::string why = l3d_detail::knot_complaint(v_, v);
    if (!why.empty())
        throw l3d_error(l3d_exit::bad_input, "surface: along v: " + why);
    l3d_nurbs_surface result = *this;
    result.v_ = l3d_detail::with_knot(v_, v);
    std::vector<l3d_detail::spline_line> columns;
    for (std::size_t column = 0; column < u_.points(); ++column)
        columns.push_back(l3d_detail::with_knot(
            v_, v, [&](std::size_t row) { return homogeneous(column, row); }));
    result.points_.clear();
    result.weights_.clear();
    for (std::size_t row = 0; row < v_.points() + 1; ++row)
        for (const l3d_detail::spline_line& column : columns)
            result.append(column[row]);
    if (weights_.empty())
        result.weights_.clear();
    return result;
}
