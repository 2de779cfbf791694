// SPDX-License-Identifier: MIT
// Points and polygons: the book's reference values, exact rules, and awkward coordinates.
#include "raster/rasterizer_factory.h"
#include "raster/parallel/simd_target.h"
#include "raster/shapes/small_triangle_p.h"

#include "raster/canvas_2d.h"
#include "raster/paths/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr unsigned seed = 20010322;
constexpr std::uint32_t color = canvas::color;

TEST(Points, AreLitInsideOnly) {
    canvas c(11, 7);
    c.draw.draw_point(3, 5, color);
    c.draw.draw_point(10, 6, color);
    for (const auto& [x, y] : {std::pair{-1, 0}, {11, 0}, {4, -1}, {4, 7}, {-1, 3}})
        c.draw.draw_point(x, y, color);
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    c.draw.draw_point(least, most, color);
    c.draw.draw_point(most, least, color);
    EXPECT_EQ(c.lit(), (pixel_set{{3, 5}, {10, 6}}));
    EXPECT_TRUE(c.guards_intact());
    c.draw.clear_buffer();
    EXPECT_TRUE(c.lit().empty());
    EXPECT_TRUE(c.guards_intact());
}

pixel_set rectangle(int left, int top, int right, int bottom) {
    pixel_set result;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            result.insert({x, y});
    return result;
}

TEST(clearing, gives_every_pixel_the_colour) {
    canvas c(11, 7);
    c.draw.clear_buffer(color);
    EXPECT_EQ(c.lit(), rectangle(0, 0, 11, 7));
    EXPECT_TRUE(c.guards_intact());
    c.draw.clear_buffer();
    EXPECT_TRUE(c.lit().empty());
}

TEST(boxes, are_whole_pixels_as_polygons_and_as_paths) {
    for (const l3d_pixel_box& box : {l3d_pixel_box{0, 0, 11, 7}, {2, 3, 5, 4}, {-9, -9, 4, 99}}) {
        const l3d_pixel_box seen = box.intersected({0, 0, 11, 7});
        canvas by_box(11, 7), by_path(11, 7);
        by_box.draw.draw_box(box, color);
        EXPECT_EQ(by_box.lit(), rectangle(seen.left, seen.top, seen.right, seen.bottom));
        EXPECT_TRUE(by_box.guards_intact());
        l3d_path path;
        path.add_box(box);
        by_path.draw.draw_path(path, {.color = color}); // a fringe would be another colour
        EXPECT_EQ(by_path.lit(), by_box.lit());
    }
    canvas none(11, 7);
    none.draw.draw_box({4, 4, 4, 9}, color);
    none.draw.draw_box({9, 4, 2, 5}, color);
    l3d_path empty;
    empty.add_box({9, 4, 2, 5});
    EXPECT_TRUE(none.lit().empty() && empty.empty());
}

pixel_set filled(const std::vector<l3d_point_2d>& corners, int width = 41, int height = 31) {
    canvas c(width, height);
    c.draw.draw_polygon_flatshaded(corners, color);
    EXPECT_TRUE(c.guards_intact());
    return c.lit();
}

TEST(Polygons, BookSquares) {
    EXPECT_EQ(filled({{10, 10}, {20, 10}, {20, 20}, {10, 20}}), rectangle(10, 10, 20, 20));
    EXPECT_EQ(filled({{10.5, 10.5}, {20.5, 10.5}, {20.5, 20.5}, {10.5, 20.5}}),
              rectangle(11, 11, 21, 21));
}

TEST(Polygons, BookTrianglesShareAnEdgeExactly) {
    const pixel_set upper = filled({{10, 10}, {20, 10}, {20, 20}});
    const pixel_set lower = filled({{10, 10}, {20, 20}, {10, 20}});
    EXPECT_EQ(upper.size(), 55u);
    EXPECT_EQ(lower.size(), 45u);
    pixel_set both = upper;
    both.insert(lower.begin(), lower.end());
    EXPECT_EQ(both, rectangle(10, 10, 20, 20));
}

TEST(Polygons, BookSpanEnds) {
    EXPECT_EQ(filled({{2, 3}, {7.32718, 3}, {7.32718, 5}, {2, 5}}), rectangle(2, 3, 8, 5));
    EXPECT_EQ(filled({{7.32718, 3}, {12, 3}, {12, 5}, {7.32718, 5}}), rectangle(8, 3, 12, 5));
}

TEST(Polygons, BookShapesHaveTheExactPixelCounts) {
    const auto count = [](const std::vector<l3d_point_2d>& v) {
        return filled(v, 320, 200).size();
    };
    EXPECT_EQ(count({{100, 100}, {200, 150}, {150, 200}, {50, 120}}), 6715u);
    EXPECT_EQ(count({{100, 100}, {200, 100}, {150, 200}, {140, 200}}), 5530u);
    EXPECT_EQ(count({{-100, 100}, {200, 100}, {950, 200}, {940, 200}}), 7132u);
    EXPECT_EQ(count({{100, 150}, {100, 100}, {250, 200}, {100, 200}}), 7450u);
}

TEST(Polygons, OfEitherWindingAreTheSame) {
    std::vector<l3d_point_2d> v{{7.3, 2.1}, {33.9, 5.6}, {36.2, 21.7}, {20.4, 28.8}, {3.3, 17.5}};
    const pixel_set expected = filled(v);
    EXPECT_GT(expected.size(), 500u);
    std::ranges::reverse(v);
    EXPECT_EQ(filled(v), expected);
    std::rotate(v.begin(), v.begin() + 2, v.end());
    EXPECT_EQ(filled(v), expected);
}

/// Inside by edge functions on the 1/256 lattice; clockwise corners.
bool inside(const std::vector<l3d_point_2d>& v, int x, int y) {
    const auto raw = [](double c) { return std::lrint(c * 256); };
    for (std::size_t i = 0; i < v.size(); ++i) {
        const l3d_point_2d &a = v[i], &b = v[(i + 1) % v.size()];
        const std::int64_t dx = raw(b.x) - raw(a.x), dy = raw(b.y) - raw(a.y);
        const std::int64_t side =
            dx * (std::int64_t{256} * y - raw(a.y)) - dy * (std::int64_t{256} * x - raw(a.x));
        const bool owns = dy < 0 || (dy == 0 && dx > 0);
        if ((dx != 0 || dy != 0) && (side < 0 || (side == 0 && !owns)))
            return false;
    }
    return true;
}

/// Corners on an ellipse, clockwise on the screen, rounded to the lattice while still convex
/// enough.
std::vector<l3d_point_2d> random_convex(std::mt19937& random) {
    const auto real = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
    };
    std::vector<double> angles(static_cast<std::size_t>(real(3, 12)));
    for (double& a : angles)
        a = real(0, 6.283185307179586);
    std::ranges::sort(angles);
    const double x = real(-10, 45), y = real(-10, 40), rx = real(4, 60), ry = real(4, 60);
    std::vector<l3d_point_2d> v;
    v.reserve(angles.size());
    for (const double a : angles)
        v.push_back({std::round((x + rx * std::cos(a)) * 256) / 256,
                     std::round((y + ry * std::sin(a)) * 256) / 256});
    return v;
}

bool is_convex(const std::vector<l3d_point_2d>& v) {
    for (std::size_t i = 0; i < v.size(); ++i) {
        const l3d_point_2d &a = v[i], &b = v[(i + 1) % v.size()], &c = v[(i + 2) % v.size()];
        if ((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) <= 0)
            return false;
    }
    return true;
}

TEST(Polygons, RandomConvexOnesAreExact) {
    std::mt19937 random(seed + 2);
    constexpr int width = 23, height = 17;
    int tried = 0;
    std::size_t lit = 0;
    for (int n = 0; n < 30000; ++n) {
        const std::vector<l3d_point_2d> v = random_convex(random);
        if (!is_convex(v))
            continue;
        ++tried;
        pixel_set expected;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (inside(v, x, y))
                    expected.insert(expected.end(), {x, y});
        ASSERT_EQ(filled(v, width, height), expected) << "seed " << seed + 2 << ", polygon " << n;
        lit += expected.size();
    }
    EXPECT_GT(tried, 15000);
    EXPECT_GT(lit, 1000000u);
}

TEST(Polygons, WithoutAreaOrCornersDrawNothing) {
    EXPECT_TRUE(filled({}).empty());
    EXPECT_TRUE(filled({{4, 5}}).empty());
    EXPECT_TRUE(filled({{4, 5}, {20, 9}}).empty());
    EXPECT_TRUE(filled({{4, 5}, {20, 9}, {4, 5}}).empty());
    EXPECT_TRUE(filled({{4, 5}, {8, 9}, {16, 17}, {6, 7}}).empty());
    EXPECT_TRUE(filled({{4, 5}, {20, 21}, {20, 5}, {4, 21}}).empty()); // crossing, areas cancel
}

TEST(Polygons, WithoutNumbersDrawNothing) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(filled({{nan, 3}, {20, 4}, {15, 25}}).empty());
    EXPECT_TRUE(filled({{3, 4}, {20, nan}, {15, 25}}).empty());
}

TEST(Polygons, ThatReachBeyondTheLimitAreCutThere) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    constexpr double limit = 1 << 30;
    for (const double far : {inf, 1e300, 2e9, limit + 1}) {
        EXPECT_EQ(filled({{3, 4}, {far, 12}, {5, 25}}), filled({{3, 4}, {limit, 12}, {5, 25}}));
        EXPECT_EQ(filled({{-far, -far}, {far, -far}, {far, far}, {-far, far}}).size(), 41u * 31u);
        EXPECT_EQ(filled({{-far, 7}, {far, 7}, {far, 9}, {-far, 9}}).size(), 41u * 2u);
    }
}

TEST(Polygons, OfAnyKindStayInsideTheBuffer) {
    std::mt19937 random(seed + 3);
    const std::array<double, 7> reaches{3, 60, 2000, 33000, 1e6, 1e10, 1e308};
    canvas c(19, 27);
    for (int n = 0; n < 100000; ++n) {
        const double reach = reaches[random() % reaches.size()];
        std::uniform_real_distribution<double> at(-reach, reach);
        std::vector<l3d_point_2d> v(random() % 9);
        for (l3d_point_2d& p : v)
            p = {at(random) + 7, at(random) + 11};
        c.draw.draw_polygon_flatshaded(v, color); // concave and crossing ones, too
    }
    EXPECT_TRUE(c.guards_intact()) << "seed " << seed + 3;
}

TEST(Imp, DrawsIntoTheTargetOfTheLastResize) {
    std::vector<std::uint32_t> first(30, 0), second(99, 0);
    const std::unique_ptr<l3d_rasterizer_2d_imp> imp =
        l3d_rasterizer_factory_sw().create_2d({first.data(), 6, 5, 6});
    l3d_rasterizer_2d draw(*imp);
    imp->set_target({second.data(), 9, 11, 9});
    draw.draw_point(8, 10, color);
    const std::array<l3d_point_2d, 3> corners{{{0, 0}, {0, 11}, {3, 11}}};
    draw.draw_polygon_flatshaded(corners, color);
    EXPECT_EQ(second.back(), color);
    EXPECT_EQ(second[90], color); // (0, 10)
    EXPECT_EQ(std::ranges::count(first, 0u), 30);
}

/// The picture's memory ends where it does, which a sanitizer sees.
TEST(small_triangles, are_the_same_where_the_picture_ends) {
    constexpr int width = 37, height = 23, room = 64;
    std::mt19937 random(20260702);
    std::uniform_real_distribution<double> x(0, width), y(0, height);
    std::bernoulli_distribution ends_there(0.25);
    const auto at_end = [&](double value, double end) { return ends_there(random) ? end : value; };
    std::vector<std::array<l3d_point_2d, 3>> triangles(500);
    for (auto& triangle : triangles)
        for (l3d_point_2d& p : triangle)
            p = {at_end(x(random), width), at_end(y(random), height)};
    for (const std::string& target : l3d_simd_targets()) {
        l3d_set_simd_target(target);
        std::vector<std::uint32_t> exact(width * height), roomy((width + room) * height);
        std::uint32_t tint = 0;
        for (const auto& triangle : triangles) {
            const std::array<double, 2> ends{width, height};
            ++tint;
            const bool is_small = l3d_detail::fill_small_triangle(
                {exact.data(), width, height, width}, triangle, ends, tint);
            ASSERT_EQ(l3d_detail::fill_small_triangle(
                          {roomy.data(), width + room, height, width + room}, triangle, ends, tint),
                      is_small);
        }
        EXPECT_GT(std::ranges::count_if(exact, [](auto word) { return word != 0; }), 500);
        for (int row = 0; row < height; ++row) {
            const auto* const words = roomy.data() + row * (width + room);
            ASSERT_TRUE(std::equal(words, words + width, exact.data() + row * width)) << target;
            ASSERT_EQ(std::count(words + width, words + width + room, 0u), room) << target;
        }
    }
    l3d_set_simd_target("");
}

} // namespace
