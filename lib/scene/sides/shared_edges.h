// SPDX-License-Identifier: MIT
// l3d_shared_edge: a curve in space at which trimmed faces of a model end.
#ifndef L3D_SCENE_SHARED_EDGES_H
#define L3D_SCENE_SHARED_EDGES_H

#include "geom/files/model_file.h"
#include "geom/files/patch_file.h"
#include "scene/space_curve.h"

#include <array>
#include <span>
#include <vector>

/// An edge of a model, at which trimmed faces end. It is a curve in space, cut into Bezier curves
/// one after another.
struct l3d_shared_edge {
    /// A part of the edge, from one parameter to another.
    struct span {
        double from, to;
        l3d_space_curve::bezier points;
    };
    l3d_nurbs_curve curve; ///< the curve as the file has it
    std::vector<span> spans;
    /// The places of the edge's two ends. Ends of two edges become one place if their distance is
    /// at most the sum of both edges' allowances. An edge's allowance is its tolerance, or `off` if
    /// that is larger.
    std::array<l3d_vector<double, 3>, 2> ends{};
    /// The largest distance found between the edge and its faces, at the same parameters. This
    /// distance is measured at places of each trim curve, not proven.
    double off = 0;
    l3d_vector<double, 3> worst{0.0, 0.0, 0.0}; ///< the place of the edge where `off` was found
    double tolerance = 0;                       ///< the largest `off` that the file allows

    /// Notes a distance to a face, measured at a place of the edge.
    void note(double distance, const l3d_vector<double, 3>& at) {
        if (distance > off) {
            off = distance;
            worst = at;
        }
    }
};

/// The longest chord of a shared edge in the picture. Straight edges are divided, too. So strips
/// beside parts of an edge far outside the picture do not reach into it. Units: pixels.
inline constexpr double l3d_longest_shared_chord = 16;

/// Finds the edges that trims of these pieces follow. A span of an edge ends wherever a face begins
/// or ends along the edge. Parameters of trims that are nearly equal to the end of a span become
/// equal to it.
std::vector<l3d_shared_edge> l3d_shared_edges(std::span<const l3d_model_edge> edges,
                                              std::span<l3d_patch_points> pieces);

#endif
