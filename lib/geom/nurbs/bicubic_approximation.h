// SPDX-License-Identifier: MIT
// l3d_bicubic_approximation, l3d_normal_approximation: bicubic patches and normals that stand for a
// rational patch of any degree.
#ifndef L3D_GEOM_BICUBIC_APPROXIMATION_H
#define L3D_GEOM_BICUBIC_APPROXIMATION_H

#include "geom/bezier_patch.h"
#include "geom/files/patch_file.h"
#include "geom/normal_net.h"

#include <cstddef>
#include <utility>
#include <vector>

/// A rational Bezier patch of any degree, or a part of one, in homogeneous coordinates. A piece is
/// halved until bicubic patches approximate its parts well enough.
///
/// Shape: (degree_u + 1) * (degree_v + 1) points (x w, y w, z w, w), u fastest.
struct l3d_rational_piece {
    using point = l3d_vector<double, 4>;

    int degree_u = 1, degree_v = 1;
    std::vector<point> points;
    /// Bounds of the rounding in any point: `noise` for a coordinate, `weight_noise` for the
    /// weight.
    double noise = 0, weight_noise = 0;

    /// Expects: degrees from 1 to 15, as many points as the degrees ask for, weights that
    ///          l3d_is_weight accepts.
    explicit l3d_rational_piece(const l3d_patch_points& patch);

    const point& at(int row, int column) const {
        return points[static_cast<std::size_t>(row * (degree_u + 1) + column)];
    }

    /// Cuts the piece in half along u, or along v. A boundary of a half depends only on the same
    /// boundary of the whole. So the halves of pieces with a common boundary share their
    /// boundaries, bit for bit, also if the pieces run along it in opposite directions.
    std::pair<l3d_rational_piece, l3d_rational_piece> halves(bool along_u) const;
};

/// A bicubic patch that stands for a rational piece, with a bound of the patch's error
/// (docs/NUMERICS.md, section 25). The patch meets the piece at 4 by 4 places, the corners among
/// them.
///
/// A boundary of the patch depends only on the same boundary of the piece. The boundary has the
/// same bits in whichever direction the piece runs along it.
struct l3d_bicubic_approximation {
    l3d_bezier_patch<double, 3> patch{};
    /// Bound of the distance between points of the patch and of the piece at the same parameters.
    /// Units: those of the points.
    double error = 0;

    explicit l3d_bicubic_approximation(const l3d_rational_piece& piece);
};

/// The normals of a rational piece as a polynomial of degree 5 by 5, with a bound of the
/// polynomial's error. The polynomial is exact at 6 by 6 places, the corners among them.
struct l3d_normal_approximation {
    l3d_normal_net net;
    /// Bound of the distance between unit normals at the same parameters; infinite if no bound was
    /// found.
    double error = 0;

    explicit l3d_normal_approximation(const l3d_rational_piece& piece);
};

#endif
