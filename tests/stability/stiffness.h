// SPDX-License-Identifier: MIT
// How far out of proportion a case is.
#ifndef L3D_TESTS_STABILITY_STIFFNESS_H
#define L3D_TESTS_STABILITY_STIFFNESS_H

#include "cases.h"

/// Four ratios, each 1 for a flat rectangle of equal steps that faces the eye. Infinite where
/// something vanishes, as the speed does at a collapsed side.
namespace stability {

struct stiffness {
    /// Largest to least distance of neighbouring control points along a row or a column: the ratio
    /// of the speeds that a curve begins, goes on and ends with.
    double speed = 1;
    /// Third difference of a row or column to its chord, plus 1.
    double third = 1;
    /// Largest to least distance of control points along the view axis, which are the weights of
    /// the patch in the picture. Infinite if some are behind the eye.
    double weights = 1;
    /// Longest to shortest of the mean lengths along u and along v.
    double aspect = 1;

    /// The largest of the four.
    double most() const;
};

/// The largest ratios of all patches of a case. Expects: !is_malformed(c).
stiffness stiffness_of(const test_case& c);

} // namespace stability

#endif
