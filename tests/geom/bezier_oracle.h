// SPDX-License-Identifier: MIT
// Cubics and bicubics by definition, in long double, and random control values for them.
#ifndef L3D_TESTS_GEOM_BEZIER_ORACLE_H
#define L3D_TESTS_GEOM_BEZIER_ORACLE_H

#include "geom/bezier_patch.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace oracle {

using real = long double;

struct jet {
    real value = 0, slope = 0;
};

/// A cubic with Bernstein coefficients b, through its power coefficients: the library never goes
/// that way. Rounding is some 40 * 2^-64 of the largest coefficient.
inline jet cubic(const std::array<real, 4>& b, real t) {
    const real a1 = 3 * (b[1] - b[0]);
    const real a2 = 3 * (b[0] - 2 * b[1] + b[2]);
    const real a3 = b[3] - b[0] + 3 * (b[1] - b[2]);
    return {b[0] + t * (a1 + t * (a2 + t * a3)), a1 + t * (2 * a2 + t * 3 * a3)};
}

/// One coordinate of a bicubic patch, with its derivatives.
struct surface_jet {
    real value = 0, by_u = 0, by_v = 0;
};

/// Shape: b[4 * row + column], columns along u.
inline surface_jet bicubic(const std::array<real, 16>& b, real u, real v) {
    std::array<real, 4> values, slopes;
    for (std::size_t r = 0; r < 4; ++r) {
        const jet row = cubic({b[4 * r], b[4 * r + 1], b[4 * r + 2], b[4 * r + 3]}, u);
        values[r] = row.value;
        slopes[r] = row.slope;
    }
    const jet across = cubic(values, v);
    return {across.value, cubic(slopes, v).value, across.slope};
}

template <class T, int N>
std::array<real, 4> component(const l3d_bezier_curve<T, N>& curve, int k) {
    std::array<real, 4> b;
    for (std::size_t i = 0; i < 4; ++i)
        b[i] = l3d_to_double(curve.points[i][k]);
    return b;
}

template <class T, int N>
std::array<real, 16> component(const l3d_bezier_patch<T, N>& patch, int k) {
    std::array<real, 16> b;
    for (std::size_t i = 0; i < 16; ++i)
        b[i] = l3d_to_double(patch.points[i][k]);
    return b;
}

/// The same numbers from the same seed everywhere, which distributions of the library are not.
class random_values {
public:
    explicit random_values(std::uint64_t seed) : engine_(seed) {}

    double within(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }

    /// A multiple of 2^-fraction_bits.
    double on_grid(double low, double high, int fraction_bits) {
        return std::ldexp(std::floor(std::ldexp(within(low, high), fraction_bits)), -fraction_bits);
    }

    int up_to(int most) { return static_cast<int>(engine_() % static_cast<unsigned>(most)) + 1; }

private:
    std::mt19937_64 engine_;
};

} // namespace oracle

#endif
