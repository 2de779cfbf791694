// SPDX-License-Identifier: MIT
// Panels: nothing is cut off where there is room, whatever the window's size and the letters'.
#include "raster/canvas_2d.h"
#include "raster/text/panel.h"
#include "raster/text/panel_layout_p.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace l3d_detail;

const std::vector<std::pair<std::string, std::string>> help{
    {"arrows, drag", "turn"},
    {"wheel, Page", "zoom"},
    {"+ -", "detail"},
    {"c", "shading"},
    {"w", "solid, wires, hidden lines"},
    {"a", "smooth edges"},
    {"n", "control nets"},
    {"o", "status"},
    {"t", "turntable"},
    {"p, space", "pause"},
    {"r", "reset view"},
    {"s", "save a picture"},
    {"F11", "whole screen"},
    {"h ?", "this help"},
    {"q Esc", "quit"},
    {"x y z", "turn the model (X Y Z back)"},
    {"v", "perspective, parallel"},
    {"b", "faces seen from behind"}};

/// All words of a layout, in the order of their rows.
std::string words_of(const panel_layout& layout) {
    std::string result;
    for (const panel_line& line : layout.lines())
        result += line.text + " ";
    return result;
}

TEST(panel, lines_break_at_spaces_and_long_words_anywhere) {
    const l3d_font font; // letters are 6 wide at size 10
    EXPECT_EQ(wrapped(font, "one two three", 10, 48),
              (std::vector<std::string>{"one two", "three"}));
    EXPECT_EQ(wrapped(font, "one two", 10, 42), (std::vector<std::string>{"one two"}));
    EXPECT_EQ(wrapped(font, "one two", 10, 41), (std::vector<std::string>{"one", "two"}));
    EXPECT_EQ(wrapped(font, "incomprehensible", 10, 36),
              (std::vector<std::string>{"incomp", "rehens", "ible"}));
    EXPECT_EQ(wrapped(font, "ab", 10, 1), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(wrapped(font, "", 10, 30), (std::vector<std::string>{""}));
    EXPECT_EQ(wrapped(font, "éé é", 10, 12), (std::vector<std::string>{"éé", "é"}))
        << "no character is divided";
}

TEST(panel, shows_all_of_a_long_help_from_320x240_on) {
    std::vector<panel_row> rows;
    for (const auto& [key, text] : help)
        rows.push_back({key, text, false});
    std::string why;
    for (const l3d_font& font : {l3d_font(), l3d_font::of_system(why)})
        for (const l3d_size size : {l3d_size{308, 180}, {300, 800}, {620, 440}, {1900, 1000}}) {
            panel_layout layout(font, rows);
            bool fits = false;
            for (int letters = 14; letters >= 8 && !fits; --letters)
                for (int columns = 1; columns <= 3 && !fits; ++columns)
                    fits = layout.make(letters, columns, size);
            ASSERT_TRUE(fits) << font.name() << " " << size.width;
            const std::string words = words_of(layout);
            for (const auto& [key, text] : help) {
                EXPECT_NE(words.find(key + " "), std::string::npos) << key;
                std::istringstream each(text);
                for (std::string word; each >> word;)
                    EXPECT_NE(words.find(word + " "), std::string::npos) << word << " is torn";
            }
            for (const panel_line& line : layout.lines()) {
                EXPECT_GE(line.x, 0);
                EXPECT_LE(line.x + font.width(line.text, layout.letter_size()),
                          layout.size().width);
                EXPECT_LE(line.y + font.line(layout.letter_size()), layout.size().height);
            }
            EXPECT_LE(layout.size().width, size.width);
            EXPECT_LE(layout.size().height, size.height);
        }
}

/// The box of what was drawn on black.
l3d_pixel_box drawn_box(canvas& it, int width, int height) {
    l3d_pixel_box box;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (it.at(x, y) != 0)
                box = box.united({x, y, x + 1, y + 1});
    return box;
}

TEST(panel, lies_in_its_corner_and_takes_its_room) {
    constexpr int width = 400, height = 300;
    for (const l3d_corner corner : {l3d_corner::top_left, l3d_corner::top_right,
                                    l3d_corner::bottom_left, l3d_corner::bottom_right}) {
        canvas it(width, height);
        l3d_panel panel;
        panel.add("a line of text");
        panel.add("key", "what it does");
        panel.add_scale({0x0000ff00, 0x00ff0000}, "0", "0.25");
        l3d_pixel_box free = l3d_whole({width, height});
        const l3d_pixel_box box = panel.draw(it.draw, free, corner);
        EXPECT_EQ(drawn_box(it, width, height), box);
        const bool right = corner == l3d_corner::top_right || corner == l3d_corner::bottom_right;
        const bool low = corner == l3d_corner::bottom_left || corner == l3d_corner::bottom_right;
        constexpr int margin = 7;
        EXPECT_EQ(right ? width - box.right : box.left, margin);
        EXPECT_EQ(low ? height - box.bottom : box.top, margin);
        EXPECT_EQ(free, low ? (l3d_pixel_box{0, 0, width, box.top})
                            : (l3d_pixel_box{0, box.bottom, width, height}));
        EXPECT_TRUE(it.guards_intact());
    }
}

TEST(panel, lets_the_picture_shine_through) {
    canvas it(200, 100);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 200; ++x)
            it.at(x, y) = x < 50 ? 0x00ffffff : 0x00808080;
    l3d_panel panel;
    panel.add("                 x");
    l3d_pixel_box free = l3d_whole({200, 100});
    const l3d_pixel_box box = panel.draw(it.draw, free, l3d_corner::top_left);
    const std::uint32_t bright = it.at(box.left + 1, box.top + 1), dim = it.at(60, box.top + 1);
    EXPECT_LT(bright & 255, 128u);
    EXPECT_GT(bright & 255, dim & 255);
    EXPECT_GT(dim & 255, 0x1bu);
}

TEST(panel, without_room_says_so_by_dots_or_not_at_all) {
    l3d_panel panel;
    for (const auto& [key, text] : help)
        panel.add(key, text);
    for (int width = 1; width < 120; width += 7)
        for (int height = 1; height < 90; height += 5) {
            canvas it(width, height);
            l3d_pixel_box free = l3d_whole({width, height});
            const l3d_pixel_box box = panel.draw(it.draw, free, l3d_corner::bottom_right);
            EXPECT_TRUE(it.guards_intact());
            EXPECT_EQ(box.intersected(l3d_whole({width, height})), box);
        }
    std::vector<panel_row> rows;
    for (const auto& [key, text] : help)
        rows.push_back({key, text, false});
    const l3d_font font;
    panel_layout layout(font, rows);
    layout.make(8, 1, {200, 70});
    layout.cut({200, 70});
    EXPECT_EQ(layout.lines().back().text, "...");
    EXPECT_LE(layout.size().height, 70);
}

/// As the legend of a surface that is inspected.
TEST(panel, a_scale_is_no_wider_than_its_room) {
    std::vector<panel_row> rows(2);
    rows[0] = {"", "Gaussian curvature per square unit, 0 is white", false};
    rows[1] = {"-5", "5", true};
    const l3d_font font;
    panel_layout layout(font, rows);
    for (int width = 70; width < 200; width += 3) {
        EXPECT_TRUE(layout.make(10, 1, {width, 200})) << width;
        for (const panel_line& line : layout.lines()) {
            EXPECT_LE(line.x + line.scale_width, width) << width;
            EXPECT_LE(line.x + font.width(line.text, 10), width) << line.text;
        }
    }
}

TEST(panel, breaks_lines_where_the_text_says_so) {
    const auto height = [](const std::string& text) {
        canvas it(200, 100);
        l3d_panel panel;
        panel.add("key", text);
        l3d_pixel_box free = l3d_whole({200, 100});
        const l3d_pixel_box box = panel.draw(it.draw, free, l3d_corner::top_left);
        return box.bottom - box.top;
    };
    const int line = l3d_font().line(l3d_panel_style().size);
    EXPECT_EQ(height("a\nb"), height("a") + line);
    EXPECT_EQ(height("a\nb\n"), height("a\nb")) << "the end of a line begins none";
    EXPECT_EQ(height("a\n\nb"), height("a\nb") + line);
    EXPECT_EQ(height(""), height("a"));
}

TEST(panel, that_is_empty_draws_nothing) {
    canvas it(50, 40);
    l3d_pixel_box free = l3d_whole({50, 40});
    EXPECT_TRUE(l3d_panel().draw(it.draw, free, l3d_corner::top_left).empty());
    EXPECT_EQ(it.lit().size(), 0u);
    EXPECT_EQ(free, l3d_whole({50, 40}));
}

/// How much of a picture a panel covers.
double share_of(const l3d_panel& panel, l3d_size size, const l3d_panel_style& style) {
    canvas it(size.width, size.height);
    l3d_pixel_box free = l3d_whole(size);
    const l3d_pixel_box box = panel.draw(it.draw, free, l3d_corner::top_left, style);
    return static_cast<double>(box.area()) / (double(size.width) * size.height);
}

TEST(panel, pages_of_a_long_help_leave_half_of_the_picture_free) {
    l3d_panel panel;
    for (const auto& [key, text] : help)
        panel.add(key, text);
    for (const l3d_size size : {l3d_size{320, 240}, {300, 200}, {640, 480}, {1920, 1080}}) {
        l3d_panel_style style;
        style.size = l3d_panel_style::size_for(size);
        const std::vector<l3d_panel> pages = panel.pages(size, "h", style);
        EXPECT_EQ(pages.size() == 1, size.width >= 640) << size.width;
        for (const l3d_panel& page : pages) {
            EXPECT_GT(share_of(page, size, style), 0.0);
            EXPECT_LE(share_of(page, size, style), 0.5) << size.width;
        }
    }
}

/// The height of the first capital or digit of a panel.
int letter_height(const l3d_panel& panel, l3d_size size, const l3d_panel_style& style) {
    canvas it(size.width, size.height);
    l3d_pixel_box free = l3d_whole(size);
    const l3d_pixel_box box = panel.draw(it.draw, free, l3d_corner::top_left, style);
    const auto has_letter = [&](int y) {
        for (int x = box.left; x < box.right; ++x)
            if ((it.at(x, y) & 255) > 0x80)
                return true;
        return false;
    };
    int first = box.top;
    while (first < box.bottom && !has_letter(first))
        ++first;
    int end = first;
    while (end < box.bottom && has_letter(end))
        ++end;
    return end - first;
}

/// Letters that a fine display asks for may leave no room for all lines at once: then there are
/// more pages of them, never smaller letters than those of a coarser display.
TEST(panel, pages_have_no_smaller_letters_where_larger_ones_are_wanted) {
    l3d_panel panel;
    for (int i = 0; i < 24; ++i)
        panel.add("KEY", "HELP LINE");
    for (const l3d_size size : {l3d_size{640, 400}, {1024, 768}, {320, 240}}) {
        int before = 0;
        std::size_t pages_before = 0;
        for (const double text_scale : {1.0, 1.5, 2.0, 3.0, 5.0, 8.0}) {
            l3d_panel_style style;
            style.size = l3d_panel_style::size_for(size, text_scale);
            const auto pages = panel.pages(size, "h", style);
            const int height = letter_height(pages.front(), size, style);
            EXPECT_GE(height, before) << size.width << " by " << text_scale;
            EXPECT_GE(pages.size(), pages_before) << size.width << " by " << text_scale;
            for (const l3d_panel& page : pages)
                EXPECT_EQ(letter_height(page, size, style), height) << "one size for all pages";
            before = height;
            pages_before = pages.size();
        }
    }
}

TEST(panel, letters_grow_with_the_display_as_long_as_a_dozen_lines_have_room) {
    constexpr l3d_size usual{1024, 768};
    EXPECT_EQ(l3d_panel_style::size_for(usual), 15);
    EXPECT_EQ(l3d_panel_style::size_for(usual, 2), 30);
    EXPECT_EQ(l3d_panel_style::size_for(usual, 8), 48);
    EXPECT_EQ(l3d_panel_style::size_for({8192, 6144}, 8), 128) << "a window of such a display";
    EXPECT_EQ(l3d_panel_style::size_for({64, 48}, 8), 12);
}

/// Half of a window of 320 x 240.
TEST(panel, pages_of_a_narrow_picture_leave_no_line_out) {
    l3d_panel panel;
    for (int i = 0; i < 24; ++i)
        panel.add("arrows, drag", "turn it as the mouse moves");
    constexpr l3d_size size{159, 240};
    l3d_panel_style style;
    style.size = l3d_panel_style::size_for(size);
    const auto pages = panel.pages(size, "h", style);
    EXPECT_GT(pages.size(), 1u);
    style.size = 8; // the smallest letters
    for (const l3d_panel& page : pages)
        EXPECT_FALSE(page.box_in(l3d_whole(size), l3d_corner::top_left, style).empty());
}

TEST(panel, pages_hold_every_row_once) {
    l3d_panel panel;
    for (const auto& [key, text] : help)
        panel.add(key, text);
    const l3d_size size{320, 240};
    l3d_panel_style style;
    style.size = 12;
    const auto pages = panel.pages(size, "h", style);
    ASSERT_GT(pages.size(), 1u);
    std::size_t rows = 0;
    for (const l3d_panel& page : pages)
        rows += page.rows() - 1; // the last one tells of the key
    EXPECT_EQ(rows, help.size());
}

TEST(panel, a_tiny_picture_has_one_page_rather_than_many_of_a_line_or_two) {
    l3d_panel panel;
    for (int i = 0; i < 20; ++i)
        panel.add("k", "word");
    for (const l3d_size size : {l3d_size{60, 40}, {160, 30}})
        EXPECT_EQ(panel.pages(size, "h", {}).size(), 1u);
}

TEST(panel, a_title_begins_where_keys_do) {
    const l3d_font font; // letters are 6 wide at size 10
    const std::vector<panel_row> rows{{"", "all that", false, true}, {"key", "what", false}};
    panel_layout layout(font, rows);
    ASSERT_TRUE(layout.make(10, 1, {300, 300}));
    ASSERT_EQ(layout.lines().size(), 3u);
    EXPECT_EQ(layout.lines()[0].x, layout.lines()[1].x);
    EXPECT_GT(layout.lines()[2].x, layout.lines()[1].x);
    EXPECT_EQ(layout.size().width, 2 * 5 + 3 * 6 + 10 + 4 * 6) << "the title needs no more";
}

} // namespace
