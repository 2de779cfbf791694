// SPDX-License-Identifier: MIT
// l3d_bezier_curve: a cubic Bezier curve with direct evaluation, the slow and obvious twin of
// forward differencing.
#ifndef L3D_GEOM_BEZIER_CURVE_H
#define L3D_GEOM_BEZIER_CURVE_H

#include "base/public.h"
#include "geom/real.h"
#include "geom/vector.h"

#include <array>
#include <cstddef>
#include <utility>

/// a + t (b - a), component by component. Exact at t = 0; monotone in t for each component.
template <class T, int N>
l3d_vector<T, N> l3d_lerp(const l3d_vector<T, N>& a, const l3d_vector<T, N>& b, T t) {
    l3d_vector<T, N> result;
    for (int i = 0; i < N; ++i)
        result[i] = a[i] + (b[i] - a[i]) * t;
    return result;
}

/// The rounded midpoint of a and b; the same bits if a and b are exchanged.
template <class T, int N>
l3d_vector<T, N> l3d_midpoint_of(const l3d_vector<T, N>& a, const l3d_vector<T, N>& b) {
    l3d_vector<T, N> result;
    for (int i = 0; i < N; ++i)
        result[i] = l3d_midpoint(a[i], b[i]);
    return result;
}

/// Turns the four control values of a cubic Bezier polynomial into its coefficients:
/// a + t (b + t (c + t d)).
template <class T> constexpr void l3d_to_powers(T& a, T& b, T& c, T& d) {
    const T first = b - a, second = c - b, third = d - c;
    const T bend = second - first;
    b = 3 * first;
    c = 3 * bend;
    d = (third - second) - bend;
}

/// A cubic Bezier curve in N dimensions; homogeneous coordinates make it rational.
///
/// Shape: four control points, parameter t in [0, 1].
template <class T, int N> struct L3D_PUBLIC l3d_bezier_curve {
    /// A control point, or a point of the curve.
    using point = l3d_vector<T, N>;
    std::array<point, 4> points; ///< the first and the last one lie on the curve

    /// The point at t, by de Casteljau's scheme (six interpolations).
    /// Source: de Casteljau 1959; Farin, Curves and Surfaces for CAGD, section 4.2.
    point evaluate(T t) const {
        std::array<point, 4> p = points;
        for (std::size_t level = 3; level > 0; --level)
            for (std::size_t i = 0; i < level; ++i)
                p[i] = l3d_lerp<T, N>(p[i], p[i + 1], t);
        return p[0];
    }

    /// Control points of the derivative, a quadratic: 3 (b1 - b0), 3 (b2 - b1), 3 (b3 - b2).
    std::array<point, 3> derivative() const {
        std::array<point, 3> result;
        for (std::size_t i = 0; i < 3; ++i)
            for (int k = 0; k < N; ++k) {
                const T difference = points[i + 1][k] - points[i][k];
                result[i][k] = difference + difference + difference;
            }
        return result;
    }

    /// The same curve, run through from its end: t becomes 1 - t.
    l3d_bezier_curve reversed() const { return {{points[3], points[2], points[1], points[0]}}; }

    /// The halves [0, 1/2] and [1/2, 1]. Reversing the curve reverses and exchanges the halves
    /// bit for bit, because every value is a midpoint.
    std::pair<l3d_bezier_curve, l3d_bezier_curve> split() const {
        const auto& p = points;
        const point a = l3d_midpoint_of<T, N>(p[0], p[1]);
        const point b = l3d_midpoint_of<T, N>(p[1], p[2]);
        const point c = l3d_midpoint_of<T, N>(p[2], p[3]);
        const point ab = l3d_midpoint_of<T, N>(a, b);
        const point bc = l3d_midpoint_of<T, N>(b, c);
        const point middle = l3d_midpoint_of<T, N>(ab, bc);
        return {{{p[0], a, ab, middle}}, {{middle, bc, c, p[3]}}};
    }
};

#endif
