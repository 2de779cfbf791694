// SPDX-License-Identifier: MIT
// l3d_forward_difference_surface against exact bicubics: its error bound and its operators.
#include "geom/bezier_oracle.h"
#include "geom/forward_difference_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace {

using oracle::real;
using fixed_16 = l3d_fixed<std::int32_t, 16>;
using fixed_20 = l3d_fixed<std::int32_t, 20>;
using fixed_32 = l3d_fixed<std::int64_t, 32>;
using values = std::array<double, 16>;

constexpr std::uint64_t seed = 20260119;

template <class T> l3d_forward_difference_surface<T> built(const values& b, int n, int m) {
    return l3d_forward_difference_surface<T>::build(b, n, m);
}

double exact_value(const values& b, real u, real v) {
    std::array<real, 16> wide;
    std::copy(b.begin(), b.end(), wide.begin());
    return static_cast<double>(oracle::bicubic(wide, u, v).value);
}

double choose(int n, int k) {
    double result = 1;
    for (int i = 0; i < k; ++i)
        result *= static_cast<double>(n - i) / (i + 1);
    return result;
}

/// S(n) = 1 + n + C(n, 2) + C(n, 3): what n steps make of an error of 1 in every register.
double spread(int n) {
    return choose(n, 0) + choose(n, 1) + choose(n, 2) + choose(n, 3);
}

/// Largest register d[i][j] of a walk in n by m steps: the i-th difference in u of the j-th in v
/// is at most the mixed derivative's largest coefficient over n^i m^j.
double largest_register(const values& b, int i, int j, int n, int m) {
    constexpr double falling[] = {1, 3, 6, 6}; // 3! / (3 - i)!
    values d = b;
    std::size_t columns = 4, rows = 4;
    for (int k = 0; k < i; ++k, --columns)
        for (std::size_t r = 0; r < 4; ++r)
            for (std::size_t c = 0; c + 1 < columns; ++c)
                d[4 * r + c] = d[4 * r + c + 1] - d[4 * r + c];
    for (int k = 0; k < j; ++k, --rows)
        for (std::size_t r = 0; r + 1 < rows; ++r)
            for (std::size_t c = 0; c < columns; ++c)
                d[4 * r + c] = d[4 * (r + 1) + c] - d[4 * r + c];
    double largest = 0;
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c)
            largest = std::max(largest, std::abs(d[4 * r + c]));
    return largest * falling[i] * falling[j] / (std::pow(n, i) * std::pow(m, j));
}

/// In double the differences of control values cancel: 170 u p for a walk in one direction (see
/// l3d_forward_difference_error), 28 p at most in all registers of the other.
double cancelling(const values& b, int n, int m) {
    return 170 * 29 * l3d_real_traits<double>::unit_roundoff * largest_register(b, 0, 0, n, m);
}

/// The error of walking n by m steps in fixed point.
///
/// One rounding to T per register, of differences made in double.
template <class T> double fixed_bound(const values& b, int n, int m) {
    return l3d_real_traits<T>::half_ulp * spread(n) * spread(m) + cancelling(b, n, m);
}

/// The same in floating point: every register is off by u of its size at first, every addition
/// by u of its result.
template <class T> double floating_bound(const values& b, int n, int m) {
    using traits = l3d_real_traits<T>;
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j)
            sum +=
                choose(n, i) * (choose(m, j) + choose(m, j + 1)) * largest_register(b, i, j, n, m);
        sum += choose(n, i + 1) * largest_register(b, i, 0, n, m);
    }
    return traits::unit_roundoff * sum + cancelling(b, n, m);
}

template <class T> double bound(const values& b, int n, int m) {
    if constexpr (l3d_is_fixed<T>)
        return fixed_bound<T>(b, n, m);
    else
        return floating_bound<T>(b, n, m);
}

template <class T> class forward_difference_surface : public testing::Test {
protected:
    /// Around 300 or all over, on a 2^-10 grid, which every type holds exactly.
    values any() {
        const bool far = random.up_to(2) == 1;
        values b;
        for (double& value : b)
            value = far ? random.on_grid(280, 330, 10) : random.on_grid(-400, 500, 10);
        return b;
    }

    /// Walks all rows and returns the largest error.
    template <class Walk> static double error_of(Walk walk, const values& b, int n, int m) {
        double error = 0;
        for (int j = 0; j <= m; ++j, walk.step_v()) {
            auto row = walk.row();
            for (int i = 0; i <= n; ++i, row.step())
                error = std::max(error, std::abs(l3d_to_double(row.value()) -
                                                 exact_value(b, real(i) / n, real(j) / m)));
        }
        return error;
    }

    oracle::random_values random{seed};

private:
    testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(seed)};
};

using numbers = testing::Types<float, double, fixed_16, fixed_20, fixed_32>;
TYPED_TEST_SUITE(forward_difference_surface, numbers);

TYPED_TEST(forward_difference_surface, every_point_is_within_the_bound) {
    using T = TypeParam;
    double worst = 0;
    // 12.20 holds no more than these values; the registers beyond wrap, which does no harm.
    for (int round = 0; round < 300; ++round) {
        const int n = this->random.up_to(24), m = this->random.up_to(24);
        const values b = this->any();
        const double error = this->error_of(built<T>(b, n, m), b, n, m);
        const double allowed = bound<T>(b, n, m);
        ASSERT_LE(error, allowed) << n << " by " << m << " steps";
        worst = std::max(worst, error / allowed);
    }
    EXPECT_GT(worst, 0.01) << "a bound so loose says nothing";
    std::printf("    measured / bound at most %.3f\n", worst);
}

TYPED_TEST(forward_difference_surface, starts_at_the_first_control_point_and_ends_at_the_last) {
    using T = TypeParam;
    const values b = this->any();
    auto walk = built<T>(b, 7, 5);
    EXPECT_EQ(l3d_to_double(walk.value()), b[0]);
    EXPECT_EQ(walk.row().value(), walk.value());
    for (int i = 0; i < 7; ++i)
        walk.step_u();
    EXPECT_NEAR(l3d_to_double(walk.value()), b[3], bound<T>(b, 7, 5));
    for (int j = 0; j < 5; ++j)
        walk.step_v();
    EXPECT_NEAR(l3d_to_double(walk.value()), b[15], bound<T>(b, 7, 5));
}

/// Both ways to the same point: in fixed point the very same bits.
TYPED_TEST(forward_difference_surface, steps_in_u_and_v_commute) {
    using T = TypeParam;
    for (int round = 0; round < 50; ++round) {
        const int n = this->random.up_to(16), m = this->random.up_to(16);
        const values b = this->any();
        auto u_first = built<T>(b, n, m), v_first = u_first;
        for (int i = 0; i < n; ++i)
            u_first.step_u();
        for (int j = 0; j < m; ++j) {
            u_first.step_v();
            v_first.step_v();
        }
        for (int i = 0; i < n; ++i)
            v_first.step_u();
        if constexpr (l3d_is_fixed<T>) {
            for (std::size_t i = 0; i < 4; ++i)
                EXPECT_EQ(u_first.in_v[i].d, v_first.in_v[i].d);
        } else {
            EXPECT_NEAR(u_first.value(), v_first.value(), 2 * bound<T>(b, n, m));
        }
    }
}

/// On dyadic data every operator is exact, so that the walk may change its step at any time.
TEST(exact_forward_difference_surface, halves_and_doubles_in_both_directions_without_error) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // 2^-8 data, 16 by 16 steps at the finest: 8 + 3 * 4 + 3 * 4 = 32 fraction bits.
    constexpr int finest = 4, grid = 8;
    oracle::random_values random(seed);
    for (int round = 0; round < 200; ++round) {
        values b;
        for (double& value : b)
            value = random.on_grid(-400, 500, grid);
        int level_u = random.up_to(finest), level_v = random.up_to(finest);
        auto walk = built<fixed_32>(b, 1 << level_u, 1 << level_v);
        int u = 0, v = 0; // in finest steps
        while (u < 1 << finest || v < 1 << finest) {
            const int step_u = 1 << (finest - level_u), step_v = 1 << (finest - level_v);
            switch (random.up_to(6)) {
            case 1:
                if (level_u < finest) {
                    walk.halve_u();
                    ++level_u;
                }
                break;
            case 2:
                if (level_v < finest) {
                    walk.halve_v();
                    ++level_v;
                }
                break;
            case 3:
                if (level_u > 0 && u % (2 * step_u) == 0) {
                    walk.double_u();
                    --level_u;
                }
                break;
            case 4:
                if (level_v > 0 && v % (2 * step_v) == 0) {
                    walk.double_v();
                    --level_v;
                }
                break;
            case 5:
                if (u < 1 << finest) {
                    walk.step_u();
                    u += step_u;
                }
                break;
            default:
                if (v < 1 << finest) {
                    walk.step_v();
                    v += step_v;
                }
            }
            ASSERT_EQ(l3d_to_double(walk.value()),
                      exact_value(b, std::ldexp(real(u), -finest), std::ldexp(real(v), -finest)))
                << "at " << u << ", " << v << " of 16";
        }
    }
}

/// Halving rounds every register by at most 1.875 half ulps (in floating point by u of its size),
/// once in each direction, on top of the errors that were there. Doubling adds nothing in fixed
/// point, and as much again in floating point. Halving, unlike stepping, is wrong for a register
/// that has left its range; from four steps on even 12.20 holds all of them.
TYPED_TEST(forward_difference_surface, halved_in_both_directions_is_built_at_half_the_steps) {
    using T = TypeParam;
    for (int round = 0; round < 50; ++round) {
        const int n = 3 + this->random.up_to(8), m = 3 + this->random.up_to(8);
        const values b = this->any();
        const double allowed = 4 * (bound<T>(b, 2 * n, 2 * m) + bound<T>(b, n, m));
        auto walk = built<T>(b, n, m);
        walk.halve_u();
        walk.halve_v();
        EXPECT_LE(this->error_of(walk, b, 2 * n, 2 * m), allowed);
        walk.double_v();
        walk.double_u();
        EXPECT_LE(this->error_of(walk, b, n, m), allowed);
    }
}

} // namespace
