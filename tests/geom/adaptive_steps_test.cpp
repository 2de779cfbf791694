// SPDX-License-Identifier: MIT
// Adaptive walks: exact in whole numbers, and each step as long as a pixel asks for.
#include "effort.h"
#include "geom/forward_difference.h"
#include "geom/bezier_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace {

using values = std::array<double, 4>;
using whole = l3d_fixed<std::int64_t, 42>; ///< a grid of 2^-6, and 3 bits for each of 12 halvings

constexpr int grid = 6, finest = 12;
const int random_curves = thorough ? 100'000 : 10'000;

template <class T>
std::array<l3d_forward_difference<T, 3>, 2> built(const std::array<values, 2>& of, int first) {
    return {l3d_forward_difference<T, 3>::build(of[0], 1 << first),
            l3d_forward_difference<T, 3>::build(of[1], 1 << first)};
}

/// The cubic at i / 2^finest in units of 2^-42: a whole number.
std::int64_t exact(const values& of, std::int64_t i) {
    std::array<std::int64_t, 4> b{};
    for (std::size_t k = 0; k < b.size(); ++k)
        b[k] = std::llround(std::ldexp(of[k], grid));
    const std::int64_t j = (std::int64_t{1} << finest) - i;
    return b[0] * j * j * j + 3 * b[1] * i * j * j + 3 * b[2] * i * i * j + b[3] * i * i * i;
}

/// Curves of pictures: most of them some pixels to some hundreds long, some with one speed.
std::array<values, 2> any_curve(oracle::random_values& random) {
    const double reach = std::ldexp(1.0, random.up_to(10));
    std::array<values, 2> of{};
    for (values& b : of)
        for (double& value : b)
            value = random.on_grid(-reach, reach, grid);
    if (random.up_to(4) == 1)
        for (values& b : of) {
            b[1] = b[0] + (b[3] - b[0]) / 4;
            b[2] = b[3] - (b[3] - b[0]) / 4;
            for (double& value : b)
                value = std::ldexp(std::round(std::ldexp(value, grid)), -grid);
        }
    return of;
}

/// The larger move of both coordinates, in pixels.
double move(const std::array<values, 2>& of, std::int64_t from, std::int64_t to) {
    const auto along = [&](const values& b) {
        return std::ldexp(std::abs(static_cast<double>(exact(b, to) - exact(b, from))), -42);
    };
    return std::max(along(of[0]), along(of[1]));
}

TEST(adaptive_steps, are_exact_and_as_long_as_a_pixel_asks_for) {
    oracle::random_values random(20260118);
    std::int64_t steps = 0, doublings = 0;
    for (int round = 0; round < random_curves; ++round) {
        const std::array<values, 2> of = any_curve(random);
        const int first = random.up_to(4);
        std::int64_t visits = 0, halved = 0, doubled = 0, last = 0;
        int before = first;
        const l3d_step_counts counts = l3d_walk_adaptively(
            built<whole>(of, first), first, finest, whole(1),
            [&](std::int64_t at, int level, const auto& curve) {
                for (std::size_t k = 0; k < of.size(); ++k)
                    ASSERT_EQ(curve[k].value().raw(), exact(of[k], at)) << round << ", at " << at;
                if (visits++ == 0)
                    return;
                const std::int64_t step = (std::int64_t{1} << finest) >> level;
                ASSERT_EQ(at, last + step);
                ASSERT_TRUE(level == finest || move(of, last, at) <= 1) << round << ", at " << at;
                const std::int64_t longer = 2 * step;
                // Nor was the step before so short that one of twice the length would do here.
                const bool may_double = level == before && level > 0 && last > 0 &&
                                        last % longer == 0 && move(of, last, at) <= 0.5;
                ASSERT_TRUE(!may_double || move(of, last, last + longer) > 1)
                    << round << ", at " << at;
                halved += std::max(level - before, 0);
                doubled += std::max(before - level, 0);
                before = level;
                last = at;
            });
        ASSERT_EQ(last, std::int64_t{1} << finest);
        ASSERT_EQ(counts.steps, visits - 1);
        ASSERT_GE(counts.doublings, doubled); // one may be taken back before a step
        ASSERT_EQ(counts.halvings - counts.doublings, halved - doubled);
        steps += counts.steps;
        doublings += counts.doublings;
    }
    EXPECT_GT(steps / random_curves, 100);
    EXPECT_GT(doublings, random_curves);
}

/// What shifts squeeze out of 32 bits, and not of floating point.
template <class T> double worst_error(int curves) {
    oracle::random_values random(7);
    double worst = 0;
    for (int round = 0; round < curves; ++round) {
        const std::array<values, 2> of = any_curve(random);
        constexpr int first = 4; // then second differences of 1000 pixels fit into 16 bits
        l3d_walk_adaptively(
            built<T>(of, first), first, finest, l3d_from_double<T>(1.0),
            [&](std::int64_t at, int, const auto& curve) {
                for (std::size_t k = 0; k < of.size(); ++k) {
                    const double right = std::ldexp(static_cast<double>(exact(of[k], at)), -42);
                    worst = std::max(worst, std::abs(l3d_to_double(curve[k].value()) - right));
                }
            });
    }
    return worst;
}

TEST(adaptive_steps, are_exact_to_a_millionth_of_a_pixel_in_double_and_hardly_known_in_32_bits) {
    EXPECT_LT(worst_error<double>(random_curves), 1e-6);
    const double of_16_16 = worst_error<l3d_fixed<std::int32_t, 16>>(2000);
    EXPECT_GT(of_16_16, 10);
    std::printf("    16.16 is off by up to %.1f pixels\n", of_16_16);
}

/// A straight line of one speed: the step is chosen once.
TEST(adaptive_steps, of_a_line_change_only_at_its_beginning) {
    const std::array<values, 2> line{{{0, 64, 128, 192}, {0, 0, 0, 0}}};
    const auto ignore = [](std::int64_t, int, const auto&) {};
    const auto counts = l3d_walk_adaptively(built<whole>(line, 4), 4, finest, whole(1), ignore);
    EXPECT_EQ(counts.steps, 256);
    EXPECT_EQ(counts.halvings, 4);
    EXPECT_EQ(counts.doublings, 0);
    const auto shorter = l3d_walk_adaptively(built<whole>(line, 10), 10, finest, whole(1), ignore);
    EXPECT_EQ(shorter.doublings, 2);
}

} // namespace
