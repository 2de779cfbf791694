// SPDX-License-Identifier: MIT
// Whole frames in colour: the greys of before times the colours of materials, by every pipeline.
#include "hard_edged.h"
#include "still_studio.h"

#include "geom/files/model_file.h"
#include "geom/polygon_shapes.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "raster/depth_buffer.h"
#include "raster/rasterizer_factory.h"
#include "base/error.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <set>

namespace {

using namespace still_tests;

/// Six colours from which a pixel's level and face can be told.
constexpr std::array<std::uint32_t, 6> telling{0xff0000, 0x00ff00, 0x0000ff,
                                               0xffff00, 0x00ffff, 0xff00ff};

std::uint32_t level_of(std::uint32_t word) {
    return std::max({word >> 16 & 255, word >> 8 & 255, word & 255});
}

/// The colour of a pixel at its brightest; 0 where there is only background.
std::uint32_t color_of(std::uint32_t word) {
    std::uint32_t result = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        result = result << 8 | ((word >> shift & 255) > 0 ? 255 : 0);
    EXPECT_EQ(l3d_product_of_colors(result, 0x010101 * level_of(word)), word) << std::hex << word;
    return result;
}

/// The .off text of a cube with a colour for each side, or without.
std::string cube_text(bool has_colors) {
    std::string text = "OFF\n8 6 0\n";
    for (int i = 0; i < 8; ++i)
        text += std::to_string(i & 1) + ' ' + std::to_string(i >> 1 & 1) + ' ' +
                std::to_string(i >> 2) + '\n';
    const char* const faces[] = {"0 2 3 1", "4 5 7 6", "0 1 5 4", "2 6 7 3", "0 4 6 2", "1 3 7 5"};
    for (std::size_t i = 0; i < telling.size(); ++i) {
        text += "4 " + std::string(faces[i]);
        for (int shift = 16; has_colors && shift >= 0; shift -= 8)
            text += ' ' + std::to_string(telling[i] >> shift & 255);
        text += '\n';
    }
    return text;
}

l3d_polygon_model cube(bool has_colors) {
    std::string why;
    const auto file = l3d_read_off(cube_text(has_colors), "cube.off", why);
    EXPECT_TRUE(file) << why;
    return l3d_polygon_model(file->mesh);
}

l3d_camera before_the_cube() {
    l3d_camera camera;
    camera.eye = {3.1, 2.3, 4.2};
    camera.target = {0.5, 0.5, 0.5};
    return camera;
}

constexpr l3d_size window{203, 151};

template <class Pipeline, class... More>
std::vector<std::uint32_t> polygons(const l3d_polygon_model& model,
                                    const l3d_polygon_settings& settings, const More&... more) {
    Pipeline pipeline(l3d_memory_canvas(window), model, before_the_cube(), settings, more...);
    pipeline.draw_event();
    return words_of(pipeline.screen().pixels());
}

using picture_of_polygons = std::vector<std::uint32_t> (*)(const l3d_polygon_model&,
                                                           const l3d_polygon_settings&);

std::vector<std::uint32_t> by_zbuffer(const l3d_polygon_model& model,
                                      const l3d_polygon_settings& settings) {
    return polygons<l3d_pipeline_zbuffer>(model, settings, l3d_rasterizer_factory_sw());
}
std::vector<std::uint32_t> by_zsort(const l3d_polygon_model& model,
                                    const l3d_polygon_settings& settings) {
    return polygons<l3d_pipeline_zsort>(model, settings);
}

/// Expects the same levels, and returns the colours that are seen.
std::set<std::uint32_t> colors_over(const std::vector<std::uint32_t>& colored,
                                    const std::vector<std::uint32_t>& plain) {
    std::set<std::uint32_t> result;
    int other = 0;
    for (std::size_t i = 0; i < colored.size(); ++i) {
        other += level_of(colored[i]) != (plain[i] & 255);
        result.insert(color_of(colored[i]));
    }
    EXPECT_EQ(other, 0);
    result.erase(0);
    return result;
}

TEST(colored_picture, of_a_cube_shows_the_colors_of_its_file) {
    for (const l3d_shade shade : {l3d_shade::flat, l3d_shade::gouraud, l3d_shade::lambert}) {
        l3d_polygon_settings settings = hard_edged_polygons();
        settings.shade = shade;
        for (const picture_of_polygons draw : {by_zbuffer, by_zsort}) {
            const auto colors =
                colors_over(draw(cube(true), settings), draw(cube(false), settings));
            EXPECT_EQ(colors, (std::set<std::uint32_t>{telling[1], telling[3], telling[5]}))
                << int(shade);
        }
        EXPECT_EQ(by_zbuffer(cube(true), settings), by_zsort(cube(true), settings));
        settings.material = l3d_material{.color = 0x00ff00};
        for (const picture_of_polygons draw : {by_zbuffer, by_zsort}) {
            const auto colors = colors_over(draw(cube(true), settings), draw(cube(false), [&] {
                                                auto plain = settings;
                                                plain.material.reset();
                                                return plain;
                                            }()));
            EXPECT_EQ(colors, std::set<std::uint32_t>{0x00ff00});
        }
    }
}

TEST(colored_picture, of_a_cube_by_gl_is_that_of_the_depth_buffer) {
    const l3d_rasterizer_factory_mesa mesa;
    l3d_polygon_settings settings = hard_edged_polygons();
    const auto by_gl = [&](bool has_colors) -> std::optional<std::vector<std::uint32_t>> {
        try {
            return polygons<l3d_pipeline_zbuffer>(cube(has_colors), settings, mesa);
        } catch (const l3d_error&) {
            return std::nullopt;
        }
    };
    const auto colored = by_gl(true);
    if (!colored)
        GTEST_SKIP() << "no GL here";
    EXPECT_EQ(colors_over(*colored, *by_gl(false)).size(), 3u);
    EXPECT_EQ(*colored, by_zbuffer(cube(true), settings));
}

/// Materials for the teapot's patches, one colour after the other.
l3d_patch_model striped(const l3d_patch_model& model) {
    std::vector<l3d_material> each;
    for (std::size_t i = 0; i < model.patches().size(); ++i)
        each.push_back({.color = telling[i % telling.size()]});
    return model.painted(each);
}

std::vector<std::uint32_t> patches(const l3d_patch_scene& scene, const l3d_afd_settings& settings) {
    l3d_camera camera;
    camera.eye = {3.2, 3.6, 7.4};
    camera.target = {0.2, 1.3, 0.0};
    tester program(scene, camera, settings);
    program.draw_event();
    return program.words();
}

TEST(colored_picture, of_patches_shows_a_material_for_each) {
    for (const l3d_shade shade : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat})
        for (const double tolerance : {0.1, 0.5, 30.0}) {
            l3d_afd_settings settings = hard_edged();
            settings.shade = shade;
            settings.tolerance = tolerance;
            const auto colors = colors_over(patches(striped(teapot_model()), settings),
                                            patches(teapot_model(), settings));
            EXPECT_EQ(colors.size(), telling.size());
        }
}

TEST(colored_picture, of_an_instance_shows_its_own_material) {
    l3d_patch_scene scene(striped(teapot_model()));
    const l3d_afd_settings settings = hard_edged();
    const auto of_model = patches(scene, settings);
    scene.paint(0, l3d_material{.color = 0x0000ff});
    EXPECT_EQ(colors_over(patches(scene, settings), patches(teapot_model(), settings)),
              std::set<std::uint32_t>{0x0000ff});
    scene.paint(0, l3d_material{});
    EXPECT_EQ(patches(scene, settings), patches(teapot_model(), settings));
    scene.paint(0, std::nullopt);
    EXPECT_EQ(patches(scene, settings), of_model);
}

TEST(colored_picture, that_is_white_is_that_of_before) {
    l3d_patch_scene scene(teapot_model());
    scene.add(teapot_model(), l3d_translation<double>(50.0, 0.0, 0.0)); // out of sight
    scene.paint(1, l3d_material{.color = 0x123456});
    ASSERT_FALSE(scene.materials().empty());
    for (const bool antialias : {false, true}) {
        l3d_afd_settings settings = hard_edged();
        settings.antialias = antialias;
        EXPECT_EQ(patches(scene, settings), patches(teapot_model(), settings)) << antialias;
    }
}

/// Beside steep folds, greys have a way of their own.
TEST(colored_picture, with_smooth_edges_is_the_grey_one_in_a_single_color) {
    l3d_patch_scene scene(teapot_model());
    scene.paint(0, l3d_material{.color = 0x00ff00});
    l3d_afd_settings settings = hard_edged();
    settings.antialias = true;
    const auto green = patches(scene, settings), grey = patches(teapot_model(), settings);
    std::size_t off = 0, far_off = 0;
    for (std::size_t i = 0; i < green.size(); ++i) {
        EXPECT_EQ(green[i] & 0xff00ff, 0U) << i;
        const int apart =
            std::abs(static_cast<int>(level_of(green[i])) - static_cast<int>(grey[i] & 255));
        off += apart > 0;
        far_off += apart > 20;
    }
    EXPECT_LT(off, green.size() / 100);
    EXPECT_LT(far_off, green.size() / 1000);
}

/// Instances that come, go, move and change colour.
TEST(colored_picture, that_changes_is_the_same_bits_as_drawn_whole) {
    int parts = 0;
    for (const bool antialias : {false, true})
        for (std::uint64_t seed = 0; seed < (antialias ? 20 : 60); ++seed) {
            studio s(seed);
            s.settings.antialias = antialias;
            s.settings.threads = 2;
            s.models[1] = striped(s.models[1]);
            tester program(s.scene, s.camera, s.settings);
            program.draw_event();
            for (int frame = 0; frame < 6; ++frame) {
                const std::size_t index = s.random() % program.scene().instances().size();
                if (frame % 2 == 0)
                    s.move(program);
                else if (s.random() % 4 == 0)
                    program.scene().paint(index, std::nullopt);
                else
                    program.scene().paint(index, l3d_material{.color = static_cast<std::uint32_t>(
                                                                  s.random() & 0xffffff)});
                program.draw_event();
                parts += program.report().pixels_kept > 0;
                tester fresh(program.scene(), s.camera, s.settings);
                fresh.draw_event();
                ASSERT_EQ(program.words(), fresh.words()) << "seed " << seed << ", frame " << frame;
            }
        }
    EXPECT_GT(parts, 100);
}

l3d_error_map doubts_of(const l3d_patch_scene& scene) {
    l3d_afd_settings settings = hard_edged();
    settings.error_map = true;
    l3d_camera camera;
    camera.eye = {3.2, 3.6, 7.4};
    camera.target = {0.2, 1.3, 0.0};
    l3d_pipeline_afd pipeline(l3d_memory_canvas({101, 75}), scene, camera, settings);
    pipeline.draw_event();
    return *pipeline.error_map();
}

TEST(colored_picture, has_the_doubts_of_the_grey_one_if_a_channel_is_as_bright) {
    l3d_patch_scene scene(teapot_model());
    const l3d_error_map grey = doubts_of(scene);
    scene.paint(0, l3d_material{.color = 0xff0000});
    const l3d_error_map red = doubts_of(scene);
    for (int y = 0; y < grey.size().height; ++y)
        for (int x = 0; x < grey.size().width; ++x)
            ASSERT_NEAR(red.at(x, y), grey.at(x, y), 1e-3) << x << ' ' << y;
}

/// Two squares that meet in a line through the picture's middle, one of each colour.
TEST(colored_picture, doubts_all_that_two_colors_differ_by_where_they_meet) {
    std::vector<l3d_patch_model::patch> both(2);
    for (std::size_t i = 0; i < 16; ++i) {
        const double x = static_cast<double>(i % 4) / 3, y = static_cast<double>(i / 4) / 3;
        both[0].points[i] = {x - 1.0, y - 0.5, 0.0};
        both[1].points[i] = {x, y - 0.5, 0.0};
    }
    const l3d_patch_model model(both);
    const l3d_material colors[] = {{.color = 0xff0000}, {.color = 0x0000ff}};
    for (const bool antialias : {false, true}) {
        l3d_afd_settings settings = hard_edged();
        settings.error_map = true;
        settings.antialias = antialias;
        l3d_camera camera;
        camera.eye = {0.02, 0, 3};
        camera.target = {0.02, 0, 0};
        l3d_pipeline_afd pipeline(l3d_memory_canvas({64, 48}), model.painted(colors), camera,
                                  settings);
        pipeline.draw_event();
        const l3d_error_map& map = *pipeline.error_map();
        const auto words = words_of(pipeline.screen().pixels());
        double most = 0;
        for (int x = 20; x < 44; ++x) {
            const float doubt = map.at(x, 24);
            const std::uint32_t word = words[std::size_t(24 * 64 + x)];
            const bool is_mixed = (word & 0xff) != 0 && (word >> 16 & 0xff) != 0;
            EXPECT_EQ(doubt > 3, x == 31) << x << ": " << doubt;
            EXPECT_EQ(is_mixed, antialias && x == 31) << x;
            most = std::max(most, double{doubt});
        }
        EXPECT_GT(most, antialias ? 3 : 80);
    }
}

} // namespace
