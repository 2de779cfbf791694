// SPDX-License-Identifier: MIT
// A surface whose curvatures have closed forms, as a patch.
#ifndef L3D_TESTS_SCENE_QUADRIC_H
#define L3D_TESTS_SCENE_QUADRIC_H

#include "scene/patch_model.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace dice_tests {

/// z = a x^2 + b x y + c y^2.
struct quadric {
    double a, b, c;

    /// Over [-1, 1]^2, as one patch.
    l3d_patch_model model() const {
        // The blossom of x^2 at t1, t2 in {-1, -1/3, ...}: control values of -1..1 are -1, -1/3,
        // 1/3, 1.
        constexpr std::array<double, 4> linear{-1, -1.0 / 3, 1.0 / 3, 1},
            square{1, -1.0 / 3, -1.0 / 3, 1};
        l3d_patch_model::patch patch;
        for (std::size_t i = 0; i < 16; ++i) {
            const std::size_t u = i % 4, v = i / 4;
            patch.points[i] = {linear[u], linear[v],
                               a * square[u] + b * linear[u] * linear[v] + c * square[v]};
        }
        return l3d_patch_model(std::vector{patch});
    }

    double fx(double x, double y) const { return 2 * a * x + b * y; }
    double fy(double x, double y) const { return b * x + 2 * c * y; }
    double square(double x, double y) const {
        return 1 + fx(x, y) * fx(x, y) + fy(x, y) * fy(x, y);
    }
    double gaussian(double x, double y) const {
        return (4 * a * c - b * b) / (square(x, y) * square(x, y));
    }
    /// Positive where it bends towards +z.
    double mean(double x, double y) const {
        const double p = fx(x, y), q = fy(x, y), s = square(x, y);
        return ((1 + p * p) * 2 * c - 2 * p * q * b + (1 + q * q) * 2 * a) / (2 * s * std::sqrt(s));
    }
    /// Unit, on the side of +z.
    l3d_patch_model::vector normal(double x, double y) const {
        return l3d_patch_model::vector{-fx(x, y), -fy(x, y), 1.0} / std::sqrt(square(x, y));
    }
};

} // namespace dice_tests

#endif
