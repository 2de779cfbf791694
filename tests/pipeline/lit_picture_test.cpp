// SPDX-License-Identifier: MIT
// Whole frames with several lights and highlights, by every pipeline, and what is said of them.
#include "hard_edged.h"
#include "still_studio.h"

#include "geom/polygon_shapes.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "raster/depth_buffer.h"
#include "raster/rasterizer_factory.h"
#include "base/error.h"
#include "scene/camera_shading.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace {

using namespace still_tests;

constexpr l3d_material shining{.color = 0x803020, .highlight = 0xffffff, .sharpness = 40};

l3d_lighting two_lights() {
    l3d_lighting lighting;
    lighting.add({-1, 0.3, 0.2}, {0, 0, 0.8F});
    return lighting;
}

std::uint32_t channel(std::uint32_t word, int shift) {
    return word >> shift & 255;
}

TEST(lit_picture, shows_highlights_and_the_second_light) {
    l3d_patch_scene scene(teapot_model());
    l3d_afd_settings settings = hard_edged();
    tester plain(scene, before_the_teapot(), settings);
    plain.draw_event();
    scene.paint(0, shining);
    tester with_highlights(scene, before_the_teapot(), settings);
    with_highlights.draw_event();
    settings.lighting = two_lights();
    tester with_both(scene, before_the_teapot(), settings);
    with_both.draw_event();
    const auto grey = plain.words(), highlights = with_highlights.words(), both = with_both.words();
    int bright = 0, blue = 0, darker = 0;
    for (std::size_t i = 0; i < grey.size(); ++i) {
        const auto scattered =
            static_cast<int>(l3d_product_of_colors(shining.color, grey[i]) >> 8 & 255);
        const auto seen = static_cast<int>(channel(highlights[i], 8));
        darker += seen < scattered - 3;
        bright += seen > scattered + 100;
        blue += channel(both[i], 0) > channel(highlights[i], 0) + 10;
    }
    EXPECT_LT(darker, 60); // at outlines, which side is seen is chance
    EXPECT_GT(bright, 20);
    EXPECT_LT(bright, 2000);
    EXPECT_GT(blue, 500);
}

TEST(lit_picture, promises_places_depth_and_shades) {
    l3d_patch_scene scene(teapot_model());
    l3d_afd_settings settings = hard_edged();
    tester plain(scene, before_the_teapot(), settings);
    plain.draw_event();
    EXPECT_TRUE(std::isfinite(plain.report().dice.shade_bound));
    scene.paint(0, shining);
    tester lit(scene, before_the_teapot(), settings);
    lit.draw_event();
    EXPECT_LE(lit.report().dice.bound_px, settings.tolerance);
    EXPECT_TRUE(std::isfinite(lit.report().dice.depth_bound_px));
    EXPECT_GT(lit.report().dice.shade_bound, plain.report().dice.shade_bound);
    EXPECT_LT(lit.report().dice.shade_bound, 40);
    settings.error_map = true; // which takes seconds in a large picture
    tester small(scene, before_the_teapot(), settings,
                 std::make_shared<l3d_rasterizer_factory_sw>(), {odd.width / 2, odd.height / 2});
    small.draw_event();
    EXPECT_LT(small.report().color_bound, 100);
    ASSERT_NE(small.error_map(), nullptr);
    EXPECT_LT(small.error_map()->at(50, 35), 20);
}

TEST(lit_picture, that_changes_is_the_same_bits_as_drawn_whole) {
    for (const bool antialias : {false, true})
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            studio s(seed);
            s.settings.antialias = antialias;
            s.settings.threads = 2;
            s.settings.lighting = two_lights();
            s.models[1] = s.models[1].painted(shining);
            tester program(s.scene, s.camera, s.settings);
            program.draw_event();
            for (int frame = 0; frame < 4; ++frame) {
                s.move(program);
                program.draw_event();
                tester fresh(program.scene(), s.camera, s.settings);
                fresh.draw_event();
                ASSERT_EQ(program.words(), fresh.words()) << "seed " << seed << ", frame " << frame;
            }
        }
}

template <class Pipeline, class... More>
std::vector<std::uint32_t> polygons(const l3d_polygon_settings& settings, l3d_projection projection,
                                    const More&... more) {
    l3d_camera camera;
    camera.eye = {3.1, 2.3, 4.2};
    camera.projection = projection;
    Pipeline pipeline(l3d_memory_canvas({203, 151}), l3d_polygon_model(l3d_sphere_mesh(24, 12)),
                      camera, settings, more...);
    pipeline.draw_event();
    return words_of(pipeline.screen().pixels());
}

/// Lanes round normals before they shade them, so a level may be the next one.
void expect_near(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (const int shift : {0, 8, 16})
            ASSERT_NEAR(channel(a[i], shift), channel(b[i], shift), 1) << i;
}

TEST(lit_picture, of_polygons_is_the_same_by_every_pipeline) {
    for (const l3d_projection projection : {l3d_projection::perspective, l3d_projection::parallel})
        for (const l3d_shade shade : {l3d_shade::flat, l3d_shade::lambert}) {
            l3d_polygon_settings settings = hard_edged_polygons();
            settings.shade = shade;
            settings.material = shining;
            settings.lighting = two_lights();
            const auto by_depth =
                polygons<l3d_pipeline_zbuffer>(settings, projection, l3d_rasterizer_factory_sw());
            expect_near(polygons<l3d_pipeline_zsort>(settings, projection), by_depth);
            EXPECT_GT(std::ranges::count_if(by_depth, [](auto w) { return channel(w, 8) > 180; }),
                      5);
            try {
                expect_near(polygons<l3d_pipeline_zbuffer>(settings, projection,
                                                           l3d_rasterizer_factory_mesa()),
                            by_depth);
            } catch (const l3d_error&) { // no GL here
            }
        }
}

l3d_camera from(const l3d_camera::vector& eye) {
    return {.eye = eye, .target = {0.2, 1.3, 0.0}};
}

/// Its direction is all that is new, so all that is promised holds of it.
TEST(lit_picture, by_a_headlight_is_that_of_a_light_of_the_world) {
    constexpr l3d_size small{61, 45};
    const auto sw = std::make_shared<l3d_rasterizer_factory_sw>();
    for (const l3d_camera::vector eye :
         {l3d_camera::vector{-4.0, 4.0, -8.0}, {1.0, -7.0, 2.0}, {0.3, 9.0, 0.1}}) {
        l3d_afd_settings settings;
        settings.error_map = settings.antialias = true;
        const l3d_frame_lights lights = l3d_headlight(from(eye), settings.lighting);
        settings.light = lights.light;
        tester placed(l3d_patch_scene(teapot_model()), from(eye), settings, sw, small);
        placed.draw_event();
        settings.light = {0.0, 0.0, 1.0};
        settings.lighting = two_lights(); // which does not shine then
        settings.headlight = true;
        tester with_eye(l3d_patch_scene(teapot_model()), from(eye), settings, sw, small);
        with_eye.draw_event();
        EXPECT_EQ(placed.words(), with_eye.words());
        EXPECT_EQ(placed.report().dice.shade_bound, with_eye.report().dice.shade_bound);
        ASSERT_NE(with_eye.error_map(), nullptr);
        EXPECT_TRUE(
            std::ranges::equal(placed.error_map()->levels(), with_eye.error_map()->levels()));
        settings.headlight = false;
        tester in_the_world(l3d_patch_scene(teapot_model()), from(eye), settings, sw, small);
        in_the_world.draw_event();
        EXPECT_NE(in_the_world.words(), with_eye.words());
    }
}

TEST(lit_picture, by_a_headlight_is_as_ever_in_the_programs_first_view) {
    l3d_afd_settings settings;
    tester usual(l3d_patch_scene(teapot_model()), before_the_teapot(), settings);
    usual.draw_event();
    settings.headlight = true;
    tester with_eye(l3d_patch_scene(teapot_model()), before_the_teapot(), settings);
    with_eye.draw_event();
    EXPECT_EQ(usual.words(), with_eye.words());
}

/// Of a ball's pixels, how many per cent have ambient light alone.
double dark_share(const std::vector<std::uint32_t>& words) {
    constexpr std::uint32_t ambient = 26; // a tenth of 255
    const auto covered = std::ranges::count_if(words, [](auto word) { return word != 0; });
    const auto dark = std::ranges::count_if(
        words, [](auto word) { return word != 0 && channel(word, 8) <= ambient; });
    EXPECT_GT(covered, 1000);
    return 100.0 * static_cast<double>(dark) / static_cast<double>(covered);
}

/// The light is 40 degrees from the eye, so of a ball's disc (1 - cos 40) / 2, 12 %, are dark.
TEST(lit_picture, by_a_headlight_has_no_dark_side) {
    double darkest_in_the_world = 0;
    for (int turn = 0; turn < 12; ++turn)
        for (const double height : {-3.0, 0.2, 4.0}) {
            const double angle = turn * std::numbers::pi / 6;
            l3d_camera camera;
            camera.eye = {4 * std::cos(angle), height, 4 * std::sin(angle)};
            l3d_polygon_settings settings = hard_edged_polygons();
            settings.shade = l3d_shade::lambert;
            const auto seen = [&] {
                l3d_pipeline_zsort pipeline(l3d_memory_canvas({203, 151}),
                                            l3d_polygon_model(l3d_sphere_mesh(24, 12)), camera,
                                            settings);
                pipeline.draw_event();
                return dark_share(words_of(pipeline.screen().pixels()));
            };
            darkest_in_the_world = std::max(darkest_in_the_world, seen());
            settings.headlight = true;
            EXPECT_LT(seen(), 13) << turn << ", " << height;
        }
    EXPECT_GT(darkest_in_the_world, 60);
}

} // namespace
