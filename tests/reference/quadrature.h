// SPDX-License-Identifier: MIT
// The mean of a function that is smooth but for jumps, and how sure it is.
#ifndef L3D_REFERENCE_QUADRATURE_H
#define L3D_REFERENCE_QUADRATURE_H

#include <cstddef>
#include <span>
#include <vector>

namespace reference {

/// What is known at one place of a line: the light there, and how much of it is covered.
struct line_node {
    double at = 0;
    double light = 0, covered = 0;
    double unsure = 0;       ///< of the light
    bool after_jump = false; ///< light is known to jump between the node before and this one
};

/// The errors that the trapezoid rule may make between neighbouring nodes.
///
/// Between two nodes, h apart and D different, a jump of D is wrong by h D / 2 at most. A bend of
/// the slope by B is wrong by h h B / 8. Slopes beside the stretch tell how far its own one is due
/// to either, but for those across a jump that is known. A thing between two nodes that changes
/// nothing at any node stays unknown.
///
/// Shape:   one error less than nodes, units of light times those of `at`.
/// Expects: nodes by growing `at`, two at least.
std::vector<double> stretch_errors(std::span<const line_node> nodes);

/// The trapezoid rule's sums, over the whole line; `at` is left 0, and `unsure` holds all errors.
/// Expects: as stretch_errors does.
line_node integral_of(std::span<const line_node> nodes);

} // namespace reference

#endif
