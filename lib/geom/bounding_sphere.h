// SPDX-License-Identifier: MIT
// l3d_bounding_sphere: a ball around a thing, for a cheap test whether two things may meet.
#ifndef L3D_GEOM_BOUNDING_SPHERE_H
#define L3D_GEOM_BOUNDING_SPHERE_H

#include "base/public.h"
#include "geom/transform.h"

#include <algorithm>
#include <span>

/// A ball that holds all vertices of an object, for a fast test before an exact one. Two objects
/// cannot meet unless their balls do.
///
/// Units: those of the vertices.
struct L3D_PUBLIC l3d_bounding_sphere {
    /// A place.
    using vector = l3d_vector<double, 3>;

    vector centre{0.0}; ///< the middle of the vertices' bounding box
    double radius = 0;  ///< distance from the centre to the farthest vertex

    /// The ball around some vertices; a point at the origin if there are none.
    /// Cost: linear. The radius is at most 1.74 times that of the smallest ball.
    static l3d_bounding_sphere of(std::span<const vector> vertices) {
        l3d_bounding_sphere ball;
        if (vertices.empty())
            return ball;
        vector least = vertices[0], most = vertices[0];
        for (const vector& v : vertices)
            for (int axis = 0; axis < 3; ++axis) {
                least[axis] = std::min(least[axis], v[axis]);
                most[axis] = std::max(most[axis], v[axis]);
            }
        ball.centre = least + (most - least) * 0.5;
        for (const vector& v : vertices)
            ball.radius = std::max(ball.radius, l3d_length(v - ball.centre));
        return ball;
    }

    /// The ball around the same vertices after they are placed.
    /// Expects: a placement that scales along the axes first, and then only rotates and shifts.
    l3d_bounding_sphere placed(const l3d_matrix<double>& placement) const {
        const auto moved = placement * l3d_vector<double, 4>(centre, 1.0);
        double scale = 0;
        for (int axis = 0; axis < 3; ++axis)
            scale = std::max(scale, l3d_length(vector(placement(0, axis), placement(1, axis),
                                                      placement(2, axis))));
        return {vector(moved[0], moved[1], moved[2]), radius * scale};
    }

    /// Whether two balls overlap: the distance of their centres is less than the sum of their
    /// radii.
    bool touches(const l3d_bounding_sphere& other) const {
        const double reach = radius + other.radius;
        const vector way = other.centre - centre;
        return l3d_dot(way, way) < reach * reach;
    }
};

#endif
