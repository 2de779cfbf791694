// SPDX-License-Identifier: MIT
// A model that is given twice looks as if it were given once.
#include "hard_edged.h"
#include "../scene/bodies.h"
#include "drawn_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace {

/// Pixels that differ by more than a level.
int different_pixels(const dice_tests::scene& scene, double tolerance) {
    l3d_afd_settings settings = hard_edged();
    settings.threads = 1;
    settings.tolerance = tolerance;
    settings.antialias = true;
    l3d_patch_scene once, twice;
    once.add(scene.model);
    twice.add(scene.model);
    twice.add(scene.model);
    const auto of_once = pipeline_tests::drawn(scene, once, settings).words,
               of_twice = pipeline_tests::drawn(scene, twice, settings).words;
    int result = 0, most = 0;
    for (std::size_t i = 0; i < of_once.size(); ++i) {
        const int apart =
            std::abs(static_cast<int>(of_once[i] & 255) - static_cast<int>(of_twice[i] & 255));
        most = std::max(most, apart);
        result += apart > 1;
    }
    std::printf("%.2f px: %d pixels differ, by %d at most\n", tolerance, result, most);
    return result;
}

TEST(twice, has_the_outlines_of_once) {
    const dice_tests::scene teapot =
        dice_tests::teapot(reference::project_views().front(), {160, 120});
    const dice_tests::scene ring(dice_tests::ring(1, 0.4),
                                 {{1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 38, 0.1}, {160, 120});
    // What was measured: 3, 2 and 0. If all counts twice: 217, 131 and 311. Triangles of slits do,
    // as both neighbours close a slit by the same ones.
    EXPECT_LE(different_pixels(teapot, 0.25), 10);
    EXPECT_LE(different_pixels(teapot, 0.02), 10);
    EXPECT_LE(different_pixels(ring, 0.25), 10);
}

} // namespace
