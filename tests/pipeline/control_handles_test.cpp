// SPDX-License-Identifier: MIT
// Handles of control points: found under a place, moved by a pointer, undone, and seen.

#include "geom/nurbs_surface.h"
#include "pipeline/pipeline_afd_editor.h"
#include "raster/rasterizer_factory.h"
#include "scene/teapot_studio.h"
#include "sizable_screen.h"
#include "words_of.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using type = l3d_event_type;
using effect = l3d_control_handles::effect;
using vector = l3d_control_handles::vector;

constexpr l3d_size size{400, 300};

l3d_handle_view view() {
    return {{.eye = {2.0, 3.0, 6.0}, .target = {0.1, -0.2, 0.3}}, size};
}

/// A place in the picture, by the camera's own matrix.
std::array<double, 2> seen(const vector& at, const l3d_handle_view& in = view()) {
    const auto h =
        in.camera.image_matrix(in.size) * l3d_vector<double, 4>(at[0], at[1], at[2], 1.0);
    return {in.size.width / 2.0 + h[0] / h[3], in.size.height / 2.0 + h[1] / h[3]};
}

/// Two sheets of degree 1 by 2 that share the points of a side.
std::vector<l3d_nurbs_surface> two_sheets() {
    const auto sheet = [](double left) {
        l3d_patch_points patch{.degree_u = 1, .degree_v = 2, .points = {}};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 2; ++column)
                patch.points.push_back({left + column, row - 1.0, 0.0});
        return l3d_nurbs_surface::of_patch(patch);
    };
    return {sheet(-1), sheet(0)};
}

std::size_t handle_at(const l3d_control_handles& handles, const vector& place) {
    const auto [x, y] = seen(place);
    const auto found = handles.find(x, y, view());
    EXPECT_TRUE(found);
    return found.value_or(0);
}

l3d_event event(type what, const vector& at, int button = 0) {
    const auto [x, y] = seen(at);
    return {.type = what, .button = button, .x = static_cast<int>(x), .y = static_cast<int>(y)};
}

TEST(control_handles, points_at_one_place_are_one_handle) {
    EXPECT_EQ(l3d_control_handles(two_sheets()).count(), 9u);
    // Of a sphere's 5 rows, the first and last are poles, and 9 points around are 8 places.
    EXPECT_EQ(l3d_control_handles(l3d_sphere_surfaces()).count(), 2u + 3 * 8);
}

TEST(control_handles, the_nearest_within_reach_is_found_and_the_front_one_of_two) {
    const l3d_control_handles handles(two_sheets());
    const std::size_t middle = handle_at(handles, {0, 0, 0});
    EXPECT_EQ(handles.place(middle), vector(0, 0, 0));
    const auto [x, y] = seen({0, 0, 0});
    EXPECT_EQ(handles.find(x + 6, y - 6, view()), middle);
    EXPECT_FALSE(handles.find(x + 9, y - 9, view())) << "beyond 10 pixels";
    l3d_handle_view fine = view();
    fine.text_scale = 2;
    EXPECT_EQ(handles.find(x + 9, y - 9, fine), middle) << "20 pixels of a fine display";

    // Both ends of this line are seen at one place.
    const vector eye = view().camera.eye;
    l3d_patch_points line{.degree_u = 1, .degree_v = 1, .points = {}};
    for (const double t : {0.9, 0.5, 0.8, 0.6})
        line.points.push_back({eye[0] * (1 - t), eye[1] * (1 - t), eye[2] * (1 - t)});
    const l3d_control_handles behind({l3d_nurbs_surface::of_patch(line)});
    const auto front = behind.find(x, y, view());
    ASSERT_TRUE(front);
    EXPECT_EQ(behind.name(*front), "row 1, column 2");
}

TEST(control_handles, reach_as_far_as_the_farthest) {
    const l3d_control_handles handles(two_sheets());
    EXPECT_EQ(handles.reach()({2, 0, 0}), 2);
    EXPECT_EQ(handles.reach()({-3, 1, 0}), 4);
}

TEST(control_handles, nothing_is_found_before_the_near_plane) {
    l3d_handle_view near = view();
    near.camera.near_z = 100;
    const auto [x, y] = seen({0, 0, 0});
    EXPECT_FALSE(l3d_control_handles(two_sheets()).find(x, y, near));
}

TEST(control_handles, neighbours_that_share_a_point_move_together_and_stay_joined) {
    l3d_control_handles handles(two_sheets());
    const vector to(0.25, 0.5, 1);
    ASSERT_TRUE(handles.move(handle_at(handles, {0, 0, 0}), to));
    EXPECT_EQ(handles.surfaces()[0].points()[3], to);
    EXPECT_EQ(handles.surfaces()[1].points()[2], to);
    EXPECT_EQ(handles.surfaces()[1].points()[3], vector(1, 0, 0)) << "others stay";
}

TEST(control_handles, a_drag_moves_in_the_plane_of_the_picture) {
    l3d_control_handles handles(two_sheets());
    EXPECT_EQ(handles.pointer(event(type::pointer_motion, {0, 0, 0}), view()), effect::seen);
    const auto marked = handles.marked();
    ASSERT_TRUE(marked);
    EXPECT_EQ(handles.pointer(event(type::pointer_motion, {0, 0, 0}), view()), effect::none);
    EXPECT_NE(handles.pointer(event(type::button_press, {0, 0, 0}, 1), view()), effect::none);
    l3d_event motion = event(type::pointer_motion, {0, 0, 0}, 1);
    motion.x += 40;
    motion.y -= 25;
    EXPECT_EQ(handles.pointer(motion, view()), effect::changed);
    const vector there = handles.place(*marked);
    EXPECT_NEAR(view().camera.depth_of(there), view().camera.depth_of({0, 0, 0}), 1e-12);
    EXPECT_NEAR(seen(there)[0], seen({0, 0, 0})[0] + 40, 1e-9);
    EXPECT_NEAR(seen(there)[1], seen({0, 0, 0})[1] - 25, 1e-9);
    EXPECT_EQ(handles.marked(), marked);

    handles.pointer(event(type::button_release, there, 1), view());
    EXPECT_EQ(handles.pointer(event(type::pointer_motion, {9, 9, -9}), view()), effect::seen);
    EXPECT_FALSE(handles.marked());
    EXPECT_EQ(handles.pointer(event(type::button_press, {9, 9, -9}, 1), view()), effect::none)
        << "a drag beside handles is the viewer's";
}

TEST(control_handles, the_right_button_moves_along_the_view_axis) {
    l3d_control_handles handles(two_sheets());
    handles.pointer(event(type::button_press, {0, 0, 0}, 3), view());
    l3d_event up = event(type::pointer_motion, {0, 0, 0}, 3);
    up.y -= 30;
    EXPECT_EQ(handles.pointer(up, view()), effect::changed);
    ASSERT_TRUE(handles.marked());
    const vector way = handles.place(*handles.marked());
    const vector forward = view().camera.axes().forward;
    EXPECT_NEAR(l3d_dot(way, forward), l3d_length(way), 1e-12) << "straight away from the eye";
    const double pixel = view().camera.depth_of({0, 0, 0}) / view().camera.focal_length(size);
    EXPECT_NEAR(l3d_length(way), 30 * pixel, 1e-12) << "as far as the same drag moves it sidewards";
    up.y += 100000;
    EXPECT_EQ(handles.pointer(up, view()), effect::seen) << "never before the near plane";
}

TEST(control_handles, weights_of_one_place_keep_their_ratio_and_stay_in_range) {
    l3d_control_handles handles(l3d_sphere_surfaces());
    const std::size_t pole = handle_at(handles, {0, 1, 0});
    const std::vector<double> before = handles.surfaces()[0].weights();
    EXPECT_EQ(handles.pointer(event(type::wheel, {0, 1, 0}), view()), effect::none)
        << "nothing is marked";
    handles.pointer(event(type::pointer_motion, {0, 1, 0}), view());
    l3d_event wheel = event(type::wheel, {0, 1, 0});
    wheel.turn = 2;
    EXPECT_EQ(handles.pointer(wheel, view()), effect::changed);
    EXPECT_NEAR(handles.weight(pole), 1.21 * before[4 * 9], 1e-12);
    const std::vector<double> after = handles.surfaces()[0].weights();
    for (std::size_t i = 0; i < after.size(); ++i)
        EXPECT_NEAR(after[i], before[i] * (i < 4 * 9 ? 1 : 1.21), 1e-12) << i;
    EXPECT_FALSE(handles.scale_weight(pole, 1e6));
    EXPECT_FALSE(handles.scale_weight(pole, 1e-6));
    EXPECT_EQ(handles.surfaces()[0].weights(), after);
}

TEST(control_handles, undo_takes_back_whole_drags_and_turns_bit_for_bit) {
    l3d_control_handles handles(two_sheets());
    EXPECT_FALSE(handles.undo());
    handles.pointer(event(type::button_press, {0, 0, 0}, 1), view());
    for (const int step : {7, 9, 11}) {
        l3d_event motion = event(type::pointer_motion, {0, 0, 0}, 1);
        motion.x += step;
        handles.pointer(motion, view());
    }
    handles.pointer(event(type::button_release, {0, 0, 0}, 1), view());
    const vector dragged = handles.place(*handles.marked());
    l3d_event wheel = event(type::wheel, dragged);
    wheel.turn = 0.25;
    for (int i = 0; i < 5; ++i)
        handles.pointer(wheel, view());
    EXPECT_TRUE(handles.undo());
    EXPECT_EQ(handles.place(*handles.marked()), dragged) << "the weight was changed last";
    EXPECT_EQ(handles.weight(*handles.marked()), 1);
    EXPECT_TRUE(handles.undo());
    EXPECT_EQ(handles.surfaces()[0].points(), two_sheets()[0].points());
    EXPECT_EQ(handles.surfaces()[1].points(), two_sheets()[1].points());
    EXPECT_FALSE(handles.undo());
}

TEST(control_handles, a_move_beyond_the_limit_changes_nothing) {
    l3d_control_handles handles(two_sheets());
    EXPECT_FALSE(handles.move(0, {2e12, 0, 0}));
    EXPECT_FALSE(handles.undo());
    EXPECT_EQ(handles.place(0), two_sheets()[0].points()[0]);
}

/// An editor, without a window, of the teapot.
class editor final : public l3d_pipeline_afd_editor {
public:
    editor()
        : l3d_pipeline_afd_editor({std::make_unique<pipeline_tests::sizable_screen>(size),
                                   std::make_shared<l3d_rasterizer_factory_sw>()},
                                  dice_tests::teapot_model(), camera_of_the_teapot(),
                                  l3d_afd_settings()) {}

    static l3d_camera camera_of_the_teapot() {
        return {.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}};
    }
    static l3d_handle_view view() { return {camera_of_the_teapot(), size}; }

    std::vector<std::uint32_t> drawn() {
        draw_event();
        return words_of(screen().pixels());
    }
    vector point(std::size_t patch, std::size_t index) {
        return scene().instances()[0].model().patches()[patch].points[index];
    }
};

TEST(pipeline_afd_editor, a_key_shows_handles_and_a_drag_changes_patches_that_share_the_point) {
    editor it;
    const auto plain = it.drawn();
    it.key_event('u'); // has nothing to undo, and says so
    it.key_event('j');
    it.key_event('k');
    const auto with_net = it.drawn();
    EXPECT_NE(with_net, plain);

    const vector corner = it.point(0, 0);
    const auto [x, y] = seen(corner, editor::view());
    l3d_event press{.type = type::button_press,
                    .button = 1,
                    .x = static_cast<int>(x),
                    .y = static_cast<int>(y)};
    it.pointer_event(press);
    l3d_event motion = press;
    motion.type = type::pointer_motion;
    motion.x += 20;
    it.pointer_event(motion);
    EXPECT_NE(it.drawn(), with_net);
    const vector moved = it.point(0, 0);
    EXPECT_NE(moved, corner);
    std::size_t shared = 0;
    const l3d_patch_model before = dice_tests::teapot_model();
    for (std::size_t p = 0; p < before.patches().size(); ++p)
        for (std::size_t i = 0; i < 16; ++i) {
            const bool is_same = before.patches()[p].points[i] == corner;
            shared += is_same;
            EXPECT_EQ(it.point(p, i), is_same ? moved : before.patches()[p].points[i]);
        }
    EXPECT_GT(shared, 1u);

    it.key_event('k');
    l3d_patch_model fresh = l3d_patch_model({it.scene().instances()[0].model().patches().begin(),
                                             it.scene().instances()[0].model().patches().end()});
    l3d_pipeline_afd plain_viewer({std::make_unique<pipeline_tests::sizable_screen>(size),
                                   std::make_shared<l3d_rasterizer_factory_sw>()},
                                  fresh, editor::camera_of_the_teapot(), l3d_afd_settings());
    plain_viewer.draw_event();
    EXPECT_EQ(it.drawn(), words_of(plain_viewer.screen().pixels())) << "all of it is remade";
    it.key_event('k');

    motion.type = type::button_release;
    it.pointer_event(motion);
    it.key_event('u');
    it.draw_event();
    EXPECT_EQ(it.point(0, 0), corner);
}

TEST(pipeline_afd_editor, a_weight_makes_patches_rational_and_undo_makes_them_plain_again) {
    editor it;
    it.key_event('k');
    const auto [x, y] = seen(it.point(0, 0), editor::view());
    l3d_event motion{
        .type = type::pointer_motion, .x = static_cast<int>(x), .y = static_cast<int>(y)};
    it.pointer_event(motion);
    it.key_event('.');
    it.draw_event();
    EXPECT_TRUE(it.scene().instances()[0].model().is_curved());
    it.key_event('U');
    it.draw_event();
    EXPECT_FALSE(it.scene().instances()[0].model().is_curved());
    EXPECT_EQ(it.scene().instances()[0].model().parts().names().size(),
              dice_tests::teapot_model().parts().names().size());
}

} // namespace
