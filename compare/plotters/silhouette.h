// SPDX-License-Identifier: MIT
// Silhouettes of a piece of a patch, at which it turns from its front to its back.
#ifndef L3D_COMPARE_PLOTTERS_SILHOUETTE_H
#define L3D_COMPARE_PLOTTERS_SILHOUETTE_H

#include "compare/plotters/scan_piece.h"

#include <optional>
#include <vector>

/// The determinant of a homogeneous point and its two derivatives, with its own derivatives. Its
/// sign tells which side of the surface is seen. Silhouettes are where it is 0.
struct l3d_scan_turn {
    double value, by_u, by_v;
};
l3d_scan_turn l3d_turn_at(const l3d_scan_piece& piece, double u, double v);

/// A place where a silhouette meets the border of a piece.
struct l3d_border_turn {
    int side; ///< v low, v high, u low, u high
    double t; ///< along the side
    l3d_scan_root root;
};

/// Finds the places where silhouettes meet the sides of a piece. Each side is divided into
/// `samples` equal intervals. Two such places in one interval are missed.
std::vector<l3d_border_turn> l3d_border_turns(const l3d_scan_piece& piece, int samples);

/// The parameters at t along a side.
l3d_scan_root l3d_on_side(int side, double t);

/// The point of a silhouette on a scan line, by Newton's iteration in two variables, within
/// `accuracy` pixels. Adds the number of evaluations to `rounds`. The point may lie outside of the
/// piece. Nothing if the iteration does not come to rest.
std::optional<l3d_scan_root> l3d_silhouette_on_line(const l3d_scan_piece& piece, double y,
                                                    l3d_scan_root start, double accuracy,
                                                    int& rounds);

/// The highest, lowest and saddle points inside a piece's picture. At these points y neither rises
/// nor falls, so two silhouettes begin or end. Searches begin at 5 x 5 places.
std::vector<l3d_scan_root> l3d_level_points(const l3d_scan_piece& piece, int& rounds);

#endif
