// SPDX-License-Identifier: MIT
// l3d_scan_edge: curves in the image that scan lines meet, for all scan line methods.
#ifndef L3D_COMPARE_PLOTTERS_SCAN_EDGES_H
#define L3D_COMPARE_PLOTTERS_SCAN_EDGES_H

#include "compare/plotters/scan_piece.h"

#include <cmath>
#include <vector>

/// The column of the first pixel whose centre, x + 1/2, is at or after a position.
inline int l3d_first_centre(double position) {
    return static_cast<int>(std::ceil(position - 0.5));
}

/// The parameters at t of the way from one root to another.
inline l3d_scan_root l3d_between(const l3d_scan_root& a, const l3d_scan_root& b, double t) {
    return {a.u + (b.u - a.u) * t, a.v + (b.v - a.v) * t, 0};
}

/// A stretch of a curve that goes down from end to end, so that it has one point on a scan line.
struct l3d_scan_edge {
    l3d_image_curve curve;
    double top, bottom; ///< the scan lines' y of its ends
    l3d_scan_root from, to;

    bool meets(double y) const { return top <= y && y < bottom; }
};

/// The place where an edge meets a scan line.
struct l3d_scan_crossing {
    double x;
    l3d_scan_root root;
};

/// Cuts a curve between two roots into edges, and adds those that are not level.
void l3d_add_scan_edges(const l3d_image_curve& curve, l3d_scan_root from, l3d_scan_root to,
                        std::vector<l3d_scan_edge>& edges);

/// Finds the crossing of an edge and a scan line; there always is one. Newton's iteration finds it,
/// and halving takes over where the iteration would leave the edge.
/// Expects: edge.meets(y).
l3d_scan_crossing l3d_guarded_crossing(const l3d_scan_edge& edge, double y);

/// The parameter of the crossing by Newton's iteration alone. It begins at `start`, the crossing
/// with the scan line before. Adds the number of evaluations to `rounds`. Nothing if the iteration
/// does not come to rest within `accuracy` pixels, or leaves the edge.
std::optional<double> l3d_newton_crossing(const l3d_scan_edge& edge, double y, double start,
                                          double accuracy, int& rounds);

/// The parameter of the chord's crossing, where Newton's iteration begins on an edge's first scan
/// line.
double l3d_chord_start(const l3d_scan_edge& edge, double y);

/// The part of a curve between two parameters.
l3d_image_curve l3d_curve_part(const l3d_image_curve& curve, double from, double to);

#endif
