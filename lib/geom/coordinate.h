// SPDX-License-Identifier: MIT
// l3d_coordinate: a place with its history: its definition, and its transformed places.
#ifndef L3D_GEOM_COORDINATE_H
#define L3D_GEOM_COORDINATE_H

#include "base/public.h"
#include "geom/transform.h"
#include "geom/two_part_list.h"

#include <array>

/// A vertex that many polygons share, and that is moved from its definition in every frame.
///
/// Every frame starts from `original`, so no rounding adds up from frame to frame. The stage is
/// counted, so a vertex is moved once however many polygons ask for it.
template <class T> struct L3D_PUBLIC l3d_coordinate {
    /// Uninitialised, as a point is.
    l3d_coordinate() = default;
    /// A vertex defined at this place, and not moved yet.
    explicit l3d_coordinate(const l3d_point<T>& place) : original(place) { reset(); }

    /// Forgets all transformations.
    void reset() {
        transformed = original;
        transform_stage = 0;
    }

    /// Applies the matrix, unless `stage` was the last stage done. Expects: a stage that is not 0;
    /// transformations that follow each other have different stages.
    void transform(const l3d_matrix<T>& matrix, int stage) {
        if (transform_stage == stage)
            return;
        transform_stage = stage;
        transformed = l3d_transformed(matrix, transformed);
    }

    l3d_point<T> original;    ///< its definition, before any transformation
    l3d_point<T> transformed; ///< in the end a position in the picture, in pixels
    /// For programs that need places between the two again, in camera space for example.
    std::array<l3d_point<T>, 2> transformed_intermediates;
    int transform_stage = 0; ///< the last stage done; 0 for none
};

/// The vertices of one or several polygons.
template <class T> using l3d_vertex_list = l3d_two_part_list<l3d_coordinate<T>>;

#endif
