// SPDX-License-Identifier: MIT
// cosines, put_lamps: cosines of a piece's normals with a direction, and with all lamps of a frame.
#ifndef L3D_DICE_CERTIFICATE_DOUBT_COSINES_P_H
#define L3D_DICE_CERTIFICATE_DOUBT_COSINES_P_H

#include "dice/certificate/doubt_bounds.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace l3d_detail {

/// Rounding of sums of a few dozen products in double, some 2^-53 each, with much to spare.
inline constexpr double rounding = 0x1p-40;

/// The linear function of a piece's parameters, from -1/2 to 1/2, that is nearest to values at the
/// four corners.
struct plane {
    double middle = 0, in_u = 0, in_v = 0;

    plane(double c00, double c01, double c10, double c11)
        : middle((c00 + c01 + c10 + c11) / 4), in_u((c01 - c00 + c11 - c10) / 2),
          in_v((c10 - c00 + c11 - c01) / 2) {}
    double at(double u, double v) const { return middle + in_u * u + in_v * v; }
    plane times(double factor) const {
        plane result = *this;
        result.middle *= factor;
        result.in_u *= factor;
        result.in_v *= factor;
        return result;
    }
    double range() const { return std::abs(in_u) + std::abs(in_v); }
};

/// A piece's normals, split into parts along their common axis and across it.
struct seen_normals {
    using vector = l3d_normal_polynomial::vector;
    static constexpr std::size_t count =
        l3d_normal_polynomial::order * l3d_normal_polynomial::order;

    vector axis{0.0, 0.0, 0.0};
    std::array<double, count> along; ///< each normal's part along the axis
    double most_along = 0;           ///< largest |along|
    double most_across = 0, longest = 0;
    double most_slope = 0; ///< largest across / along; infinite if a normal is far from the axis

    explicit seen_normals(const std::array<vector, count>& normals);
};

/// Bounds of the cosine n.l of unit normals n over a piece: from `least` to `most`, and within
/// `off` of `line`.
struct cosines {
    plane line{0, 0, 0, 0};
    double off = 1, least = -1, most = 1;
    double slope = 2; ///< largest distance of a unit normal from the normals' axis

    cosines(const l3d_doubt_piece& piece, const seen_normals& seen,
            const l3d_normal_polynomial::vector& light);
};

/// Turns a linear function of the parameters into one of the place in the picture.
l3d_doubt_line line_of(const plane& of, double off, const l3d_doubt_bounds& b);

/// Sets bounds to a line and its range, or to the range alone if the line is no better.
void put(l3d_doubt_line& into, double least, double most, const l3d_doubt_line& line);

/// Sets the bounds for all lamps of the piece's lighting, and the level's spread, which tells
/// whether halves of the piece would be better known.
/// Expects: all other bounds are set; w > 0.
void put_lamps(l3d_doubt_bounds& b, const l3d_doubt_piece& piece, const seen_normals& normals,
               const l3d_doubt_view& view);

} // namespace l3d_detail

#endif
