// SPDX-License-Identifier: MIT
// Rational Bezier patches of any degree by definition, in long double, and random ones.
#ifndef L3D_TESTS_GEOM_RATIONAL_ORACLE_H
#define L3D_TESTS_GEOM_RATIONAL_ORACLE_H

#include "geom/bezier_patch.h"
#include "geom/files/patch_file.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace oracle {

using place_3 = std::array<long double, 3>;

inline long double length(const place_3& a) {
    return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}
inline long double distance(const place_3& a, const place_3& b) {
    return length({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}
inline place_3 unit(const place_3& a) {
    const long double l = length(a);
    return {a[0] / l, a[1] / l, a[2] / l};
}

/// Bernstein polynomials of degree n at t, and their derivatives.
struct bernstein {
    std::vector<long double> value, slope;

    bernstein(int n, long double t) : value(basis(n, t)), slope(value.size(), 0) {
        const std::vector<long double> lower = basis(n - 1, t);
        for (std::size_t i = 0; i < value.size(); ++i)
            slope[i] = n * ((i > 0 ? lower[i - 1] : 0) - (i < lower.size() ? lower[i] : 0));
    }

private:
    static std::vector<long double> basis(int n, long double t) {
        std::vector<long double> b{1};
        for (int level = 0; level < n; ++level) {
            b.push_back(0);
            for (std::size_t i = b.size() - 1; i > 0; --i)
                b[i] = b[i] * (1 - t) + b[i - 1] * t;
            b[0] *= 1 - t;
        }
        return b;
    }
};

/// Place and first derivatives of a patch at (u, v).
struct rational_jet {
    place_3 place{}, by_u{}, by_v{};

    rational_jet(const l3d_patch_points& patch, long double u, long double v) {
        const bernstein in_u(patch.degree_u, u), in_v(patch.degree_v, v);
        std::array<std::array<long double, 4>, 3> sums{}; // value, by u, by v
        for (std::size_t r = 0; r < in_v.value.size(); ++r)
            for (std::size_t c = 0; c < in_u.value.size(); ++c) {
                const std::size_t i = r * in_u.value.size() + c;
                const long double w = patch.weights.empty() ? 1 : patch.weights[i];
                const long double of[3] = {in_u.value[c] * in_v.value[r],
                                           in_u.slope[c] * in_v.value[r],
                                           in_u.value[c] * in_v.slope[r]};
                for (std::size_t d = 0; d < 3; ++d) {
                    for (std::size_t k = 0; k < 3; ++k)
                        sums[d][k] += of[d] * w * patch.points[i][k];
                    sums[d][3] += of[d] * w;
                }
            }
        for (std::size_t k = 0; k < 3; ++k) {
            place[k] = sums[0][k] / sums[0][3];
            by_u[k] = (sums[1][k] - place[k] * sums[1][3]) / sums[0][3];
            by_v[k] = (sums[2][k] - place[k] * sums[2][3]) / sums[0][3];
        }
    }

    rational_jet(const l3d_bezier_patch<double, 3>& patch, long double u, long double v)
        : rational_jet(as_points(patch), u, v) {}

    place_3 normal() const {
        return {by_u[1] * by_v[2] - by_u[2] * by_v[1], by_u[2] * by_v[0] - by_u[0] * by_v[2],
                by_u[0] * by_v[1] - by_u[1] * by_v[0]};
    }

private:
    static l3d_patch_points as_points(const l3d_bezier_patch<double, 3>& patch) {
        l3d_patch_points result{3, 3, {}};
        for (const auto& p : patch.points)
            result.points.push_back({p[0], p[1], p[2]});
        return result;
    }
};

/// A random patch of degrees 1 to 15. Most are rational, with weights from 1e-3 to 1e3 or nearly
/// equal ones; some are nearly flat, far from the origin, thin as needles, or have a pole.
inline l3d_patch_points random_rational(std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1, 1);
    const int top = random() % 2 == 0 ? 15 : 3;
    l3d_patch_points patch{1 + static_cast<int>(random() % static_cast<unsigned>(top)),
                           1 + static_cast<int>(random() % static_cast<unsigned>(top)),
                           {}};
    const double wild = std::array{1.0, 0.1, 0.001}[random() % 3];
    const double weights = std::array{0.0, 0.3, 6.9}[random() % 3]; // of logarithms
    const double needle = random() % 8 == 0 ? 1e-4 : 1;
    const double far = random() % 8 == 0 ? 1e4 : 0;
    for (int r = 0; r <= patch.degree_v; ++r)
        for (int c = 0; c <= patch.degree_u; ++c) {
            const double x = static_cast<double>(c) / patch.degree_u;
            const double y = static_cast<double>(r) / patch.degree_v;
            patch.points.push_back({(x + wild * any(random)) * needle + far, y + wild * any(random),
                                    wild * any(random)});
            if (weights > 0)
                patch.weights.push_back(std::exp(weights * any(random)));
        }
    if (random() % 6 == 0)
        for (int c = 1; c <= patch.degree_u; ++c)
            patch.points[static_cast<std::size_t>(c)] = patch.points[0];
    return patch;
}

} // namespace oracle

#endif
