// SPDX-License-Identifier: MIT
// The lines of a course's whiteboards, pixel by pixel: Bresenham's and Wu's, as printed there.
#include "raster/canvas_2d.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <utility>

namespace {

struct printed_line {
    l3d_line_2d line;
    std::map<std::pair<int, int>, int> levels;
};

/// The lists of one algorithm, each with its line.
std::map<std::array<int, 4>, printed_line> printed(const std::string& algorithm) {
    std::map<std::array<int, 4>, printed_line> result;
    std::ifstream file("tests/data/whiteboard_lines.csv");
    for (std::string row; std::getline(file, row);) {
        std::array<int, 4> ends{};
        int x = 0, y = 0, level = 0;
        const std::string form = algorithm + ",%d,%d,%d,%d,%d,%d,%d";
        if (std::sscanf(row.c_str(), form.c_str(), &ends[0], &ends[1], &ends[2], &ends[3], &x, &y,
                        &level) != 7)
            continue;
        printed_line& line = result[ends];
        line.line = {ends[0], ends[1], ends[2], ends[3]};
        line.levels[{x, y}] = level;
    }
    return result;
}

constexpr int width = 50, height = 30;

/// The whiteboard moves on at a tie. Ours takes the upper or left pixel, whichever end it comes
/// from: so a line and its reverse are the same pixels.
TEST(whiteboard, has_the_same_pixels_of_bresenhams_lines_but_for_one_tie) {
    const auto lists = printed("bresenham");
    ASSERT_EQ(lists.size(), 5u);
    pixel_set only_ours, only_printed;
    for (const auto& [ends, list] : lists) {
        canvas c(width, height);
        c.draw.draw_line(ends[0], ends[1], ends[2], ends[3], canvas::color);
        const pixel_set lit = c.lit();
        EXPECT_EQ(lit.size(), list.levels.size());
        for (const auto& pixel : lit)
            if (!list.levels.contains(pixel))
                only_ours.insert(pixel);
        for (const auto& [pixel, level] : list.levels)
            if (!lit.contains(pixel))
                only_printed.insert(pixel);
    }
    EXPECT_EQ(only_ours, (pixel_set{{6, 3}})); // of (0, 0) - (12, 7): at 6 the line is at 3.5
    EXPECT_EQ(only_printed, (pixel_set{{6, 4}}));
}

/// The whiteboard cuts levels off where ours rounds them.
TEST(whiteboard, has_the_levels_of_wus_lines_within_one) {
    const auto lists = printed("wu");
    ASSERT_EQ(lists.size(), 3u);
    for (const auto& [ends, list] : lists) {
        canvas c(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                c.at(x, y) = 0x00ffffff;
        c.draw.draw_line_antialiased({double(ends[0]), double(ends[1])},
                                     {double(ends[2]), double(ends[3])}, 0);
        EXPECT_GT(list.levels.size(), 40u);
        for (const auto& [pixel, level] : list.levels)
            EXPECT_NEAR(c.at(pixel.first, pixel.second) & 255, level, 1)
                << pixel.first << ' ' << pixel.second;
    }
}

} // namespace
