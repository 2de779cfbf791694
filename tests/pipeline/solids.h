// SPDX-License-Identifier: MIT
// Solids of trimmed faces that meet along edges, each also in closed form.
#ifndef L3D_TESTS_PIPELINE_SOLIDS_H
#define L3D_TESTS_PIPELINE_SOLIDS_H

#include "geom/files/model_file.h"
#include "geom/nurbs_surface.h"

#include <functional>
#include <vector>

/// A closed body. Normals of its faces point outwards.
struct solid {
    using vector = l3d_vector<double, 3>;

    std::vector<l3d_nurbs_surface> faces;
    std::vector<l3d_model_edge> edges;
    /// At least the distance to the body outside of it, negative within.
    /// Shape: of Lipschitz constant 1.
    std::function<double(const vector&)> outside;
    vector middle{0.0, 0.0, 0.0};
    double radius = 1; ///< of a ball that holds it
};

/// How far trims are off the edges that they follow: circles on planes are larger or smaller by
/// this part of their radius.
struct solid_errors {
    double circles = 0;
};

/// A plate with `across` by `across` round holes.
solid holed_plate(int across, const solid_errors& errors = {});
/// A disc with a hub, a bore and `bolts` bolt holes.
solid flange(int bolts, const solid_errors& errors = {});
/// Two cylinders of different radii on one axis, with a fillet where they meet.
solid filleted_cylinders(const solid_errors& errors = {});
/// A ball that a cylinder beside its middle goes through. Curves are cubics through `spans` places
/// of the exact ones; the cylinder's axis is at a distance along x, negative away from the seam.
solid drilled_ball(int spans, double distance);
/// A ball without what is above a level plane. One loop goes around the ball, and has no seam.
solid capped_ball();

#endif
