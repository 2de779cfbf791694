// SPDX-License-Identifier: MIT
// x11_palette: the largest palette in maps that no server here has, and what is near enough.
#include "tool_2d/x11/x11_colormap_p.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

using namespace l3d_detail;

TEST(x11_palette, of_fixed_cells) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::vector<std::uint32_t> cells;
    const palette_shape five = palette_shape::cube(5);
    cells.reserve(125);
    for (int place = 0; place < five.size(); ++place)
        cells.push_back(five.color(place));
    std::ranges::shuffle(cells, random);
    const auto exact = palette_of_cells(cells, false);
    ASSERT_TRUE(exact);
    EXPECT_EQ(exact->red, 5);
    EXPECT_EQ(exact->deviation, 0);
    for (int place = 0; place < five.size(); ++place)
        EXPECT_EQ(cells[exact->pixels[static_cast<std::size_t>(place)]], five.color(place));

    // One corner gone: within half a step of 2x2x2 there is another colour.
    std::erase(cells, 0x0000FFU);
    const auto without = palette_of_cells(cells, false);
    ASSERT_TRUE(without);
    EXPECT_EQ(without->red, 2);
    EXPECT_EQ(without->deviation, 64);

    EXPECT_FALSE(palette_of_cells(std::vector<std::uint32_t>(256, 0x406080), false));
    EXPECT_FALSE(palette_of_cells({}, true));
}

TEST(x11_palette, ramps_of_fixed_cells) {
    std::vector<std::uint32_t> cells;
    for (int gray = 15; gray >= 0; --gray)
        cells.push_back(static_cast<std::uint32_t>(gray * 17) * 0x010101);
    const auto ramp = palette_of_cells(cells, true);
    ASSERT_TRUE(ramp);
    EXPECT_EQ(ramp->red, 16);
    EXPECT_EQ(ramp->deviation, 0);
    EXPECT_EQ(ramp->pixels.front(), 15U);
    EXPECT_EQ(ramp->pixels.back(), 0U);
}

TEST(x11_palette, half_a_step_is_near) {
    const palette_shape shape{6, 3, 2}; // steps of 51, 127.5, 255
    EXPECT_TRUE(shape.is_near(0x400000, 0x400000 + (25 << 16)));
    EXPECT_FALSE(shape.is_near(0x400000, 0x400000 + (26 << 16)));
    EXPECT_TRUE(shape.is_near(0x7F00, 0x7F00 - (63 << 8)));
    EXPECT_FALSE(shape.is_near(0x7F00, 0x7F00 - (64 << 8)));
    EXPECT_TRUE(shape.is_near(0x12, 0x12 + 127));
    EXPECT_FALSE(shape.is_near(0x12, 0x12 + 128));
}

} // namespace
