// SPDX-License-Identifier: MIT
// The trapezoid rule, with errors from the slopes beside each stretch.
#include "reference/quadrature.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace reference {

std::vector<double> stretch_errors(std::span<const line_node> nodes) {
    assert(nodes.size() >= 2);
    const std::size_t count = nodes.size() - 1;
    const auto slope = [&](std::size_t k) {
        return (nodes[k + 1].light - nodes[k].light) / (nodes[k + 1].at - nodes[k].at);
    };
    std::vector<double> result(count);
    const auto is_jump = [&](std::size_t k) { return nodes[k + 1].after_jump; };
    for (std::size_t k = 0; k < count; ++k) {
        const double width = nodes[k + 1].at - nodes[k].at, own = slope(k);
        const double jump = width * width / 2 * std::abs(own), bend = width * width / 4;
        const bool has_before = k > 0 && !is_jump(k - 1);
        const bool has_after = k + 1 < count && !is_jump(k + 1);
        if (is_jump(k) || (!has_before && !has_after)) {
            result[k] = jump;
            continue;
        }
        // Where there is one neighbour only, it stands for both.
        const double before = std::abs(own - slope(has_before ? k - 1 : k + 1));
        const double after = std::abs(own - slope(has_after ? k + 1 : k - 1));
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
