// SPDX-License-Identifier: MIT
// l3d_scan_piece: a piece of a patch that Newton's iteration is led over.
#ifndef L3D_COMPARE_PLOTTERS_SCAN_PIECE_H
#define L3D_COMPARE_PLOTTERS_SCAN_PIECE_H

#include "geom/step_bound.h"

#include <array>
#include <cstdint>
#include <optional>

/// The parameters of a point of a piece, each from 0 to 1, and its w.
struct l3d_scan_root {
    double u = 0.5, v = 0.5, w = 0;
};

/// The effort of Newton's iterations. A round is one evaluation of the surface, or of a curve on
/// it.
struct l3d_scan_effort {
    std::int64_t solved = 0, failed = 0;               ///< iterations
    std::int64_t solved_rounds = 0, failed_rounds = 0; ///< rounds of these iterations

    void add(bool is_solved, int rounds) {
        (is_solved ? solved : failed) += 1;
        (is_solved ? solved_rounds : failed_rounds) += rounds;
    }
};

/// A piece in power form, which Horner's scheme evaluates: points and derivatives.
class l3d_scan_piece {
public:
    /// Newton's iteration doubles the number of right digits in each round. An iteration that needs
    /// more rounds goes astray.
    static constexpr int most_rounds = 10;

    explicit l3d_scan_piece(const l3d_image_patch& net);

    /// The parameters at which the piece is seen at (x, y), by Newton's iteration from `start`.
    /// Nothing if it does not converge within `accuracy` pixels, or converges outside the piece.
    ///
    /// Source:  Blinn in Lane, Carpenter, Whitted, Blinn, Scan Line Methods for Displaying
    ///          Parametrically Defined Surfaces, CACM 23, 1980.
    std::optional<l3d_scan_root> find(double x, double y, l3d_scan_root start,
                                      double accuracy) const {
        int rounds = 0;
        return find(x, y, start, accuracy, rounds);
    }

    /// Finds the parameters as above, and adds the number of evaluations to `rounds`.
    std::optional<l3d_scan_root> find(double x, double y, l3d_scan_root start, double accuracy,
                                      int& rounds) const;

    /// A point and its derivatives.
    struct jet {
        l3d_image_point value, by_u, by_v;
    };
    jet at(double u, double v) const;

    /// A point with its second derivatives, too.
    struct second_jet : jet {
        l3d_image_point by_uu, by_uv, by_vv;
    };
    second_jet second_at(double u, double v) const;

    std::array<std::array<l3d_image_point, 4>, 4> powers_; ///< [power of v][power of u]
};

/// Whether the image of a net is proved to be one to one. Then it has no silhouette, fold or
/// overlap.
///
/// Let c be any point of the image's box. The derivatives of (x, y) - c w are means of the net's
/// differences. The test is that the differences along u lie within a right angle, and so do those
/// along v, and that each pair of one along u and one along v turns the same way. Then all
/// derivatives turn that way, whatever c is.
/// Expects: every w > 0.
bool l3d_is_one_to_one(const l3d_image_patch& net, const l3d_image_box& hull);

#endif
