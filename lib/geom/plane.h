// SPDX-License-Identifier: MIT
// l3d_plane: a plane with a front and a back.
#ifndef L3D_GEOM_PLANE_H
#define L3D_GEOM_PLANE_H

#include "base/public.h"
#include "geom/transform.h"

#include <optional>

/// The place where a line meets a plane.
template <class T> struct L3D_PUBLIC l3d_plane_crossing {
    T t;             ///< 0 at the line's first point, 1 at the second; not restricted to these
    l3d_point<T> at; ///< the place itself
    bool from_front; ///< the first point is in front
};

/// The points p with normal . p + d = 0; points with a positive sum are in front.
///
/// Units:   the normal is a unit vector, d the distance from the plane to the origin along it.
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
    /// Errors:  nothing if they lie on a line. That is so if the sine of the angle at p0 is below
    ///          2^-10, where float's 2^-24 would turn the normal by more than 2^-14.
    static std::optional<l3d_plane> through(const l3d_point<T>& p0, const l3d_point<T>& p1,
                                            const l3d_point<T>& p2) noexcept {
        // Lengths are taken out first, so that neither large nor small triangles lose bits.
        const vector sine = l3d_cross(l3d_normalized(p1 - p0), l3d_normalized(p2 - p0));
        if (l3d_to_double(l3d_length(sine)) < 0x1p-10)
            return std::nullopt;
        return through(p0, sine);
    }

    /// The same points with front and back exchanged.
    l3d_plane flipped() const noexcept { return {-normal, -d}; }

    /// The distance to the plane, negative behind it.
    T side_of_point(const l3d_point<T>& p) const noexcept {
        return l3d_dot(normal, p.from_origin) + d;
    }

    /// The crossing of the line through two points.
    /// Errors:  nothing if it is parallel: if T sees both points equally far away.
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

#endif
