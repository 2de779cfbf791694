// SPDX-License-Identifier: MIT
// flat_steps: the bound of a chord's distance.
#include "raster/paths/flat_curve_p.h"

double l3d_detail::flat_steps(const l3d_curve_2d& curve, double distance) {
    const auto& p = curve.points;
    const bool plain = is_plain(curve);
    const l3d_point_2d from = projected(p[0]), to = projected(p[3]);
    const l3d_point_2d origin{(from.x + to.x) / 2, (from.y + to.y) / 2};
    double bend = 0, weight_bend = 0, reach = 0, least_weight = p[3][2];
    for (std::size_t i = 0; i < 2; ++i) {
        const auto second = [&](int k) { return p[i][k] - 2 * p[i + 1][k] + p[i + 2][k]; };
        const double w = plain ? 0 : second(2);
        const double x = second(0) - origin.x * w, y = second(1) - origin.y * w;
        bend = std::max(bend, x * x + y * y);
        weight_bend = std::max(weight_bend, std::abs(w));
    }
    if (!plain)
        for (const auto& control : p) {
            const l3d_point_2d at = projected(control);
            const double x = at.x - origin.x, y = at.y - origin.y;
            reach = std::max(reach, std::sqrt(x * x + y * y));
            least_weight = std::min(least_weight, control[2]);
        }
    const double second_derivative = 6 * (std::sqrt(bend) + reach * weight_bend);
    return std::ceil(std::sqrt(second_derivative / (8 * distance * least_weight)));
}
