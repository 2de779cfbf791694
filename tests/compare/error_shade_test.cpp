// SPDX-License-Identifier: MIT
// The picture of mode `error`, with every method that has something to show.
#include "hard_edged.h"
#include "pipeline/still_studio.h"

#include "compare/method_choice.h"
#include "dice/error_color.h"
#include "pipeline/pipeline_afd_viewer.h"
#include "base/error.h"

#include <gtest/gtest.h>

namespace still_tests {
namespace {

constexpr const char* bounded[] = {
    "afd", "fd", "fd:2", "fd:9", "subdivision", "tessellation", "tessellation:3", "micropolygons"};

l3d_afd_settings settings_of(const std::string& method, l3d_shade shade) {
    l3d_afd_settings settings = hard_edged();
    std::string why;
    settings.method = l3d_method_choice::from_name(method, why).value().factory();
    settings.shade = shade;
    settings.tolerance = 1; // some patches are points from far away
    return settings;
}

l3d_camera near_camera() {
    l3d_camera camera = dice_tests::oblique_camera();
    camera.eye = {0.9, 1.2, 2.2};
    return camera;
}

l3d_camera far_camera() {
    l3d_camera camera = dice_tests::oblique_camera();
    camera.eye = camera.eye * 60.0;
    return camera;
}

/// The part of the tolerance that a colour stands for; at least 1 if it is red.
double part_of(std::uint32_t word) {
    const auto red = word >> 16 & 255, green = word >> 8 & 255;
    return green == 255 ? red / 510.0 : 1 - green / 510.0;
}

bool is_of_legend(std::uint32_t word) {
    const auto red = word >> 16 & 255, green = word >> 8 & 255;
    return (word & 255) == 0 && std::max(red, green) == 255;
}

/// A patch about `at`, wide as a unit, whose middle is `bulge` before it.
l3d_patch_model::patch patch_at(double x, double bulge) {
    l3d_patch_model::patch patch;
    for (int i = 0; i < 16; ++i) {
        const bool is_inside = i % 4 % 3 > 0 && i / 4 % 3 > 0;
        patch.points[static_cast<std::size_t>(i)] = {x + i % 4 / 3.0, i / 4 / 3.0,
                                                     is_inside ? bulge : 0.0};
    }
    return patch;
}

TEST(error_shade, colours_run_from_green_over_yellow_to_red) {
    EXPECT_EQ(l3d_error_color(0, 0.3), 0x0000ff00u);
    EXPECT_EQ(l3d_error_color(0.15, 0.3), 0x00ffff00u);
    EXPECT_EQ(l3d_error_color(0.3, 0.3), 0x00ff0000u);
    EXPECT_EQ(l3d_error_color(INFINITY, 0.3), 0x00ff0000u);
    EXPECT_NEAR(part_of(l3d_error_color(0.07, 0.7)), 0.1, 1.0 / 255);
    EXPECT_NEAR(part_of(l3d_error_color(0.63, 0.7)), 0.9, 1.0 / 255);
}

/// Also of patches that are clipped, and of those that are drawn as a point.
TEST(error_shade, every_pixel_that_is_drawn_has_a_bound) {
    for (const l3d_camera& camera : {dice_tests::oblique_camera(), near_camera(), far_camera()})
        for (const char* method : bounded) {
            const l3d_patch_model teapot = teapot_model();
            tester lit(teapot, camera, settings_of(method, l3d_shade::lambert));
            lit.draw_event();
            tester shown(teapot, camera, settings_of(method, l3d_shade::error));
            shown.draw_event();
            const auto grey = lit.words(), words = shown.words();
            double most = 0;
            int wrong = 0;
            for (std::size_t i = 0; i < words.size(); ++i) {
                wrong += grey[i] != 0 ? !is_of_legend(words[i]) : words[i] != 0;
                most = std::max(most, words[i] != 0 ? part_of(words[i]) : 0);
            }
            EXPECT_EQ(wrong, 0) << method;
            EXPECT_GT(most, 0) << method;
            const double bound = shown.report().dice.bound_px / shown.settings().tolerance;
            EXPECT_LE(most, std::min(1.0, bound) + 1.0 / 255) << method;
        }
}

/// With fixed steps, surfaces that bend more have larger errors.
TEST(error_shade, every_patch_has_its_own) {
    l3d_camera camera;
    camera.eye = {0.1, 0.3, 4.1};
    camera.target = {0.0, 0.4, 0.0};
    camera.fov = 41;
    const l3d_patch_model patches({patch_at(-1.2, 0), patch_at(0.2, 0.4)});
    for (const char* method : {"fd:3", "tessellation:3"}) {
        l3d_afd_settings settings = settings_of(method, l3d_shade::error);
        settings.tolerance = 11;
        tester program(patches, camera, settings);
        program.draw_event();
        const auto at = [&](int x) {
            return part_of(
                program.screen().pixels().row(odd.height / 2)[static_cast<std::size_t>(x)]);
        };
        const double bound = program.report().dice.bound_px / settings.tolerance;
        EXPECT_LT(at(odd.width / 4), 0.01) << method;
        EXPECT_GT(at(odd.width * 3 / 4), 0.05) << method;
        EXPECT_NEAR(at(odd.width * 3 / 4), bound, 0.01) << method;
    }
}

TEST(error_shade, does_not_depend_on_frames_before) {
    for (const char* method : bounded) {
        const l3d_patch_model teapot = teapot_model();
        const l3d_afd_settings settings = settings_of(method, l3d_shade::error);
        tester used(teapot, near_camera(), settings);
        used.draw_event();
        used.camera() = far_camera();
        used.draw_event();
        EXPECT_EQ(used.report().dice.as_points > 0, method == std::string("afd"));
        tester fresh(teapot, far_camera(), settings);
        fresh.draw_event();
        EXPECT_EQ(used.words(), fresh.words()) << method;
    }
}

TEST(error_shade, methods_without_a_bound_refuse) {
    const l3d_patch_model teapot = teapot_model();
    for (const char* method : {"isocurves", "scanline", "voxels", "mesa"}) {
        const l3d_afd_settings settings = settings_of(method, l3d_shade::error);
        EXPECT_EQ(l3d_afd_complaint(dice_tests::oblique_camera(), odd, settings),
                  "shade: error shows a bound of the error, and " + settings.method.name() +
                      " has none");
    }
    EXPECT_THROW(
        tester(teapot, dice_tests::oblique_camera(), settings_of("scanline", l3d_shade::error)),
        l3d_error);
}

class viewer final : public l3d_pipeline_afd_viewer {
public:
    explicit viewer(const l3d_patch_model& model, const std::string& method)
        : l3d_pipeline_afd_viewer(l3d_memory_canvas(odd), model, dice_tests::oblique_camera(),
                                  settings_of(method, l3d_shade::lambert)) {}

    /// The shades that a key leads through until the first comes again.
    std::vector<l3d_shade> shades() {
        std::vector<l3d_shade> found;
        do {
            found.push_back(settings().shade);
            key_event('c');
            EXPECT_EQ(l3d_afd_complaint(camera(), odd, settings()), "");
        } while (settings().shade != found.front());
        return found;
    }
};

TEST(error_shade, the_key_leads_only_to_what_there_is) {
    using enum l3d_shade;
    const l3d_patch_model teapot = teapot_model();
    EXPECT_EQ(viewer(teapot, "fd").shades(), (std::vector{lambert, gouraud, flat, normals, error}));
    EXPECT_EQ(viewer(teapot, "isocurves").shades(), (std::vector{lambert, gouraud, flat, normals}));
}

} // namespace
} // namespace still_tests
