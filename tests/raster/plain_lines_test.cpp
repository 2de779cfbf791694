// SPDX-License-Identifier: MIT
// Lines with hard edges: the book's reference values, exact rules, and awkward coordinates.
#include "raster/lines/line_steps_p.h"

#include "raster/canvas_2d.h"
#include "raster/slow_2d.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

namespace {

constexpr unsigned seed = 20010322;
constexpr std::uint32_t color = canvas::color;

using slow_2d::pixel_of_line;
using wide = slow_2d::wide;

/// All of a line's pixels that lie in a picture, step by step.
pixel_set exact_line(const l3d_line_2d& l, int width, int height) {
    const std::int64_t length =
        std::max(std::abs(std::int64_t{l.x1} - l.x0), std::abs(std::int64_t{l.y1} - l.y0));
    pixel_set result;
    for (std::int64_t i = 0; i <= length; ++i) {
        const auto [x, y] = pixel_of_line(l, i);
        if (x >= 0 && x < width && y >= 0 && y < height)
            result.insert({static_cast<int>(x), static_cast<int>(y)});
    }
    return result;
}

pixel_set drawn(const l3d_line_2d& l, int width, int height) {
    canvas c(width, height);
    c.draw.draw_line(l.x0, l.y0, l.x1, l.y1, color);
    EXPECT_TRUE(c.guards_intact());
    return c.lit();
}

TEST(Lines, BookValues) {
    const pixel_set shallow = drawn({0, 0, 9, 3}, 13, 8);
    EXPECT_EQ(shallow.size(), 10u);
    for (int x = 0; x <= 9; ++x)
        EXPECT_EQ(std::ranges::count_if(shallow, [&](auto p) { return p.first == x; }), 1) << x;
    EXPECT_TRUE(shallow.contains({9, 3}));
    EXPECT_EQ(drawn({5, 5, 5, 5}, 13, 8), (pixel_set{{5, 5}}));
    EXPECT_EQ(drawn({2, 6, 9, 6}, 13, 8).size(), 8u);
    EXPECT_EQ(drawn({4, 1, 4, 6}, 13, 8).size(), 6u);
    EXPECT_EQ(drawn({3, 1, 8, 6}, 13, 8).size(), 6u);
}

TEST(Lines, TiesGoUpAndLeft) {
    EXPECT_EQ(drawn({2, 3, 4, 4}, 9, 7), (pixel_set{{2, 3}, {3, 3}, {4, 4}}));
    EXPECT_EQ(drawn({2, 4, 4, 3}, 9, 7), (pixel_set{{2, 4}, {3, 3}, {4, 3}}));
    EXPECT_EQ(drawn({5, 2, 4, 4}, 9, 7), (pixel_set{{5, 2}, {4, 3}, {4, 4}}));
}

/// Near lines, half of them clipped, in both directions.
void test_lines(int lines, unsigned first_seed) {
    std::mt19937 random(first_seed);
    std::uniform_int_distribution<int> near(-30, 60), size(1, 33);
    std::size_t lit = 0;
    for (int n = 0; n < lines; ++n) {
        const l3d_line_2d l{near(random), near(random), near(random), near(random)};
        const int width = size(random), height = size(random) + 2;
        const pixel_set expected = exact_line(l, width, height);
        ASSERT_EQ(drawn(l, width, height), expected)
            << "seed " << first_seed << ", line " << n << ": " << l.x0 << " " << l.y0 << " " << l.x1
            << " " << l.y1 << " in " << width << " x " << height;
        if (n % 4 == 0) {
            ASSERT_EQ(drawn({l.x1, l.y1, l.x0, l.y0}, width, height), expected);
        }
        lit += expected.size();
    }
    EXPECT_GT(lit, static_cast<std::size_t>(lines) * 3);
}

TEST(Lines, AreTheNearestPixelsInEitherDirection) {
    test_lines(50000, seed);
}

/// Takes a minute: make stress.
TEST(Lines, DISABLED_AMillionAreTheNearestPixels) {
    test_lines(1000000, seed + 9);
}

/// Lines with ends opposite each other, at most so far away, so that they come near the picture.
void test_far_lines(int least, int most, unsigned first_seed) {
    std::mt19937 random(first_seed);
    std::uniform_int_distribution<int> any(least, most), jitter(-40, 60);
    constexpr int width = 37, height = 23;
    std::size_t lit = 0;
    for (int n = 0; n < 20000; ++n) {
        l3d_line_2d l{any(random), any(random), 0, 0};
        l.x1 = static_cast<int>(
            std::clamp<std::int64_t>(jitter(random) - std::int64_t{l.x0}, least, most));
        l.y1 = static_cast<int>(
            std::clamp<std::int64_t>(jitter(random) - std::int64_t{l.y0}, least, most));
        const wide dx = wide{l.x1} - l.x0, dy = wide{l.y1} - l.y0;
        const bool x_major = (dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy);
        pixel_set expected;
        for (int major = 0; major < (x_major ? width : height); ++major) {
            const wide from = x_major ? l.x0 : l.y0, delta = x_major ? dx : dy;
            const wide i = delta < 0 ? from - major : major - from;
            const auto [x, y] = pixel_of_line(l, i);
            if (x >= 0 && x < width && y >= 0 && y < height)
                expected.insert({static_cast<int>(x), static_cast<int>(y)});
        }
        ASSERT_EQ(drawn(l, width, height), expected)
            << "seed " << first_seed << ", line " << n << ": " << l.x0 << " " << l.y0 << " " << l.x1
            << " " << l.y1;
        lit += expected.size();
    }
    EXPECT_GT(lit, 10000u);
}

TEST(Lines, FromFarAwayAreExactWhereTheyAreSeen) {
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    test_far_lines(least, most, seed + 1);
    constexpr int width = 37, height = 23;
    EXPECT_EQ(drawn({least, 4, most, 4}, width, height).size(), 37u);
    EXPECT_EQ(drawn({9, most, 9, least}, width, height).size(), 23u);
    EXPECT_TRUE(drawn({least, least, most, least}, width, height).empty());
}

/// As long as swift_minors serve.
TEST(Lines, FromTheFarthestThatAreSteppedInFixedPointAreExact) {
    constexpr int most = 1 << 17;
    test_far_lines(-most + 100, most - 100, seed + 2);
}

TEST(Lines, OfEveryDirectionAreExact) {
    constexpr int most = 40, size = most + 1;
    for (int dx = -most; dx <= most; ++dx)
        for (int dy = -most; dy <= most; ++dy) {
            const int x = dx < 0 ? most : 0, y = dy < 0 ? most : 0;
            const l3d_line_2d l{x, y, x + dx, y + dy};
            ASSERT_EQ(drawn(l, size, size), exact_line(l, size, size)) << dx << " " << dy;
        }
}

TEST(Lines, ThatLieInALargePictureAreExact) {
    constexpr int width = 700, height = 500;
    std::mt19937 random(seed + 3);
    std::uniform_int_distribution<int> column(0, width - 1), row(0, height - 1);
    for (int n = 0; n < 200; ++n) {
        l3d_line_2d l{column(random), row(random), column(random), row(random)};
        if (n % 8 == 0)
            l.y1 = l.y0;
        if (n % 8 == 1)
            l.x1 = l.x0;
        ASSERT_EQ(drawn(l, width, height), exact_line(l, width, height))
            << l.x0 << " " << l.y0 << " " << l.x1 << " " << l.y1;
    }
}

/// The pixels of a line in a picture just large enough, without a set of them.
void test_huge_line(const l3d_line_2d& l) {
    const int width = std::max(l.x0, l.x1) + 1, height = std::max(l.y0, l.y1) + 1;
    canvas c(width, height);
    c.draw.draw_line(l.x0, l.y0, l.x1, l.y1, color);
    const int length = std::max(width, height) - 1;
    for (int i = 0; i <= length; ++i) {
        const auto [x, y] = pixel_of_line(l, i);
        std::uint32_t& word = c.at(static_cast<int>(x), static_cast<int>(y));
        ASSERT_EQ(word, color) << length << ": " << i;
        word = 0;
    }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            ASSERT_EQ(c.at(x, y), 0u) << length << ": " << x << " " << y;
    EXPECT_TRUE(c.guards_intact());
}

/// Where the arithmetic changes from swift_minors to exact_steps.
TEST(Lines, AsLongAsFixedPointServesAndLongerAreExact) {
    for (const int length : {(1 << 18) - 1, 1 << 18, (1 << 18) + 1})
        for (const int rise : {1, 2, 3}) {
            test_huge_line({length, rise, 0, 0});
            test_huge_line({0, rise, length, 0});
            test_huge_line({rise, 0, 0, length});
            test_huge_line({rise, length, 0, 0});
        }
}

/// floor((2 i rise + length - 1) / (2 length)), as written.
std::int64_t minor_of_step(std::int64_t i, std::int64_t length, std::int64_t rise) {
    const std::int64_t n = 2 * i * rise + length - 1, d = 2 * length;
    return n / d - (n % d < 0 ? 1 : 0);
}

TEST(Lines, SwiftMinorsOfShortLinesAreExact) {
    using l3d_detail::swift_minors;
    EXPECT_EQ(swift_minors::of_short(0, 0).floor(), 0);
    for (std::int32_t length = 1; length < swift_minors::short_length; ++length)
        for (std::int32_t rise = -length; rise <= length; ++rise) {
            swift_minors minors = swift_minors::of_short(length, rise);
            for (std::int32_t i = 0; i <= length; ++i, minors.step())
                ASSERT_EQ(minors.floor(), minor_of_step(i, length, rise)) << length << " " << rise;
        }
}

TEST(Lines, SwiftMinorsAreExactUpToTheLongestLines) {
    using l3d_detail::swift_minors;
    std::mt19937 random(seed + 4);
    constexpr std::int64_t longest = (1 << 18) - 1;
    EXPECT_TRUE(swift_minors::serve(longest));
    EXPECT_FALSE(swift_minors::serve(longest + 1));
    for (int n = 0; n < 64; ++n) {
        const std::int64_t length = longest - n % 5;
        const std::int64_t rise =
            n < 8 ? length - n
                  : std::uniform_int_distribution<std::int64_t>(-length, length)(random);
        swift_minors minors = swift_minors::of(length, rise);
        for (std::int64_t i = 0; i <= length; ++i, minors.step())
            ASSERT_EQ(minors.floor(), minor_of_step(i, length, rise)) << length << " " << rise;
        minors.skip(-7);
        EXPECT_EQ(minors.floor(), minor_of_step(length - 6, length, rise));
    }
}

TEST(Lines, InABatchAreTheSameLines) {
    canvas one(29, 17), batch(29, 17);
    const std::array<l3d_line_2d, 3> lines{{{1, 2, 20, 9}, {-5, 14, 40, 3}, {7, 7, 7, 7}}};
    for (const l3d_line_2d& l : lines)
        one.draw.draw_line(l.x0, l.y0, l.x1, l.y1, color);
    batch.draw.draw_lines(lines, color);
    EXPECT_EQ(one.lit(), batch.lit());
    EXPECT_GT(one.lit().size(), 40u);
}

} // namespace
