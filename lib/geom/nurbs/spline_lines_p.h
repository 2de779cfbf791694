// SPDX-License-Identifier: MIT
// spline_lines: evaluates a line of homogeneous control points, and inserts knots.
#ifndef L3D_GEOM_SPLINE_LINES_P_H
#define L3D_GEOM_SPLINE_LINES_P_H

#include "geom/nurbs_surface.h"
#include "geom/vector.h"

#include <cstddef>
#include <vector>

namespace l3d_detail {

/// A homogeneous point: x w, y w, z w, w.
using weighted = l3d_vector<double, 4>;
using spline_line = std::vector<weighted>;

/// The index i of the knot span that holds t: knots[i] <= t < knots[i + 1]. The last span of
/// positive length includes the end of the range.
/// Expects: knots[degree] <= t <= knots[points()].
inline std::size_t span_of(const l3d_bspline_direction& d, double t) {
    auto span = static_cast<std::size_t>(d.degree);
    for (std::size_t i = span; i < d.points(); ++i)
        if (d.knots[i] < d.knots[i + 1] && (i == span || d.knots[i] <= t))
            span = i;
    return span;
}

/// The derivative of a spline at t, of any order. at(i) gives control point i of the spline.
/// Source: de Boor, A Practical Guide to Splines, chapter X: the derivative's control points are m
///         (p_j - p_(j-1)) / (t_(j+m) - t_j), and its degree is m - 1.
template <class At>
weighted spline_derivative(const l3d_bspline_direction& d, double t, int order, const At& at) {
    const std::size_t span = span_of(d, t);
    auto m = static_cast<std::size_t>(d.degree);
    spline_line p(m + 1);
    const std::size_t first = span - m;
    for (std::size_t i = 0; i <= m; ++i)
        p[i] = at(first + i);
    for (int k = 0; k < order; ++k) {
        if (m == 0)
            return weighted(0.0);
        for (std::size_t j = span; j > span - m; --j)
            p[j - first] = (p[j - first] - p[j - 1 - first]) *
                           (static_cast<double>(m) / (d.knots[j + m] - d.knots[j]));
        --m;
    }
    for (std::size_t step = 1; step <= m; ++step)
        for (std::size_t j = span; j > span - m + step - 1; --j) {
            const double low = d.knots[j], high = d.knots[j + m - step + 1];
            p[j - first] =
                (p[j - 1 - first] * (high - t) + p[j - first] * (t - low)) * (1 / (high - low));
        }
    return p.back();
}

/// The control points of a spline after the knot t is inserted once.
/// Expects: knots[degree] <= t < knots[points()], and t is listed less than `degree` times.
/// Source:  Boehm, Inserting new knots into B-spline curves, CAD 12, 1980.
template <class At> spline_line with_knot(const l3d_bspline_direction& d, double t, const At& at) {
    const auto n = static_cast<std::size_t>(d.degree);
    const std::size_t span = span_of(d, t);
    spline_line result(d.points() + 1);
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (i + n <= span) {
            result[i] = at(i);
        } else if (i > span) {
            result[i] = at(i - 1);
        } else {
            const double low = d.knots[i], high = d.knots[i + n];
            result[i] = (at(i - 1) * (high - t) + at(i) * (t - low)) * (1 / (high - low));
        }
    }
    return result;
}

/// The knots after the knot t is inserted once. Expects: knots[degree] <= t < knots[points()].
inline l3d_bspline_direction with_knot(l3d_bspline_direction d, double t) {
    const auto place = static_cast<std::ptrdiff_t>(span_of(d, t) + 1);
    d.knots.insert(d.knots.begin() + place, t);
    return d;
}

/// The reason why the knot t cannot be inserted; "" if it can.
std::string knot_complaint(const l3d_bspline_direction& d, double t);

/// The error message for invalid control points or weights of a spline; "" if all are valid. There
/// must be `wanted` points, and as many weights or none.
std::string points_complaint(const std::vector<l3d_vector<double, 3>>& points,
                             const std::vector<double>& weights, std::size_t wanted);

} // namespace l3d_detail

#endif
