// SPDX-License-Identifier: MIT
// The trapezoid rule, with errors from the slopes beside each stretch.
#include "reference/quadrature.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>

namespace reference {
namespace {

/// The slope beside a stretch, before or after it: over a quarter of its width at least. Narrower
/// ones tell of a jump that is none of this stretch's business. Empty if a known jump or the end
/// comes first.
std::optional<double> slope_beside(std::span<const line_node> nodes, std::size_t stretch,
                                   bool after) {
    const double wanted = (nodes[stretch + 1].at - nodes[stretch].at) / 4;
    const std::size_t from = after ? stretch + 1 : stretch;
    for (std::size_t to = from; after ? to + 1 < nodes.size() : to > 0;) {
        if (nodes[after ? to + 1 : to].after_jump)
            break;
        after ? ++to : --to;
        const double width = nodes[to].at - nodes[from].at;
        if (std::abs(width) >= wanted)
            return (nodes[to].light - nodes[from].light) / width;
    }
    return std::nullopt;
}

} // namespace

std::vector<double> stretch_errors(std::span<const line_node> nodes) {
    assert(nodes.size() >= 2);
    std::vector<double> result(nodes.size() - 1);
    for (std::size_t k = 0; k < result.size(); ++k) {
        const double width = nodes[k + 1].at - nodes[k].at;
        const double change = nodes[k + 1].light - nodes[k].light;
        const double jump = width / 2 * std::abs(change), bend = width * width / 4;
        const auto slope_before = slope_beside(nodes, k, false);
        const auto slope_after = slope_beside(nodes, k, true);
        if (nodes[k + 1].after_jump || (!slope_before && !slope_after)) {
            result[k] = jump;
            continue;
        }
        // Where there is one neighbour only, it stands for both.
        const double own = change / width;
        const double before = std::abs(own - slope_before.value_or(slope_after.value_or(own)));
        const double after = std::abs(own - slope_after.value_or(slope_before.value_or(own)));
        result[k] = std::min(bend * (before + after), jump + bend * std::min(before, after));
    }
    return result;
}

line_node integral_of(std::span<const line_node> nodes) {
    const auto errors = stretch_errors(nodes);
    line_node result;
    result.unsure = std::accumulate(errors.begin(), errors.end(), 0.0);
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
        const line_node &from = nodes[k], &to = nodes[k + 1];
        const double half = (to.at - from.at) / 2;
        result.light += half * (from.light + to.light);
        result.covered += half * (from.covered + to.covered);
        result.unsure += half * (from.unsure + to.unsure);
    }
    return result;
}

} // namespace reference
