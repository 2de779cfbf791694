// SPDX-License-Identifier: MIT
// cosines, put_lamps: bound the cosines of a piece's normals with one direction, and with all lamps
// of a frame.
#ifndef L3D_DICE_CERTIFICATE_DOUBT_COSINES_P_H
#define L3D_DICE_CERTIFICATE_DOUBT_COSINES_P_H

#include "dice/certificate/doubt_bounds.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace l3d_detail {

/// Bounds the relative rounding of sums of a few dozen products in double. Each operation adds
/// 2^-53 of the sum's terms, so this bound is far larger than needed.
inline constexpr double rounding = 0x1p-40;

/// A linear function of a piece's parameters, which run from -1/2 to 1/2. The constructor takes
/// values at the four corners; the function is as near to these values as possible.
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

/// The coefficients of a piece's normals. Each is split into a part along an axis that all share,
/// and a part across this axis. Cosines of the normals are bounded from these parts.
struct seen_normals {
    using vector = l3d_normal_polynomial::vector;
    static constexpr std::size_t count =
        l3d_normal_polynomial::order * l3d_normal_polynomial::order;

    vector axis{0.0, 0.0, 0.0};
    std::array<double, count> along; ///< each coefficient's part along the axis
    double most_along = 0;           ///< the largest magnitude in `along`
    double most_across = 0, longest = 0;
    /// The largest ratio of a part across to the part along; infinite if any coefficient is far
    /// from the axis.
    double most_slope = 0;

    explicit seen_normals(const std::array<vector, count>& normals);
};

/// Bounds of the cosine n.l over a piece, for its unit normals n and a direction l to a light. The
/// cosine lies between `least` and `most`, and within `off` of `line`.
struct cosines {
    plane line{0, 0, 0, 0};
    double off = 1, least = -1, most = 1;
    double slope = 2; ///< largest distance of a unit normal from seen_normals::axis

    cosines(const l3d_doubt_piece& piece, const seen_normals& seen,
            const l3d_normal_polynomial::vector& light);
};

/// Turns a linear function of a piece's parameters into a linear function of the place in the
/// picture. `off` is the error of the function of parameters. The result's `off` is the error of
/// the function of the place.
l3d_doubt_line line_of(const plane& of, double off, const l3d_doubt_bounds& b);

/// Sets `into` to a line and the range from `least` to `most`, or to the range alone if the line's
/// error is no less than half of the range.
void put(l3d_doubt_line& into, double least, double most, const l3d_doubt_line& line);

/// Sets b.lamps: the bounds of the cosines for all lamps of the piece's lighting. Also sets
/// b.level.off to how uncertain the light is, which tells whether halving the piece is worth while.
/// Expects: all other members of b are set; w > 0.
void put_lamps(l3d_doubt_bounds& b, const l3d_doubt_piece& piece, const seen_normals& normals,
               const l3d_doubt_view& view);

} // namespace l3d_detail

#endif
