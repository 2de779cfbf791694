// SPDX-License-Identifier: MIT
// l3d_integer_cubic: halved, walked or both, its values are the exact ones.
#include "geom/forward_difference.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace {

using control_values = std::array<std::int64_t, 4>;

/// Bernstein's form at i / n, times n^3, which is 8^level.
std::int64_t exact(const control_values& b, std::int64_t i, std::int64_t n) {
    const std::int64_t j = n - i;
    return (b[0] * j * j * j + 3 * b[1] * j * j * i + 3 * b[2] * j * i * i + b[3] * i * i * i);
}

TEST(integer_cubic, has_the_exact_values_whatever_of_its_steps_are_halvings) {
    std::mt19937 random(1);
    for (int n = 0; n < 300; ++n) {
        const std::int64_t most = n % 3 == 0 ? 1 << 24 : 1000;
        control_values b{};
        for (std::int64_t& value : b)
            value = n % 5 == 0 ? (random() % 2 == 0 ? most : -most)
                               : static_cast<std::int64_t>(
                                     random() % static_cast<std::uint64_t>(2 * most + 1)) -
                                     most;
        const int level = n % 10 == 0 ? l3d_integer_cubic::most_level : static_cast<int>(n % 8);
        const std::int64_t steps = std::int64_t{1} << level;
        for (int halvings = 0; halvings <= level; ++halvings) {
            std::int64_t i = 0;
            l3d_integer_cubic(b).walk_halved(halvings, level - halvings, [&](std::int64_t value) {
                ASSERT_EQ(value, exact(b, i, steps)) << n << ": " << i << " of " << steps;
                ++i;
            });
            ASSERT_EQ(i, steps + 1);
        }
    }
}

TEST(integer_cubic, knows_its_level) {
    const l3d_integer_cubic cubic({1, 2, 3, 5});
    EXPECT_EQ(cubic.level(), 0);
    const auto [left, right] = cubic.split();
    EXPECT_EQ(left.level(), 1);
    EXPECT_EQ(right.split().second.level(), 2);
}

} // namespace
