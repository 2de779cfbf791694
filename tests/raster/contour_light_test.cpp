// SPDX-License-Identifier: MIT
// find_light and middle_on_right: against a plane's own numbers, and against a fine grid of places.
#include "raster/refine/contour_light_p.h"
#include "surface_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace {

using l3d_detail::contour_pixel;
using l3d_detail::picture_place;

/// A plane's depth and level at a place in pixels.
float depth_at(double x, double y) {
    return static_cast<float>(0.5 + 0.003 * x - 0.002 * y);
}
float level_at(double x, double y) {
    return static_cast<float>(20 + 4 * x + 3 * y);
}

/// A sheet in that plane, its vertices a little off a grid of 4 pixels, moved by `behind` in depth.
l3d_surface_part sheet(std::mt19937& random, float behind) {
    constexpr int side = 9;
    std::uniform_int_distribution<int> off(-300, 300);
    l3d_micro_grid grid;
    grid.resize(side, side);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const std::int32_t x = 1024 * column + off(random), y = 1024 * row + off(random);
            surface_picture::set(grid, row, column,
                                 {x,
                                  y,
                                  depth_at(x / 256.0, y / 256.0) - behind,
                                  {level_at(x / 256.0, y / 256.0), 0, 0}});
        }
    return part_of(grid);
}

contour_pixel beside(const l3d_surface_part& part, int row, int column) {
    contour_pixel pixel{};
    pixel.beside = {&part, row, column};
    return pixel;
}

TEST(ContourLight, IsThatOfThePlane) {
    std::mt19937 random(scene_seed);
    std::uniform_real_distribution<float> away(-4, 4);
    for (int n = 0; n < 2000; ++n) {
        const l3d_surface_part part = sheet(random, 0);
        // The quads around the vertex at (16, 16) reach to 8 and to 24, less what vertices are off.
        const picture_place place{16 + away(random), 16 + away(random)};
        l3d_detail::surface_light found;
        ASSERT_TRUE(find_light(beside(part, 4, 4), place, found)) << n;
        // A quad's bilinear levels of a plane are those of the plane, up to how skew it is.
        ASSERT_NEAR(found.level, 25.5f + level_at(place.x, place.y), 4) << n;
        ASSERT_NEAR(found.inv_w, depth_at(place.x, place.y), 0.004f) << n;
        ASSERT_TRUE(found.turns_right);
    }
}

TEST(ContourLight, IsThatOfTheNearerSheet) {
    std::mt19937 random(scene_seed);
    constexpr float behind = 0.1f;
    const l3d_surface_part near = sheet(random, 0), far = sheet(random, behind);
    const picture_place place{15.3f, 16.8f};
    l3d_detail::surface_light of_near, of_both;
    for (const bool swapped : {false, true}) {
        contour_pixel pixel = beside(swapped ? far : near, 4, 4);
        pixel.also = {swapped ? &near : &far, 4, 4};
        ASSERT_TRUE(find_light(beside(near, 4, 4), place, of_near));
        ASSERT_TRUE(find_light(pixel, place, of_both));
        EXPECT_EQ(of_both.inv_w, of_near.inv_w);
        EXPECT_EQ(of_both.level, of_near.level);
    }
}

TEST(ContourLight, IsNotFoundFarAway) {
    std::mt19937 random(scene_seed);
    const l3d_surface_part part = sheet(random, 0);
    l3d_detail::surface_light found;
    EXPECT_FALSE(find_light(beside(part, 4, 4), {30, 16}, found));
    EXPECT_FALSE(find_light(beside(part, 4, 4), {-3, -3}, found));
    EXPECT_FALSE(find_light(contour_pixel{}, {16, 16}, found));
}

/// A pixel that a straight contour passes at that way from its centre, which lies on the right.
contour_pixel straight(double direction, double way) {
    contour_pixel pixel{};
    const auto units = [](double number) {
        return static_cast<std::int32_t>(std::lround(number * contour_pixel::whole));
    };
    pixel.x = 7;
    pixel.y = 5;
    pixel.crossings = 2;
    pixel.along_x = units(std::cos(direction));
    pixel.along_y = units(std::sin(direction));
    pixel.to_centre = units(way);
    return pixel;
}

TEST(ContourLight, TheMiddleIsThatOfTheShare) {
    std::mt19937 random(scene_seed);
    std::uniform_real_distribution<double> number(0, 1);
    constexpr int cells = 200;
    for (int n = 0; n < 500; ++n) {
        const double direction = 6.28318530717959 * number(random),
                     way = 0.9 * number(random) - 0.4;
        // Seen in the picture, whose rows go down, right of (c, s) is (-s, c).
        const double right_x = -std::sin(direction), right_y = std::cos(direction);
        double x = 0, y = 0;
        int count = 0;
        for (int row = 0; row < cells; ++row)
            for (int column = 0; column < cells; ++column) {
                const double dx = (column + 0.5) / cells - 0.5, dy = (row + 0.5) / cells - 0.5;
                if (dx * right_x + dy * right_y + way <= 0)
                    continue;
                x += dx;
                y += dy;
                ++count;
            }
        const picture_place middle = middle_on_right(straight(direction, way));
        if (count < cells * cells / 20)
            continue;
        // Two columns of the pixel stand for all of it; where the contour leaves through a side
        // between them, they miss a corner.
        EXPECT_NEAR(middle.x, 7.5 + x / count, 0.08) << n;
        EXPECT_NEAR(middle.y, 5.5 + y / count, 0.08) << n;
    }
}

} // namespace
