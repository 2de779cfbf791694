// SPDX-License-Identifier: MIT
// l3d_lesson: time that can be stopped, a start that can be repeated, a hand that takes hold.
#include "pipeline/lesson.h"
#include "pipeline/worlds/pipeline_world.h"
#include "raster/rasterizer_factory.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace {

constexpr l3d_size picture{40, 30};

l3d_canvas canvas_of(bool is_classic) {
    l3d_canvas canvas = l3d_memory_canvas(picture);
    canvas.is_classic = is_classic;
    return canvas;
}

/// Adds a red pixel to a row with each picture.
class row_lesson final : public l3d_lesson {
public:
    explicit row_lesson(bool is_classic = false) : l3d_lesson(canvas_of(is_classic)) {}

    double seconds = 0;
    int restarts = 0, right = 0, down = 0, notches = 0, drags = 0;

    std::uint32_t pixel(int x, int y) {
        return screen().pixels().row(y)[static_cast<std::size_t>(x)];
    }
    void mouse(l3d_event_type type, int button, int x, int y) {
        l3d_event event;
        event.type = type;
        event.button = button;
        event.x = x;
        event.y = y;
        any_event(event);
        pointer_event(event);
    }

private:
    void draw_lesson(l3d_rasterizer_2d& rasterizer) override {
        rasterizer.draw_point(drawn_++, 5, 0xff0000);
    }
    void advance(double passed) override { seconds += passed; }
    void restart() override {
        ++restarts;
        drawn_ = 0;
    }
    void drag(int, int, int to_right, int downwards) override {
        ++drags;
        right += to_right;
        down += downwards;
    }
    void roll(int turned) override { notches += turned; }

    int drawn_ = 0;
};

TEST(lesson, lies_on_a_dark_ground_and_on_black_if_it_is_classic) {
    row_lesson modern, classic(true);
    modern.draw_event();
    classic.draw_event();
    EXPECT_EQ(classic.pixel(20, 0), 0u);
    EXPECT_NE(modern.pixel(20, 0), 0u);
    EXPECT_NE(modern.pixel(20, 0), modern.pixel(20, picture.height - 1)) << "lighter below";
    EXPECT_LT(modern.pixel(20, picture.height - 1) & 255, 0x60u);
    EXPECT_EQ(modern.pixel(39, 29), modern.pixel(0, 29)) << "up to the last column";
    modern.draw_event();
    EXPECT_EQ(modern.pixel(0, 5), 0xff0000u) << "what was drawn before stays";
}

TEST(lesson, stops_and_goes_on_by_space) {
    row_lesson it;
    it.update_event(1);
    it.draw_event();
    EXPECT_FALSE(it.needs_redraw());
    EXPECT_EQ(it.message(), "");
    it.any_event({});
    it.key_event(' ');
    EXPECT_TRUE(it.is_at_rest());
    EXPECT_TRUE(it.needs_redraw()) << "it says so";
    EXPECT_NE(it.message(), "");
    it.draw_event();
    it.update_event(5);
    EXPECT_EQ(it.seconds, 1);
    EXPECT_FALSE(it.needs_redraw());
    it.key_event(' ');
    it.update_event(1);
    EXPECT_EQ(it.seconds, 2);
    EXPECT_TRUE(it.needs_redraw());
}

TEST(lesson, begins_again_by_r_on_a_bare_ground) {
    row_lesson it;
    for (int i = 0; i < 3; ++i)
        it.draw_event();
    it.key_event('r');
    EXPECT_EQ(it.restarts, 1);
    it.draw_event();
    EXPECT_EQ(it.pixel(0, 5), 0xff0000u);
    EXPECT_EQ(it.pixel(2, 5), it.pixel(20, 5));
    it.key_event('q');
    EXPECT_TRUE(it.done);
}

TEST(lesson, is_dragged_by_the_first_button_alone) {
    row_lesson it;
    it.mouse(l3d_event_type::pointer_motion, 0, 3, 3);
    it.mouse(l3d_event_type::button_press, 3, 3, 3);
    it.mouse(l3d_event_type::pointer_motion, 3, 9, 9);
    EXPECT_EQ(it.drags, 0);
    it.mouse(l3d_event_type::button_press, 1, 10, 10);
    EXPECT_EQ(it.drags, 1) << "a click";
    it.mouse(l3d_event_type::pointer_motion, 1, 14, 9);
    it.mouse(l3d_event_type::pointer_motion, 1, 15, 7);
    it.mouse(l3d_event_type::button_release, 1, 15, 7);
    it.mouse(l3d_event_type::pointer_motion, 0, 30, 30);
    EXPECT_EQ(it.drags, 3);
    EXPECT_EQ(it.right, 5);
    EXPECT_EQ(it.down, -3);
    l3d_event wheel;
    wheel.type = l3d_event_type::wheel;
    wheel.notches = -2;
    it.pointer_event(wheel);
    EXPECT_EQ(it.notches, -2);
}

/// A world of one square before the eye.
class square_world final : public l3d_world {
public:
    explicit square_world(l3d_size size) : l3d_world(size) {
        order = l3d_draw_order::far_first;
        camera.place = l3d_point<l3d_real>::of(0, 0, -20);
        l3d_polygon_mesh mesh;
        mesh.vertices = {{-5, 5, 0}, {5, 5, 0}, {5, -5, 0}, {-5, -5, 0}};
        mesh.add_face({{0, 1, 2, 3}});
        mesh.face_colors = {0x00ff00};
        add(std::make_unique<l3d_object>(std::move(mesh)));
    }
};

std::unique_ptr<l3d_pipeline_world> square_pipeline(bool is_classic) {
    return std::make_unique<l3d_pipeline_world>(
        canvas_of(is_classic), [](l3d_size size) { return std::make_unique<square_world>(size); });
}

/// The green of the pixel in the middle, and of one in a corner.
std::pair<std::uint32_t, std::uint32_t> greens(l3d_pipeline_world& pipeline) {
    pipeline.draw_event();
    const l3d_pixels pixels = pipeline.screen().pixels();
    return {pixels.row(15)[20] >> 8 & 255, pixels.row(0)[0] >> 8 & 255};
}

TEST(lesson_of_a_world, starts_again_where_it_was_and_says_that_nothing_is_seen) {
    for (const bool is_classic : {true, false}) {
        const auto it = square_pipeline(is_classic);
        EXPECT_GT(greens(*it).first, 0x60u);
        EXPECT_EQ(it->message(), "");
        for (int i = 0; i < 300; ++i) {
            it->key_event('i');
            it->update_event(0.1);
        }
        EXPECT_LT(greens(*it).first, 0x60u) << "it flew through";
        EXPECT_NE(it->message().find("r starts again"), std::string::npos);
        it->key_event('r');
        EXPECT_GT(greens(*it).first, 0x60u);
        EXPECT_EQ(it->message(), "");
    }
}

TEST(lesson_of_a_world, is_on_black_if_it_is_classic) {
    EXPECT_EQ(greens(*square_pipeline(true)).second, 0u);
    EXPECT_NE(greens(*square_pipeline(false)).second, 0u);
}

TEST(lesson_of_a_world, rests_when_it_is_stopped_and_the_camera_stands_still) {
    const auto it = square_pipeline(false);
    it->draw_event();
    EXPECT_FALSE(it->is_at_rest());
    it->key_event('0');
    it->draw_event();
    EXPECT_TRUE(it->is_at_rest());
    EXPECT_FALSE(it->needs_redraw());
    it->key_event('j');
    EXPECT_FALSE(it->is_at_rest()) << "the camera turns";
    for (int i = 0; i < 100; ++i)
        it->update_event(0.1);
    EXPECT_TRUE(it->is_at_rest());
    EXPECT_TRUE(it->needs_redraw()) << "its last step is to be seen";
}

/// What is dragged follows the pointer, as far as it is in the middle.
TEST(lesson_of_a_world, turns_as_it_is_dragged) {
    const auto it = square_pipeline(true);
    const auto left_end = [&] {
        it->draw_event();
        const auto row = it->screen().pixels().row(15);
        int x = 0;
        while (x < picture.width && row[static_cast<std::size_t>(x)] == 0)
            ++x;
        return x;
    };
    const int before = left_end();
    l3d_event event;
    event.type = l3d_event_type::button_press;
    event.button = 1;
    it->pointer_event(event);
    event.type = l3d_event_type::pointer_motion;
    event.x = 6;
    it->pointer_event(event);
    EXPECT_NEAR(left_end() - before, 6, 1);
}

/// A square whose sides lie between pixels.
TEST(edges_of_the_factory, are_hard_or_smooth) {
    for (const l3d_edges edges : {l3d_edges::hard, l3d_edges::smooth}) {
        l3d_canvas canvas = l3d_memory_canvas(picture);
        const auto imp = l3d_rasterizer_factory_sw(edges).create_2d(canvas.screen->pixels());
        l3d_rasterizer_2d rasterizer(*imp);
        const l3d_point_2d corners[] = {
            {10.25, 10.25}, {20.25, 10.25}, {20.25, 20.25}, {10.25, 20.25}};
        rasterizer.draw_polygon_flatshaded(corners, 0xffffff);
        rasterizer.draw_line(0, 0, 9, 4, 0xffffff);
        int between = 0;
        for (int y = 0; y < picture.height; ++y)
            for (const std::uint32_t word : canvas.screen->pixels().row(y))
                between += word != 0 && word != 0xffffff;
        EXPECT_EQ(between > 0, edges == l3d_edges::smooth);
        EXPECT_EQ(canvas.screen->pixels().row(15)[15], 0xffffffu);
        const std::uint32_t at_edge = edges == l3d_edges::smooth ? 64 : 0;
        EXPECT_EQ(canvas.screen->pixels().row(15)[10] & 255, at_edge) << "a quarter";
    }
}

} // namespace
