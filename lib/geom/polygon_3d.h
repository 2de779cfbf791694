// SPDX-License-Identifier: MIT
// l3d_polygon_3d: a polygon in space over shared vertices, and its clipping to a plane.
#ifndef L3D_GEOM_POLYGON_3D_H
#define L3D_GEOM_POLYGON_3D_H

#include "base/public.h"
#include "geom/plane.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// A convex, planar polygon: a list of indices into a list of vertices that several polygons may
/// share.
///
/// Shape:   as a face of l3d_polygon_mesh: the front is where (p1 - p0) x (p2 - p0) points to.
/// Expects: three corners or more, each naming a vertex.
/// Lives:   borrows both lists.
template <class T> struct L3D_PUBLIC l3d_polygon_3d {
    std::span<const l3d_point<T>> vertices; ///< the list that the indices refer to
    /// The polygon's corners in order, as indices into `vertices`.
    std::span<const std::uint32_t> corners;

    /// The place of a corner. Expects: i < corners.size().
    const l3d_point<T>& corner(std::size_t i) const { return vertices[corners[i]]; }

    /// The mean of the corners.
    l3d_point<T> centre() const;

    /// The plane through the first three corners that are not on a line. The plane's normal is a
    /// unit vector that points outwards.
    /// Errors:  nothing if all corners are on a line.
    std::optional<l3d_plane<T>> plane() const;

    /// Whether the front is seen from `eye`: the sign of normal . (eye - corner), which perspective
    /// does not change. False for a polygon seen from its edge or without a plane.
    bool faces(const l3d_point<T>& eye) const;

    /// The area within the edges. Units: world units squared.
    double area() const;
};

/// The largest distance from a plane at which a vertex counts as on the plane.
/// Units: world units; the value is that of Lin's book (docs/BOOK.md).
inline constexpr double l3d_plane_thickness = 0.001;

/// The place where the edge from `front` to `behind` crosses a plane. `front_side` and
/// `behind_side` are the signed distances of the edge's ends from the plane.
template <class T>
l3d_point<T> l3d_between(const l3d_point<T>& front, const l3d_point<T>& behind, T front_side,
                         T behind_side) noexcept {
    return front + (behind - front) * (front_side / (front_side - behind_side));
}

/// Clips a convex polygon to the front of a plane. `kept` gets the corners of the part that is
/// left; new vertices go to the end of `vertices`.
/// Errors:  false, and `kept` is empty, if nothing is in front.
template <class T>
bool l3d_clip_to_plane(std::span<const std::uint32_t> corners, const l3d_plane<T>& plane,
                       std::vector<l3d_point<T>>& vertices, std::vector<std::uint32_t>& kept) {
    const auto side = [&](std::uint32_t i) { return plane.side_of_point(vertices[i]); };
    const auto cut = [&](std::uint32_t front, std::uint32_t behind) {
        vertices.push_back(
            l3d_between(vertices[front], vertices[behind], side(front), side(behind)));
        return static_cast<std::uint32_t>(vertices.size() - 1);
    };
    return l3d_clip_to_plane(corners, l3d_from_double<T>(l3d_plane_thickness), side, cut, kept);
}

/// Keeps the part of a convex polygon at z >= near_z: `kept` gets its corners. New vertices, at the
/// end of `vertices`, have z = near_z to the last bit. So no quotient by z is larger than at
/// near_z.
/// Errors:  false, and `kept` is empty, if nothing is in front.
template <class T>
bool l3d_clip_near_z(std::span<const std::uint32_t> corners, T near_z,
                     std::vector<l3d_point<T>>& vertices, std::vector<std::uint32_t>& kept) {
    const auto side = [&](std::uint32_t i) { return vertices[i][2] - near_z; };
    const auto cut = [&](std::uint32_t front, std::uint32_t behind) {
        vertices.push_back(
            l3d_between(vertices[front], vertices[behind], side(front), side(behind)));
        vertices.back()[2] = near_z;
        return static_cast<std::uint32_t>(vertices.size() - 1);
    };
    return l3d_clip_to_plane(corners, l3d_from_double<T>(0), side, cut, kept);
}

template <class T> l3d_point<T> l3d_polygon_3d<T>::centre() const {
    // Differences from one corner are small even if coordinates are large.
    const l3d_point<T>& base = corner(0);
    l3d_vector<T, 3> sum = base - base;
    for (std::size_t i = 1; i < corners.size(); ++i)
        sum += corner(i) - base;
    return base + sum / l3d_from_double<T>(static_cast<double>(corners.size()));
}

template <class T> std::optional<l3d_plane<T>> l3d_polygon_3d<T>::plane() const {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
        if (auto p = l3d_plane<T>::through(corner(i), corner((i + 1) % n), corner((i + 2) % n)))
            return p;
    return std::nullopt;
}

template <class T> bool l3d_polygon_3d<T>::faces(const l3d_point<T>& eye) const {
    const auto front = plane();
    return front && front->side_of_point(eye) > l3d_from_double<T>(0);
}

template <class T> double l3d_polygon_3d<T>::area() const {
    l3d_vector<double, 3> sum(0);
    const auto edge = [this](std::size_t i) {
        return l3d_converted<double, T, 3>(corner(i) - corner(0));
    };
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += l3d_cross(edge(i - 1), edge(i));
    return l3d_length(sum) / 2;
}

#endif
