// SPDX-License-Identifier: MIT
// Fog: each pixel by its own depth, edges by what is seen in them, and what a frame says of it.
#include "hard_edged.h"
#include "still_studio.h"

#include "geom/transform.h"
#include "raster/depth_buffer.h"
#include "raster/color/srgb_light.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace {

using namespace still_tests;
using picture = std::vector<std::uint32_t>;

l3d_afd_settings with_fog(std::optional<std::uint32_t> color = 0x4060a0) {
    l3d_afd_settings settings = hard_edged();
    settings.background = l3d_background::gradient();
    settings.fog = {.from = 6.5F, .to = 10, .color = color};
    return settings;
}

picture drawn(const l3d_patch_scene& scene, const l3d_afd_settings& settings, int scale = 1) {
    tester program(scene, before_the_teapot(), settings,
                   std::make_shared<l3d_rasterizer_factory_sw>(),
                   {scale * odd.width, scale * odd.height});
    program.draw_event();
    return program.words();
}

struct surface_look {
    l3d_material material;
    l3d_shade shade = l3d_shade::lambert;
};

TEST(fog, fades_each_pixel_by_its_own_depth) {
    for (const std::optional<std::uint32_t> color :
         {std::optional<std::uint32_t>(), std::optional<std::uint32_t>(0x4060a0)})
        for (const surface_look& look : {surface_look{}, surface_look{{.color = 0xc06020}},
                                         surface_look{{.color = 0xc06020, .highlight = 0xffffff}},
                                         surface_look{{}, l3d_shade::normals}}) {
            l3d_patch_scene scene(teapot_model());
            scene.paint(0, look.material);
            l3d_afd_settings settings = with_fog(color);
            settings.shade = look.shade;
            settings.depth = true;
            tester fogged(scene, before_the_teapot(), settings);
            fogged.draw_event();
            settings.fog = {};
            const picture clear = drawn(scene, settings);
            const picture words = fogged.words();
            const std::vector<float> distances = l3d_distances(fogged.depth());
            int faded = 0;
            for (std::size_t i = 0; i < words.size(); ++i) {
                const double amount =
                    std::clamp((double{distances[i]} - 6.5) / (10 - 6.5), 0.0, 1.0);
                const int row = static_cast<int>(i) / odd.width;
                const std::uint32_t to = color ? *color : settings.background.word(row, odd.height);
                for (const int shift : {0, 8, 16}) {
                    const double before = clear[i] >> shift & 255, fog = to >> shift & 255;
                    const double exact =
                        std::isinf(distances[i]) ? before : before + amount * (fog - before);
                    ASSERT_NEAR(words[i] >> shift & 255, exact, 1.51) << i;
                    faded += std::abs(exact - before) > 5;
                }
            }
            EXPECT_GT(faded, 3000);
        }
}

/// As when a user of a viewer looks for curvature in a foggy picture.
TEST(fog, is_not_before_the_colors_of_a_scale) {
    l3d_afd_settings settings = with_fog();
    tester program(l3d_patch_scene(teapot_model()), before_the_teapot(), settings);
    program.settings().shade = l3d_shade::gaussian;
    program.draw_event();
    settings.fog = {};
    settings.shade = l3d_shade::gaussian;
    EXPECT_EQ(program.words(), drawn(l3d_patch_scene(teapot_model()), settings));
}

/// The root mean square of what a smooth picture is off the mean of 8 x 8 samples a pixel.
double off_the_mean(const l3d_patch_scene& scene, l3d_afd_settings settings) {
    constexpr int fine = 8;
    const picture samples = drawn(scene, settings, fine);
    settings.antialias = true;
    const picture smooth = drawn(scene, settings);
    double squares = 0;
    for (int y = 0; y < odd.height; ++y)
        for (int x = 0; x < odd.width; ++x)
            for (const int shift : {0, 8, 16}) {
                double sum = 0;
                for (int k = 0; k < fine * fine; ++k) {
                    const int row = fine * y + k / fine, column = fine * x + k % fine;
                    sum += l3d_light_of_level(
                        samples[static_cast<std::size_t>(row * fine * odd.width + column)] >>
                            shift &
                        255);
                }
                const double level =
                    smooth[static_cast<std::size_t>(y * odd.width + x)] >> shift & 255;
                const double off = level - l3d_level_of_light(sum / (fine * fine));
                squares += off * off;
            }
    return std::sqrt(squares / (3 * odd.width * odd.height));
}

TEST(fog, smooth_edges_mix_what_is_fogged_each_by_its_depth) {
    for (const std::optional<l3d_material>& material :
         {std::optional<l3d_material>(),
          std::optional(l3d_material{.color = 0xc06020, .highlight = 0xffffff})}) {
        l3d_patch_scene scene(teapot_model());
        scene.paint(0, material);
        l3d_afd_settings settings = with_fog(0xffffff);
        settings.fog.to = 9; // the far rim is white before the near one
        const double fogged = off_the_mean(scene, settings);
        settings.fog = {};
        const double clear = off_the_mean(scene, settings);
        EXPECT_LT(fogged, 1.2 * clear);
        EXPECT_LT(clear, 2);
    }
}

TEST(fog, leaves_the_bits_of_a_whole_picture_where_parts_are_drawn) {
    for (const bool antialias : {false, true})
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            studio s(seed);
            s.settings.antialias = antialias;
            s.settings.shade = l3d_shade::lambert;
            s.settings.fog = {.from = 1, .to = 12, .color = {}};
            s.settings.background = l3d_background::gradient();
            tester program(s.scene, s.camera, s.settings);
            program.draw_event();
            s.settings.threads = 3;
            for (int frame = 0; frame < 3; ++frame) {
                s.move(program);
                program.draw_event();
                tester fresh(program.scene(), s.camera, s.settings);
                fresh.draw_event();
                ASSERT_EQ(program.words(), fresh.words()) << "seed " << seed << ", frame " << frame;
            }
        }
}

TEST(fog, adds_to_the_bound_of_shades_and_has_bounds_of_colors) {
    l3d_afd_settings settings = with_fog();
    settings.error_map = true;
    tester fogged(l3d_patch_scene(teapot_model()), before_the_teapot(), settings);
    fogged.draw_event();
    settings.fog = {};
    settings.error_map = false;
    tester clear(l3d_patch_scene(teapot_model()), before_the_teapot(), settings);
    clear.draw_event();
    const double more = fogged.report().dice.shade_bound - clear.report().dice.shade_bound;
    EXPECT_GT(more, 1.51);
    EXPECT_LT(more, 4);
    EXPECT_EQ(fogged.report().dice.bound_px, clear.report().dice.bound_px);
    EXPECT_LT(fogged.report().color_bound, 40);
    EXPECT_LT(fogged.error_map()->at(20, 20), 255);
}

TEST(fog, that_makes_no_sense_is_refused) {
    const l3d_size size{64, 48};
    l3d_afd_settings settings = with_fog();
    EXPECT_EQ(l3d_afd_complaint(before_the_teapot(), size, settings), "");
    settings.background = l3d_background::none();
    EXPECT_EQ(l3d_afd_complaint(before_the_teapot(), size, settings), "");
    settings.fog.color = {};
    EXPECT_NE(l3d_afd_complaint(before_the_teapot(), size, settings), "");
    for (const auto& [near, far] : {std::pair(3.0F, 2.0F), {-1.0F, 2.0F}, {0.0F, HUGE_VALF}}) {
        settings = with_fog();
        settings.fog.from = near;
        settings.fog.to = far;
        EXPECT_NE(l3d_afd_complaint(before_the_teapot(), size, settings), "") << near << ' ' << far;
    }
    settings = with_fog();
    settings.shade = l3d_shade::zebra;
    EXPECT_NE(l3d_afd_complaint(before_the_teapot(), size, settings), "");
}

} // namespace
