// SPDX-License-Identifier: MIT
// l3d_plane and l3d_side_2d: a plane, or a line of the plane, with a front and a back; clipping to
// it.
#ifndef L3D_GEOM_PLANE_H
#define L3D_GEOM_PLANE_H

#include "base/public.h"
#include "geom/transform.h"
#include "geom/vector.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// The place where a line meets a plane.
template <class T> struct L3D_PUBLIC l3d_plane_crossing {
    T t;             ///< 0 at the line's first point, 1 at the second; it may lie beyond either
    l3d_point<T> at; ///< the place itself
    bool from_front; ///< whether the line's first point is in front of the plane
};

/// A plane with a front and a back: the points p with normal . p + d = 0. Points with a positive
/// sum are in front.
///
/// Units:   the normal is a unit vector; d is the distance of the origin in front of the plane.
template <class T> struct L3D_PUBLIC l3d_plane {
    /// A direction.
    using vector = l3d_vector<T, 3>;

    vector normal; ///< unit normal, towards the front
    T d;           ///< the plane's distance from the origin, positive if the origin is in front

    /// The plane through a point; the normal may have any length but 0.
    static l3d_plane through(const l3d_point<T>& point, const vector& normal) noexcept {
        const vector unit = l3d_normalized(normal);
        return {unit, -l3d_dot(unit, point.from_origin)};
    }

    /// The plane through three points which, seen from the front, run clockwise in left-handed axes
    /// and counterclockwise in right-handed ones.
    /// Errors:  nothing if the points lie on a line: the sine of the angle at p0 is below 2^-10. At
    ///          a smaller sine, a float's rounding of 2^-24 would turn the normal by more than
    ///          2^-14.
    static std::optional<l3d_plane> through(const l3d_point<T>& p0, const l3d_point<T>& p1,
                                            const l3d_point<T>& p2) noexcept {
        // Lengths are taken out first, so that neither large nor small triangles lose bits.
        const vector sine = l3d_cross(l3d_normalized(p1 - p0), l3d_normalized(p2 - p0));
        if (l3d_to_double(l3d_length(sine)) < 0x1p-10)
            return std::nullopt;
        return through(p0, sine);
    }

    /// The same plane with front and back exchanged.
    l3d_plane flipped() const noexcept { return {-normal, -d}; }

    /// The distance of a point from the plane, negative behind it.
    T side_of_point(const l3d_point<T>& p) const noexcept {
        return l3d_dot(normal, p.from_origin) + d;
    }

    /// The place where the line through two points crosses the plane.
    /// Errors:  nothing if the line is parallel to the plane: both points have the same distance in
    ///          T.
    std::optional<l3d_plane_crossing<T>> crossing(const l3d_point<T>& p0,
                                                  const l3d_point<T>& p1) const noexcept {
        const T side0 = side_of_point(p0);
        const T drop = side0 - side_of_point(p1);
        const T zero = l3d_from_double<T>(0);
        if (drop == zero)
            return std::nullopt;
        const T t = side0 / drop;
        return l3d_plane_crossing<T>{t, p0 + (p1 - p0) * t, side0 > zero};
    }
};

/// A position in the picture. Units: pixels, y down.
template <class T> using l3d_position = l3d_vector<T, 2>;

/// The distance of p to the right of the line from a to b: negative to the left, 0 on the line.
/// Right is inside of a polygon whose corners run clockwise on the screen.
///
/// Units:   pixels times the distance from a to b.
/// Expects: coordinates less than 2^29 in fixed point, where the sign is exact. Floating point is
///          computed in double, and the sign is exact where the differences and products are.
template <class T>
double l3d_side_2d(const l3d_position<T>& p, const l3d_position<T>& a,
                   const l3d_position<T>& b) noexcept {
    if constexpr (l3d_is_fixed<T>) {
        // 2^29 * 2^32 is 2^61: differences are below 2^62, products below 2^124.
        using wide = l3d_detail::int128;
        const auto minus = [](T u, T v) { return wide{u.raw()} - v.raw(); };
        const wide raw = minus(b[0], a[0]) * minus(p[1], a[1]) - //
                         minus(b[1], a[1]) * minus(p[0], a[0]);
        const double one = static_cast<double>(wide{1} << T::fraction_bits);
        return static_cast<double>(raw) / (one * one);
    } else {
        return (double{b[0]} - a[0]) * (double{p[1]} - a[1]) -
               (double{b[1]} - a[1]) * (double{p[0]} - a[0]);
    }
}

/// The position p + t (q - p), part of the way from p to q. Each coordinate stays between those of
/// p and q.
/// Expects: 0 <= t <= 1.
template <class T>
l3d_position<T> l3d_part_way(const l3d_position<T>& p, const l3d_position<T>& q,
                             double t) noexcept {
    l3d_position<T> result;
    for (int axis = 0; axis < 2; ++axis) {
        const double from = l3d_to_double(p[axis]);
        const double to = l3d_to_double(q[axis]);
        // Rounding may lead past an end by a step.
        const T there = l3d_from_double<T>(from + (to - from) * t);
        result[axis] = std::clamp(there, std::min(p[axis], q[axis]), std::max(p[axis], q[axis]));
    }
    return result;
}

/// The point where the segment from p to q crosses the line through a and b, and its parameter.
template <class T> struct L3D_PUBLIC l3d_crossing_2d {
    l3d_position<T> at; ///< the place of the crossing
    double t;           ///< 0 at p, 1 at q
};

/// The point where the segment from p to q crosses the line through a and b.
/// Expects: p and q on different sides of the line, neither on it.
template <class T>
l3d_crossing_2d<T> l3d_cross_line_2d(const l3d_position<T>& p, const l3d_position<T>& q,
                                     const l3d_position<T>& a, const l3d_position<T>& b) noexcept {
    const double p_side = l3d_side_2d<T>(p, a, b);
    const double t = p_side / (p_side - l3d_side_2d<T>(q, a, b));
    l3d_position<T> at = l3d_part_way<T>(p, q, t);
    // A crossing with a vertical or horizontal line lies on it exactly, so that it is not outside a
    // window.
    for (int axis = 0; axis < 2; ++axis)
        if (a[axis] == b[axis])
            at[axis] = a[axis];
    return {at, t};
}

/// Keeps the part of a convex polygon that is in front of a plane.
///
/// A corner within `thickness` of the plane counts as on it: the corner is kept, and no edge is cut
/// there. So a plane that passes through corners leaves no slivers.
/// Shape:   side(vertex) gives the signed distance of a vertex from the plane, front positive.
///          cut(front, behind) gives the index of the vertex where the edge between two vertices
///          crosses the plane. If `cut` depends only on these two vertices, both polygons at an
///          edge get the same cut, without a crack. `kept` is emptied, and gets the corners in
///          order.
/// Expects: at least one corner.
/// Errors:  false, and `kept` is empty, if nothing is in front.
/// Cost:    a call of `side` for each corner, at most two of `cut`.
/// Source:  one step of Sutherland and Hodgman's Reentrant Polygon Clipping (1974).
template <class T, class Side, class Cut>
bool l3d_clip_to_plane(std::span<const std::uint32_t> corners, T thickness, Side side, Cut cut,
                       std::vector<std::uint32_t>& kept) {
    kept.clear();
    bool in_front = false;
    std::uint32_t before = corners.back();
    T before_side = side(before);
    for (const std::uint32_t corner : corners) {
        const T corner_side = side(corner);
        if (corner_side > thickness && before_side < -thickness)
            kept.push_back(cut(corner, before));
        if (corner_side < -thickness && before_side > thickness)
            kept.push_back(cut(before, corner));
        if (!(corner_side < -thickness))
            kept.push_back(corner);
        in_front = in_front || corner_side > thickness;
        before = corner;
        before_side = corner_side;
    }
    if (!in_front)
        kept.clear();
    return in_front;
}

#endif
