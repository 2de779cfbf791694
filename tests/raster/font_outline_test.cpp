// SPDX-License-Identifier: MIT
// Text as paths: FreeType's own pictures, kerning, what a font does not have, and placing.
#include "raster/canvas_2d.h"
#include "raster/paths/path.h"
#include "raster/text/font.h"
#include "raster/text/text_shaper_p.h"
#include "raster/text/utf8_p.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace {

constexpr int width = 90, height = 50;

/// A face that kerns by its kern table and by OpenType alike.
constexpr const char* dejavu = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

std::optional<l3d_font> a_file() {
    std::string why;
    return l3d_font::load(dejavu, why);
}

/// Counts the pieces of a path.
struct piece_counter {
    int moves = 0, lines = 0, curves = 0, closes = 0;
    void move(l3d_point_2d) { ++moves; }
    void line(l3d_point_2d) { ++lines; }
    void curve(const l3d_curve_2d&) { ++curves; }
    void close() { ++closes; }
};

piece_counter pieces(const l3d_path& path) {
    piece_counter result;
    path.visit(result);
    return result;
}

struct freetype {
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    freetype() { FT_Init_FreeType(&library) == 0 && FT_New_Face(library, dejavu, 0, &face); }
    freetype(const freetype&) = delete;
    freetype& operator=(const freetype&) = delete;
    ~freetype() {
        FT_Done_Face(face);
        FT_Done_FreeType(library);
    }
};

/// FreeType rounds points to 1/64 pixel, and its chords are off by some levels. Letters of 64 times
/// the size have less than a level of that in the mean of 64 x 64 pixels.
TEST(font_outline, is_what_freetype_draws_without_hinting) {
    const auto font = a_file();
    if (!font)
        GTEST_SKIP() << dejavu << " is not on this machine";
    const freetype ft;
    constexpr int size = 32, finer = 64;
    for (const char32_t code : std::u32string(U"agSW8&%@fé§")) {
        FT_Set_Pixel_Sizes(ft.face, 0, static_cast<FT_UInt>(size * finer));
        ASSERT_EQ(FT_Load_Char(ft.face, code, FT_LOAD_RENDER | FT_LOAD_NO_HINTING), 0);
        const FT_Bitmap& bitmap = ft.face->glyph->bitmap;
        std::string text(1, static_cast<char>(code));
        if (code >= 0x80)
            text = {static_cast<char>(0xc0 | code >> 6), static_cast<char>(0x80 | (code & 63))};
        canvas c(width, height);
        l3d_path path;
        constexpr int x0 = 9, y0 = 38;
        // a pixel's square begins half a pixel before its sample
        font->outline(path, {x0 - 0.5, y0 - 0.5}, text, size);
        c.draw.draw_path(path, {.color = 0x00ffffff});
        std::vector<int> sums(std::size_t{width} * height);
        for (int row = 0; row < static_cast<int>(bitmap.rows); ++row)
            for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
                const int x = x0 * finer + ft.face->glyph->bitmap_left + column;
                const int y = y0 * finer - ft.face->glyph->bitmap_top + row;
                sums[static_cast<std::size_t>(y / finer * width + x / finer)] +=
                    bitmap.buffer[row * bitmap.pitch + column];
            }
        long sum = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double expected =
                    sums[static_cast<std::size_t>(y * width + x)] / double{finer * finer};
                ASSERT_NEAR(c.at(x, y) & 255, expected, 1) << text << ": " << x << ' ' << y;
                sum += static_cast<long>(expected);
            }
        EXPECT_GT(sum, 255 * size);
    }
}

TEST(font_outline, kerns_by_harfbuzz_as_by_the_fonts_table) {
    const auto font = a_file();
    if (!font)
        GTEST_SKIP() << dejavu << " is not on this machine";
    const auto wide = [&](std::string_view text) {
        l3d_path path;
        return font->outline(path, {}, text, 100);
    };
    EXPECT_LT(wide("AV"), wide("A") + wide("V") - 3);
    EXPECT_NEAR(wide("nn"), wide("n") + wide("n"), 1e-9);
    std::string why;
    const auto source = l3d_detail::font_source::open(dejavu, 0, why);
    for (const std::u32string text : {U"AV", U"To", U"LT", U"nn", U"P.", U""}) {
        std::vector<l3d_detail::shaped_glyph> glyphs;
        const double units =
            source->shape_by_table({.text = text, .begin = 0, .end = text.size()}, glyphs);
        EXPECT_NEAR(units * 100 / source->face()->units_per_EM,
                    wide(std::string(text.begin(), text.end())), 1e-9);
    }
}

/// The characters of a line from left to right; 0 for a glyph that stands for none alone.
std::u32string from_left(const std::string& text) {
    std::string why;
    const auto source = l3d_detail::font_source::open(dejavu, 0, why);
    l3d_detail::text_shaper shaper(*source);
    std::u32string result;
    double last = -1;
    for (const auto& glyph : shaper.shape(text).glyphs) {
        EXPECT_GE(glyph.x, last);
        last = glyph.x;
        char32_t found = 0;
        for (std::string_view rest = text; !rest.empty();)
            if (const char32_t code = l3d_detail::take_character(rest);
                FT_Get_Char_Index(glyph.source->face(), code) == glyph.index)
                found = code;
        result += found;
    }
    return result;
}

TEST(text_shaper, puts_scripts_from_right_to_left_among_others_as_they_are_read) {
    if (!a_file())
        GTEST_SKIP() << dejavu << " is not on this machine";
    EXPECT_EQ(from_left("abc"), U"abc");
    EXPECT_EQ(from_left("אבג"), U"גבא");
    EXPECT_EQ(from_left("abc אבג"), U"abc גבא");
    EXPECT_EQ(from_left("אבג abc"), U"abc גבא");
    EXPECT_EQ(from_left("אבג abc דה"), U"הד abc גבא");
    EXPECT_EQ(from_left("a אב 12 ג z"), U"a ג 12 בא z");
    EXPECT_EQ(from_left("אב: 12.5"), U"12.5 :בא");
    // blanks at the end are at the end of the line, which is on the left here
    EXPECT_EQ(from_left("אב  "), U"  בא");
}

TEST(text_shaper, joins_arabic_letters_and_mirrors_brackets) {
    if (!a_file())
        GTEST_SKIP() << dejavu << " is not on this machine";
    // each letter has a form of its own between others, so none is that of the letter alone
    EXPECT_EQ(from_left("ببب"), (std::u32string{0, 0, 0}));
    EXPECT_EQ(from_left("(א) b"), U"b (א)");
}

TEST(text_shaper, takes_letters_that_a_font_lacks_from_another_one) {
    std::string why;
    const char* serif = "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf";
    const auto source = l3d_detail::font_source::open(serif, 0, why);
    if (!source || source->has(U'א') || !a_file())
        GTEST_SKIP() << serif << " and " << dejavu << " are not on this machine";
    l3d_detail::text_shaper shaper(*source);
    int others = 0;
    for (const auto& glyph : shaper.shape("ab א\xd6\xb7 c").glyphs) { // a letter with a vowel sign
        others += glyph.source != source.get();
        EXPECT_NE(glyph.index, 0U);
    }
    EXPECT_GE(others, 1);
    EXPECT_LE(others, 2);
    const auto font = l3d_font::load(serif, why);
    EXPECT_GT(font->width("א", 40), 15);
    l3d_path other, missing;
    font->outline(other, {}, "א", 40);
    font->outline(missing, {}, "\xf4\x8f\xbf\xbd", 40);
    EXPECT_NE(pieces(other).lines + pieces(other).curves,
              pieces(missing).lines + pieces(missing).curves);
}

TEST(font, drawn_letters_are_kerned_as_outlines_are) {
    const auto font = a_file();
    if (!font)
        GTEST_SKIP() << dejavu << " is not on this machine";
    constexpr int size = 40;
    EXPECT_LT(font->width("AV", size), font->width("A", size) + font->width("V", size) - 1);
    canvas drawn(120, 60), filled(120, 60);
    font->draw(drawn.draw, 5, 5, "AVAToLT", 0x00ffffff, 24);
    l3d_path path;
    font->outline(path, {4.5, 30}, "AVAToLT", 24);
    filled.draw.draw_path(path, {.color = 0x00ffffff});
    // Hinting moves heights, but no columns: the last one is that of the outlines.
    const auto last = [](canvas& c) {
        int result = -1;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 120; ++x)
                if ((c.at(x, y) & 255) > 100)
                    result = std::max(result, x);
        return result;
    };
    EXPECT_NEAR(last(drawn), last(filled), 1);
}

TEST(font_outline, grows_with_the_size_and_closes_its_outlines) {
    const auto font = a_file();
    if (!font)
        GTEST_SKIP() << dejavu << " is not on this machine";
    l3d_path small, large, twice;
    const double w = font->outline(small, {3, 4}, "Säge", 10.25);
    EXPECT_NEAR(font->outline(large, {6, 8}, "Säge", 20.5), 2 * w, 1e-9);
    twice.add(small, l3d_placement_2d::scaled(2, 2));
    canvas one(width, height), other(width, height);
    one.draw.draw_path(large, {.color = 0x00ffffff});
    other.draw.draw_path(twice, {.color = 0x00ffffff});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            ASSERT_NEAR(one.at(x, y) & 255, other.at(x, y) & 255, 1);
    const piece_counter n = pieces(small);
    EXPECT_EQ(n.moves, n.closes);
    EXPECT_EQ(n.moves, 9); // S, a and its eye and two dots, g and its eye, e and its eye
    EXPECT_GT(n.curves, 40);
}

TEST(font_outline, has_a_sign_for_what_the_font_has_not_and_nothing_for_a_blank) {
    const auto font = a_file();
    if (!font)
        GTEST_SKIP() << dejavu << " is not on this machine";
    l3d_path blank, missing, other;
    EXPECT_GT(font->outline(blank, {}, " ", 20), 4);
    EXPECT_TRUE(blank.empty());
    const double w = font->outline(missing, {}, "\xf4\x8f\xbf\xbd", 20); // U+10FFFD, private
    EXPECT_GT(w, 4);
    EXPECT_FALSE(missing.empty());
    EXPECT_EQ(font->outline(other, {}, "\xf4\x8f\xbf\xbc", 20), w); // U+10FFFC, private, too
    EXPECT_EQ(pieces(other).lines, pieces(missing).lines);
    l3d_path broken, replaced;
    font->outline(broken, {}, "a\xff", 20);
    font->outline(replaced, {}, "a\xef\xbf\xbd", 20);
    EXPECT_EQ(pieces(broken).curves, pieces(replaced).curves);
}

TEST(font_outline, of_the_built_in_face_is_its_dots) {
    const l3d_font font;
    canvas one(width, height), other(width, height);
    l3d_draw_text(one.draw, 3, 5, "Ag|%\xc3", canvas::color, 2);
    l3d_path path;
    // the base line is below the last of seven rows
    EXPECT_EQ(font.outline(path, {2.5, 4.5 + 14}, "Ag|%\xc3", 20), 5 * 12);
    other.draw.draw_path(path, {.color = canvas::color});
    EXPECT_EQ(other.lit(), one.lit());
    EXPECT_GT(other.lit().size(), 200u);
}

TEST(font_outline, of_no_size_or_no_text_is_empty) {
    l3d_path path;
    for (const auto& font : {l3d_font(), a_file().value_or(l3d_font())}) {
        for (const double size : {0.0, -3.0, std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::infinity()})
            EXPECT_EQ(font.outline(path, {}, "Text", size), 0);
        EXPECT_EQ(font.outline(path, {}, "", 20), 0);
    }
    EXPECT_TRUE(path.empty());
}

/// An outline that was begun before is not touched by the letters'.
TEST(font_outline, leaves_open_what_was_open) {
    l3d_path path;
    path.move_to({1, 1});
    path.line_to({5, 1});
    a_file().value_or(l3d_font()).outline(path, {10, 20}, "o", 20);
    const piece_counter n = pieces(path);
    EXPECT_EQ(n.moves, n.closes + 1);
}

TEST(path, added_and_turned_by_a_quarter_is_the_picture_turned) {
    const l3d_font font;
    l3d_path text, turned, rings;
    font.outline(text, {4, 30}, "Gr&", 22);
    text.arc_to({40, 12}, {11, 6}, 17, 0, 286);
    const l3d_point_2d middle{24.5, 24.5};
    turned.add(text, l3d_placement_2d::turned(90, middle));
    canvas upright(50, 50), sideways(50, 50), itself(50, 50);
    upright.draw.draw_path(text, {.color = 0x00ffffff});
    sideways.draw.draw_path(turned, {.color = 0x00ffffff});
    int lit = 0;
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 50; ++x) {
            // clockwise: what was on the left is on top
            EXPECT_NEAR(sideways.at(49 - y, x) & 255, upright.at(x, y) & 255, 1) << x << ' ' << y;
            lit += upright.at(x, y) != 0;
        }
    EXPECT_GT(lit, 200);
    text.add(text, l3d_placement_2d::moved(0, 100)); // itself, out of sight
    itself.draw.draw_path(text, {.color = 0x00ffffff});
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 50; ++x)
            EXPECT_EQ(itself.at(x, y), upright.at(x, y));
}

TEST(placement, windows_fill_viewports_and_placements_follow_each_other) {
    const auto map = l3d_placement_2d::window_to_viewport({1, 0}, {5, 3}, {0, 99}, {200, 0});
    const auto is = [](l3d_point_2d p, double x, double y) {
        EXPECT_NEAR(p.x, x, 1e-12);
        EXPECT_NEAR(p.y, y, 1e-12);
    };
    is(map.at({1, 0}), 0, 99);
    is(map.at({5, 3}), 200, 0);
    is(map.at({2, 1}), 50, 66);
    const auto turn = l3d_placement_2d::turned(40, {3, 4});
    is(turn.at({3, 4}), 3, 4);
    const l3d_placement_2d slant{{1, 2}, {3, 1}, {-2, 5}};
    const l3d_point_2d p{6, -7}, first = slant.at(p), expected = turn.at(first);
    is(slant.then(turn).at(p), expected.x, expected.y);
}

} // namespace
