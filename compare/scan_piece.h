// SPDX-License-Identifier: MIT
// l3d_scan_piece: a piece of a patch that Newton's iteration is led over.
#ifndef L3D_COMPARE_SCAN_PIECE_H
#define L3D_COMPARE_SCAN_PIECE_H

#include "geom/step_bound.h"

#include <array>
#include <optional>

/// Parameters of a point of a piece, each from 0 to 1, and w there.
struct l3d_scan_root {
    double u = 0.5, v = 0.5, w = 0;
};

/// A piece in power form, for points and derivatives by Horner's scheme.
class l3d_scan_piece {
public:
    explicit l3d_scan_piece(const l3d_image_patch& net);

    /// The parameters at which the piece is seen at (x, y), by Newton's iteration from `start`;
    /// nothing if it does not come to rest within `accuracy` pixels, or rests outside the piece.
    ///
    /// Source: Blinn's way in Lane, Carpenter, Whitted, Blinn, Scan Line Methods for Displaying
    ///         Parametrically Defined Surfaces, CACM 23, 1980.
    std::optional<l3d_scan_root> find(double x, double y, l3d_scan_root start,
                                      double accuracy) const;

private:
    struct jet {
        l3d_image_point value, by_u, by_v;
    };
    jet at(double u, double v) const;

    std::array<std::array<l3d_image_point, 4>, 4> powers_; ///< [power of v][power of u]
};

/// Whether the image of a net is proved to be one to one: no silhouette, no fold, no overlap.
///
/// Let c be any point of its box. The derivatives of (x, y) - c w are means of the net's
/// differences. Let those along u lie within a right angle, and those along v, and let each pair of
/// them turn the same way. Then so do all derivatives, whatever c.
/// Expects: every w > 0.
bool l3d_is_one_to_one(const l3d_image_patch& net, const l3d_image_box& hull);

#endif
