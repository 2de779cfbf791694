// SPDX-License-Identifier: MIT
// l3d_bicubic_approximation: a bicubic patch in the place of a rational one of any degree.
#ifndef L3D_GEOM_BICUBIC_APPROXIMATION_H
#define L3D_GEOM_BICUBIC_APPROXIMATION_H

#include "geom/bezier_patch.h"
#include "geom/files/patch_file.h"

#include <cstddef>
#include <utility>
#include <vector>

/// A rational Bezier patch of any degree, or a part of one, in homogeneous coordinates.
///
/// Shape: (degree_u + 1) * (degree_v + 1) points (x w, y w, z w, w), u fastest.
struct l3d_rational_piece {
    using point = l3d_vector<double, 4>;

    int degree_u = 1, degree_v = 1;
    std::vector<point> points;
    /// How far rounding may have moved a coordinate, and a weight, of any point.
    double noise = 0, weight_noise = 0;

    /// Expects: degrees from 1 to 15, as many points as they say, weights that l3d_is_weight
    ///          accepts.
    explicit l3d_rational_piece(const l3d_patch_points& patch);

    const point& at(int row, int column) const {
        return points[static_cast<std::size_t>(row * (degree_u + 1) + column)];
    }

    /// The halves along u, or along v. Each boundary is a function of the same boundary of the
    /// whole; halves of a boundary that runs the other way are the same, bit for bit.
    std::pair<l3d_rational_piece, l3d_rational_piece> halves(bool along_u) const;
};

/// The bicubic patch that has a rational piece's corners, first derivatives and mixed derivatives
/// there, and how far it is from the piece (docs/NUMERICS.md, section 25).
///
/// A boundary of the patch is a function of that boundary of the piece, bit for bit, whichever way
/// it is run through.
struct l3d_bicubic_approximation {
    l3d_bezier_patch<double, 3> patch{};
    /// Bound of the distance between points of the same parameters. Units: those of the points.
    double error = 0;
    /// Bound of the distance between unit normals of the same parameters; infinite without one.
    double normal_error = 0;

    explicit l3d_bicubic_approximation(const l3d_rational_piece& piece);
};

#endif
