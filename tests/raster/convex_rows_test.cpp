// SPDX-License-Identifier: MIT
// convex_rows: which outlines are convex, and the exact areas of those that are.
#include "raster/canvas_2d.h"
#include "raster/paths/convex_rows_p.h"
#include "raster/paths/path.h"
#include "raster/slow_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace {

constexpr int width = 15, height = 11;

using corners = std::vector<l3d_point_2d>;

bool is_convex(const corners& c) {
    return l3d_detail::convex_rows().begin(c, width, height);
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

TEST(convex_rows, cover_the_exact_area_of_each_pixel) {
    std::mt19937 random(11);
    canvas c(width, height);
    int convex = 0;
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
        convex += is_convex(moved);
    }
    EXPECT_GT(convex, 2000);
}

TEST(convex_rows, know_a_convex_outline_in_either_direction) {
    EXPECT_TRUE(is_convex({{1, 1}, {9, 1}, {9, 8}, {1, 8}}));
    EXPECT_TRUE(is_convex({{1, 8}, {9, 8}, {9, 1}, {1, 1}}));
    EXPECT_TRUE(is_convex({{1, 1}, {5, 1}, {9, 1}, {9, 1}, {9, 8}, {1, 8}, {1, 1}}));
    EXPECT_TRUE(is_convex({{0, 0}, {15, 3}, {2, 40}}));
}

TEST(convex_rows, leave_other_outlines_alone) {
    struct outline {
        const char* what;
        corners of;
    };
    const std::vector<outline> others{
        {"two corners", {{1, 1}, {9, 1}}},
        {"there and back", {{1, 1}, {9, 1}, {1, 1}, {9, 1}}},
        {"a dent", {{1, 1}, {9, 1}, {3, 2}, {1, 8}}},
        {"crosses itself", {{1, 1}, {9, 8}, {9, 1}, {1, 8}}},
        {"twice around", {{1, 1}, {9, 1}, {5, 8}, {1, 1}, {9, 1}, {5, 8}}},
        {"beyond the left", {{-1, 1}, {9, 1}, {5, 8}}},
        {"beyond the right", {{1, 1}, {15.1, 1}, {5, 8}}},
    };
    for (const outline& o : others)
        EXPECT_FALSE(is_convex(o.of)) << o.what;
    corners star;
    for (int i = 0; i < 5; ++i)
        star.push_back({7 + 5 * std::sin(i * 0.8 * std::numbers::pi),
                        5 - 5 * std::cos(i * 0.8 * std::numbers::pi)});
    EXPECT_FALSE(is_convex(star));
}

} // namespace
