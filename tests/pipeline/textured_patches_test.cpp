// SPDX-License-Identifier: MIT
// Pictures on patches: each pixel by the parameters that a pick finds there, filters beside means
// of 256 samples, and pictures of one colour beside materials.
#include "pipeline/pipeline_afd.h"

#include "geom/nurbs_surface.h"
#include "hard_edged.h"
#include "pipeline/polygons/polygon_model.h"
#include "raster/color/srgb_light.h"
#include "raster/rasterizer_factory.h"
#include "raster/surfaces/surface_rasterizer_scalar.h"
#include "scene/laid_picture.h"
#include "tool_2d/image.h"
#include "words_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr l3d_size window{133, 101};

std::shared_ptr<const l3d_texture> texture_of(l3d_size size,
                                              const std::function<std::uint32_t(int, int)>& word,
                                              l3d_texture_wrap wrap = l3d_texture_wrap::clamp) {
    l3d_image image(size, size.width);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image.pixels().row(y)[static_cast<std::size_t>(x)] = word(x, y);
    return std::make_shared<const l3d_texture>(image.pixels(), wrap, wrap);
}

/// Red tells u and green v, with 256 pixels along each.
std::shared_ptr<const l3d_texture> places() {
    return texture_of({256, 256}, [](int x, int y) {
        return static_cast<std::uint32_t>(x << 16 | y << 8 | 0x80);
    });
}

/// Squares of 4 by 4 pixels, as hard as colours can be.
std::shared_ptr<const l3d_texture> squares(int size = 64) {
    return texture_of({size, size},
                      [](int x, int y) { return (x / 4 + y / 4) % 2 ? 0xffe0c0U : 0x202040U; });
}

/// The usual light, whose levels are multiplied by colours, and stairs at edges.
l3d_afd_settings by_levels(l3d_texture_filter filter = l3d_texture_filter::bilinear) {
    l3d_afd_settings settings = hard_edged();
    settings.texture_filter = filter;
    return settings;
}

/// Colours as they are, whatever the light: levels are 255.
l3d_afd_settings plainly(l3d_texture_filter filter) {
    l3d_afd_settings settings = by_levels(filter);
    settings.lighting.ambient = {1, 1, 1};
    settings.lighting.color = {0, 0, 0};
    return settings;
}

l3d_patch_scene scene_of(const l3d_patch_model& model,
                         const std::shared_ptr<const l3d_texture>& texture) {
    l3d_patch_scene scene(model);
    scene.lay(0, {texture});
    return scene;
}

l3d_camera teapot_camera() {
    l3d_camera camera;
    camera.eye = {3.2, 3.6, 7.4};
    camera.target = {0.2, 1.3, 0.0};
    return camera;
}

std::vector<std::uint32_t> drawn(const l3d_patch_scene& scene, const l3d_afd_settings& settings,
                                 const l3d_camera& camera = teapot_camera(),
                                 l3d_size size = window) {
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), scene, camera, settings);
    pipeline.draw_event();
    return words_of(pipeline.screen().pixels());
}

int channel(std::uint32_t word, int shift) {
    return static_cast<int>(word >> shift & 255);
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

/// A flat patch, 2 by 2, in the plane y = 0.
l3d_patch_model floor_patch() {
    l3d_patch_model::patch patch;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            patch.at(row, column) = {column * 2 / 3.0 - 1, 0.0, row * 2 / 3.0 - 1};
    return l3d_patch_model(std::vector{patch});
}

l3d_patch_model sphere() {
    return l3d_patch_model::from_surfaces(*l3d_exact_shape("sphere"));
}

/// A camera that sees the floor under an angle between it and the line of sight.
l3d_camera above_floor(double degrees) {
    const double angle = degrees * 3.14159265358979 / 180;
    l3d_camera camera;
    camera.target = {0.0, 0.0, 0.0};
    camera.eye = {0.0, 3 * std::sin(angle), 3 * std::cos(angle)};
    camera.up = {0.0, std::cos(angle), -std::sin(angle)};
    camera.fov = 30;
    return camera;
}

constexpr std::uint32_t nothing = 0x010203;

/// The roots of the mean squares, for each filter, of the differences from means of 256 samples in
/// linear light, where all samples see the surface. Units: levels of 255.
std::array<double, 4> errors_of(const l3d_patch_scene& scene, const l3d_camera& camera) {
    constexpr int across = 16, samples = across * across;
    constexpr l3d_size size{64, 48};
    l3d_afd_settings settings = plainly(l3d_texture_filter::nearest);
    settings.background = l3d_background::color(nothing);
    const auto fine = drawn(scene, settings, camera, {across * size.width, across * size.height});
    std::vector<std::array<double, 3>> means;
    std::vector<bool> covered;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            std::array<double, 3> light{};
            bool is_covered = true;
            for (int k = 0; k < samples; ++k) {
                const int row = y * across + k / across, column = x * across + k % across;
                const std::uint32_t word =
                    fine[static_cast<std::size_t>(row * across * size.width + column)];
                is_covered = is_covered && word != nothing;
                for (std::size_t c = 0; c < 3; ++c)
                    light[c] +=
                        l3d_light_of_level(channel(word, 16 - 8 * static_cast<int>(c))) / samples;
            }
            means.push_back(light);
            covered.push_back(is_covered);
        }
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < result.size(); ++i) {
        settings.texture_filter = l3d_texture_filter_names[i].second;
        const auto words = drawn(scene, settings, camera, size);
        double sum = 0;
        int count = 0;
        for (std::size_t p = 0; p < words.size(); ++p)
            for (std::size_t c = 0; covered[p] && c < 3; ++c) {
                const double off = channel(words[p], 16 - 8 * static_cast<int>(c)) -
                                   l3d_level_of_light(means[p][c]);
                sum += off * off;
                ++count;
            }
        result[i] = std::sqrt(sum / std::max(count, 1));
    }
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
    const auto of_teapot =
        errors_of(scene_of(l3d_patch_model::teapot(), squares()), teapot_camera());
    note("teapot", of_teapot);
    EXPECT_LT(std::max(of_teapot[2], of_teapot[3]), of_teapot[1] / 2);
    l3d_camera beside;
    beside.eye = {1.6, 1.2, 3.6};
    const auto of_sphere = errors_of(scene_of(sphere(), squares()), beside);
    note("sphere", of_sphere);
    EXPECT_LT(std::max(of_sphere[2], of_sphere[3]), of_sphere[1] / 2);
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
    EXPECT_GT(model.at_level(1, 1).patches().size(), model.patches().size());
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
