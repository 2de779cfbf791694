// SPDX-License-Identifier: MIT
// How keys and the pointer move the eye: by events, on a model that is a ball about the origin.
#include "pipeline/viewer_controls.h"

#include "still_studio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace {

using type = l3d_event_type;
using vector = l3d_camera::vector;

/// A viewer of a unit ball, which knows where a ray meets it.
class ball_viewer : public l3d_pipeline {
public:
    still_tests::sizable_screen screen{{400, 300}};
    l3d_camera camera{.eye = {2.0, 3.0, 6.0}, .target = {0.1, -0.2, 0.3}};
    l3d_viewer_controls controls{*this,
                                 screen,
                                 camera,
                                 {},
                                 {},
                                 {.framed = [this](const l3d_camera& from) { return framed(from); },
                                  .place_at = [this](double x, double y) { return place(x, y); }}};

    l3d_size size() { return screen.pixels().size(); }

    /// Where a place is in the picture, by the camera's own matrix.
    std::array<double, 2> seen(const vector& at) {
        const auto h =
            camera.image_matrix(size()) * l3d_vector<double, 4>(at[0], at[1], at[2], 1.0);
        return {size().width / 2.0 + h[0] / h[3], size().height / 2.0 + h[1] / h[3]};
    }

    std::optional<l3d_pointed_place> place(double x, double y) {
        const vector on = camera.place_at(x, y, 1, size());
        const vector ray = l3d_normalized(on - camera.eye);
        const double middle = -l3d_dot(camera.eye, ray);
        const double square = l3d_dot(camera.eye, camera.eye) - middle * middle;
        if (square > 1)
            return std::nullopt;
        return l3d_pointed_place{camera.eye + ray * (middle - std::sqrt(1 - square)), 0.001,
                                 "ball"};
    }

    l3d_camera framed(const l3d_camera& from) {
        l3d_camera result = from;
        result.target = {0.0, 0.0, 0.0};
        result.eye = l3d_normalized(from.eye - from.target) * (10.0 * size().height / size().width);
        return result;
    }

    bool send(const l3d_event& event) {
        controls.note(event);
        return event.type == type::key_press ? controls.key(event.key) : controls.pointer(event);
    }
    bool drag(int button, std::array<int, 2> from, std::array<int, 2> to, bool shift = false) {
        send({.type = type::button_press,
              .button = button,
              .x = from[0],
              .y = from[1],
              .clicks = 1,
              .shift = shift});
        const bool moved = send({.type = type::pointer_motion,
                                 .button = button,
                                 .x = to[0],
                                 .y = to[1],
                                 .shift = shift});
        send({.type = type::button_release, .button = button, .x = to[0], .y = to[1]});
        return moved;
    }
    void press(int key, bool control = false) {
        EXPECT_TRUE(send({.type = type::key_press, .key = key, .control = control}));
    }
    vector direction() const { return l3d_normalized(camera.target - camera.eye); }
};

void expect_near(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    EXPECT_NEAR(a[0], b[0], 1e-6);
    EXPECT_NEAR(a[1], b[1], 1e-6);
}

TEST(view_steering, what_is_grabbed_stays_under_the_pointer_that_moves) {
    for (const auto& [button, shift] : {std::pair(2, false), {1, true}}) {
        ball_viewer it;
        const auto grabbed = it.place(180.5, 140.5);
        ASSERT_TRUE(grabbed);
        const vector direction = it.direction();
        EXPECT_TRUE(it.drag(button, {180, 140}, {231, 97}, shift));
        expect_near(it.seen(grabbed->place), {231.5, 97.5});
        EXPECT_LT(l3d_length(it.direction() - direction), 1e-12) << "nothing is turned";
    }
}

TEST(view_steering, where_nothing_is_the_targets_plane_is_grabbed) {
    ball_viewer it;
    ASSERT_FALSE(it.place(3, 5));
    const vector target = it.camera.target;
    EXPECT_TRUE(it.drag(2, {3, 5}, {43, -15}));
    expect_near(it.seen(target), {240, 130});
}

TEST(view_steering, parallel_pictures_move_with_the_pointer_as_well) {
    ball_viewer it;
    it.camera.projection = l3d_projection::parallel;
    const vector target = it.camera.target;
    EXPECT_TRUE(it.drag(2, {200, 150}, {230, 110}));
    expect_near(it.seen(target), {230, 110});
}

TEST(view_steering, wheel_and_right_drag_zoom_to_what_is_under_the_pointer) {
    for (const bool wheel : {true, false}) {
        ball_viewer it;
        const auto under = it.place(220.5, 130.5);
        ASSERT_TRUE(under);
        const double before = it.camera.depth_of(under->place);
        if (wheel)
            EXPECT_TRUE(
                it.send({.type = type::wheel, .x = 220, .y = 130, .turn = 1, .notches = 1}));
        else
            EXPECT_TRUE(it.drag(3, {220, 130}, {220, 100}));
        expect_near(it.seen(under->place), {220.5, 130.5});
        EXPECT_LT(it.camera.depth_of(under->place), 0.95 * before);
    }
}

TEST(view_steering, zoom_ends_before_the_near_plane_and_the_end_of_the_world) {
    ball_viewer it;
    for (int i = 0; i < 500; ++i)
        it.send({.type = type::wheel, .x = 200, .y = 150, .turn = 1, .notches = 1});
    const auto there = it.place(200.5, 150.5);
    ASSERT_TRUE(there);
    EXPECT_GE(it.camera.depth_of(there->place), it.camera.near_z);
    for (int i = 0; i < 3000; ++i)
        it.send({.type = type::wheel, .x = 200, .y = 150, .turn = -1, .notches = -1});
    EXPECT_TRUE(it.camera.is_valid()) << it.camera.complaint();
}

TEST(view_steering, a_double_click_sets_what_the_eye_turns_about) {
    ball_viewer it;
    const auto place = it.place(170.5, 120.5);
    ASSERT_TRUE(place);
    const l3d_event first{.type = type::button_press, .button = 1, .x = 170, .y = 120, .clicks = 1};
    EXPECT_FALSE(it.send(first));
    l3d_event second = first;
    second.clicks = 2;
    EXPECT_TRUE(it.send(second));
    EXPECT_LT(l3d_length(it.camera.target - place->place), 1e-12);
    it.press(l3d_key_left);
    expect_near(it.seen(place->place), {200, 150});
    second.x = 2, second.y = 2;
    EXPECT_FALSE(it.send(second)) << "nothing is there";
}

TEST(view_steering, keys_show_the_sides_and_ctrl_the_opposite_ones) {
    struct side {
        int key;
        bool control;
        vector eye;
    };
    for (const side& each : {side{'1', false, {0.0, 0.0, 1.0}},
                             {'1', true, {0.0, 0.0, -1.0}},
                             {'3', false, {1.0, 0.0, 0.0}},
                             {'3', true, {-1.0, 0.0, 0.0}},
                             {'7', false, {0.0, 1.0, 0.0}},
                             {'7', true, {0.0, -1.0, 0.0}}}) {
        ball_viewer it;
        const l3d_camera before = it.camera;
        it.press(each.key, each.control);
        EXPECT_LT(l3d_length(it.direction() + each.eye), 1e-12) << each.key << each.control;
        EXPECT_EQ(it.camera.target, before.target);
        EXPECT_NEAR(l3d_length(it.camera.eye - it.camera.target),
                    l3d_length(before.eye - before.target), 1e-12);
        EXPECT_TRUE(it.camera.is_valid());
        it.press('9');
        EXPECT_LT(l3d_length(it.direction() - each.eye), 1e-12) << "the opposite of " << each.key;
    }
}

TEST(view_steering, from_above_the_front_is_below_and_turning_goes_on_from_there) {
    ball_viewer it;
    it.press('7');
    EXPECT_LT(l3d_length(it.camera.axes().up - vector{0.0, 0.0, -1.0}), 1e-12);
    const auto before = it.camera.axes();
    it.press(l3d_key_down);
    EXPECT_EQ(it.camera.up, (vector{0.0, 1.0, 0.0}));
    // Five degrees and the 1.2 that turning stays away from the pole.
    EXPECT_GT(l3d_dot(it.camera.axes().right, before.right), 0.99);
    EXPECT_GT(l3d_dot(it.camera.axes().up, before.up), 0.99);
    it.press('7', true);
    EXPECT_LT(l3d_length(it.camera.axes().up - vector{0.0, 0.0, 1.0}), 1e-12);
    const auto below = it.camera.axes();
    it.press(l3d_key_up);
    EXPECT_GT(l3d_dot(it.camera.axes().right, below.right), 0.99);
    EXPECT_GT(l3d_dot(it.camera.axes().up, below.up), 0.99);
}

TEST(view_steering, f_frames_and_r_returns) {
    ball_viewer it;
    const l3d_camera first = it.camera;
    it.press('f');
    EXPECT_EQ(it.camera, it.framed(first));
    it.press('r');
    EXPECT_EQ(it.camera, first);
}

TEST(view_steering, ctrl_clicks_tell_places_and_measure_between_two) {
    ball_viewer it;
    const l3d_camera camera = it.camera;
    const auto click = [&](int x, int y) {
        return it.send({.type = type::button_press,
                        .button = 1,
                        .x = x,
                        .y = y,
                        .clicks = 1,
                        .control = true});
    };
    EXPECT_TRUE(click(200, 150));
    EXPECT_TRUE(it.controls.shows_text());
    EXPECT_TRUE(click(150, 110));
    const double distance =
        l3d_length(it.place(200.5, 150.5)->place - it.place(150.5, 110.5)->place);
    char words[80];
    std::snprintf(words, sizeof words, "distance %.9g units, good to 0.002", distance);
    EXPECT_EQ(it.controls.message(), words);
    EXPECT_FALSE(it.send({.type = type::pointer_motion, .button = 1, .x = 90, .y = 9}));
    EXPECT_EQ(it.camera, camera) << "a click with Ctrl begins no drag";
    EXPECT_TRUE(click(1, 1));
    EXPECT_EQ(it.controls.message(), "nothing is there");
}

/// Rings stay where they were set on the model while it turns, and until a key after the second.
TEST(view_steering, places_that_are_clicked_on_are_marked) {
    for (const bool parallel : {false, true}) {
        ball_viewer it;
        it.camera.projection = parallel ? l3d_projection::parallel : l3d_projection::perspective;
        const auto has_mark = [&](const std::array<double, 2>& at) {
            const l3d_pixels pixels = it.screen.pixels();
            const l3d_rasterizer_factory_sw factory;
            const auto imp = factory.create_2d(pixels);
            l3d_rasterizer_2d rasterizer(*imp);
            rasterizer.clear_buffer();
            it.controls.draw(rasterizer, {});
            const auto is_lit = [&](double x, double y) {
                const auto column = static_cast<std::size_t>(std::floor(at[0] + x));
                return (pixels.row(static_cast<int>(std::floor(at[1] + y)))[column] & 0xff0000) >
                       0x600000;
            };
            return is_lit(5, 0) && is_lit(-5, 0) && is_lit(0, 5) && is_lit(0, -5) && !is_lit(0, 0);
        };
        const auto click = [&](int x, int y) {
            it.send({.type = type::button_press,
                     .button = 1,
                     .x = x,
                     .y = y,
                     .clicks = 1,
                     .control = true});
        };
        const auto first = it.place(200.5, 150.5);
        ASSERT_TRUE(first);
        EXPECT_FALSE(has_mark(it.seen(first->place)));
        click(200, 150);
        EXPECT_TRUE(has_mark(it.seen(first->place)));
        it.press(l3d_key_left);
        it.press(l3d_key_up);
        EXPECT_TRUE(it.controls.shows_text());
        EXPECT_TRUE(has_mark(it.seen(first->place)));
        it.press('r');
        EXPECT_FALSE(it.controls.shows_text());
        click(200, 150);
        click(230, 180);
        EXPECT_TRUE(it.controls.shows_text());
        it.press(l3d_key_left);
        EXPECT_FALSE(it.controls.shows_text());
    }
}

TEST(view_steering, a_window_of_another_size_keeps_the_view) {
    ball_viewer it;
    const l3d_camera own = it.camera;
    it.screen.resize({300, 900});
    it.controls.resized();
    EXPECT_EQ(it.camera, own) << "the program placed it";
    it.screen.resize({400, 300});
    it.controls.resized();
    it.controls.set_home([&] { return it.framed(own); });
    it.screen.resize({300, 900});
    it.controls.resized();
    EXPECT_EQ(it.camera, it.framed(own)) << "framed again";
    // Moved by hand, what filled the smaller side fills it still.
    it.press(l3d_key_page_up);
    const double before = l3d_length(it.camera.eye - it.camera.target);
    it.screen.resize({900, 300});
    it.controls.resized();
    EXPECT_NEAR(l3d_length(it.camera.eye - it.camera.target), before / 3, 1e-9);
}

/// An arrow to the right, with keys held.
l3d_event arrow(int key, bool control, bool shift) {
    return {.type = type::key_press, .key = key, .shift = shift, .control = control};
}

TEST(view_steering, keys_roll_move_and_zoom) {
    ball_viewer rolled;
    const auto axes = rolled.camera.axes();
    const vector eye = rolled.camera.eye, target = rolled.camera.target;
    rolled.send(arrow(l3d_key_right, false, true));
    EXPECT_EQ(rolled.camera.eye, eye);
    const auto right_one = rolled.seen(target + axes.right);
    EXPECT_NEAR(std::atan2(right_one[1] - 150, right_one[0] - 200), 5 * std::numbers::pi / 180,
                1e-9)
        << "not clockwise";

    ball_viewer moved;
    moved.send(arrow(l3d_key_right, true, false));
    EXPECT_NEAR(moved.seen(target)[0], 200 + 0.05 * 300, 1e-9);
    EXPECT_NEAR(moved.seen(target)[1], 150, 1e-9);

    ball_viewer nearer;
    nearer.send(arrow('+', true, false));
    EXPECT_LT(l3d_length(nearer.camera.eye - target), l3d_length(eye - target));
}

TEST(view_steering, digits_turn_as_arrows_do_and_as_fast_as_is_wished) {
    for (const auto& [digit, key] : {std::pair('4', l3d_key_left), std::pair('6', l3d_key_right),
                                     std::pair('8', l3d_key_up), std::pair('2', l3d_key_down)}) {
        ball_viewer by_digit, by_arrow, fast;
        by_digit.send(arrow(digit, false, false));
        by_arrow.send(arrow(key, false, false));
        EXPECT_EQ(by_digit.camera, by_arrow.camera);
        fast.controls.set_turn_speed(2);
        fast.send(arrow(key, false, false));
        by_arrow.send(arrow(key, false, false));
        EXPECT_NEAR(l3d_length(fast.camera.eye - by_arrow.camera.eye), 0, 1e-9);
    }
}

} // namespace
