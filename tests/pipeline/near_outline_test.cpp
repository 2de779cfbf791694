// SPDX-License-Identifier: MIT
// Outlines of surfaces that pass by the eye: smooth and without sparks.
#include "hard_edged.h"
#include "../dice/scene.h"
#include "../scene/bodies.h"
#include "beside_larger.h"

#include "pipeline/pipeline_afd.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

/// Pixels that are farther than `levels` off in a picture of a ball, from the side and looking
/// past it.
int far_off(double distance, double height, double tolerance, int levels) {
    const reference::camera view{
        {distance, height, 0}, {distance + 0.05, 2, 3 * height}, {0, 1, 0.1}, 120, 0.1};
    const auto greys = [&](l3d_size size, bool smooth) {
        const dice_tests::scene scene(dice_tests::ball(), view, size);
        l3d_afd_settings settings = hard_edged();
        settings.threads = 1;
        settings.tolerance = tolerance;
        settings.antialias = smooth;
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), scene.model, scene.camera, settings);
        pipeline.draw_event();
        return pipeline_tests::greys_drawn(pipeline);
    };
    return pipeline_tests::pixels_far_off(greys, {320, 240}, levels);
}

/// Patches cross the near plane there. The triangles of pieces that are clipped have no contours.
TEST(near_outline, is_smooth_where_patches_are_clipped) {
    // What was measured: 9, and 67 if pieces of 8 steps a strip are clipped.
    int far = 0;
    for (const double height : {0.0, 0.1, 0.2})
        far += far_off(1.2, height, 0.25, 30);
    EXPECT_LE(far, 20);
}

/// Where a surface folds over, a pixel's centre may have met a sliver of the back, as dark as what
/// is behind.
TEST(near_outline, has_no_sparks_of_the_back) {
    EXPECT_EQ(far_off(1.2, 0.1, 0.25, 60), 0);
    EXPECT_EQ(far_off(1.2, 0.3, 0.25, 60), 0);
    EXPECT_EQ(far_off(1.2, 0.1, 0.05, 60), 0);
}

} // namespace
