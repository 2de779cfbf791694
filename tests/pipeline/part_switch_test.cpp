// SPDX-License-Identifier: MIT
// Parts that come and go while a scene is looked at.
#include "hard_edged.h"
#include "still_studio.h"

#include "pipeline/pipeline_afd_viewer.h"
#include "scene/camera.h"
#include "scene/patch_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace still_tests;

std::size_t patches_of(const l3d_patch_scene& scene) {
    return static_cast<std::size_t>(scene.patch_count());
}

TEST(part_switch, hides_and_shows_one_part_after_the_other) {
    const l3d_patch_model teapot = l3d_patch_model::teapot();
    const auto names = teapot.parts().names();
    ASSERT_EQ(names.size(), 4u);
    l3d_patch_scene scene(teapot);
    l3d_part_switch parts(scene);
    EXPECT_EQ(parts.choose_next(), "part 1 of 4: " + names[0]);
    EXPECT_EQ(parts.choose_next(), "part 2 of 4: " + names[1]);
    EXPECT_EQ(parts.switch_chosen(), names[1] + " is hidden");
    EXPECT_EQ(patches_of(scene), teapot.patches().size() - teapot.parts().size_of(1));
    EXPECT_FALSE(scene.instances()[0].model().parts().find(names[1]));
    EXPECT_EQ(parts.switch_chosen(), names[1] + " is shown");
    EXPECT_EQ(patches_of(scene), teapot.patches().size());
    for (std::size_t i = 0; i < 3; ++i) {
        parts.switch_chosen();
        parts.choose_next();
    }
    const std::size_t left = patches_of(scene);
    EXPECT_EQ(parts.switch_chosen(), names[0] + " stays: without it nothing is left");
    EXPECT_EQ(patches_of(scene), left);
    EXPECT_EQ(parts.choose_next(), "part 2 of 4: " + names[1] + ", hidden");
    parts.show_all();
    EXPECT_EQ(patches_of(scene), teapot.patches().size());
    EXPECT_EQ(scene.instances()[0].model().parts().names().size(), 4u);
}

TEST(part_switch, keeps_the_colors_opacities_and_places_of_instances) {
    const l3d_patch_model teapot = l3d_patch_model::teapot();
    l3d_patch_scene scene(teapot);
    scene.add(teapot, l3d_translation<double>(3.0, 0.0, 0.0));
    scene.paint(1, l3d_material{.color = 0x123456});
    scene.set_opacity(1, 0.5);
    l3d_part_switch parts(scene);
    EXPECT_NE(parts.switch_chosen(), "");
    EXPECT_LT(patches_of(scene), 2 * teapot.patches().size());
    EXPECT_EQ(scene.instances()[1].opacity(), 0.5);
    EXPECT_EQ(scene.transparent_count(), 1u);
    ASSERT_TRUE(scene.instances()[1].material());
    EXPECT_EQ(scene.instances()[1].material()->color, 0x123456u);
    EXPECT_EQ(scene.instances()[1].placement()(0, 3), 3);
    // Another model is whole, and what was hidden of the first one's kind is hidden of it, too,
    // from the next change on.
    scene.place(0, teapot.painted(l3d_material{.color = 0xff0000}), l3d_identity<double>());
    parts.switch_chosen();
    EXPECT_EQ(patches_of(scene), 2 * teapot.patches().size());
    EXPECT_FALSE(scene.instances()[0].model().materials().empty());
}

TEST(part_switch, says_that_there_are_no_parts) {
    l3d_patch_scene scene(teapot_model().with_parts({}));
    l3d_part_switch parts(scene);
    EXPECT_EQ(parts.choose_next(), "the model has no named parts");
    EXPECT_EQ(parts.switch_chosen(), "the model has no named parts");
    parts.show_all();
    EXPECT_EQ(patches_of(scene), teapot_model().patches().size());
}

TEST(part_switch, has_keys_in_the_viewer) {
    l3d_pipeline_afd_viewer viewer(l3d_memory_canvas({203, 151}),
                                   l3d_patch_scene(l3d_patch_model::teapot()), before_the_teapot(),
                                   hard_edged());
    viewer.draw_event();
    const std::int64_t whole = viewer.report().patches;
    viewer.key_event('e');
    EXPECT_EQ(viewer.controls().message().substr(0, 12), "part 1 of 4:");
    viewer.key_event('d');
    EXPECT_NE(viewer.controls().message().find("is hidden"), std::string::npos);
    viewer.draw_event();
    EXPECT_LT(viewer.report().patches, whole);
    viewer.key_event('r');
    viewer.draw_event();
    EXPECT_EQ(viewer.report().patches, whole);
}

/// What has opacity 0 is not there.
TEST(part_switch, leaves_what_nobody_sees_out_of_frames_and_picks) {
    l3d_patch_scene scene(teapot_model());
    const l3d_camera alone = l3d_framed(before_the_teapot(), {203, 151}, l3d_reach_of(scene));
    scene.add(teapot_model(), l3d_translation<double>(30.0, 0.0, 0.0));
    EXPECT_NE(l3d_framed(before_the_teapot(), {203, 151}, l3d_reach_of(scene)).eye[0],
              alone.eye[0]);
    scene.set_opacity(1, 0);
    EXPECT_EQ(l3d_framed(before_the_teapot(), {203, 151}, l3d_reach_of(scene)).eye[0],
              alone.eye[0]);
    scene.set_opacity(0, 0);
    tester program(scene, before_the_teapot(), {});
    EXPECT_FALSE(program.pick(101.5, 75.5));
    program.scene().set_opacity(0, 1);
    EXPECT_TRUE(program.pick(101.5, 75.5));
}

} // namespace
