// SPDX-License-Identifier: MIT
// Lines in a depth buffer: what is in front of them hides them, their own surface does not.
#include "raster/lines/hidden_lines.h"

#include "surface_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <random>
#include <vector>

namespace {

constexpr l3d_size size{64, 64};

/// The light of a triangle's sides over a filled picture.
std::int64_t lit_over(const l3d_depth_buffer& depth, const l3d_painter_triangle& triangle,
                      bool smooth) {
    std::vector<std::uint32_t> words(std::size_t(size.width) * std::size_t(size.height));
    l3d_draw_seen_sides({words.data(), size.width, size.height, size.width}, depth,
                        std::array{triangle}, {}, {.color = 255, .smooth = smooth});
    return std::accumulate(words.begin(), words.end(), std::int64_t{0}) / 255;
}

/// The light of a triangle's sides over a surface whose 1/w is `at(x, y)` at pixel centres.
template <class At>
std::int64_t lit_over(At at, const l3d_painter_triangle& triangle, bool smooth) {
    l3d_depth_buffer depth;
    depth.resize(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            depth.row(y)[static_cast<std::size_t>(x)] = static_cast<float>(at(x + 0.5, y + 0.5));
    return lit_over(depth, triangle, smooth);
}

/// A triangle of the picture, on the plane 1/w = at(x, y).
template <class At> l3d_painter_triangle triangle_on(At at) {
    l3d_painter_triangle result;
    constexpr std::array<std::array<int, 2>, 3> corners{{{5, 8}, {50, 12}, {20, 55}}};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [x, y] = corners[k];
        result.v[k].x = x * l3d_subpixel_one;
        result.v[k].y = y * l3d_subpixel_one;
        result.v[k].inv_w = static_cast<float>(at(x, y));
    }
    return result;
}

double level(double, double) {
    return 0.5;
}
double slope(double x, double y) {
    return 0.3 + 0.004 * x - 0.002 * y;
}
/// The slope as far as the nearest corner of the triangle on it, and level beyond.
double ending_slope(double x, double y) {
    return std::min(slope(x, y), slope(50, 12));
}
constexpr double rise = 0.004 + 0.002; // of the slope, over a pixel in x and in y

constexpr auto nothing = [](double, double) { return 0; };
constexpr auto both_kinds = {false, true};

TEST(HiddenLines, OfASurfaceAreSeenOnIt) {
    for (const bool smooth : both_kinds) {
        const std::int64_t all = lit_over(nothing, triangle_on(level), smooth);
        EXPECT_GT(all, 100);
        EXPECT_EQ(lit_over(level, triangle_on(level), smooth), all);
        EXPECT_EQ(lit_over(ending_slope, triangle_on(slope), smooth), all);
    }
}

TEST(HiddenLines, AreHiddenByWhatIsALittleInFront) {
    const auto in_front_of = [](auto of, double by) {
        return [=](double x, double y) { return of(x, y) + by; };
    };
    for (const bool smooth : both_kinds) {
        EXPECT_EQ(lit_over(in_front_of(level, 1e-5), triangle_on(level), smooth), 0);
        EXPECT_EQ(lit_over(in_front_of(slope, 2.1 * rise), triangle_on(slope), smooth), 0);
    }
}

TEST(HiddenLines, AreSeenBeforeWhatIsBehind) {
    for (const bool smooth : both_kinds) {
        const std::int64_t all = lit_over(nothing, triangle_on(level), smooth);
        const auto behind = [](double x, double y) { return ending_slope(x, y) - 1e-4; };
        EXPECT_EQ(lit_over(behind, triangle_on(slope), smooth), all);
    }
}

/// A triangle that is less than a pixel wide in the picture and deep in space.
l3d_painter_triangle sliver(std::mt19937& random) {
    const auto within = [&](int from, int to) {
        return std::uniform_int_distribution<int>(from, to)(random);
    };
    const int x = within(10, 50), slope = within(-10, 10), width = 1 << within(0, 8);
    l3d_painter_triangle t;
    do {
        for (l3d_micro_vertex& v : t.v) {
            const int y = within(5 * l3d_subpixel_one, 60 * l3d_subpixel_one);
            v = {.x = x * l3d_subpixel_one + y * slope / 64 + within(0, width),
                 .y = y,
                 .inv_w = 1 / static_cast<float>(within(1, 100))};
            v.normal[2] = 1;
        }
    } while (reference::area2(t.v[0], t.v[1], t.v[2]) == 0);
    return t;
}

/// However steep a triangle is, nothing of it is nearer than its nearest corner.
TEST(HiddenLines, OfSteepTrianglesAreHiddenByWhatIsBeforeTheirNearestCorner) {
    std::mt19937 random(5);
    for (int i = 0; i < 300; ++i) {
        const l3d_painter_triangle t = sliver(random);
        const float nearest = std::max({t.v[0].inv_w, t.v[1].inv_w, t.v[2].inv_w});
        const auto wall = [&](double, double) { return 1.0001 * nearest; };
        for (const bool smooth : both_kinds)
            EXPECT_EQ(lit_over(wall, t, smooth), 0) << i;
    }
}

TEST(HiddenLines, OfSteepTrianglesAreSeenOnThemselves) {
    std::mt19937 random(6);
    for (int i = 0; i < 3000; ++i) {
        const l3d_painter_triangle t = sliver(random);
        surface_picture filled(size.width, size.height, 1), slowly(size.width, size.height);
        for (surface_picture* each : {&filled, &slowly}) {
            each->begin(l3d_shade::error);
            each->draw({t.v[0], t.v[1], t.v[2]});
            for (const bool smooth : both_kinds)
                EXPECT_EQ(lit_over(each->depth, t, smooth), lit_over(nothing, t, smooth)) << i;
        }
    }
}

/// A line has the light of its length, wherever it lies, and twice the same line is the line.
TEST(HiddenLines, ThatAreSmoothCoverTheirLength) {
    const l3d_painter_triangle t = triangle_on(level);
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const l3d_micro_vertex &a = t.v[k], &b = t.v[(k + 1) % 3];
        length += std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) / double(l3d_subpixel_one);
    }
    EXPECT_NEAR(static_cast<double>(lit_over(nothing, t, true)), length, 4);
}

} // namespace
