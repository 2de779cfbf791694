// SPDX-License-Identifier: MIT
// Why forward differencing in plain 16.16 failed, and what cures it: measured, beside the theory.
#include "geom/bezier_oracle.h"
#include "geom/fixed_failure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace fixed_failure;
using fixed_16 = l3d_fixed<std::int32_t, 16>;

constexpr std::uint64_t seed = 20260122;

/// S(n) = 1 + n + C(n, 2) + C(n, 3): n steps multiply the k-th difference's error by C(n, k).
double spread(int n) {
    const double pairs = n * (n - 1.0) / 2;
    return 1 + n + pairs + pairs * (n - 2.0) / 3;
}

/// Largest error of one walk of n steps of a curve in one coordinate.
double error_of_walk(const std::array<double, 4>& b, int n) {
    auto walk = l3d_forward_difference<fixed_16, 3>::build(b, n);
    double error = 0;
    for (int i = 0; i <= n; ++i, walk.step()) {
        const auto exact = oracle::cubic({b[0], b[1], b[2], b[3]}, oracle::real(i) / n).value;
        error = std::max(error, std::abs(static_cast<double>(l3d_to_double(walk.value()) - exact)));
    }
    return error;
}

/// One rounding a register and nothing else: 2^-17 S(n), reached by the unluckiest of many curves.
TEST(fixed_failure, of_a_curve_in_16_16_is_what_theory_says) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    std::printf("    %6s %12s %12s %8s\n", "steps", "measured px", "theory px", "ratio");
    for (const int n : {16, 64, 256, 1024}) {
        double error = 0;
        for (int round = 0; round < 2000; ++round) {
            std::array<double, 4> b;
            for (double& value : b)
                value = random.on_grid(-512, 512, 20);
            error = std::max(error, error_of_walk(b, n));
        }
        const double theory = std::ldexp(spread(n), -17);
        std::printf("    %6d %12.4g %12.4g %8.3f\n", n, error, theory, error / theory);
        // Differences made in double are off by 170 2^-53 512 = 1e-11 at most: 1e-6 half ulps.
        EXPECT_LE(error, theory * (1 + 2e-6));
        EXPECT_GT(error, 0.9 * theory);
        if (n == 1024) {
            EXPECT_GT(error, 1200);
        }
    }
}

/// The limits of a method's error, in pixels.
struct expectation {
    std::string_view number, way;
    double mean_from, mean_to, most_from, most_to;
};

constexpr double any = std::numeric_limits<double>::infinity();
constexpr expectation expected[] = {
    {"16.16", "tensor", 20, any, 300, any},      {"16.16", "isocurves", 2, any, 50, any},
    {"16.16", "strips of 16", 0, 0.01, 0, 0.15}, {"float", "tensor", 0, 1e-3, 0, 0.01},
    {"float", "isocurves", 0, 1e-3, 0, 0.01},    {"float", "strips of 16", 0, 1e-4, 0, 1e-3},
    {"32.32", "tensor", 2, any, 100, any},       {"32.32", "isocurves", 0, 0.02, 0, 0.5},
    {"32.32", "strips of 16", 0, 1e-6, 0, 1e-5},
};

TEST(fixed_failure, of_the_teapot_is_tens_to_hundreds_of_pixels_and_restarting_cures_it) {
    const auto patches = teapot_in_view_full("data/teapot.bpt");
    ASSERT_EQ(patches.size(), 28U);
    const auto ways = methods();
    std::vector<error_statistics> errors(ways.size());
    int least = std::numeric_limits<int>::max(), most = 0;
    for (const l3d_image_patch& patch : patches) {
        const steps n = steps_of_one_pixel(patch);
        least = std::min({least, n.u, n.v});
        most = std::max({most, n.u, n.v});
        const points exact = exact_points(patch, n);
        for (std::size_t i = 0; i < ways.size(); ++i)
            errors[i].add(exact, ways[i].walk(patch, n));
    }
    std::printf("    %zu points, %d to %d steps a patch\n", errors[0].count(), least, most);
    print_header();
    for (std::size_t i = 0; i < ways.size(); ++i) {
        print_row(ways[i], errors[i]);
        const expectation& e = expected[i];
        ASSERT_EQ(e.number, ways[i].number);
        ASSERT_EQ(e.way, ways[i].way);
        EXPECT_GE(errors[i].mean(), e.mean_from);
        EXPECT_LE(errors[i].mean(), e.mean_to);
        EXPECT_GE(errors[i].quantile(1), e.most_from);
        EXPECT_LE(errors[i].quantile(1), e.most_to);
    }
}

/// The product's certificate, on the same strips: S(16) in each coordinate, through the division.
TEST(fixed_failure, of_strips_is_within_the_certified_bound) {
    const auto patches = teapot_in_view_full("data/teapot.bpt");
    double worst = 0;
    for (const l3d_image_patch& patch : patches) {
        const steps n = steps_of_one_pixel(patch);
        // In fixed point the sizes of the registers do not matter.
        const double e = l3d_forward_difference_error<fixed_16>(short_strip, 0, 0, 0, 0);
        const double bound = l3d_vertex_error(e, e, l3d_image_box_of(patch.points).reach(),
                                              l3d_depth_range_of(patch.points).least);
        error_statistics errors;
        errors.add(exact_points(patch, n), isocurve_walk<fixed_16, short_strip>(patch, n));
        EXPECT_LE(errors.quantile(1), bound);
        worst = std::max(worst, errors.quantile(1) / bound);
    }
    std::printf("    strips of 16 in 16.16: measured / bound at most %.3f\n", worst);
}

} // namespace
