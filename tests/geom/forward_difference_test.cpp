// SPDX-License-Identifier: MIT
// l3d_forward_difference against exact cubics: its error bound, exactness on dyadic data,
// operators.
#include "geom/bezier_oracle.h"
#include "geom/forward_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <type_traits>

namespace {

using oracle::real;
using fixed_16 = l3d_fixed<std::int32_t, 16>;
using fixed_32 = l3d_fixed<std::int64_t, 32>;
using values = std::array<double, 4>;

constexpr std::uint64_t seed = 20260118;

template <class T> const char* name() {
    if constexpr (std::is_same_v<T, float>)
        return "float";
    else if constexpr (std::is_same_v<T, double>)
        return "double";
    else
        return sizeof(T) == 4 ? "16.16" : "32.32";
}

/// Largest control value, and largest first, second and third difference of neighbours.
std::array<double, 4> magnitudes(values b) {
    std::array<double, 4> result{};
    for (std::size_t order = 0; order < 4; ++order) {
        for (std::size_t i = 0; i + order < 4; ++i)
            result[order] = std::max(result[order], std::abs(b[i]));
        for (std::size_t i = 0; i + order + 1 < 4; ++i)
            b[i] = b[i + 1] - b[i];
    }
    return result;
}

template <class T> double bound(int n, const values& b) {
    const auto m = magnitudes(b);
    return l3d_forward_difference_error<T>(n, m[0], m[1], m[2], m[3]);
}

template <class T> l3d_forward_difference<T, 3> built(const values& b, int steps) {
    return l3d_forward_difference<T, 3>::build(b, steps);
}

real exact_value(const values& b, real t) {
    return oracle::cubic({b[0], b[1], b[2], b[3]}, t).value;
}

template <class T> class forward_difference : public testing::Test {
protected:
    /// Control values of all kinds, up to 512 and far from 0, on a 2^-10 grid, which every type
    /// holds exactly.
    values any() {
        const double x = random.on_grid(-500, 500, 10);
        switch (random.up_to(4)) {
        case 1: // anything
            return {x, within(500), within(500), within(500)};
        case 2: // the largest differences of all orders
            return {x, -x, x, -x};
        case 3: // nearly straight
            return {x, x / 2 + within(1), within(1), within(1) - x / 2};
        default: // short, far away
            return {400 + within(1), 400 + within(1), 401 + within(1), 400 + within(1)};
        }
    }
    double within(double size) { return random.on_grid(-size, size, 11); }

    oracle::random_values random{seed};

private:
    testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(seed)};
};

using numbers = testing::Types<float, double, fixed_16, fixed_32>;
TYPED_TEST_SUITE(forward_difference, numbers);

TYPED_TEST(forward_difference, every_step_is_within_the_stated_error) {
    using T = TypeParam;
    double worst = 0, worst_last = 0;
    for (int n = 1; n <= 1024; ++n)
        for (int round = 0; round < 6; ++round) {
            const values b = this->any();
            const double allowed = bound<T>(n, b);
            auto walk = built<T>(b, n);
            double error = 0;
            for (int i = 0; i <= n; ++i, walk.step()) {
                const real at_i = exact_value(b, real(i) / n);
                error = std::max(error, double(std::abs(l3d_to_double(walk.value()) - at_i)));
                if (i == n)
                    worst_last = std::max(
                        worst_last, double(std::abs(l3d_to_double(walk.value()) - b[3])) / allowed);
            }
            ASSERT_LE(error, allowed)
                << n << " steps of " << b[0] << ' ' << b[1] << ' ' << b[2] << ' ' << b[3];
            worst = std::max(worst, error / allowed);
        }
    EXPECT_LE(worst_last, 1);
    EXPECT_GT(worst, 0.05) << "a bound so loose says nothing";
    std::printf("    %-6s measured / bound at most %.3f, at the end point %.3f\n", name<T>(), worst,
                worst_last);
}

TYPED_TEST(forward_difference, one_step_is_the_whole_curve) {
    using T = TypeParam;
    const values b = {37.5, -211.25, 8.75, 301.125};
    auto walk = built<T>(b, 1);
    EXPECT_EQ(l3d_to_double(walk.value()), b[0]);
    walk.step();
    EXPECT_EQ(l3d_to_double(walk.value()), b[3]);
}

/// The error that a register may have. In fixed point it is half an ulp, in floating point u times
/// the registers' sizes. For the differences of control values, it is u of double times p.
template <class T> double fresh_error(int k, int n, const values& b) {
    using traits = l3d_real_traits<T>;
    const auto m = magnitudes(b);
    const double d3 = 6 * m[3] / std::pow(n, 3), d2 = 6 * m[2] / (1.0 * n * n) + d3;
    const double sizes[] = {m[0], 3 * m[1] / n + 2 * d2, d2, d3};
    const auto at = static_cast<std::size_t>(k);
    return traits::half_ulp + traits::unit_roundoff * sizes[at] +
           l3d_real_traits<double>::unit_roundoff * 512 * m[0] / std::pow(n, k);
}

TYPED_TEST(forward_difference, halved_is_built_at_half_the_step) {
    using T = TypeParam;
    using traits = l3d_real_traits<T>;
    double worst = 0;
    for (int n = 1; n <= 300; ++n) {
        const values b = this->any();
        auto halved = built<T>(b, n);
        halved.halve();
        const auto fresh = built<T>(b, 2 * n);
        const double old[] = {0, fresh_error<T>(1, n, b), fresh_error<T>(2, n, b),
                              fresh_error<T>(3, n, b)};
        const double size[] = {0, std::abs(l3d_to_double(fresh.d[1])),
                               std::abs(l3d_to_double(fresh.d[2])),
                               std::abs(l3d_to_double(fresh.d[3]))};
        const double h = traits::half_ulp, u = traits::unit_roundoff;
        // How halve passes on old errors, and its own roundings: 1.75, 1.75 and 1 + 1.75/2 half
        // ulps; in floating point one subtraction for the second, one more for the first.
        const double carried[] = {old[0], old[1] / 2 + old[2] / 8 + old[3] / 16,
                                  old[2] / 4 + old[3] / 8, old[3] / 8};
        const double own[] = {0, 1.875 * h + u * (size[1] + size[2]), 1.75 * h + u * size[2],
                              1.75 * h};
        for (int k = 0; k < 4; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const double allowed = carried[k] + own[k] + 1.01 * fresh_error<T>(k, 2 * n, b);
            const double error = std::abs(l3d_to_double(halved.d[i]) - l3d_to_double(fresh.d[i]));
            ASSERT_LE(error, allowed) << "difference " << k << ", " << n << " steps";
            if (allowed > 0)
                worst = std::max(worst, error / allowed);
        }
    }
    std::printf("    %-6s measured / bound at most %.3f\n", name<T>(), worst);
}

TYPED_TEST(forward_difference, doubling_undoes_halving) {
    using T = TypeParam;
    using traits = l3d_real_traits<T>;
    double worst = 0;
    for (int n = 1; n <= 1000; ++n) {
        const auto before = built<T>(this->any(), n);
        auto after = before;
        after.halve();
        after.double_step();
        const auto size = [&](std::size_t k) { return std::abs(l3d_to_double(before.d[k])); };
        // d2 is doubled twice, d3 three times: roundings of 1.5 + 1.5 and 1.75 half ulps come back
        // 4 and 8 fold. Doubling gives back what halve takes from d1, except halve's own rounding,
        // doubled. Floating point: d3 is exact, d2 has one rounding either way, d1 too.
        const double h = traits::half_ulp, u = traits::unit_roundoff;
        const double allowed[] = {0, 2 * h + 3 * u * (size(1) + size(2)),
                                  12 * h + 3 * u * (size(2) + size(3)), 14 * h};
        for (std::size_t k = 0; k < 4; ++k) {
            const double error = std::abs(l3d_to_double(after.d[k]) - l3d_to_double(before.d[k]));
            ASSERT_LE(error, allowed[k]) << "difference " << k << ", " << n << " steps";
            if (allowed[k] > 0)
                worst = std::max(worst, error / allowed[k]);
        }
    }
    std::printf("    %-6s measured / bound at most %.3f\n", name<T>(), worst);
}

/// 2^(3 k) times the cubic at i / 2^k, for integer Bernstein coefficients: an integer.
std::int64_t exact_times_cube(const std::array<std::int64_t, 4>& b, std::int64_t i, int k) {
    const std::int64_t j = (std::int64_t{1} << k) - i;
    return b[0] * j * j * j + 3 * b[1] * i * j * j + 3 * b[2] * i * i * j + b[3] * i * i * i;
}

/// Data on a 2^-grid grid walked in 2^k steps need grid + 3 k fraction bits, and no more.
template <class Fixed> void expect_exact(int k, std::uint64_t curves) {
    const int grid = Fixed::fraction_bits - 3 * k;
    oracle::random_values random(seed + static_cast<std::uint64_t>(k));
    for (std::uint64_t round = 0; round < curves; ++round) {
        std::array<std::int64_t, 4> raw;
        values b;
        for (std::size_t i = 0; i < 4; ++i) {
            b[i] = random.on_grid(-500, 500, grid);
            raw[i] = static_cast<std::int64_t>(std::ldexp(b[i], grid));
        }
        auto walk = built<Fixed>(b, 1 << k);
        for (std::int64_t i = 0; i <= (1 << k); ++i, walk.step())
            ASSERT_EQ(walk.value().raw(), exact_times_cube(raw, i, k)) << "step " << i;
    }
}

TEST(exact_forward_difference, has_no_error_on_dyadic_data) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (int k = 0; k <= 10; ++k)
        expect_exact<fixed_32>(k, 30);
    for (int k = 0; k <= 5; ++k)
        expect_exact<fixed_16>(k, 200);
    using fixed_20 = l3d_fixed<std::int32_t, 20>;
    expect_exact<fixed_20>(4, 500); // 16 steps of 1/256 pixel over 1000 pixels in 32 bits
}

/// Adaptive walks: any order of steps, halvings and doublings stays exact on dyadic data.
TEST(exact_forward_difference, stays_exact_through_halving_and_doubling) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    constexpr int finest = 8, grid = fixed_32::fraction_bits - 3 * finest;
    oracle::random_values random(seed);
    for (int round = 0; round < 300; ++round) {
        std::array<std::int64_t, 4> raw;
        values b;
        for (std::size_t i = 0; i < 4; ++i) {
            b[i] = random.on_grid(-500, 500, grid);
            raw[i] = static_cast<std::int64_t>(std::ldexp(b[i], grid));
        }
        int level = random.up_to(finest);
        auto walk = built<fixed_32>(b, 1 << level);
        int at = 0; // in finest steps
        while (at < 1 << finest) {
            const int step = 1 << (finest - level);
            const int choice = random.up_to(3);
            if (choice == 1 && level < finest) {
                walk.halve();
                ++level;
            } else if (choice == 2 && level > 0 && at % (2 * step) == 0) {
                walk.double_step();
                --level;
            } else {
                walk.step();
                at += step;
            }
            ASSERT_EQ(walk.value().raw(), exact_times_cube(raw, at, finest))
                << "at " << at << " of 256, level " << level;
        }
    }
}

/// Without rounding of its own, halving n times is the curve at a fine step: the operators' sign
/// and weights, on a curve whose differences are known.
TEST(exact_forward_difference, of_a_cube_is_known) {
    // t^3 has Bernstein coefficients 0 0 0 1; at step 1: 0 1 6 6; at step 1/2 an eighth of that.
    auto walk = built<double>({0, 0, 0, 1}, 1);
    EXPECT_EQ(walk.d, (std::array<double, 4>{0, 1, 6, 6}));
    walk.halve();
    EXPECT_EQ(walk.d, (std::array<double, 4>{0, 0.125, 0.75, 0.75}));
    walk.step(); // to t = 1/2: (1 - 1/8), 1.5, 0.75
    EXPECT_EQ(walk.d, (std::array<double, 4>{0.125, 0.875, 1.5, 0.75}));
    walk.halve(); // 0.75^3 - 0.5^3 = 0.296875
    EXPECT_EQ(walk.d, (std::array<double, 4>{0.125, 0.296875, 0.28125, 0.09375}));
    walk.double_step();
    EXPECT_EQ(walk.d, (std::array<double, 4>{0.125, 0.875, 1.5, 0.75}));
}

} // namespace
