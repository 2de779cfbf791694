// SPDX-License-Identifier: MIT
// flat_steps: bounds the distance between chords and their curve.
#include "raster/paths/flat_curve_p.h"

#include <algorithm>
#include <array>
#include <cmath>

l3d_detail::flat_plan l3d_detail::flat_steps(const l3d_curve_2d& curve, double distance) {
    const auto& p = curve.points;
    const bool plain = is_plain(curve);
    std::array<l3d_point_2d, 4> hull;
    std::ranges::transform(p, hull.begin(), projected);
    const l3d_point_2d origin{(hull[0].x + hull[3].x) / 2, (hull[0].y + hull[3].y) / 2};
    double least_weight = p[0][2];
    for (std::size_t i = 0; i < hull.size(); ++i) {
        hull[i] = {hull[i].x - origin.x, hull[i].y - origin.y};
        least_weight = std::min(least_weight, p[i][2]);
    }
    // Second differences of the control points, with places relative to the origin.
    std::array<l3d_point_2d, 2> bends;
    std::array<double, 2> weights{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto second = [&](int k) { return p[i][k] - 2 * p[i + 1][k] + p[i + 2][k]; };
        weights[i] = plain ? 0 : second(2);
        bends[i] = {second(0) - origin.x * weights[i], second(1) - origin.y * weights[i]};
    }
    // The largest length of bend - x weight, for all places x on chords, which are within
    // `distance` of the hull.
    const auto most_of = [&](l3d_point_2d bend, double weight) {
        double most = 0;
        for (const l3d_point_2d& corner : hull) {
            const double x = bend.x - corner.x * weight, y = bend.y - corner.y * weight;
            most = std::max(most, x * x + y * y);
        }
        return std::sqrt(most) + distance * std::abs(weight);
    };
    const double second =
        6 * std::max(most_of(bends[0], weights[0]), most_of(bends[1], weights[1]));
    if (second <= 8 * distance * least_weight)
        return {1, false};
    const double third =
        6 * most_of({bends[1].x - bends[0].x, bends[1].y - bends[0].y}, weights[1] - weights[0]);
    // The least 1 / h for which h^2 (second + 0.3 h third) is at most 16 times the distance. For
    // the h in brackets, the value for third = 0 is taken. In this form, the quotients need not
    // wait for the roots.
    const double squared = second / (16 * distance * least_weight);
    const double inner = std::sqrt(squared + 0.3 * third / second * std::sqrt(squared));
    const double steps = std::ceil(std::max(inner + 2 * (1 - flat_step_at_ends), 2.0));
    // If one half bends less than the other, uneven steps save more than they cost, up to this
    // number of steps.
    constexpr double most_uneven_steps = 24;
    return {steps, steps > (third < second / 4 ? most_flat_steps : most_uneven_steps)};
}
