// SPDX-License-Identifier: MIT
// A program's caption: as text, and on the pictures of a window.
#include "pipeline/captioned_p.h"

#include "effort.h"
#include "sizable_screen.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <vector>

namespace {

constexpr double hint_seconds = 2;

/// Adds a pixel more to a row with each picture, and never clears.
class growing_row final : public l3d_pipeline {
public:
    explicit growing_row(l3d_screen& screen) : screen_(screen) {}

    int draws = 0, keys = 0;
    bool moves = true;
    std::string says;

    void draw_event() override {
        const auto row = screen_.pixels().row(screen_.pixels().height - 20);
        row[static_cast<std::size_t>(draws++)] = 0xFF0000;
    }
    void key_event(int key) override {
        ++keys;
        done |= key == 'q';
    }
    bool needs_redraw() const override { return moves; }
    bool is_at_rest() const override { return !moves; }
    std::string message() const override { return says; }

private:
    l3d_screen& screen_;
};

class captioned_row : public testing::Test {
protected:
    explicit captioned_row(l3d_size size = {400, 300}) : screen(size) {}

    /// The picture with the row's pixels, and without a panel?
    bool is_plain() {
        for (int y = 0; y < screen.pixels().height; ++y)
            for (int x = 0; x < screen.pixels().width; ++x) {
                const bool lit = y == screen.pixels().height - 20 && x < row.draws;
                if (screen.pixels().row(y)[static_cast<std::size_t>(x)] != (lit ? 0xFF0000u : 0u))
                    return false;
            }
        return true;
    }
    void pass(double seconds) {
        shown.update_event(seconds);
        shown.draw_event();
    }

    pipeline_tests::sizable_screen screen;
    growing_row row{screen};
    l3d_detail::captioned shown{row, screen,
                                l3d_caption{.what = "A row grows.", .keys = {{"x", "nothing"}}},
                                l3d_font(), hint_seconds};
};

class captioned_row_in_a_small_window : public captioned_row {
protected:
    captioned_row_in_a_small_window() : captioned_row({60, 40}) {}
};

} // namespace

TEST(caption, says_all_keys_of_a_program_below_what_it_shows) {
    const l3d_caption caption{.what = "Dots.", .keys = {{"p", "rest"}}};
    EXPECT_EQ(caption.text(),
              "Dots.\nKeys: p: rest; F11: whole screen; h, ?: help; q, Escape: quit.");
}

TEST(caption, breaks_lines_before_they_leave_a_terminal) {
    l3d_caption caption{.what = "Dots."};
    for (int i = 0; i < 20; ++i)
        caption.keys.push_back({"a, b", "a thing that keys do"});
    const std::string text = caption.text();
    std::size_t longest = 0, begin = 0;
    for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
        end = text.find('\n', begin);
        longest = std::max(longest, std::min(end, text.size()) - begin);
    }
    EXPECT_LE(longest, 80u);
    EXPECT_GT(longest, 50u);
}

TEST(caption, says_what_a_lesson_teaches_between_what_it_shows_and_its_keys) {
    const l3d_caption caption{.what = "Dots.", .teaches = "Far dots move less.", .keys = {}};
    EXPECT_EQ(caption.text(), "Dots.\nFar dots move less.\n"
                              "Keys: F11: whole screen; h, ?: help; q, Escape: quit.");
    l3d_caption longer = caption;
    for (int i = 0; i < 20; ++i)
        longer.teaches += " Far dots move less.";
    const std::string text = longer.text();
    for (std::size_t begin = 0, end = 0; end != text.size(); begin = end + 1) {
        end = std::min(text.find('\n', begin), text.size());
        EXPECT_LE(end - begin, 79u);
    }
}

TEST_F(captioned_row, gives_back_the_memory_of_a_large_picture) {
    if (sanitized)
        GTEST_SKIP() << "sanitizers have memory of their own";
    const auto bytes_in_use = [] {
        const struct mallinfo2 all = mallinfo2();
        return all.uordblks + all.hblkhd;
    };
    const auto show = [&](l3d_size size) {
        screen.resize(size);
        shown.resize_event(size);
        shown.draw_event();
    };
    show({400, 300});
    const std::size_t before = bytes_in_use();
    show({4000, 3000});
    show({400, 300});
    EXPECT_LT(bytes_in_use(), before + (std::size_t{1} << 20));
}

TEST_F(captioned_row, shows_a_message_as_long_as_it_is_told_and_tells_where_text_stands) {
    row.moves = false;
    pass(hint_seconds);
    EXPECT_TRUE(is_plain());
    EXPECT_TRUE(screen.text.empty());
    row.says = "it stands\nstill";
    shown.draw_event();
    EXPECT_FALSE(is_plain());
    ASSERT_EQ(screen.text.size(), 1u);
    EXPECT_LT(screen.text[0].bottom, 100) << "above, where no hint is";
    row.says = "";
    shown.draw_event();
    EXPECT_TRUE(is_plain());
    EXPECT_TRUE(screen.text.empty());
}

TEST_F(captioned_row, hides_what_is_behind_text_where_the_line_is_slow) {
    for (int y = 0; y < 300; ++y)
        std::ranges::fill(screen.pixels().row(y), 0xFFFFFFu);
    const auto corner_of_hint = [&] {
        shown.draw_event();
        const l3d_pixel_box box = screen.text.at(0);
        return screen.pixels().row(box.top)[static_cast<std::size_t>(box.left)];
    };
    const std::uint32_t through = corner_of_hint();
    screen.slow = true;
    EXPECT_EQ(corner_of_hint(), l3d_panel_style().ground);
    EXPECT_NE(through, l3d_panel_style().ground);
}

TEST_F(captioned_row, shows_a_hint_at_first_and_leaves_the_picture_as_it_would_be) {
    constexpr double step = 0.25; // exact, as are its sums
    for (double seconds = step; seconds < hint_seconds; seconds += step) {
        pass(step);
        EXPECT_FALSE(is_plain());
    }
    pass(step);
    EXPECT_TRUE(is_plain()) << "what the panel covered is there again";
    EXPECT_EQ(row.draws, 8);
}

TEST_F(captioned_row, shows_its_hint_in_a_corner_until_a_button_is_pressed) {
    row.moves = false;
    const auto is_covered = [&](int x, int y) {
        return screen.pixels().row(y)[static_cast<std::size_t>(x)] != 0;
    };
    l3d_detail::captioned above{
        row, screen, l3d_caption{.what = "A row grows.", .corner = l3d_corner::top_right},
        l3d_font(), hint_seconds};
    above.draw_event();
    EXPECT_TRUE(is_covered(385, 15));
    EXPECT_FALSE(is_covered(15, 285));
    above.pointer_event({.type = l3d_event_type::button_press, .button = 1});
    EXPECT_TRUE(above.needs_redraw());
    EXPECT_TRUE(above.is_at_rest());
    above.draw_event();
    EXPECT_TRUE(is_plain());
}

TEST_F(captioned_row, asks_for_a_picture_when_its_panel_comes_or_goes) {
    row.moves = false;
    pass(0.1);
    EXPECT_FALSE(shown.needs_redraw());
    EXPECT_TRUE(shown.is_at_rest());
    EXPECT_DOUBLE_EQ(shown.rest_left(), hint_seconds - 0.1) << "time takes the hint away";
    shown.rest_event(hint_seconds - 1);
    EXPECT_FALSE(shown.needs_redraw()) << "a key may end a rest, and leave the hint";
    EXPECT_NEAR(shown.rest_left(), 0.9, 1e-12);
    shown.rest_event(1);
    EXPECT_TRUE(shown.needs_redraw());
    EXPECT_GT(shown.rest_left(), 1e9);
    shown.draw_event();
    EXPECT_FALSE(shown.needs_redraw());
    EXPECT_TRUE(is_plain());
}

TEST_F(captioned_row, shows_help_by_its_keys_and_keeps_them_for_itself) {
    row.moves = false;
    pass(hint_seconds);
    for (const int key : {'h', '?'}) {
        shown.key_event(key);
        EXPECT_TRUE(shown.needs_redraw());
        pass(0.1);
        EXPECT_FALSE(is_plain());
        pass(100);
        EXPECT_FALSE(is_plain()) << "help stays until a key hides it";
        shown.key_event(key);
        pass(0.1);
        EXPECT_TRUE(is_plain());
    }
    EXPECT_EQ(row.keys, 0);
    shown.key_event('x');
    EXPECT_EQ(row.keys, 1);
}

TEST_F(captioned_row, tells_which_pixels_changed) {
    row.moves = false;
    pass(hint_seconds);
    shown.key_event('h');
    shown.draw_event();
    const l3d_pixel_box whole = l3d_whole(screen.pixels().size());
    EXPECT_EQ(shown.changed().intersected(whole), whole) << "the row says nothing less";
}

TEST_F(captioned_row, is_done_when_the_program_is) {
    EXPECT_FALSE(shown.done);
    shown.key_event('q');
    EXPECT_TRUE(shown.done);
}

TEST_F(captioned_row, puts_nothing_of_the_old_size_into_the_new_one) {
    for (int y = 0; y < 300; ++y)
        std::ranges::fill(screen.pixels().row(y), 0x123456u);
    pass(0.1);
    screen.resize({400, 340});
    shown.resize_event({400, 340});
    row.draws = 0;
    pass(hint_seconds);
    EXPECT_TRUE(is_plain());
}

TEST(captioned_row_with_many_words, names_the_key_of_help_where_they_have_no_room) {
    pipeline_tests::sizable_screen screen(l3d_size{320, 240});
    growing_row row{screen};
    const std::string words = "Many words of what this picture is to show, and of what for. ";
    l3d_detail::captioned shown{row, screen, l3d_caption{.what = words + words + words + words},
                                l3d_font(), hint_seconds};
    shown.update_event(0.1);
    shown.draw_event();
    const auto lit_rows = [&](int from, int to) {
        int lit = 0;
        for (int y = from; y < to; ++y)
            for (const std::uint32_t word : screen.pixels().row(y))
                lit += word != 0;
        return lit;
    };
    EXPECT_EQ(lit_rows(0, 200), 0) << "the words would hide these rows";
    EXPECT_NE(lit_rows(200, 240), 0) << "the key's panel";
}

TEST_F(captioned_row_in_a_small_window, gives_no_hint_that_would_cover_the_picture) {
    pass(0.1);
    EXPECT_TRUE(is_plain());
    EXPECT_FALSE(shown.needs_redraw() && !row.moves);
}
