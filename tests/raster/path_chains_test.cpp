// SPDX-License-Identifier: MIT
// path_chains: where outlines are cut, and the exact areas of those that are not cut on the way.
#include "raster/canvas_2d.h"
#include "raster/paths/path.h"
#include "raster/paths/path_chains_p.h"
#include "raster/slow_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace {

constexpr int width = 15, height = 11;

using corners = std::vector<l3d_point_2d>;

/// How many chains an outline is cut into: two, or none.
std::size_t chains_of(const corners& c) {
    l3d_detail::path_chains chains;
    chains.clear(width, height);
    chains.begin(c[0]);
    chains.lines(std::span(c).subspan(1));
    chains.end(0);
    return chains.chains().size();
}

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Corners on an ellipse that fits between the picture's sides, in order and to either side. Some
/// are there twice; some are in line; it may be thin, and reach beyond the top and the bottom.
corners random_convex(std::mt19937& random) {
    const double rx = random() % 4 == 0 ? uniform(random, 0, 0.2) : uniform(random, 0, 7);
    const double ry = uniform(random, 0, 9);
    const double x = uniform(random, rx, width - 1 - rx), y = uniform(random, -2, height + 2);
    std::vector<double> angles(3 + random() % 9);
    for (double& a : angles)
        a = random() % 3 == 0 ? std::numbers::pi / 2 * double(random() % 4)
                              : uniform(random, 0, 2 * std::numbers::pi);
    std::ranges::sort(angles);
    if (random() % 2 == 0)
        std::ranges::reverse(angles);
    corners result;
    for (const double a : angles) {
        result.push_back({x + rx * std::cos(a), y + ry * std::sin(a)});
        if (random() % 8 == 0)
            result.push_back(result.back());
    }
    if (random() % 4 == 0)
        for (l3d_point_2d& c : result)
            c = {std::round(c.x) + 0.5, std::round(c.y) + 0.5}; // sides are level and in line
    return result;
}

TEST(path_chains, cover_the_exact_area_of_each_pixel) {
    std::mt19937 random(11);
    canvas c(width, height);
    int pairs = 0;
    for (int n = 0; n < 3000; ++n) {
        const corners shape = random_convex(random);
        l3d_path path;
        path.add_polygon(shape);
        c.draw.clear_buffer();
        c.draw.draw_path(path, {.color = 0x00ffffff});
        const slow_area::picture exact({{{shape}}});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                ASSERT_LE(std::abs((c.at(x, y) & 255) - 255 * double(exact.share(x, y))),
                          0.5 + 1e-6)
                    << n << ", pixel " << x << " " << y;
        corners moved = shape; // to where the picture's corner is (0, 0)
        for (l3d_point_2d& p : moved)
            p = {p.x + 0.5, p.y + 0.5};
        pairs += chains_of(moved) == 2;
    }
    EXPECT_GT(pairs, 2000);
}

TEST(path_chains, are_two_for_an_outline_that_turns_at_its_top_and_its_bottom_alone) {
    const std::vector<corners> outlines{
        {{1, 1}, {9, 1}, {9, 8}, {1, 8}},
        {{1, 8}, {9, 8}, {9, 1}, {1, 1}},
        {{1, 1}, {5, 1}, {9, 1}, {9, 1}, {9, 8}, {1, 8}, {1, 1}},
        {{0, 0}, {15, 3}, {2, 40}},
        {{-8, 1}, {9, 1}, {5, 8}},
        {{1, 1}, {9, 1}, {3, 2}, {1, 8}},
    };
    for (const corners& c : outlines)
        EXPECT_EQ(chains_of(c), 2u) << c[0].x << " " << c[0].y;
}

TEST(path_chains, are_none_for_an_outline_that_turns_more_often) {
    EXPECT_EQ(chains_of({{1, 1}, {5, 4}, {9, 1}, {9, 8}, {1, 8}}), 0u);
    EXPECT_EQ(chains_of({{1, 1}, {9, 1}, {5, 8}, {1, 1}, {9, 1}, {5, 8}}), 0u);
    corners star;
    for (int i = 0; i < 5; ++i)
        star.push_back({7 + 5 * std::sin(i * 0.8 * std::numbers::pi),
                        5 - 5 * std::cos(i * 0.8 * std::numbers::pi)});
    EXPECT_EQ(chains_of(star), 0u);
}

/// How many outlines are apart from all others.
std::size_t apart_of(const std::vector<corners>& outlines) {
    l3d_detail::path_chains chains;
    chains.clear(1000, 100);
    for (const corners& c : outlines) {
        chains.begin(c[0]);
        chains.lines(std::span(c).subspan(1));
        chains.end(0);
    }
    chains.sort();
    chains.find_apart();
    return static_cast<std::size_t>(
        std::ranges::count_if(chains.outlines(), [](const auto& o) { return o.apart; }));
}

TEST(path_chains, know_outlines_that_share_no_pixel_with_the_box_of_another) {
    const auto square = [](double x, double y) {
        return corners{{x, y}, {x + 2.5, y}, {x + 2.5, y + 2.5}, {x, y + 2.5}};
    };
    EXPECT_EQ(apart_of({square(3, 3)}), 1u);
    EXPECT_EQ(apart_of({square(3, 3), square(6, 3), square(3, 6)}), 3u);
    EXPECT_EQ(apart_of({square(3, 3), square(5.6, 3), square(30, 3)}), 1u);
    EXPECT_EQ(apart_of({square(3, 3), square(3, 5.6), square(30, 3)}), 1u);
    EXPECT_EQ(apart_of({square(3, 3), square(3, 3), square(3, 60)}), 1u);
    EXPECT_EQ(apart_of({square(3, 3), square(-20, 3)}), 1u); // the other one is left out
    // Very many beside each other are not looked at.
    std::vector<corners> many(200);
    for (std::size_t i = 0; i < many.size(); ++i)
        many[i] = square(4.0 * double(i), 3);
    EXPECT_EQ(apart_of(many), 0u);
    for (std::size_t i = 0; i < many.size(); ++i) {
        const std::size_t column = i % 20, row = i / 20;
        many[i] = square(4.0 * double(column), 4.0 * double(row));
    }
    EXPECT_EQ(apart_of(many), 200u);
}

TEST(path_chains, are_none_where_nothing_is_seen) {
    EXPECT_EQ(chains_of({{1, 1}}), 0u);
    EXPECT_EQ(chains_of({{1, 1}, {9, 1}, {1, 1}, {9, 1}}), 0u);
    EXPECT_EQ(chains_of({{1, -3}, {9, -1}, {5, -2}}), 0u);
    EXPECT_EQ(chains_of({{1, 11}, {9, 12}, {5, 13}}), 0u);
    EXPECT_EQ(chains_of({{-9, 1}, {0, 5}, {-4, 9}}), 0u);
    EXPECT_EQ(chains_of({{15, 1}, {99, 5}, {20, 9}}), 0u);
    EXPECT_EQ(chains_of({{-9, 1}, {0.1, 5}, {-4, 9}}), 2u);
    EXPECT_EQ(chains_of({{14.9, 1}, {99, 5}, {20, 9}}), 2u);
}

} // namespace
