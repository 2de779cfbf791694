// SPDX-License-Identifier: MIT
// The keys, the mouse and the text that all viewers share.
#include "pipeline/viewer_controls.h"

#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"
#include "words_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace {

/// A viewer of nothing, with a key of its own.
class nothing_viewer : public l3d_pipeline {
public:
    explicit nothing_viewer(l3d_size size = {403, 311}) : screen(size) {}

    l3d_screen_memory screen;
    l3d_camera camera;
    int own = 0, resets = 0;
    l3d_viewer_controls controls{
        *this, screen, camera, {{"k", "count", {{'k', [this] { ++own; }}}}}, [this] { ++resets; }};

    /// Rows of the picture that have text in them.
    int text_rows() {
        const l3d_rasterizer_factory_sw factory;
        const auto imp = factory.create_2d(screen.pixels());
        l3d_rasterizer_2d rasterizer(*imp);
        rasterizer.clear_buffer();
        const std::string line = "a line of the viewer's own";
        controls.draw(rasterizer, {&line, 1});
        int rows = 0;
        for (int y = 0; y < screen.pixels().height; ++y)
            rows += std::ranges::any_of(screen.pixels().row(y),
                                        [](std::uint32_t word) { return word != 0; });
        return rows;
    }
};

double distance(const l3d_camera& camera) {
    return l3d_length(camera.eye - camera.target);
}

TEST(viewer_controls, turn_zoom_and_reset) {
    nothing_viewer it;
    const l3d_camera first = it.camera;
    for (const int key : {l3d_key_left, l3d_key_right, l3d_key_up, l3d_key_down}) {
        const auto eye = it.camera.eye;
        EXPECT_TRUE(it.controls.key(key));
        EXPECT_NE(it.camera.eye, eye) << key;
        EXPECT_NEAR(distance(it.camera), distance(first), 1e-12);
    }
    EXPECT_TRUE(it.controls.key(l3d_key_page_up));
    EXPECT_LT(distance(it.camera), distance(first));
    EXPECT_TRUE(it.controls.key('r'));
    EXPECT_EQ(it.camera.eye, first.eye);
    EXPECT_EQ(it.resets, 1);
}

TEST(viewer_controls, have_the_viewers_own_keys_and_the_end) {
    nothing_viewer it;
    EXPECT_TRUE(it.controls.key('k'));
    EXPECT_EQ(it.own, 1);
    EXPECT_FALSE(it.controls.key('j')) << "a key that nobody has needs no other picture";
    for (const int key : {static_cast<int>('q'), static_cast<int>(l3d_key_escape)}) {
        it.done = false;
        it.controls.key(key);
        EXPECT_TRUE(it.done);
    }
}

TEST(viewer_controls, take_further_keys_and_list_them) {
    nothing_viewer it({640, 480});
    it.controls.key('h');
    const int rows_before = it.text_rows();
    int further = 0;
    it.controls.add({"x", "further", {{'x', [&] { ++further; }}}});
    EXPECT_TRUE(it.controls.key('x'));
    EXPECT_EQ(further, 1);
    EXPECT_GT(it.text_rows(), rows_before);
}

TEST(viewer_controls, drag_and_wheel) {
    nothing_viewer it;
    const l3d_camera first = it.camera;
    using type = l3d_event_type;
    EXPECT_FALSE(it.controls.pointer({type::button_press, 0, 1, 31, 17, {}}));
    EXPECT_EQ(it.camera.eye, first.eye);
    EXPECT_TRUE(it.controls.pointer({type::pointer_motion, 0, 1, 121, 17, {}}));
    // A quarter of a turn, to where the eye is at right angles to where it was, seen from above.
    const auto was = first.eye - first.target, is = it.camera.eye - it.camera.target;
    EXPECT_NEAR(was[0] * is[0] + was[2] * is[2], 0, 1e-9);
    EXPECT_TRUE(
        it.controls.pointer({.type = type::wheel, .x = 201, .y = 155, .turn = -1, .notches = -1}));
    EXPECT_NEAR(distance(it.camera), 1.1 * distance(first), 1e-9);
}

TEST(viewer_controls, the_turntable_starts_after_the_first_frame_and_pauses) {
    nothing_viewer it;
    it.controls.set_turntable(3, 20);
    const auto eye = it.camera.eye;
    EXPECT_FALSE(it.controls.update(0.05));
    EXPECT_EQ(it.camera.eye, eye);
    EXPECT_TRUE(it.controls.update(0.05));
    l3d_camera turned;
    turned.orbit(3, 0);
    EXPECT_NEAR(l3d_length(it.camera.eye - turned.eye), 0, 1e-12);
    it.controls.key(' ');
    EXPECT_FALSE(it.controls.update(0.05));
    it.controls.key('p');
    EXPECT_TRUE(it.controls.update(0.05));
    it.controls.key('t');
    EXPECT_FALSE(it.controls.update(0.05));
}

TEST(viewer_controls, show_status_help_and_a_message_until_the_next_key) {
    nothing_viewer it;
    EXPECT_FALSE(it.controls.shows_text());
    EXPECT_EQ(it.text_rows(), 0);
    it.controls.key('o');
    const int status = it.text_rows();
    EXPECT_GT(status, 20) << "two lines, and the panel around them";
    it.controls.key('?');
    const int help = it.text_rows();
    EXPECT_GT(help, 4 * status) << "ten rows of ours and one of the viewer's";
    it.controls.key('p');
    EXPECT_GT(it.text_rows(), help);
    EXPECT_TRUE(it.controls.key('j')) << "the message goes";
    EXPECT_EQ(it.text_rows(), help);
}

/// The pictures of a viewer at some pace, by a clock of the test's own.
TEST(viewer_controls, tell_the_pace_of_pictures_by_one_clock) {
    const auto status = [](int pictures, int milliseconds) {
        nothing_viewer it;
        l3d_picture_pace::clock::time_point now{};
        it.controls.pace() = l3d_picture_pace([&now] { return now; });
        it.controls.key('o');
        for (int i = 0; i < pictures; ++i) {
            it.controls.pace().begin();
            now += std::chrono::milliseconds(milliseconds);
            it.controls.pace().end();
            it.controls.update(0.001); // steps of time that draw nothing count for nothing
        }
        it.text_rows();
        return words_of(it.screen.pixels());
    };
    EXPECT_TRUE(status(3, 20) == status(9, 20));
    EXPECT_FALSE(status(3, 20) == status(3, 40));
    EXPECT_FALSE(status(0, 20) == status(3, 20));
}

TEST(viewer_controls, tell_of_the_help_for_some_seconds_or_until_a_key) {
    nothing_viewer it;
    it.controls.show_hint(1);
    EXPECT_GT(it.text_rows(), 10);
    EXPECT_FALSE(it.controls.update(0.6)) << "it is still shown";
    EXPECT_TRUE(it.controls.shows_text());
    EXPECT_TRUE(it.controls.update(0.6)) << "it has to go";
    EXPECT_FALSE(it.controls.shows_text());
    EXPECT_FALSE(it.controls.update(0.6));
    it.controls.show_hint(1);
    EXPECT_TRUE(it.controls.key('j'));
    EXPECT_FALSE(it.controls.shows_text());
    EXPECT_EQ(it.text_rows(), 0);
}

TEST(viewer_controls, rest_until_their_hint_ends) {
    nothing_viewer it;
    EXPECT_GT(it.controls.rest_left(), 1e9);
    it.controls.show_hint(1);
    EXPECT_TRUE(it.controls.is_at_rest());
    EXPECT_FALSE(it.controls.rest(0.25));
    EXPECT_DOUBLE_EQ(it.controls.rest_left(), 0.75);
    EXPECT_TRUE(it.controls.rest(0.75)) << "it has to go";
    EXPECT_GT(it.controls.rest_left(), 1e9);
    EXPECT_FALSE(it.controls.rest(9));
}

/// With letters made for finer displays, too: everything is inside, as margins show.
TEST(viewer_controls, fit_into_every_window) {
    for (const l3d_size size : {l3d_size{320, 240}, {403, 311}, {640, 480}, {240, 900}}) {
        nothing_viewer it(size);
        it.controls.key('h');
        it.controls.key('o');
        it.controls.key('p');
        EXPECT_GT(it.text_rows(), 100);
        for (int y = 0; y < size.height; ++y) {
            const auto row = it.screen.pixels().row(y);
            ASSERT_EQ(row.front() | row.back(), 0u) << size.width << ", row " << y;
            if (y == 0 || y == size.height - 1) {
                ASSERT_TRUE(std::ranges::all_of(row, [](std::uint32_t word) { return word == 0; }));
            }
        }
    }
}

/// All that a viewer can have at a time, on white.
struct crowd {
    nothing_viewer viewer;
    l3d_panel legend;
    l3d_standing_panel standing;

    explicit crowd(l3d_size size) : viewer(size) {
        legend.add("angle to the light, in stripes of 10 degrees");
        legend.add_scale({white, white}, "0", "180");
        standing.panel.add("patches", "80");
        standing.panel.add("error", "0.25 pixels at most");
        standing.panel.add("frame", "1.25 ms");
    }

    static constexpr std::uint32_t white = 0x00ffffff;

    void draw(bool with_all = true) {
        const l3d_rasterizer_factory_sw factory;
        const auto imp = factory.create_2d(viewer.screen.pixels());
        l3d_rasterizer_2d rasterizer(*imp);
        for (int y = 0; y < viewer.screen.pixels().height; ++y)
            std::ranges::fill(viewer.screen.pixels().row(y), white);
        const std::string line = "error at most 0.250 pixels, of 0.25 allowed";
        if (with_all)
            viewer.controls.draw(rasterizer, {&line, 1}, legend, standing);
        else
            viewer.controls.draw(rasterizer, {&line, 1});
    }

    /// Where a panel's ground is on another panel's. One ground leaves a fifth of white.
    int covered_twice() {
        int pixels = 0;
        for (const std::uint32_t word : words_of(viewer.screen.pixels()))
            pixels += (word >> 16) < 60;
        return pixels;
    }
};

TEST(viewer_controls, draw_no_panel_on_another) {
    for (const l3d_size size :
         {l3d_size{320, 240}, {480, 360}, {642, 480}, {1024, 640}, {160, 240}, {97, 73}})
        for (const std::string keys : {"o", "h", "oh", "op", "ohp", "s"})
            for (const l3d_corner corner : {l3d_corner::bottom_right, l3d_corner::top_right}) {
                crowd it(size);
                it.standing.corner = corner;
                for (const char key : keys)
                    it.viewer.controls.key(key);
                it.draw();
                EXPECT_EQ(it.covered_twice(), 0) << size.width << ", keys " << keys;
            }
}

/// In each page of a small window, too, where the others do not leave room for it.
TEST(viewer_controls, show_help_as_if_it_were_alone) {
    for (const l3d_size size : {l3d_size{320, 240}, {160, 240}, {480, 360}}) {
        crowd it(size);
        for (it.viewer.controls.key('h'); it.viewer.controls.shows_text();
             it.viewer.controls.key('h')) {
            it.draw(false);
            const std::vector<std::uint32_t> alone = words_of(it.viewer.screen.pixels());
            it.draw();
            const std::vector<std::uint32_t> beside = words_of(it.viewer.screen.pixels());
            int differing = 0;
            for (std::size_t i = 0; i < alone.size(); ++i)
                differing += alone[i] != crowd::white && alone[i] != beside[i];
            ASSERT_EQ(differing, 0) << size.width;
        }
    }
}

/// Two short panels of one row: that on the right need not go up for that on the left.
TEST(viewer_controls, leave_a_panel_in_its_corner_beside_a_message) {
    crowd it({640, 480});
    const auto corner = [&] { return it.viewer.screen.pixels().row(470)[620]; };
    it.draw();
    const std::uint32_t ground = corner();
    EXPECT_NE(ground, crowd::white);
    it.viewer.controls.key('p');
    it.draw();
    EXPECT_EQ(corner(), ground);
    EXPECT_NE(it.viewer.screen.pixels().row(470)[20], crowd::white) << "the message";
}

/// At 320 x 240 a page of the help leaves half of the picture free; the key goes through all.
TEST(viewer_controls, turn_the_pages_of_help_in_a_small_window) {
    nothing_viewer it({320, 240});
    int pages = 0;
    for (it.controls.key('h'); it.controls.shows_text(); it.controls.key('h')) {
        EXPECT_GT(it.text_rows(), 20);
        ASSERT_LT(++pages, 10);
    }
    EXPECT_GT(pages, 1);
    EXPECT_EQ(it.text_rows(), 0);
    nothing_viewer large({640, 480});
    large.controls.key('h');
    large.controls.key('h');
    EXPECT_FALSE(large.controls.shows_text()) << "one page";
}

TEST(viewer_controls, save_the_screens_pixels) {
    nothing_viewer it;
    EXPECT_TRUE(it.controls.key('s'));
    EXPECT_FALSE(it.controls.shows_text()) << "nobody saves";
    const std::uint32_t* saved = nullptr;
    it.controls.set_screenshot([&](const l3d_pixels& pixels) {
        saved = pixels.row(0).data();
        return "saved it";
    });
    it.controls.key('s');
    EXPECT_EQ(saved, it.screen.pixels().row(0).data());
    EXPECT_TRUE(it.controls.shows_text());
}

} // namespace
