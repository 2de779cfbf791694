// SPDX-License-Identifier: MIT
// Boxes and ranges of depth hold the surface; what is called outside has no visible point.
#include "random_nets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace random_nets;

TEST(image_box, and_depth_range_hold_the_surface) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (int round = 0; round < 300; ++round) {
        const auto patch = random_patch(random, kinds[round % 3]);
        const auto box = l3d_image_box_of(patch.points).grown(1e-9);
        const auto depth = l3d_depth_range_of(patch.points);
        l3d_image_net net = random_patch(random, kinds[0]);
        for (int again = 0; again < 2; ++again) {
            EXPECT_EQ(net.box().left, l3d_image_box_of(net.points).left);
            EXPECT_EQ(net.w().most, l3d_depth_range_of(net.points).most);
            net = patch; // which forgets what was found
        }
        for (int i = 0; i < 20; ++i) {
            const double u = random.within(0, 1), v = random.within(0, 1);
            const point h = patch.evaluate(u, v);
            EXPECT_TRUE(holds(box, projected(h)));
            EXPECT_GE(h[2], depth.least - 1e-12);
            EXPECT_LE(h[2], depth.most + 1e-12);
        }
        for (const int corner : {0, 3, 12, 15}) { // the corners touch nothing if the box is off
            const pixel p = projected(patch.points[static_cast<std::size_t>(corner)]);
            EXPECT_LE(std::max({std::abs(p[0]), std::abs(p[1])}), box.reach());
        }
    }
}

/// Nets anywhere, also around and behind the eye.
TEST(image_box, outside_is_never_said_of_a_net_with_a_visible_point) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    constexpr double near = 0.25;
    int outside = 0, visible = 0, crossing = 0;
    for (int round = 0; round < 4000; ++round) {
        const double x = random.within(-3000, 3000), y = random.within(-2500, 2500);
        const double size = random.within(10, 2500), depth = random.within(-2, 4);
        l3d_image_patch patch;
        for (point& p : patch.points)
            p = {x + random.within(-size, size), y + random.within(-size, size),
                 depth + random.within(-1.5, 1.5)};
        const bool said = l3d_outside(patch.points, window, near);
        const auto range = l3d_depth_range_of(patch.points);
        bool seen = false;
        for (int i = 0; i <= 12 && !seen; ++i)
            for (int j = 0; j <= 12 && !seen; ++j) {
                const point h = patch.evaluate(i / 12.0, j / 12.0);
                seen = h[2] > near && holds(window, projected(h));
            }
        ASSERT_FALSE(said && seen);
        outside += said;
        visible += seen;
        crossing += seen && range.least < 0;
    }
    EXPECT_GT(outside, 800);
    EXPECT_GT(visible, 400);
    EXPECT_GT(crossing, 100) << "too few nets reach behind the eye";
    // A point that is clearly outside must be reported as outside.
    l3d_image_patch right;
    for (point& p : right.points) {
        const double w = random.within(1, 5);
        p = point{520 + random.within(0, 30), random.within(-300, 300), 1} * w;
    }
    EXPECT_TRUE(l3d_outside(right.points, window, near));
    EXPECT_FALSE(l3d_outside(right.points, window.grown(40), near));
    for (point& p : right.points)
        p = {random.within(-1, 1), random.within(-1, 1), random.within(-1, near)};
    EXPECT_TRUE(l3d_outside(right.points, window, near));
}

/// Control points that all project beyond one side, some from behind the eye: the surface between
/// them crosses the picture.
TEST(image_box, outside_is_not_told_from_projections_of_what_is_behind_the_eye) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (int round = 0; round < 200; ++round)
        for (const int axis : {0, 1})
            for (const double side : {-1.0, 1.0}) {
                l3d_image_patch patch;
                for (int r = 0; r < 4; ++r)
                    for (int c = 0; c < 4; ++c) {
                        const bool front = r < 2;
                        const double w = front ? random.within(2.5, 3.5) : random.within(-2.5, -2);
                        const double beyond =
                            front ? random.within(530, 700) : random.within(1500, 3000);
                        point& p = patch.at(r, c);
                        p[axis] = side * beyond * w;
                        p[1 - axis] = random.within(-200, 200);
                        p[2] = w;
                    }
                bool seen = false;
                for (int i = 0; i <= 100 && !seen; ++i) {
                    const point h = patch.evaluate(0.4, i / 100.0);
                    seen = h[2] > 0.25 && holds(window, projected(h));
                }
                ASSERT_TRUE(seen);
                ASSERT_FALSE(l3d_outside(patch.points, window, 0.25));
            }
}

} // namespace
