// SPDX-License-Identifier: MIT
// Patches of any degrees, evaluated in the plainest way.
#ifndef L3D_TESTS_GEOM_PATCH_POINTS_H
#define L3D_TESTS_GEOM_PATCH_POINTS_H

#include "geom/files/patch_file.h"

#include <array>
#include <cstddef>
#include <vector>

using triple = std::array<double, 3>;

inline std::size_t points_along(int degree) {
    return static_cast<std::size_t>(degree) + 1;
}

/// sum of b_i B_i(t) by de Casteljau's scheme.
inline triple on_curve(std::vector<triple> b, double t) {
    for (std::size_t last = b.size() - 1; last > 0; --last)
        for (std::size_t i = 0; i < last; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                b[i][k] += t * (b[i + 1][k] - b[i][k]);
    return b[0];
}

inline triple on_surface(const l3d_patch_points& patch, double u, double v) {
    const auto columns = static_cast<std::ptrdiff_t>(points_along(patch.degree_u));
    std::vector<triple> column;
    for (auto row = patch.points.begin(); row != patch.points.end(); row += columns)
        column.push_back(on_curve(std::vector<triple>(row, row + columns), u));
    return on_curve(column, v);
}

#endif
