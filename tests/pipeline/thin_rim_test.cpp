// SPDX-License-Identifier: MIT
// Smooth edges of what is thinner than a pixel, and of light that changes within one.
#include "hard_edged.h"
#include "beside_larger.h"

#include "pipeline/pipeline_afd.h"
#include "raster/color/srgb_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

/// Draws a teapot that fills the picture.
struct teapot_view {
    l3d_camera camera;
    l3d_fog fog = {};
    bool framed = true; ///< by an eye that is as far away as it has to be

    std::vector<int> greys(l3d_size size, bool smooth) const {
        l3d_afd_settings settings = hard_edged();
        settings.threads = 1;
        settings.antialias = smooth;
        settings.fog = fog;
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), l3d_patch_model::teapot(), camera,
                                  settings);
        if (framed)
            pipeline.frame_all();
        pipeline.draw_event();
        return pipeline_tests::greys_drawn(pipeline);
    }

    int far_off(l3d_size size, int levels) const {
        return pipeline_tests::pixels_far_off(
            [&](l3d_size of, bool smooth) { return greys(of, smooth); }, size, levels);
    }
};

constexpr l3d_camera from_aside{.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0}};

/// Below the body a bright rim, half a pixel wide, lies between a dark side and the background.
TEST(thin_rim, is_no_row_of_beads) {
    // What was measured: 7. Those beside the rim show dark light alone if they keep the level of
    // their middle; 51 where the dark side's levels are taken for the rim's.
    EXPECT_LE((teapot_view{from_aside}.far_off({320, 240}, 30)), 10);
}

TEST(thin_rim, is_no_row_of_beads_in_fog) {
    // What was measured: 5, and 26 where the dark side's levels are taken for the rim's.
    EXPECT_LE(
        (teapot_view{from_aside, {.from = 5, .to = 12, .color = 0x202020}}.far_off({320, 240}, 30)),
        10);
}

/// Light rises or falls by a hundred levels within the pixels beside an outline. Its mean is not
/// that of a place in the middle.
TEST(steep_light, is_the_mean_of_each_pixel) {
    const l3d_camera from_above{.eye = {1.5, 7.5, 3}, .target = {0.2, 1.2, 0}};
    const int aside = teapot_view{from_aside}.far_off({400, 300}, 12);
    const int above = teapot_view{from_above}.far_off({400, 300}, 12);
    EXPECT_LE(aside, 100);
    EXPECT_LE(above, 148);
}

/// Where the body turns away behind the handle, one pixel shows it half, while its middle shows the
/// handle. There the body is farther than at the middle of any pixel around.
TEST(steep_slope, goes_on_behind_what_hides_its_middle) {
    const l3d_camera beside{.eye = {8.927444, 5.778318, 5.456309}, .target = {0.2625, 1.5, 0}};
    const teapot_view view{beside, {}, false};
    EXPECT_EQ(view.far_off({160, 120}, 45), 0);
}

/// Stripes of a plane that faces the eye, two to a pixel. Wherever the middle of a pixel shows a
/// stripe, so may its neighbours' middles, and these are as near as the stripe's sides.
TEST(comb, is_the_mean_of_each_pixel) {
    constexpr l3d_size size{160, 12};
    constexpr double pitch = 0.52, width = 0.26; // pixels
    const double unit = 2 * std::tan(19 * 3.14159265358979 / 180) * 5 / size.height;
    std::vector<l3d_patch_model::patch> stripes(static_cast<std::size_t>(size.width / pitch));
    for (std::size_t n = 0; n < stripes.size(); ++n)
        for (std::size_t i = 0; i < stripes[n].points.size(); ++i)
            stripes[n].points[i] = {
                (pitch * double(n) + width * double(i % 4) / 3 - size.width / 2.0) * unit,
                (double(i / 4) / 3 - 0.5) * (size.height + 2) * unit, 0.0};
    l3d_afd_settings settings = hard_edged();
    settings.antialias = true;
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), l3d_patch_model(stripes),
                              {.eye = {0, 0, 5}, .fov = 38}, settings);
    pipeline.draw_event();
    const double light =
        l3d_light_of_level(std::round(255 * (0.1 + 0.9 * 0.45 / std::sqrt(1.0025))));
    const std::vector<int> greys = pipeline_tests::greys_drawn(pipeline);
    double worst = 0;
    for (int x = 1; x + 1 < size.width; ++x) {
        double share = 0;
        for (std::size_t n = 0; n < stripes.size(); ++n)
            share += std::max(0.0, std::min(x + 1.0, pitch * double(n) + width) -
                                       std::max(double(x), pitch * double(n)));
        const double off =
            greys[static_cast<std::size_t>(6 * size.width + x)] - l3d_level_of_light(share * light);
        worst = std::max(worst, std::abs(off));
    }
    // What was measured: 4.3, and 38 where surfaces as near as a side hide it.
    EXPECT_LT(worst, 12);
}

} // namespace
