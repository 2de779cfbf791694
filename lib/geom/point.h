// SPDX-License-Identifier: MIT
// l3d_point: a place in space, which is not a displacement.
#ifndef L3D_GEOM_POINT_H
#define L3D_GEOM_POINT_H

#include "base/public.h"
#include "geom/vector.h"

/// A place, held as its displacement from the origin.
///
/// The difference of two points is a vector, and a point moved by a vector is a point. Operations
/// without a meaning (the sum of two points, a vector minus a point) do not compile. The fourth
/// coordinate of the book, 1 for points and 0 for vectors, is the type itself.
template <class T> struct L3D_PUBLIC l3d_point {
    /// A difference of two points.
    using vector = l3d_vector<T, 3>;

    /// Uninitialised, as a number is; l3d_point<T>{} is the origin.
    l3d_point() = default;
    /// The point with these three coordinates.
    constexpr l3d_point(T x, T y, T z) noexcept : from_origin(x, y, z) {}
    /// The point that the vector leads to from the origin.
    explicit constexpr l3d_point(const vector& place) noexcept : from_origin(place) {}

    /// The point with coordinates rounded to T. It has a name of its own, since a fixed point
    /// number is never made implicitly.
    static l3d_point of(double x, double y, double z) noexcept {
        return {l3d_from_double<T>(x), l3d_from_double<T>(y), l3d_from_double<T>(z)};
    }

    /// A coordinate, to be changed. Expects: 0 <= axis < 3.
    T& operator[](int axis) noexcept { return from_origin[axis]; }
    /// A coordinate. Expects: 0 <= axis < 3.
    const T& operator[](int axis) const noexcept { return from_origin[axis]; }

    /// Moves the point along the vector.
    l3d_point& operator+=(const vector& v) noexcept {
        from_origin += v;
        return *this;
    }
    /// The point moved along the vector.
    friend l3d_point operator+(const l3d_point& p, const vector& v) noexcept {
        return l3d_point(p.from_origin + v);
    }
    /// The point moved along the vector.
    friend l3d_point operator+(const vector& v, const l3d_point& p) noexcept { return p + v; }
    /// The point moved against the vector.
    friend l3d_point operator-(const l3d_point& p, const vector& v) noexcept {
        return l3d_point(p.from_origin - v);
    }
    /// The vector that leads from q to p.
    friend vector operator-(const l3d_point& p, const l3d_point& q) noexcept {
        return p.from_origin - q.from_origin;
    }
    /// Whether all coordinates are equal.
    friend bool operator==(const l3d_point& p, const l3d_point& q) noexcept {
        return p.from_origin == q.from_origin;
    }

    vector from_origin; ///< the coordinates
};

#endif
