// SPDX-License-Identifier: MIT
// The side of a line in the picture on which a point lies, and the crossing with another line.
#ifndef L3D_GEOM_SIDE_2D_H
#define L3D_GEOM_SIDE_2D_H

#include "base/public.h"
#include "geom/vector.h"

#include <algorithm>

/// A position in the picture. Units: pixels, y down.
template <class T> using l3d_position = l3d_vector<T, 2>;

/// The distance of p to the right of the line from a to b: negative to the left, 0 on the line.
/// Right is inside of a polygon whose corners run clockwise on the screen.
///
/// Units:   pixels times the length of the way.
/// Expects: coordinates less than 2^29 in fixed point, where the sign is exact. In floating point
///          it is computed in double, and exact where the differences and products are.
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

/// The position t of the way from p to q, each coordinate between theirs.
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

/// The place where the way from p to q crosses the line through a and b, and its share of the way.
template <class T> struct L3D_PUBLIC l3d_crossing_2d {
    l3d_position<T> at; ///< the place on both lines
    double t;           ///< 0 at p, 1 at q
};

/// The crossing of the way from p to q with the line through a and b.
/// Expects: p and q on different sides of the line, neither on it.
template <class T>
l3d_crossing_2d<T> l3d_cross_line_2d(const l3d_position<T>& p, const l3d_position<T>& q,
                                     const l3d_position<T>& a, const l3d_position<T>& b) noexcept {
    const double p_side = l3d_side_2d<T>(p, a, b);
    const double t = p_side / (p_side - l3d_side_2d<T>(q, a, b));
    l3d_position<T> at = l3d_part_way<T>(p, q, t);
    // A crossing with an upright or level line lies on it exactly, so that it is not outside a
    // window.
    for (int axis = 0; axis < 2; ++axis)
        if (a[axis] == b[axis])
            at[axis] = a[axis];
    return {at, t};
}

#endif
