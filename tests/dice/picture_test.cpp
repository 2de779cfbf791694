// SPDX-License-Identifier: MIT
// Whole pictures against the exact ones.
#include "picture.h"
#include "scene.h"

#include "reference/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace dice_tests {
namespace {

/// One scene with its exact picture.
struct judged {
    judged(std::string_view view, l3d_size size)
        : name(view), seen(teapot(reference::project_view(view), size)),
          exact(seen.patches, seen.eye, seen.picture()),
          region(seen.patches, seen.eye, seen.picture()) {}

    std::string_view name;
    scene seen;
    reference::exact_image exact;
    reference::exact_region region;
};

/// The judged part of a picture: all but outlines, jumps and the border. The least share, 87.3 %,
/// is that of `near_cut` in 320 x 240 pixels: thin rims of what the near plane cuts. In a picture
/// of half the size, they are twice as much of it.
double least_share(l3d_size size) {
    return 1 - 0.13 * std::max(1.0, 320.0 / size.width);
}

template <class T> void compare(const judged& j, double tolerance) {
    const l3d_size size = j.seen.size;
    SCOPED_TRACE(testing::Message() << name_of<T>() << " " << j.name << " " << size.width << "x"
                                    << size.height << " tolerance " << tolerance);
    picture drawn(size, j.seen.camera);
    const l3d_dice_counts counts = dice<T>(j.seen, tolerance, drawn);
    const std::vector<float> depth = drawn.distances();
    const reference::measurement m = reference::measure(depth, j.exact, j.region);
    const reference::shade_difference shade =
        reference::measure_lambert(drawn.greys(), depth, j.exact, reference::project_light);
    std::printf("%-6s %-8.*s %4dx%-4d tolerance %.2f: bound %.4f px; holes %ld, extra %ld (max "
                "%.4f px), missing %ld (max %.4f px); of %.1f %%: depth max %.3f mean %.4f px, "
                "grey max %d rms %.2f\n",
                name_of<T>(), static_cast<int>(j.name.size()), j.name.data(), size.width,
                size.height, tolerance, counts.bound_px, static_cast<long>(m.holes),
                static_cast<long>(m.extra), m.max_extra_distance, static_cast<long>(m.missing),
                m.max_missing_distance, 100 * m.depth_share(), m.max_depth_px, m.mean_depth_px,
                shade.max, shade.rms);
    EXPECT_GT(m.covered_exact, 20);
    EXPECT_TRUE(m.distances_complete);
    EXPECT_EQ(m.holes, 0);
    // A covered pixel's centre is a drawn point. The reference is good to 1e-4 and 1 %.
    EXPECT_LE(m.max_extra_distance, counts.bound_px + 1e-3);
    EXPECT_LE(m.max_missing_distance, counts.bound_px * 1.02 + 5e-3);
    // Both in tolerances; where two surfaces meet, single pixels show the other one.
    EXPECT_LE(m.mean_depth_px, tolerance);
    if (m.depth_compared > 1000) {
        EXPECT_LE(shade.rms, 6);
        EXPECT_GT(m.depth_share(), least_share(size));
        EXPECT_EQ(shade.share(), m.depth_share());
    }
}

TEST(pictures, the_teapot_is_exact_within_the_bound_in_every_view) {
    for (const reference::view& view : reference::project_views()) {
        const bool is_large = thorough || view.name == "tiny"; // which else has too few pixels
        const judged j(view.name, is_large ? l3d_size{320, 240} : l3d_size{160, 120});
        for (const double tolerance : {1.0, 0.25}) {
            compare<float>(j, tolerance);
            if (!thorough && tolerance < 1)
                continue;
            compare<double>(j, tolerance);
            compare<fixed>(j, tolerance);
        }
    }
}

TEST(pictures, large_ones_are_exact_within_the_bound_too) {
    if (sanitized)
        GTEST_SKIP() << "too slow with sanitizers";
    for (const std::string_view name : {"full", "near_cut"}) {
        const judged j(name, {1024, 768});
        compare<float>(j, 0.25);
        compare<fixed>(j, 0.05);
    }
    compare<float>(judged("closeup", {1920, 1080}), 0.25);
}

/// Some five minutes: every view, large, in every number type.
TEST(pictures, DISABLED_large_ones_are_exact_in_every_view) {
    for (const reference::view& view : reference::project_views())
        for (const l3d_size size : {l3d_size{1024, 768}, l3d_size{1920, 1080}}) {
            const judged j(view.name, size);
            for (const double tolerance : {0.25, 0.05}) {
                compare<float>(j, tolerance);
                compare<double>(j, tolerance);
                compare<fixed>(j, tolerance);
            }
        }
}

} // namespace
} // namespace dice_tests
