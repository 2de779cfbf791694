// SPDX-License-Identifier: MIT
// Text: every character has its own shape, is where it should be, and is clipped.
#include "raster/shapes/rasterizer_2d_sw.h"
#include "raster/text/font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace {

/// The picture of a text: one string per row, '#' for ink.
std::vector<std::string> picture_of(std::string_view text, int x, int y, int width, int height,
                                    int scale = 1) {
    const int stride = width + 2;
    std::vector<std::uint32_t> words(std::size_t(stride) * std::size_t(height), 7);
    l3d_rasterizer_2d_sw_imp imp({words.data(), width, height, stride});
    l3d_rasterizer_2d rasterizer(imp);
    rasterizer.clear_buffer();
    l3d_draw_text(rasterizer, x, y, text, 0xffcc00, scale);
    std::vector<std::string> rows;
    for (int row = 0; row < height; ++row) {
        rows.emplace_back();
        for (int column = 0; column < stride; ++column) {
            const std::uint32_t word =
                words[std::size_t(row) * std::size_t(stride) + std::size_t(column)];
            if (column < width)
                rows.back() += word == 0xffcc00 ? '#' : '.';
            else
                EXPECT_EQ(word, 7u); // nothing is written beside the picture
        }
    }
    return rows;
}

TEST(Text, LooksAsDrawn) {
    EXPECT_EQ(picture_of("L3", 2, 1, 14, 9), (std::vector<std::string>{
                                                 "..............",
                                                 "..#......###..",
                                                 "..#.....#...#.",
                                                 "..#.........#.",
                                                 "..#.......##..",
                                                 "..#.........#.",
                                                 "..#.....#...#.",
                                                 "..#####..###..",
                                                 "..............",
                                             }));
}

TEST(Text, EveryPrintableCharacterIsItsOwn) {
    std::set<std::vector<std::string>> shapes;
    for (char c = ' '; c <= '~'; ++c)
        shapes.insert(picture_of(std::string(1, c), 1, 2, 8, 10));
    EXPECT_EQ(shapes.size(), 95u);
}

TEST(Text, UnknownCharactersAreBoxes) {
    const auto box = picture_of("\xc3\xa9", 1, 1, 7, 9);
    EXPECT_EQ(box[1], ".#####.");
    EXPECT_EQ(box[4], ".#...#.");
    EXPECT_EQ(picture_of("\xe9", 1, 1, 7, 9), box);
    const auto nothing = picture_of(" ", 1, 1, 7, 9); // control characters are not seen
    EXPECT_EQ(picture_of("\x01", 1, 1, 7, 9), nothing);
    EXPECT_EQ(picture_of("\x7f", 1, 1, 7, 9), nothing);
}

TEST(Text, ScaleRepeatsEveryPixel) {
    const auto once = picture_of("g7", 2, 1, 15, 9), thrice = picture_of("g7", 6, 3, 45, 27, 3);
    for (std::size_t y = 0; y < thrice.size(); ++y)
        for (std::size_t x = 0; x < thrice[y].size(); ++x)
            ASSERT_EQ(thrice[y][x], once[y / 3][x / 3]) << x << ", " << y;
}

TEST(Text, IsClippedOnEverySide) {
    const auto whole = picture_of("Qy%", 7, 9, 33, 27);
    for (const auto& [dx, dy] : {std::pair{10, 0}, {0, 11}, {14, 12}, {-13, -12}, {40, 3}}) {
        const auto part = picture_of("Qy%", 7 - dx, 9 - dy, 19, 13);
        for (int y = 0; y < 13; ++y)
            for (int x = 0; x < 19; ++x) {
                const int from_x = x + dx, from_y = y + dy;
                const bool known = from_x >= 0 && from_x < 33 && from_y >= 0 && from_y < 27;
                const char expected =
                    known
                        ? whole[static_cast<std::size_t>(from_y)][static_cast<std::size_t>(from_x)]
                        : '.';
                ASSERT_EQ(part[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)], expected);
            }
    }
}

TEST(Text, FarAwayIsNoFault) {
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    const auto empty = picture_of("", 0, 0, 9, 5);
    for (const int x : {least, most, -100, 3})
        for (const int y : {least, most})
            EXPECT_EQ(picture_of("East", x, y, 9, 5, 1000), empty);
    EXPECT_EQ(picture_of(std::string(10000, 'E'), 4, 9, 9, 5), empty);
}

} // namespace
