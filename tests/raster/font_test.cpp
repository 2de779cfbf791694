// SPDX-License-Identifier: MIT
// Fonts: the built-in face, UTF-8, and faces from files where the machine has one.
#include "raster/canvas_2d.h"
#include "raster/paths/path.h"
#include "raster/text/font.h"
#include "raster/text/panel_layout_p.h"
#include "raster/text/utf8_p.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

namespace {

using l3d_detail::replacement_character;
using l3d_detail::take_character;

std::u32string characters(std::string_view text) {
    std::u32string result;
    while (!text.empty())
        result += take_character(text);
    return result;
}

TEST(utf8, characters_of_one_to_four_bytes) {
    EXPECT_EQ(characters("aé€😀z"), U"aé€😀z");
    EXPECT_EQ(characters("\x7f\xc2\x80\xdf\xbf\xe0\xa0\x80\xef\xbf\xbf\xf0\x90\x80\x80"),
              (std::u32string{0x7f, 0x80, 0x7ff, 0x800, 0xffff, 0x10000}));
}

/// What cannot be read takes one byte, so that the rest is read in step.
TEST(utf8, broken_bytes_stand_for_themselves) {
    const std::u32string one(1, replacement_character);
    EXPECT_EQ(characters("a\xe9z"), U"a" + one + U"z");
    EXPECT_EQ(characters("\xc3"), one);
    EXPECT_EQ(characters("\x80\x80"), one + one);
    EXPECT_EQ(characters("\xc0\xaf"), one + one) << "longer than it need be";
    EXPECT_EQ(characters("\xe0\x80\xaf"), one + one + one);
    EXPECT_EQ(characters("\xed\xa0\x80"), one + one + one) << "half of a pair";
    EXPECT_EQ(characters("\xf4\x90\x80\x80"), one + one + one + one) << "beyond the last";
    EXPECT_EQ(characters("\xe2\x82"), one + one) << "cut off";
    EXPECT_EQ(characters(std::string_view("a\0b", 3)), std::u32string(U"a\0b", 3));
}

TEST(font, built_in_letters_are_those_of_draw_text) {
    const l3d_font font;
    EXPECT_EQ(font.name(), "built-in");
    for (const int scale : {1, 2, 3}) {
        canvas one(260, 50), other(260, 50);
        const std::string text = "Ag3 {|} ~%";
        l3d_draw_text(one.draw, 4, 3 + scale, text, canvas::color, scale);
        font.draw(other.draw, 4, 3, text, canvas::color, 10 * scale);
        EXPECT_EQ(other.lit(), one.lit());
        EXPECT_GT(other.lit().size(), 60u);
        EXPECT_EQ(font.width(text, 10 * scale), 60 * scale);
        EXPECT_EQ(font.line(10 * scale), 10 * scale);
        EXPECT_TRUE(other.guards_intact());
    }
}

TEST(font, built_in_draws_a_box_for_each_character_that_it_has_not) {
    const l3d_font font;
    canvas one(40, 20), other(40, 20);
    font.draw(one.draw, 2, 2, "é€", canvas::color, 10);
    font.draw(other.draw, 2, 2, "\xff\xfe", canvas::color, 10);
    EXPECT_EQ(one.lit(), other.lit());
    EXPECT_EQ(font.width("é€", 10), 12);
}

/// Also of a face from a file, if there is one.
std::vector<l3d_font> all_faces() {
    std::string why;
    return {l3d_font(), l3d_font::of_system(why)};
}

TEST(font, tabs_go_to_the_next_multiple_of_eight_blanks) {
    for (const l3d_font& font : all_faces()) {
        const int tab = font.width("        ", 20), letter = font.width("a", 20);
        EXPECT_EQ(font.width("\t", 20), tab);
        EXPECT_NEAR(font.width("a\t", 20), tab, 1);
        EXPECT_NEAR(font.width("a\ta", 20), tab + letter, 1);
        EXPECT_NEAR(font.width("\t\t", 20), 2 * tab, 1);
        EXPECT_NEAR(font.width("        \t", 20), 2 * tab, 1);
        canvas by_tab(120, 40), by_blanks(120, 40);
        font.draw(by_tab.draw, 2, 2, "\ta", canvas::color, 10);
        font.draw(by_blanks.draw, 2, 2, "        a", canvas::color, 10);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 120; ++x)
                ASSERT_EQ(by_tab.at(x, y), by_blanks.at(x, y));
        l3d_path path;
        EXPECT_NEAR(font.outline(path, {}, "a\ta", 20), tab + letter, 1.5);
    }
}

TEST(font, soft_hyphens_and_control_characters_are_not_seen) {
    for (const l3d_font& font : all_faces()) {
        EXPECT_EQ(font.width("\x01\r\n\x1b\x7f\xc2\x9b\xc2\xad\xe2\x80\xa9", 20), 0);
        canvas plain(80, 40), with(80, 40);
        font.draw(plain.draw, 2, 2, "Wagen", canvas::color, 14);
        font.draw(with.draw, 2, 2,
                  "Wa\xc2\xadg\x07"
                  "en\n",
                  canvas::color, 14);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 80; ++x)
                ASSERT_EQ(with.at(x, y), plain.at(x, y));
    }
    canvas plain(80, 40), with(80, 40);
    l3d_draw_text(plain.draw, 2, 2, "ab", canvas::color);
    l3d_draw_text(with.draw, 2, 2,
                  "\x02"
                  "a\xc2\xad"
                  "b",
                  canvas::color);
    EXPECT_EQ(with.lit(), plain.lit());
}

TEST(wrapped_text, shows_a_hyphen_where_a_word_is_broken_and_nowhere_else) {
    const l3d_font font; // six pixels a character at size 10
    const std::string text = "an un\xc2\xad"
                             "break\xc2\xad"
                             "able word";
    const auto lines = [&](int characters) {
        return l3d_detail::wrapped(font, text, 10, 6 * characters);
    };
    using words = std::vector<std::string>;
    EXPECT_EQ(lines(40), words{text});
    EXPECT_EQ(lines(9), (words{"an un-",
                               "break\xc2\xad"
                               "able",
                               "word"}));
    EXPECT_EQ(lines(7), (words{"an un-", "break-", "able", "word"}));
    // no room for a hyphen: torn apart, as a word without one is
    EXPECT_EQ(lines(5), (words{"an", "un-", "break\xc2\xad", "able", "word"}));
}

TEST(font, reasons_name_the_file) {
    std::string why;
    EXPECT_FALSE(l3d_font::load("/no/such/font.ttf", why));
    EXPECT_NE(why.find("/no/such/font.ttf: No such file"), std::string::npos) << why;
    EXPECT_FALSE(l3d_font::load("/proc/self/exe", why));
    EXPECT_NE(why.find("/proc/self/exe: is no font"), std::string::npos) << why;
    const std::string pipe = testing::TempDir() + "font_" + std::to_string(getpid());
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_FALSE(l3d_font::load(pipe, why));
    EXPECT_EQ(why, pipe + ": is no regular file");
    unlink(pipe.c_str());
}

TEST(font, of_the_system_is_what_the_environment_says) {
    std::string why;
    ASSERT_EQ(setenv("L3D_FONT", "built-in", 1), 0);
    EXPECT_EQ(l3d_font::of_system(why).name(), "built-in");
    EXPECT_EQ(why, "");
    ASSERT_EQ(setenv("L3D_FONT", "/no/such/font.ttf", 1), 0);
    EXPECT_EQ(l3d_font::of_system(why).name(), "built-in");
    EXPECT_EQ(why, "L3D_FONT: /no/such/font.ttf: No such file or directory");
    ASSERT_EQ(unsetenv("L3D_FONT"), 0);
    l3d_font::of_system(why);
    EXPECT_EQ(why, "");
}

/// The face that this machine has, if it has one.
std::optional<l3d_font> a_file() {
    std::string why;
    l3d_font font = l3d_font::of_system(why);
    if (font.name() == "built-in")
        return std::nullopt;
    return font;
}

/// Pixels that are lit, however little.
pixel_set lit(const l3d_font& font, std::string_view text, int size) {
    constexpr int width = 90, height = 60;
    canvas it(width, height);
    font.draw(it.draw, 5, 5, text, 0x00ffffff, size);
    EXPECT_TRUE(it.guards_intact());
    pixel_set result;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (it.at(x, y) != 0)
                result.insert({x, y});
    return result;
}

int lowest(const pixel_set& pixels) {
    int result = -1;
    for (const auto& [x, y] : pixels)
        result = std::max(result, y);
    return result;
}

TEST(font, files_have_descenders_and_smooth_edges_and_more_than_ascii) {
    const auto font = a_file();
    if (!font)
        GTEST_SKIP() << "no font file on this machine";
    for (const int size : {9, 14, 28}) {
        EXPECT_GT(lowest(lit(*font, "g", size)), lowest(lit(*font, "n", size)) + size / 10);
        EXPECT_NE(lit(*font, "é", size), lit(*font, "e", size));
        EXPECT_LE(lowest(lit(*font, "gjpqy|", size)), 5 + font->line(size));
        EXPECT_GT(font->width("WWW", size), font->width("iii", size));
        EXPECT_EQ(font->width("", size), 0);
    }
    canvas it(40, 40);
    font->draw(it.draw, 5, 5, "S", 0x000000ff, 20);
    int between = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            between += it.at(x, y) > 20 && it.at(x, y) < 235;
    EXPECT_GT(between, 10);
}

TEST(font, text_anywhere_is_clipped) {
    std::string why;
    for (const l3d_font& font : {l3d_font(), l3d_font::of_system(why)}) {
        canvas it(30, 20);
        for (const int x : {-1000000000, -7, 28, 1000000000})
            for (const int y : {-1000000000, -4, 17, 1000000000})
                font.draw(it.draw, x, y, "Qgé%", canvas::color, 12);
        EXPECT_TRUE(it.guards_intact());
    }
}

} // namespace
