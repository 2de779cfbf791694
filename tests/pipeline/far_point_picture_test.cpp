// SPDX-License-Identifier: MIT
// Frames of scenes with points at the end of the world: their near plane, picture and bound.
#include "hard_edged.h"
#include "drawn_picture.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace pipeline_tests {
namespace {

constexpr l3d_size size{320, 240};

reference::patch strip_to(double x) {
    reference::patch result;
    for (std::size_t i = 0; i < 16; ++i)
        result.points[i] = {x, static_cast<double>(i % 4), static_cast<double>(i / 4)};
    return result;
}

picture teapot_beside(const std::vector<reference::patch>& more) {
    dice_tests::scene s = dice_tests::teapot(reference::project_view("full"), size);
    std::vector<reference::patch> patches = s.patches;
    patches.insert(patches.end(), more.begin(), more.end());
    const dice_tests::scene both(patches, s.eye, size);
    l3d_afd_settings settings = hard_edged();
    settings.tolerance = 0.25;
    settings.outlines = true;
    return drawn(both, both.model, settings);
}

TEST(far_point_picture, is_the_same_beside_what_is_not_seen) {
    const picture alone = teapot_beside({});
    for (const double x : {1e11, 1e12, -1e12}) {
        const picture beside = teapot_beside({strip_to(x)});
        EXPECT_EQ(beside.words, alone.words) << x;
        EXPECT_NEAR(beside.report.dice.bound_px, alone.report.dice.bound_px, 1e-9) << x;
        EXPECT_EQ(beside.report.near_z, alone.report.near_z) << x;
        EXPECT_EQ(beside.report.outline_pixels, alone.report.outline_pixels) << x;
        EXPECT_TRUE(beside.outlines == alone.outlines) << x;
    }
}

/// With points at 1e12, w is off by 0.02: nothing nearer than 0.7 can be drawn of such a patch.
TEST(far_point_picture, near_is_pushed_away_only_where_something_is_cut_off) {
    const picture alone = teapot_beside({});
    const reference::view& view = reference::project_view("full");
    const reference::camera_frame frame(view.eye, {size.width, size.height});
    reference::patch wide;
    for (std::size_t i = 0; i < 16; ++i) {
        // From beside the eye to far behind what is looked at.
        const double along = i % 4 == 0 ? view.eye.near * 2 : i % 4 == 3 ? 1e12 : 100.0;
        wide.points[i] = frame.unproject(size.width / 2.0 + 10 * static_cast<double>(i / 4),
                                         size.height * 0.9, along);
    }
    const picture cut = teapot_beside({wide});
    EXPECT_GT(cut.report.near_z, 2 * alone.report.near_z);
    for (reference::vec3& point : wide.points)
        point = frame.unproject(3, 3, 1e12);
    EXPECT_EQ(teapot_beside({wide}).report.near_z, alone.report.near_z);
}

} // namespace
} // namespace pipeline_tests
