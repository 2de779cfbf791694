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
    /// At most the distance to the body outside of it, negative within.
    /// Shape: of Lipschitz constant 1 outside.
    std::function<double(const vector&)> outside;
    vector middle{0.0, 0.0, 0.0};
    double radius = 1;      ///< of a ball that holds it
    double model_error = 0; ///< how far the model's faces are off the closed form
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

/// A rod of radius 1 with a thread of trapezoids around it, `turns` of them, cut by level planes.
/// Helices are cubics through `spans` places a turn, and flanks are straight between them.
solid threaded_rod(int turns, int spans);

#endif
