// SPDX-License-Identifier: MIT
// Smooth edges of what is thinner than a pixel.
#include "beside_larger.h"

#include "pipeline/pipeline_afd.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

/// Pixels that are far off in a picture that a teapot fills.
int far_off(const l3d_fog& fog) {
    const auto greys = [&](l3d_size size, bool smooth) {
        l3d_afd_settings settings;
        settings.threads = 1;
        settings.antialias = smooth;
        settings.fog = fog;
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), l3d_patch_model::teapot(),
                                  {.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0}}, settings);
        pipeline.frame_all();
        pipeline.draw_event();
        return pipeline_tests::greys_drawn(pipeline);
    };
    return pipeline_tests::pixels_far_off(greys, {320, 240}, 30);
}

/// Below the body a bright rim, half a pixel wide, lies between a dark side and the background.
TEST(thin_rim, is_no_row_of_beads) {
    // What was measured: 17, and 51 where the dark side's levels are taken for the rim's.
    EXPECT_LE(far_off({}), 25);
}

TEST(thin_rim, is_no_row_of_beads_in_fog) {
    // What was measured: 5, and 26 where the dark side's levels are taken for the rim's.
    EXPECT_LE(far_off({.near = 5, .far = 12, .color = 0x202020}), 10);
}

} // namespace
