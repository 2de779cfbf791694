// SPDX-License-Identifier: MIT
// Gradients along lines and circles.
#include "raster/canvas_2d.h"
#include "raster/paths/gradient.h"
#include "raster/paths/path.h"

#include <array>
#include <cmath>

namespace {

double level(std::uint32_t word, int shift) {
    return word >> shift & 255;
}

TEST(gradient, has_the_nearest_level_to_the_line_between_two_stops) {
    const std::array<l3d_color_stop, 3> stops{
        {{0.25, 0x00ff0010}, {0.5, 0x0000ff20}, {1, 0x000000f0}}};
    const auto expected = [&](double t, int shift) {
        if (t <= 0.25)
            return level(stops[0].color, shift);
        const std::size_t i = t < 0.5 ? 0 : 1;
        const double share = std::min((t - stops[i].at) / (stops[i + 1].at - stops[i].at), 1.0);
        return std::lerp(level(stops[i].color, shift), level(stops[i + 1].color, shift), share);
    };
    canvas c(50, 40);
    l3d_path all;
    all.add_circle({25, 20}, 100);
    const auto test = [&](const l3d_gradient& gradient, const auto& place) {
        c.draw.draw_path(all, {.gradient = &gradient});
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 50; ++x)
                for (const int shift : {0, 8, 16})
                    ASSERT_NEAR(level(c.at(x, y), shift), expected(place(x, y), shift), 0.5001)
                        << x << ' ' << y;
    };
    test(l3d_gradient::linear({5, 7}, {40, 30}, stops),
         [](int x, int y) { return ((x - 5) * 35.0 + (y - 7) * 23.0) / (35 * 35 + 23 * 23); });
    test(l3d_gradient::radial({20, 11}, 25, stops),
         [](int x, int y) { return std::hypot(x - 20, y - 11) / 25; });
    // at the rim it is mixed with what is there
    c.draw.clear_buffer();
    l3d_path half;
    half.add_polygon(std::array<l3d_point_2d, 4>{{{10, -9}, {60, -9}, {60, 60}, {10, 60}}});
    const std::array<l3d_color_stop, 1> white{{{0, 0x00ffffff}}};
    const l3d_gradient plain = l3d_gradient::radial({0, 0}, 1, white);
    c.draw.draw_path(half, {.gradient = &plain});
    EXPECT_EQ(c.at(9, 5), 0u);
    EXPECT_EQ(c.at(10, 5), 0x00808080u);
    EXPECT_EQ(c.at(11, 5), 0x00ffffffu);
}

} // namespace
