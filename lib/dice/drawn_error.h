// SPDX-License-Identifier: MIT
// Bounds what rounding and snapping of vertices add to the error of everything drawn between them.
#ifndef L3D_DICE_DRAWN_ERROR_H
#define L3D_DICE_DRAWN_ERROR_H

#include "geom/real.h"
#include "geom/step_bound.h"
#include "scene/dice_view.h"
#include "dice/snap.h"

#include <limits>

/// Bounds the error of a point evaluated from a control net in double, by 16 successive operations
/// on coordinates up to `largest`. The error of the image transform already includes halvings of
/// the net.
inline double l3d_evaluation_error(double largest) {
    return 16 * l3d_real_traits<double>::unit_roundoff * largest;
}

/// Bounds the error of a curve's points that Horner's scheme evaluates. The curve's power
/// coefficients are computed as differences of its control points.
///
/// All numbers here are in units of u * largest, with the unit roundoff u. First to third
/// differences are at most 2, 4, 8 and err by 2, 8, 24. The coefficients are at most 6, 12, 8, and
/// err by 12, 36, 24. Horner's products and sums are at most 8, 20, 20, 26, 26, 1, and each is
/// rounded. t is rounded, too, and the curve changes by at most 6 along it: 179 in all. Balancing
/// adds 11: it moves points by at most l3d_balance / 4 of the second derivative. The second
/// derivative has values up to 72, which err by 216 and are rounded three times.
inline double l3d_power_form_error(double largest) {
    return 190 * l3d_real_traits<double>::unit_roundoff * largest;
}

/// The errors of a piece's vertices and the range of their coordinates. drawn_error() computes a
/// bound of errors of places from these numbers.
///
/// Units: errors of x, y and w are in units of homogeneous points; reaches are in pixels from the
///        picture's centre.
struct l3d_vertex_accuracy {
    double error_xy = 0, error_w = 0; ///< errors of homogeneous coordinates, before the division
    double w_low = 0;                 ///< least w of the exact surface where something is drawn
    double seen_reach = 0;            ///< largest |x| or |y| of the piece's part that is seen
    double reach = 0;      ///< largest |x| or |y| of the vertices; may lie far outside the window
    double snap_error = 0; ///< error that snapping adds to a vertex, in pixels

    /// The largest ratio of a chord's w to the exact w at the same parameters. `in_front` is for
    /// pieces in front of the near plane, `crossing` for pieces that cross it.
    ///
    /// In front of the plane, steps keep a chord's w within an eighth of the exact w. Another
    /// eighth allows for drawn points beside the box in which the chord error was bounded. At the
    /// near plane, the exact w is at least half of the interpolated w.
    static constexpr double in_front = 1.25, crossing = 2;

    /// The part of drawn_error() that comes from rounding the centre of a folded quad to
    /// sub-pixels. Slits have no folded quads, so their bound leaves this part out. Units: pixels.
    static double of_centre() { return in_front * l3d_snap_error<double>(0); }

    /// Bounds the error of drawn points that comes on top of the chord error, for points inside the
    /// window. Units: pixels; infinite if w is not well enough known.
    ///
    /// Let corner i have homogeneous errors e_i. The corner is drawn at a distance d_i from its
    /// place X_i, and its 1 / w is wrong by the factor 1 + r_i. Let b_i be the corner's weight at
    /// the drawn point X0. To first order
    ///     S / w - X0 = chord + sum b_i (e_i.xy - X0 e_i.w) / w
    ///                + sum b_i w_i / w (d_i + r_i (X_i - X0)).
    /// The errors of w are multiplied by X0 alone, not by X_i, and sum b_i w_i / w is at most
    /// `w_ratio`. 1 / w is rounded to a float, by at most 2^-24 of it, and once more in the
    /// division.
    double drawn_error(double w_ratio) const {
        constexpr double root_two = 1.4142135623730951, reciprocal = 0x1p-23;
        if (!(error_w < w_low / 4))
            return std::numeric_limits<double>::infinity();
        return l3d_vertex_error(error_xy, error_w, seen_reach, w_low) +
               w_ratio * (snap_error + reciprocal * root_two * (reach + seen_reach));
    }
};

/// Bounds the error of a vertex along the line of sight. The error comes from the error of w, and
/// from rounding depth to a float. The bound does not include the error of the vertex' place in the
/// picture.
/// Units: pixels at the vertex' depth.
inline double l3d_depth_vertex_error(const l3d_dice_view& view, double error_w, double w_low) {
    return view.focal * (error_w / w_low) + view.depth_rounding();
}

#endif
