// SPDX-License-Identifier: MIT
// Outlines of surfaces that pass by the eye: smooth and without sparks.
#include "hard_edged.h"
#include "../dice/scene.h"
#include "../scene/bodies.h"
#include "beside_larger.h"

#include "pipeline/pipeline_afd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

/// Pixels that are farther than `levels` off.
int far_off(const std::vector<reference::patch>& patches, const reference::camera& view,
            double tolerance, l3d_size picture, int levels, double far = 1e16) {
    const auto greys = [&](l3d_size size, bool smooth) {
        dice_tests::scene scene(patches, view, size);
        scene.camera.far_z = far;
        l3d_afd_settings settings = hard_edged();
        settings.threads = 1;
        settings.tolerance = tolerance;
        settings.antialias = smooth;
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), scene.model, scene.camera, settings);
        pipeline.draw_event();
        return pipeline_tests::greys_drawn(pipeline);
    };
    return pipeline_tests::pixels_far_off(greys, picture, levels);
}

/// The same in a picture of a ball, from the side and looking past it.
int far_off(double distance, double height, double tolerance, int levels) {
    const reference::camera view{
        {distance, height, 0}, {distance + 0.05, 2, 3 * height}, {0, 1, 0.1}, 120, 0.1};
    return far_off(dice_tests::ball(), view, tolerance, {320, 240}, levels);
}

/// A sheet with the profile of a wave that runs towards the eye, `from` before it to `to` behind
/// it, and `turned` about the line of sight. It is seen edge on, as thin wedges.
std::vector<reference::patch> wave(double from, double to, double turned) {
    reference::patch result;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            const double x = -1 + static_cast<double>(column) / 1.5,
                         y = column % 2 == 0 ? -0.2 : 0.2;
            result.points[4 * row + column] = {std::cos(turned) * x - std::sin(turned) * y,
                                               std::sin(turned) * x + std::cos(turned) * y,
                                               -from + (from + to) * static_cast<double>(row) / 3};
        }
    return {result};
}

/// Patches cross the near plane there. The triangles of pieces that are clipped have no contours.
TEST(near_outline, is_smooth_where_patches_are_clipped) {
    // What was measured: 9, and 67 if pieces of 8 steps a strip are clipped.
    int far = 0;
    for (const double height : {0.0, 0.1, 0.2})
        far += far_off(1.2, height, 0.25, 30);
    EXPECT_LE(far, 20);
}

/// What is thinner than a pixel has a centre nowhere: the plane's cut alone tells where it ends.
/// Both sides of a wedge may lie a tolerance beside their places: at one pixel, it is that much too
/// wide or too narrow. What was measured: 4 pixels at 1 px, 3 at finer tolerances, at the wedges'
/// tips.
TEST(near_outline, is_seen_of_wedges_between_the_plane_and_a_border) {
    for (const double tolerance : {1.0, 0.25, 0.05})
        for (const double turned : {0.0, 0.4, 1.5}) {
            const reference::camera view{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 60, 0.05};
            EXPECT_LE(far_off(wave(2.5, 1.5, turned), view, tolerance, {160, 120}, 20), 4)
                << tolerance << " px, turned by " << turned;
        }
}

/// The far plane cuts likewise. A wedge's tip moves by several pixels if its sides are a tolerance
/// beside their places.
TEST(near_outline, is_seen_where_the_far_plane_cuts) {
    for (const double turned : {0.0, 0.4, 1.5}) {
        const reference::camera view{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 60, 0.05};
        EXPECT_LE(far_off(wave(9, -0.5, turned), view, 0.25, {160, 120}, 20, 3), 5) << turned;
    }
}

/// Where a surface folds over, a pixel's centre may have met a sliver of the back, as dark as what
/// is behind.
TEST(near_outline, has_no_sparks_of_the_back) {
    EXPECT_EQ(far_off(1.2, 0.1, 0.25, 60), 0);
    EXPECT_EQ(far_off(1.2, 0.3, 0.25, 60), 0);
    EXPECT_EQ(far_off(1.2, 0.1, 0.05, 60), 0);
}

} // namespace
