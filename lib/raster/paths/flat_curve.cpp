// SPDX-License-Identifier: MIT
// flat_steps: the bound of a chord's distance.
#include "raster/paths/flat_curve_p.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

double length(l3d_point_2d p) {
    return std::sqrt(p.x * p.x + p.y * p.y);
}

} // namespace

l3d_detail::flat_plan l3d_detail::flat_steps(const l3d_curve_2d& curve, double distance) {
    const auto& p = curve.points;
    const bool plain = is_plain(curve);
    const l3d_point_2d from = projected(p[0]), to = projected(p[3]);
    const l3d_point_2d origin{(from.x + to.x) / 2, (from.y + to.y) / 2};
    double reach = 0, least_weight = 1;
    if (!plain) {
        least_weight = p[0][2];
        for (const auto& control : p) {
            const l3d_point_2d at = projected(control);
            reach = std::max(reach, length({at.x - origin.x, at.y - origin.y}));
            least_weight = std::min(least_weight, control[2]);
        }
        reach += distance; // so far chords may be from the curve
    }
    // Second differences from the origin.
    std::array<l3d_point_2d, 2> bends;
    std::array<double, 2> weights{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto second = [&](int k) { return p[i][k] - 2 * p[i + 1][k] + p[i + 2][k]; };
        weights[i] = plain ? 0 : second(2);
        bends[i] = {second(0) - origin.x * weights[i], second(1) - origin.y * weights[i]};
    }
    const double bend = std::max(length(bends[0]), length(bends[1]));
    const double weight_bend = std::max(std::abs(weights[0]), std::abs(weights[1]));
    const double second = 6 * (bend + reach * weight_bend);
    if (second <= 8 * distance * least_weight)
        return {1, false};
    const double third = 6 * (length({bends[1].x - bends[0].x, bends[1].y - bends[0].y}) +
                              reach * std::abs(weights[1] - weights[0]));
    // The least 1 / h for which h^2 (second + 0.3 h third) is at most 16 times the distance.
    const double least = std::sqrt(second / (16 * distance * least_weight));
    const double inner = least * std::sqrt(1 + 0.3 * third / (second * least));
    const double steps = std::ceil(std::max(inner + 2 * (1 - flat_step_at_ends), 2.0));
    // Where one half bends less than the other, it saves more steps than it costs.
    constexpr double most_uneven_steps = 24;
    return {steps, steps > (third < second / 4 ? most_flat_steps : most_uneven_steps)};
}
