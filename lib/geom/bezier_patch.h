// SPDX-License-Identifier: MIT
// l3d_bezier_patch and l3d_bezier_curve: bicubic patches and cubic curves with exact evaluation.
#ifndef L3D_GEOM_BEZIER_PATCH_H
#define L3D_GEOM_BEZIER_PATCH_H

#include "base/public.h"
#include "geom/real.h"
#include "geom/vector.h"

#include <array>
#include <cstddef>
#include <utility>

/// Interpolates linearly between two points: a + t (b - a) in each component. The result is exactly
/// a at t = 0. Each component is monotone in t.
template <class T, int N>
l3d_vector<T, N> l3d_lerp(const l3d_vector<T, N>& a, const l3d_vector<T, N>& b, T t) {
    l3d_vector<T, N> result;
    for (int i = 0; i < N; ++i)
        result[i] = a[i] + (b[i] - a[i]) * t;
    return result;
}

/// The rounded midpoint of a and b. Exchanging a and b does not change the midpoint's bits.
template <class T, int N>
l3d_vector<T, N> l3d_midpoint_of(const l3d_vector<T, N>& a, const l3d_vector<T, N>& b) {
    l3d_vector<T, N> result;
    for (int i = 0; i < N; ++i)
        result[i] = l3d_midpoint(a[i], b[i]);
    return result;
}

/// Turns the four control values of a cubic Bezier polynomial into its power coefficients: the
/// polynomial is then a + t (b + t (c + t d)).
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
    std::array<point, 4> points; ///< the control points; the first and the last lie on the curve

    /// The point at t, by de Casteljau's scheme (six interpolations).
    /// Source: de Casteljau 1959; Farin, Curves and Surfaces for CAGD, section 4.2.
    point evaluate(T t) const {
        std::array<point, 4> p = points;
        for (std::size_t level = 3; level > 0; --level)
            for (std::size_t i = 0; i < level; ++i)
                p[i] = l3d_lerp<T, N>(p[i], p[i + 1], t);
        return p[0];
    }

    /// The control points of the derivative, which is quadratic:
    /// 3 (b1 - b0), 3 (b2 - b1), 3 (b3 - b2).
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

    /// The halves [0, 1/2] and [1/2, 1]. The halves of the reversed curve are these halves,
    /// reversed and exchanged, bit for bit, because every value is a midpoint.
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

/// A bicubic tensor-product Bezier patch in N dimensions.
///
/// Shape: 16 control points, index = 4 * row + column; columns run along u, rows along v;
///        u, v in [0, 1].
///
/// Rational form: with homogeneous control points (N = 4: x w, y w, z w, w) the same class is a
/// rational patch. l3d_projected and l3d_rational_derivatives return to three dimensions.
template <class T, int N> struct L3D_PUBLIC l3d_bezier_patch {
    /// A control point, or a point of the surface.
    using point = l3d_vector<T, N>;
    /// A line of the surface along u or v, or a row or column of the control net.
    using curve = l3d_bezier_curve<T, N>;
    std::array<point, 16> points; ///< the control net, row by row

    /// The index of a control point in `points`. Expects: 0 <= row, column < 4.
    static constexpr std::size_t index(int row, int column) {
        return 4 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column);
    }
    /// A control point. Expects: as index.
    const point& at(int row, int column) const { return points[index(row, column)]; }
    /// A control point, to be changed. Expects: as index.
    point& at(int row, int column) { return points[index(row, column)]; }

    /// The control points of one row, as a curve in u.
    curve row(int r) const { return {{at(r, 0), at(r, 1), at(r, 2), at(r, 3)}}; }

    /// The control points of one column, as a curve in v.
    curve column(int c) const { return {{at(0, c), at(1, c), at(2, c), at(3, c)}}; }

    /// The curve v -> S(u, v) for a fixed u.
    curve curve_at_u(T u) const {
        return {{row(0).evaluate(u), row(1).evaluate(u), row(2).evaluate(u), row(3).evaluate(u)}};
    }

    /// The point S(u, v), by de Casteljau's scheme in u, then in v.
    point evaluate(T u, T v) const { return curve_at_u(u).evaluate(v); }

    /// The derivative dS/du at (u, v).
    point derivative_u(T u, T v) const {
        curve in_u;
        for (int c = 0; c < 4; ++c)
            in_u.points[static_cast<std::size_t>(c)] = column(c).evaluate(v);
        return evaluate_quadratic(in_u.derivative(), u);
    }

    /// The derivative dS/dv at (u, v).
    point derivative_v(T u, T v) const { return evaluate_quadratic(curve_at_u(u).derivative(), v); }

    /// The patch with u and v exchanged.
    l3d_bezier_patch transposed() const {
        l3d_bezier_patch result;
        for (int r = 0; r < 4; ++r)
            for (int c = 0; c < 4; ++c)
                result.at(c, r) = at(r, c);
        return result;
    }

    /// The halves of the patch: u in [0, 1/2] and u in [1/2, 1]. Reversing the patch along u
    /// reverses and exchanges the halves, bit for bit, as for l3d_bezier_curve::split.
    std::pair<l3d_bezier_patch, l3d_bezier_patch> split_u() const {
        std::pair<l3d_bezier_patch, l3d_bezier_patch> halves;
        for (int r = 0; r < 4; ++r) {
            const auto [low, high] = row(r).split();
            for (int c = 0; c < 4; ++c) {
                halves.first.at(r, c) = low.points[static_cast<std::size_t>(c)];
                halves.second.at(r, c) = high.points[static_cast<std::size_t>(c)];
            }
        }
        return halves;
    }

    /// The halves of the patch: v in [0, 1/2] and v in [1/2, 1], as for split_u.
    std::pair<l3d_bezier_patch, l3d_bezier_patch> split_v() const {
        std::pair<l3d_bezier_patch, l3d_bezier_patch> halves;
        for (int c = 0; c < 4; ++c) {
            const auto [low, high] = column(c).split();
            for (int r = 0; r < 4; ++r) {
                halves.first.at(r, c) = low.points[static_cast<std::size_t>(r)];
                halves.second.at(r, c) = high.points[static_cast<std::size_t>(r)];
            }
        }
        return halves;
    }

    /// The least and the largest coordinates of the control points. These coordinates bound the
    /// whole patch, which lies in the convex hull of the control points.
    std::pair<point, point> bounds() const {
        std::pair<point, point> box{points[0], points[0]};
        for (const point& p : points)
            for (int i = 0; i < N; ++i) {
                if (p[i] < box.first[i])
                    box.first[i] = p[i];
                if (p[i] > box.second[i])
                    box.second[i] = p[i];
            }
        return box;
    }

private:
    static point evaluate_quadratic(const std::array<point, 3>& b, T t) {
        return l3d_lerp<T, N>(l3d_lerp<T, N>(b[0], b[1], t), l3d_lerp<T, N>(b[1], b[2], t), t);
    }
};

/// Divides a homogeneous point by its weight, the last component. Expects: the weight is not zero.
template <class T, int N> l3d_vector<T, N - 1> l3d_projected(const l3d_vector<T, N>& h) {
    l3d_vector<T, N - 1> result;
    for (int i = 0; i < N - 1; ++i)
        result[i] = h[i] / h[N - 1];
    return result;
}

/// The derivatives by u and by v of the surface S in space that a rational patch stands for. If w
/// is the patch's weight, (S w)' = S' w + S w' gives S' = ((S w)' - S w') / w.
/// Expects: the weight at (u, v) is not zero.
template <class T, int N>
std::pair<l3d_vector<T, N - 1>, l3d_vector<T, N - 1>>
l3d_rational_derivatives(const l3d_bezier_patch<T, N>& patch, T u, T v) {
    const l3d_vector<T, N> h = patch.evaluate(u, v);
    const l3d_vector<T, N - 1> s = l3d_projected<T, N>(h);
    const l3d_vector<T, N> hu = patch.derivative_u(u, v);
    const l3d_vector<T, N> hv = patch.derivative_v(u, v);
    std::pair<l3d_vector<T, N - 1>, l3d_vector<T, N - 1>> result;
    for (int i = 0; i < N - 1; ++i) {
        result.first[i] = (hu[i] - s[i] * hu[N - 1]) / h[N - 1];
        result.second[i] = (hv[i] - s[i] * hv[N - 1]) / h[N - 1];
    }
    return result;
}

/// A patch with the same control points in another number type.
template <class To, class From, int N>
l3d_bezier_patch<To, N> l3d_converted(const l3d_bezier_patch<From, N>& patch) {
    l3d_bezier_patch<To, N> result;
    for (std::size_t i = 0; i < 16; ++i)
        for (int k = 0; k < N; ++k)
            result.points[i][k] = l3d_from_double<To>(l3d_to_double(patch.points[i][k]));
    return result;
}

#endif
