// SPDX-License-Identifier: MIT
// A course's whiteboards from model to pixels: windows, clip regions, curves at a resolution.
#include "raster/canvas_2d.h"
#include "raster/paths/path.h"
#include "raster/placement_2d.h"
#include "raster/rasterizer_2d.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace {

/// tx = -xmin, ty = -ymin, sx = (W - 1) / (xmax - xmin), sy = (H - 1) / (ymax - ymin); y flips.
TEST(whiteboard, window_to_viewport_fills_the_picture_with_the_window) {
    constexpr int width = 201, height = 101;
    const auto map =
        l3d_placement_2d::window_to_viewport({1, 0.5}, {5, 3}, {0, height - 1}, {width - 1, 0});
    EXPECT_DOUBLE_EQ(map.across.x, 50);
    EXPECT_DOUBLE_EQ(map.down.y, -40);
    // the model of the whiteboard: a rectangle of two triangles
    const std::array<l3d_point_2d, 4> model{{{2, 2}, {2, 1}, {4, 1}, {4, 2}}};
    const std::array<l3d_point_2d, 4> pixels{{{50, 40}, {50, 80}, {150, 80}, {150, 40}}};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_DOUBLE_EQ(map.at(model[i]).x, pixels[i].x);
        EXPECT_DOUBLE_EQ(map.at(model[i]).y, pixels[i].y);
    }
}

TEST(whiteboard, outcodes_are_those_of_cohen_and_sutherland) {
    const l3d_clip_region region{{10, 20}, {30, 40}};
    EXPECT_EQ(region.outcode({9, 30}), 1u);
    EXPECT_EQ(region.outcode({31, 30}), 2u);
    EXPECT_EQ(region.outcode({20, 41}), 4u);
    EXPECT_EQ(region.outcode({20, 19}), 8u);
    EXPECT_EQ(region.outcode({31, 19}), 10u);
    EXPECT_EQ(region.outcode({9, 41}), 5u);
    for (const l3d_point_2d& corner :
         std::array<l3d_point_2d, 4>{{{10, 20}, {30, 20}, {30, 40}, {10, 40}}})
        EXPECT_EQ(region.outcode(corner), 0u);
}

/// The part of a line that is inside, by its parameters in long double.
TEST(whiteboard, lines_are_cut_where_they_leave_the_region) {
    std::mt19937 random(6);
    const l3d_clip_region region{{10, 20}, {30, 40}};
    int drawn = 0, refused = 0;
    for (int n = 0; n < 20000; ++n) {
        const auto place = [&] {
            const double reach = n % 3 == 0 ? 1e6 : 30;
            std::uniform_real_distribution<double> at(-reach, reach);
            l3d_point_2d p{20 + at(random), 30 + at(random)};
            if (n % 4 == 0)
                p = {std::round(p.x / 10) * 10, std::round(p.y / 10) * 10};
            return p;
        };
        const l3d_point_2d a = place(), b = place();
        long double from = 0, to = 1;
        const auto cut = [&](long double start, long double step, long double low,
                             long double high) {
            if (step == 0) {
                if (start < low || start > high)
                    to = -1;
                return;
            }
            const long double first = (low - start) / step, second = (high - start) / step;
            from = std::max(from, std::min(first, second));
            to = std::min(to, std::max(first, second));
        };
        cut(a.x, static_cast<long double>(b.x) - a.x, 10, 30);
        cut(a.y, static_cast<long double>(b.y) - a.y, 20, 40);
        l3d_point_2d p = a, q = b;
        const bool is_in = region.clip(p, q);
        if (std::abs(to - from) < 1e-12L)
            continue; // a corner is touched, or nearly
        ASSERT_EQ(is_in, from < to) << n;
        (is_in ? drawn : refused) += 1;
        if (!is_in)
            continue;
        const auto at = [&](long double t, double start, double end) {
            return static_cast<double>(start + (static_cast<long double>(end) - start) * t);
        };
        ASSERT_NEAR(p.x, at(from, a.x, b.x), 1e-9);
        ASSERT_NEAR(p.y, at(from, a.y, b.y), 1e-9);
        ASSERT_NEAR(q.x, at(to, a.x, b.x), 1e-9);
        ASSERT_NEAR(q.y, at(to, a.y, b.y), 1e-9);
        ASSERT_EQ(region.outcode(p) | region.outcode(q), 0u);
    }
    EXPECT_GT(drawn, 4000);
    EXPECT_GT(refused, 4000);
}

TEST(whiteboard, border_of_the_clip_region_is_drawn_around_it) {
    canvas c(20, 15);
    const l3d_clip_region region{{3, 4}, {11, 9}};
    region.draw_border(c.draw, canvas::color);
    pixel_set border;
    for (int x = 3; x <= 11; ++x)
        for (int y = 4; y <= 9; ++y)
            if (x == 3 || x == 11 || y == 4 || y == 9)
                border.insert({x, y});
    EXPECT_EQ(c.lit(), border);
    c.draw.clear_buffer();
    region.draw_line(c.draw, {-10, 6}, {40, 6}, canvas::color);
    region.draw_line(c.draw, {0, 0}, {19, 2}, canvas::color);
    pixel_set inside;
    for (int x = 3; x <= 11; ++x)
        inside.insert({x, 6});
    EXPECT_EQ(c.lit(), inside);
}

TEST(whiteboard, curves_at_a_resolution_have_its_points) {
    const auto curve = l3d_sampled_quadratic({0, 2}, {2, 1}, {4, 3}, 5);
    const std::array<l3d_point_2d, 5> printed{
        {{0, 2}, {1, 1.6875}, {2, 1.75}, {3, 2.1875}, {4, 3}}};
    ASSERT_EQ(curve.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(curve[i].x, printed[i].x);
        EXPECT_EQ(curve[i].y, printed[i].y);
    }
    // t = 0, 0.2, 0.4, 0.6 and 0.8 of a turn
    const auto circle = l3d_sampled_circle({3, -1}, 2, 5);
    ASSERT_EQ(circle.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        const double degrees = 72 * static_cast<double>(i);
        EXPECT_NEAR(circle[i].x, 3 + 2 * std::cos(degrees * 0.017453292519943295), 1e-14);
        EXPECT_NEAR(circle[i].y, -1 + 2 * std::sin(degrees * 0.017453292519943295), 1e-14);
    }
}

/// Numbers that printed coordinates need: beyond 2^24 adding 1 changes nothing, and -0.0 is 0.
TEST(whiteboard, printed_numbers_of_32_bits) {
    volatile float large = 16777216.0f;
    EXPECT_EQ(large + 1.0f, large);
    volatile float negative_zero = -0.0f;
    EXPECT_EQ(negative_zero, 0.0f);
    const auto map = l3d_placement_2d::window_to_viewport({-1, -1}, {1, 1}, {-0.0, 0}, {-0.0, 4});
    EXPECT_EQ(map.at({-0.0, -0.0}).x, 0.0);
}

} // namespace
