// SPDX-License-Identifier: MIT
// The sequence is the published one; every number of a range is equally likely, its ends included.
#include "geom/random.h"

#include <array>
#include <gtest/gtest.h>
#include <limits>

// Computed from the formulas of the paper with whole numbers of any length.
TEST(random, is_the_published_sequence) {
    l3d_random random(42);
    for (const std::uint32_t wanted : {0xc2f57bd6u, 0x6b07c4a9u, 0x72b7b29bu, 0x44215383u})
        EXPECT_EQ(random.next(), wanted);
}

TEST(random, seeds_give_other_numbers) {
    EXPECT_NE(l3d_random(1).next(), l3d_random(2).next());
}

TEST(random, fills_a_range_evenly) {
    constexpr int draws = 120000;
    l3d_random random(7);
    std::array<int, 12> found{};
    for (int i = 0; i < draws; ++i)
        ++found.at(static_cast<std::size_t>(random.between(-5, 6) + 5));
    // 10000 each, with a standard deviation of sqrt(draws * 1/12 * 11/12) = 96; five of them.
    for (const int count : found)
        EXPECT_NEAR(count, draws / 12, 480);
}

TEST(random, reaches_the_ends_of_what_there_is) {
    l3d_random random(3);
    EXPECT_EQ(random.between(9, 9), 9);
    constexpr int least = std::numeric_limits<int>::min();
    constexpr int most = std::numeric_limits<int>::max();
    bool negative = false;
    bool positive = false;
    for (int i = 0; i < 64; ++i) {
        const int drawn = random.between(least, most);
        negative |= drawn < 0;
        positive |= drawn > 0;
    }
    EXPECT_TRUE(negative && positive);
}

// There are two words for every other number of this range, and one for the rest: all of them come
// equally often only because some draws are repeated.
TEST(random, is_even_where_the_range_divides_nothing) {
    constexpr int draws = 30000;
    constexpr int half = 0x55555554; // of 2 * half + 1 numbers, 2/3 of 2^32
    l3d_random random(5);
    int odd = 0;
    for (int i = 0; i < draws; ++i)
        odd += random.between(-half, half) & 1;
    // Standard deviation sqrt(draws) / 2 = 87; five of them.
    EXPECT_NEAR(odd, draws / 2, 433);
}

TEST(random, fractions_are_below_one) {
    l3d_random random(11);
    double sum = 0;
    for (int i = 0; i < 10000; ++i) {
        const double drawn = random.fraction();
        ASSERT_GE(drawn, 0);
        ASSERT_LT(drawn, 1);
        sum += drawn;
    }
    EXPECT_NEAR(sum / 10000, 0.5, 5 * 0.2887 / 100); // five standard deviations of the mean
}
