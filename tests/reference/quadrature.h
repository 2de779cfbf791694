// SPDX-License-Identifier: MIT
// The mean of a function that is smooth but for jumps, and how sure it is.
#ifndef L3D_REFERENCE_QUADRATURE_H
#define L3D_REFERENCE_QUADRATURE_H

#include <cstddef>
#include <span>
#include <vector>

namespace reference {

/// The facts known at one place of a line: the light there, and the covered share.
struct line_node {
    double at = 0;
    double light = 0, covered = 0;
    double unsure = 0;       ///< error bound of the light
    bool after_jump = false; ///< whether light is known to jump since the node before
};

/// Estimates the errors that the trapezoid rule makes between neighbouring nodes.
///
/// Between two nodes, h apart and D different, a jump of D causes an error of h D / 2 at most. A
/// bend of the slope by B causes h h B / 8. The slopes of the neighbouring stretches tell which
/// share of its own slope is due to either. Slopes across a known jump are left out. A thing
/// between two nodes that changes nothing at any node stays unknown.
///
/// Shape:   one error less than nodes, in units of light times those of `at`.
/// Expects: two nodes at least, by growing `at`.
std::vector<double> stretch_errors(std::span<const line_node> nodes);

/// The trapezoid rule's sums over the whole line. `at` is left 0, and `unsure` is the sum of all
/// errors.
/// Expects: as stretch_errors does.
line_node integral_of(std::span<const line_node> nodes);

} // namespace reference

#endif
