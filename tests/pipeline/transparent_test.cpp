// SPDX-License-Identifier: MIT
// Instances that are seen through: pictures against means of the pictures with and without them.
#include "hard_edged.h"
#include "still_studio.h"

#include "raster/background.h"
#include "raster/depth_buffer.h"
#include "raster/color/srgb_light.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace {

using namespace still_tests;
using picture = std::vector<std::uint32_t>;

constexpr l3d_material red{.color = 0xff4030}, shining{.color = 0x40c060, .highlight = 0xffffff};

/// The teapot, and two of its lids beside and through it.
l3d_patch_scene three_models() {
    const l3d_patch_model teapot = teapot_model();
    l3d_patch_scene scene(teapot);
    scene.add(teapot.painted(red), l3d_translation<double>(0.9, 0.4, 0.8));
    scene.add(teapot.painted(shining), l3d_translation<double>(-0.7, 0.2, 1.1));
    return scene;
}

l3d_camera before_them() {
    return {.eye = {3.2, 3.6, 9.4}, .target = {0.2, 1.3, 0.0}};
}

picture drawn(const l3d_patch_scene& scene, const l3d_afd_settings& settings) {
    tester program(scene, before_them(), settings);
    program.draw_event();
    return program.words();
}

/// The mean light of pictures of all choices of instances, each as likely as opacities say.
std::vector<double> mean_light(const l3d_patch_scene& scene, const l3d_afd_settings& settings) {
    std::vector<double> sum;
    const auto instances = scene.instances();
    for (unsigned choice = 0; choice < 1U << instances.size(); ++choice) {
        double weight = 1;
        std::vector<std::size_t> kept;
        for (std::size_t i = 0; i < instances.size(); ++i) {
            const bool is_there = choice >> i & 1;
            weight *= is_there ? instances[i].opacity() : 1 - instances[i].opacity();
            if (is_there)
                kept.push_back(i);
        }
        if (weight == 0)
            continue;
        const picture words = drawn(scene.only(kept), settings);
        sum.resize(3 * words.size());
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += weight * l3d_light_of_level(words[i / 3] >> (16 - 8 * (i % 3)) & 255);
    }
    return sum;
}

TEST(transparent, pictures_are_means_of_those_with_and_without_an_instance) {
    for (const bool antialias : {false, true}) {
        l3d_afd_settings settings = hard_edged();
        settings.antialias = antialias;
        settings.background = l3d_background::color(0x203040);
        l3d_patch_scene scene = three_models();
        scene.set_opacity(1, 0.3);
        scene.set_opacity(2, 0.75);
        const std::vector<double> mean = mean_light(scene, settings);
        const picture mixed = drawn(scene, settings);
        const picture opaque = drawn(three_models(), settings);
        int other = 0;
        for (std::size_t i = 0; i < mean.size(); ++i) {
            const double level = mixed[i / 3] >> (16 - 8 * (i % 3)) & 255;
            ASSERT_NEAR(level, l3d_level_of_light(mean[i]), 0.51) << i;
            other += std::abs(level - (opaque[i / 3] >> (16 - 8 * (i % 3)) & 255)) > 8;
        }
        EXPECT_GT(other, 3000);
    }
}

TEST(transparent, instances_of_opacity_0_and_1_are_not_there_or_opaque) {
    const l3d_afd_settings settings = hard_edged();
    l3d_patch_scene scene = three_models();
    scene.set_opacity(1, 0);
    EXPECT_EQ(drawn(scene, settings), drawn(scene.only(std::vector<std::size_t>{0, 2}), settings));
    scene.set_opacity(1, 1);
    EXPECT_EQ(scene.transparent_count(), 0u);
    EXPECT_EQ(drawn(scene, settings), drawn(three_models(), settings));
}

TEST(transparent, pictures_without_background_are_transparent_where_instances_are) {
    l3d_afd_settings settings = hard_edged();
    settings.background = l3d_background::none();
    l3d_patch_scene scene(teapot_model());
    const picture opaque = drawn(scene, settings);
    scene.set_opacity(0, 0.25);
    const picture mixed = drawn(scene, settings);
    for (std::size_t i = 0; i < opaque.size(); ++i) {
        EXPECT_EQ(mixed[i] >> 24, opaque[i] >> 24 == 255 ? 255u : 191u);
        if (opaque[i] >> 24 == 0) {
            ASSERT_EQ(mixed[i] & 0xffffff, opaque[i]);
        }
    }
}

TEST(transparent, changes_and_threads_leave_the_bits_of_a_fresh_picture) {
    for (const bool antialias : {false, true}) {
        l3d_afd_settings settings = hard_edged();
        settings.antialias = antialias;
        l3d_patch_scene scene = three_models();
        tester program(scene, before_them(), settings);
        settings.threads = 3;
        const auto expect_fresh = [&](const char* what) {
            program.draw_event();
            EXPECT_EQ(program.words(), drawn(program.scene(), settings)) << what;
        };
        expect_fresh("opaque");
        program.scene().set_opacity(2, 0.5);
        expect_fresh("one is transparent");
        program.scene().place(2, l3d_translation<double>(0.2, 0.2, 1.3));
        expect_fresh("it moves");
        program.scene().set_opacity(0, 0.9);
        expect_fresh("two are");
        program.scene().set_opacity(2, 1);
        program.scene().set_opacity(0, 1);
        expect_fresh("opaque again");
    }
}

TEST(transparent, frames_keep_depth_and_have_bounds_of_places_and_colors) {
    l3d_afd_settings settings = hard_edged();
    settings.depth = true;
    l3d_patch_scene scene = three_models();
    scene.paint(2, red);
    tester opaque(scene, before_them(), settings);
    opaque.draw_event();
    scene.set_opacity(1, 0.5);
    tester mixed(scene, before_them(), settings);
    mixed.draw_event();
    EXPECT_EQ(l3d_distances(mixed.depth()), l3d_distances(opaque.depth()));
    EXPECT_LE(mixed.report().dice.bound_px, settings.tolerance);
    EXPECT_GT(mixed.report().dice.shade_bound, 4.0 / 3 * opaque.report().dice.shade_bound + 0.5);
    EXPECT_LT(mixed.report().dice.shade_bound, 4);
    settings.error_map = true; // which takes seconds in a large picture
    tester small(scene, before_them(), settings, std::make_shared<l3d_rasterizer_factory_sw>(),
                 {odd.width / 3, odd.height / 3});
    small.draw_event();
    EXPECT_LT(small.report().color_bound, 63); // 1.2 times what was measured
    EXPECT_LT(small.error_map()->at(7, 7), 255);
}

/// At last there is nothing at all.
TEST(transparent, what_has_no_opacity_has_no_depth) {
    l3d_afd_settings settings = hard_edged();
    settings.depth = true;
    l3d_patch_scene scene = three_models();
    const auto distances = [&](const l3d_patch_scene& of) {
        tester program(of, before_them(), settings);
        program.draw_event();
        return l3d_distances(program.depth());
    };
    for (const double second : {1.0, 0.5}) {
        scene.set_opacity(1, second);
        scene.set_opacity(2, 0);
        EXPECT_EQ(distances(scene), distances(scene.only(std::vector<std::size_t>{0, 1})));
    }
    scene.set_opacity(0, 0);
    scene.set_opacity(1, 0);
    for (const float distance : distances(scene))
        ASSERT_TRUE(std::isinf(distance));
}

TEST(transparent, what_has_no_opacity_has_no_lines) {
    l3d_patch_scene scene = three_models();
    scene.set_opacity(2, 0);
    const l3d_patch_scene others = scene.only(std::vector<std::size_t>{0, 1});
    for (const bool is_wire : {false, true}) {
        l3d_afd_settings settings = hard_edged();
        settings.wireframe = is_wire;
        settings.net = !is_wire;
        EXPECT_EQ(drawn(scene, settings), drawn(others, settings)) << is_wire;
    }
}

TEST(transparent, scenes_refuse_what_is_no_opacity_and_too_many) {
    l3d_patch_scene scene;
    for (std::size_t i = 0; i <= l3d_patch_scene::most_transparent; ++i)
        scene.add(teapot_model());
    EXPECT_THROW(scene.set_opacity(0, -0.1), l3d_error);
    EXPECT_THROW(scene.set_opacity(0, 1.1), l3d_error);
    EXPECT_THROW(scene.set_opacity(0, std::nan("")), l3d_error);
    for (std::size_t i = 0; i < l3d_patch_scene::most_transparent; ++i)
        scene.set_opacity(i, 0.5);
    EXPECT_THROW(scene.set_opacity(l3d_patch_scene::most_transparent, 0.5), l3d_error);
    EXPECT_EQ(scene.instances().back().opacity(), 1);
    scene.set_opacity(0, 1);
    scene.set_opacity(l3d_patch_scene::most_transparent, 0.5);
    scene.place(1, l3d_patch_model::teapot(), l3d_identity<double>());
    EXPECT_EQ(scene.transparent_count(), l3d_patch_scene::most_transparent - 1);
}

TEST(transparent, models_are_as_their_materials_say) {
    const l3d_patch_model teapot = teapot_model();
    std::vector<l3d_material> each(teapot.patches().size(), red);
    const auto opaque_and = [&](std::size_t count) {
        for (std::size_t i = 0; i < each.size(); ++i)
            each[i].opacity = i < count ? static_cast<float>(i + 1) / 32 : 1.0F;
        l3d_patch_scene scene;
        scene.add_by_opacity(teapot.painted(each));
        return scene;
    };
    EXPECT_EQ(opaque_and(0).instances().size(), 1u);
    const l3d_patch_scene two = opaque_and(2);
    ASSERT_EQ(two.instances().size(), 3u);
    EXPECT_EQ(two.transparent_count(), 2u);
    EXPECT_EQ(two.instances()[0].opacity(), 1.0 / 32);
    EXPECT_EQ(two.instances()[1].model().patches().size(), 1u);
    EXPECT_EQ(two.patch_count(), static_cast<std::int64_t>(each.size()));
    l3d_patch_scene by_hand(teapot.painted(each).of_opacity(1, 1));
    for (const float opacity : {1.0F / 32, 2.0F / 32}) {
        by_hand.add(teapot.painted(each).of_opacity(opacity, opacity));
        by_hand.set_opacity(by_hand.instances().size() - 1, double{opacity});
    }
    EXPECT_EQ(drawn(two, {}), drawn(by_hand, {}));
    // More than may be transparent are rounded up to eighths.
    const l3d_patch_scene many = opaque_and(20);
    EXPECT_LE(many.transparent_count(), l3d_patch_scene::most_transparent);
    EXPECT_EQ(many.patch_count(), static_cast<std::int64_t>(each.size()));
    EXPECT_EQ(many.instances()[0].opacity(), 1.0 / 8);
    EXPECT_EQ(many.instances()[0].model().patches().size(), 4u);
}

/// NUMERICS, section 22: how much a change of all levels changes the level of a mean.
TEST(transparent, levels_of_means_change_by_a_third_more_than_levels_at_most) {
    double most = 0;
    for (double low = 0; low < 24; low += 0.5)
        for (double high = low; high < 255; high += high < 60 ? 0.5 : 5)
            for (double weight = 0.005; weight < 1; weight += 0.005) {
                const auto mean = [&](double more) {
                    return l3d_level_of_light((1 - weight) * l3d_light_of_level(low + more) +
                                              weight * l3d_light_of_level(high + more));
                };
                most = std::max(most, (mean(0.01) - mean(0)) / 0.01);
            }
    EXPECT_LT(most, 4.0 / 3);
    EXPECT_GT(most, 1.3);
}

} // namespace
