// SPDX-License-Identifier: MIT
// Pictures on patches: each pixel by the parameters that a pick finds there, filters beside means
// of 256 samples, and pictures of one colour beside materials.
#include "pipeline/pipeline_afd.h"

#include "pipeline/polygons/polygon_model.h"
#include "raster/rasterizer_factory.h"
#include "raster/surfaces/surface_rasterizer_scalar.h"
#include "textured_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace textured_scenes;

/// Red tells u and green v, with 256 pixels along each.
std::shared_ptr<const l3d_texture> places() {
    return texture_of({256, 256}, [](int x, int y) {
        return static_cast<std::uint32_t>(x << 16 | y << 8 | 0x80);
    });
}

int difference(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (const int shift : {0, 8, 16})
        most = std::max(most, std::abs(channel(a, shift) - channel(b, shift)));
    return most;
}

int most_different(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, difference(a[i], b[i]));
    return most;
}

/// Rasterizers that fill pixel by pixel, as the slow twin does.
class scalar_factory : public l3d_rasterizer_factory {
    std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const override {
        return l3d_rasterizer_factory_sw().create_2d(target);
    }
    std::unique_ptr<l3d_surface_rasterizer> do_create_surface(l3d_workers&) const override {
        return std::make_unique<l3d_surface_rasterizer_scalar>();
    }
};

/// The errors of each filter.
std::array<double, 4> errors_of(const l3d_patch_scene& scene, const l3d_camera& camera) {
    const means truth(scene, camera);
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = truth.error_of(
            drawn(scene, plainly(l3d_texture_filter_names[i].second), camera, means::size));
    return result;
}

/// Places are those of the surface that is drawn, which is within the tolerance of the exact one.
TEST(textured_patches, show_the_picture_at_the_parameters_that_a_pick_finds) {
    const l3d_patch_model model = l3d_patch_model::teapot();
    const l3d_patch_scene scene = scene_of(model, places());
    for (const double tolerance : {0.1, 0.25}) {
        l3d_afd_settings settings = by_levels();
        settings.tolerance = tolerance;
        const auto grey = drawn(model, settings);
        l3d_pipeline_afd pipeline(l3d_memory_canvas(window), scene, teapot_camera(), settings);
        pipeline.draw_event();
        const auto words = words_of(pipeline.screen().pixels());
        int judged = 0, off = 0;
        for (int y = 0; y < window.height; ++y)
            for (int x = 0; x < window.width; ++x) {
                const auto at = pipeline.pick(x + 0.5, y + 0.5);
                // The change of u and v within the tolerance, as picks beside show it.
                const auto beside = pipeline.pick(x + 0.5 + tolerance, y + 0.5);
                const auto below = pipeline.pick(x + 0.5, y + 0.5 + tolerance);
                if (!at || !beside || !below || beside->patch != at->patch ||
                    below->patch != at->patch)
                    continue;
                const auto i = static_cast<std::size_t>(y * window.width + x);
                const auto level = [](double p) {
                    return static_cast<std::uint32_t>(
                        std::lround(std::clamp(p * 256 - 0.5, 0.0, 255.0)));
                };
                const std::uint32_t expected =
                    l3d_product_of_colors(level(at->u) << 16 | level(at->v) << 8 | 0x80, grey[i]);
                const double moves =
                    256 * (std::abs(beside->u - at->u) + std::abs(beside->v - at->v) +
                           std::abs(below->u - at->u) + std::abs(below->v - at->v));
                ++judged;
                off += difference(words[i], expected) > 2 + moves;
            }
        EXPECT_GT(judged, 2000);
        EXPECT_LE(off, judged / 200) << tolerance;
    }
}

/// A picture of one colour looks as a material of that colour: alone, under coloured lights, with
/// smooth edges, and pixel by pixel.
TEST(textured_patches, of_one_colour_look_as_painted_ones) {
    constexpr std::uint32_t color = 0x40c0e0;
    const l3d_patch_model model = l3d_patch_model::teapot();
    const l3d_patch_scene laid =
        scene_of(model, texture_of({1, 1}, [](int, int) { return color; }));
    const l3d_patch_scene painted(model.painted({.color = color}));
    for (const bool is_lit : {false, true})
        for (const bool antialias : {false, true}) {
            l3d_afd_settings settings = by_levels(l3d_texture_filter::anisotropic);
            settings.antialias = antialias;
            if (is_lit)
                settings.lighting.color = {1, 0.5F, 0.25F};
            EXPECT_LE(most_different(drawn(laid, settings), drawn(painted, settings)),
                      is_lit || antialias ? 2 : 0)
                << is_lit << antialias;
        }
}

TEST(textured_patches, look_the_same_in_lanes_and_pixel_by_pixel) {
    const l3d_patch_scene scene = scene_of(l3d_patch_model::teapot(), squares());
    for (const auto& [name, filter] : l3d_texture_filter_names) {
        l3d_canvas canvas = l3d_memory_canvas(window);
        canvas.rasterizers = std::make_shared<scalar_factory>();
        l3d_pipeline_afd slow(std::move(canvas), scene, teapot_camera(), by_levels(filter));
        slow.draw_event();
        const auto expected = words_of(slow.screen().pixels());
        const auto words = drawn(scene, by_levels(filter));
        std::size_t off = 0;
        for (std::size_t i = 0; i < words.size(); ++i)
            off += difference(words[i], expected[i]) > 1;
        EXPECT_LE(off, words.size() / 1000) << name;
    }
}

/// On teapot and sphere, pixels see up to 6 by 12 pixels of the picture, or more. Squares of 4 are
/// whole pixels of a smaller picture then: with one that is a little finer than a pixel they are
/// seen at full contrast, and with the next one not at all. A filter that blurs more errs less. So
/// squares tell nothing of the filters there, but waves do.
TEST(textured_patches, are_nearer_to_the_mean_with_better_filters) {
    const auto note = [](const std::string& name, const std::array<double, 4>& errors) {
        std::string text;
        for (const double error : errors)
            text += std::to_string(error) + ' ';
        RecordProperty(name, text);
    };
    const l3d_patch_scene floor = scene_of(floor_patch(), squares(128));
    for (const int angle : {90, 45, 20, 10}) {
        const auto errors = errors_of(floor, above_floor(angle));
        note("floor_" + std::to_string(angle), errors);
        EXPECT_LT(errors[1], errors[0]) << angle;
        EXPECT_LT(errors[2], errors[1] / 2) << angle;
        EXPECT_LE(errors[3], errors[2]) << angle;
    }
    l3d_camera beside;
    beside.eye = {1.6, 1.2, 3.6};
    const auto waves = std::make_shared<const l3d_texture>(
        waves_picture(128).pixels(), l3d_texture_wrap::clamp, l3d_texture_wrap::clamp);
    for (const auto& [name, scene, camera] :
         {std::tuple{"teapot", scene_of(l3d_patch_model::teapot(), waves), teapot_camera()},
          std::tuple{"sphere", scene_of(sphere(), waves), beside}}) {
        const auto errors = errors_of(scene, camera);
        note(name, errors);
        EXPECT_LT(errors[2], errors[1] / 2) << name;
        EXPECT_LT(errors[3], 0.9 * errors[2]) << name;
    }
}

TEST(textured_patches, show_what_they_did_when_the_picture_is_taken_away) {
    const l3d_patch_model model = l3d_patch_model::teapot();
    l3d_patch_scene scene = scene_of(model, squares());
    scene.lay(0, {});
    EXPECT_FALSE(scene.has_pictures());
    EXPECT_EQ(drawn(scene, by_levels()), drawn(model, by_levels()));
}

TEST(textured_patches, are_drawn_anew_when_picture_or_filter_changes) {
    const l3d_patch_model model = l3d_patch_model::teapot();
    l3d_pipeline_afd pipeline(l3d_memory_canvas(window), model, teapot_camera(), by_levels());
    pipeline.draw_event();
    pipeline.scene().lay(0, {squares()});
    for (const auto& [name, filter] : l3d_texture_filter_names) {
        pipeline.settings().texture_filter = filter;
        pipeline.draw_event();
        EXPECT_EQ(words_of(pipeline.screen().pixels()),
                  drawn(scene_of(model, squares()), by_levels(filter)))
            << name;
    }
}

/// A finer level of an exact shape has more patches, and the picture stays where it is.
TEST(textured_patches, show_one_picture_on_all_patches_that_stand_for_a_piece) {
    l3d_camera camera;
    camera.eye = {1.6, 1.2, 3.6};
    const l3d_patch_model model = sphere();
    EXPECT_GT(model.at_level(8, 8).patches().size(), model.patches().size());
    l3d_afd_settings settings = by_levels();
    const auto coarse = drawn(scene_of(model, places()), settings, camera);
    settings.tolerance = 0.02;
    const auto fine = drawn(scene_of(model, places()), settings, camera);
    std::size_t off = 0;
    for (std::size_t i = 0; i < fine.size(); ++i)
        off += difference(fine[i], coarse[i]) > 16;
    EXPECT_LE(off, fine.size() / 50);
}

/// Corners of pieces turn a picture, and repeat it.
TEST(textured_patches, lie_where_corners_of_pieces_say) {
    l3d_patch_scene scene(floor_patch());
    scene.lay(0, {places(), {{{{1, 0}, {0, 0}, {1, 1}, {0, 1}}}}});
    const l3d_patch_scene straight = scene_of(floor_patch(), places());
    const auto turned = drawn(scene, plainly(l3d_texture_filter::bilinear), above_floor(90));
    const auto words = drawn(straight, plainly(l3d_texture_filter::bilinear), above_floor(90));
    const auto middle = static_cast<std::size_t>(window.height / 2 * window.width);
    for (std::size_t x = 55; x < 78; ++x)
        EXPECT_NEAR(channel(turned[middle + x], 16), 255 - channel(words[middle + x], 16), 2);
}

TEST(textured_patches, tell_of_a_picture_that_cannot_be_read) {
    std::vector<std::string> notes;
    EXPECT_EQ(l3d_read_texture("/no/such.png", notes), nullptr);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("/no/such.png"), std::string::npos);
}

} // namespace
