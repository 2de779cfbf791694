// SPDX-License-Identifier: MIT
// Polygons clipped before they are drawn, and cut off by the drawing, light the same pixels.
#include "raster/shapes/polygon_2d_flatshaded.h"

#include "geom/random.h"
#include "geom/real.h"
#include "raster/shapes/rasterizer_2d_sw.h"
#include "tool_2d/image.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {

constexpr l3d_size size{97, 61};
constexpr std::uint32_t blue = 0x0080FF;

using position = l3d_position<l3d_real>;

struct picture {
    picture() { rasterizer.clear_buffer(); }
    bool lit(int x, int y) { return image.pixels().row(y)[static_cast<std::size_t>(x)] != 0; }

    l3d_image image{size, size.width + 7};
    l3d_rasterizer_2d_sw_imp imp{image.pixels()};
    l3d_rasterizer_2d rasterizer{imp};
};

l3d_vertex_list<l3d_real> random_corners(l3d_random& random) {
    const double x = 160 * random.fraction() - 30, y = 120 * random.fraction() - 30;
    std::vector<double> angles(static_cast<std::size_t>(random.between(3, 9)));
    std::ranges::generate(angles, [&] { return 2 * std::numbers::pi * random.fraction(); });
    std::ranges::sort(angles);
    std::vector<l3d_coordinate<l3d_real>> corners;
    for (const double angle : angles)
        corners.emplace_back(
            l3d_point<l3d_real>::of(x + 80 * std::cos(angle), y + 60 * std::sin(angle), 0));
    return l3d_vertex_list<l3d_real>(corners);
}

l3d_polygon_2d_flatshaded polygon_of(const l3d_vertex_list<l3d_real>& vertices) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < vertices.fixed_size(); ++i)
        all.push_back(i);
    return {all, blue};
}

} // namespace

TEST(polygon_2d_flatshaded, row_23_clipped_pixels_are_the_pixels_in_the_window) {
    const position least{l3d_from_double<l3d_real>(11), l3d_from_double<l3d_real>(7)};
    const position most{l3d_from_double<l3d_real>(83), l3d_from_double<l3d_real>(52)};
    const auto window = l3d_window_corners(least, most);
    l3d_random random(123);
    int strays = 0;
    int pixels = 0;
    for (int i = 0; i < 10000; ++i) {
        auto vertices = random_corners(random);
        auto polygon = polygon_of(vertices);
        picture whole;
        polygon.draw(vertices, whole.rasterizer);
        picture part;
        if (polygon.clip_to_polygon_2d(vertices, window))
            polygon.draw(vertices, part.rasterizer);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const bool in_window = x >= 11 && x < 83 && y >= 7 && y < 52;
                pixels += part.lit(x, y);
                if (part.lit(x, y) == (in_window && whole.lit(x, y)))
                    continue;
                // The corner at the window's border is rounded to 1/256 pixel, which turns the
                // edge by so much: a pixel that the edge nearly hits may change, no other.
                ++strays;
                const bool at_an_edge =
                    (x > 0 && whole.lit(x - 1, y) != whole.lit(x, y)) ||
                    (y > 0 && whole.lit(x, y - 1) != whole.lit(x, y)) ||
                    (x + 1 < size.width && whole.lit(x + 1, y) != whole.lit(x, y)) ||
                    (y + 1 < size.height && whole.lit(x, y + 1) != whole.lit(x, y));
                ASSERT_TRUE(in_window && at_an_edge) << "case " << i << " at " << x << ',' << y;
            }
    }
    EXPECT_GT(pixels, 1000000);
    EXPECT_LT(strays, pixels / 5000);
    RecordProperty("strays", strays);
    RecordProperty("pixels", pixels);
    std::printf("%d of %d pixels differ\n", strays, pixels);
}

TEST(polygon_2d_flatshaded, row_28_copies_keep_type_and_colour) {
    l3d_random random(5);
    auto vertices = random_corners(random);
    const auto original = polygon_of(vertices);
    auto copy = original;
    static_assert(std::is_same_v<decltype(copy), l3d_polygon_2d_flatshaded>);
    copy.final_color = 0xFF0000;
    EXPECT_EQ(original.final_color, blue);
}
