// SPDX-License-Identifier: MIT
// Bodies that are proven closed, and what is then left out of their pictures.
#include "scene/bodies.h"
#include "picture.h"
#include "scene.h"

#include "scene/model_eye.h"
#include "reference/measure.h"
#include "reference/random_patches.h"
#include "scene/culling/facing_cones.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace dice_tests {
namespace {

constexpr l3d_size size{320, 240};
using vector = l3d_facing_cones::vector;

reference::camera at(double x, double y, double z) {
    reference::camera eye;
    eye.eye = {x, y, z};
    eye.target = {0.1, -0.05, 0.02};
    return eye;
}

int orientation(const std::vector<reference::patch>& patches) {
    return scene(patches, at(3, 2, 4), size).model.orientation();
}

TEST(closed_body, is_proven_of_a_ball_whichever_way_it_is_turned) {
    EXPECT_EQ(orientation(ball()), 1);
    EXPECT_EQ(orientation(inside_out(ball())), -1);
}

TEST(closed_body, is_not_proven_where_anything_is_missing_or_wrong) {
    const std::vector<reference::patch> whole = ball();
    std::vector<reference::patch> open = whole;
    open.pop_back();
    EXPECT_EQ(orientation(open), 0);
    std::vector<reference::patch> cracked = whole;
    cracked[2].points[1].x += 1e-9;
    EXPECT_EQ(orientation(cracked), 0);
    std::vector<reference::patch> doubled = whole;
    doubled.insert(doubled.end(), whole.begin(), whole.end());
    EXPECT_EQ(orientation(doubled), 0);
    std::vector<reference::patch> one_turned = whole;
    one_turned[3] = inside_out({whole[3]})[0];
    EXPECT_EQ(orientation(one_turned), 0);
    std::vector<reference::patch> dented = whole; // beyond the middle
    dented[4].points[5].z = -2;
    EXPECT_EQ(orientation(dented), 0);
    EXPECT_EQ(orientation(ring(2, 0.7)), 0); // closed, but not star-shaped
    EXPECT_EQ(orientation(teapot(reference::project_view("full"), size).patches), 0);
}

TEST(facing_cones, never_call_a_block_turned_away_that_shows_its_front) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0, 1), place(-6, 6);
    int away = 0, really = 0;
    for (int i = 0; i < 3000; ++i) {
        l3d_bezier_patch<double, 3> patch;
        const double bumps = 0.6 * unit(random);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                patch.at(row, column) = {column + bumps * unit(random), row + bumps * unit(random),
                                         4 * bumps * unit(random)};
        const l3d_normal_net normals(patch);
        const vector eye{place(random), place(random), place(random)};
        const double side = i % 2 == 0 ? 1 : -1;
        const unsigned bits = l3d_facing_cones(patch, normals).away_from(eye, side);
        for (int block = 0; block < 16; ++block) {
            bool all = true;
            for (int sample = 0; sample < 25; ++sample) {
                const double u = (block % 4 + sample % 5 / 4.0) / 4;
                const double v = (block / 4 + sample / 5 / 4.0) / 4;
                all = all && side * l3d_dot(patch.evaluate(u, v) - eye, normals.evaluate(u, v)) > 0;
            }
            EXPECT_TRUE(all || (bits >> block & 1) == 0) << i << " block " << block;
            away += static_cast<int>(bits >> block & 1);
            really += all;
        }
    }
    std::printf("%d blocks turn away, %d are found\n", really, away);
    EXPECT_GT(away, really / 2);
    EXPECT_LT(really, 3000 * 16);
}

TEST(model_eye, the_eye_is_where_the_camera_is) {
    const scene s(ball(), at(3, 2, 4), size);
    l3d_patch_scene world(s.model);
    const l3d_image_transform to_image(s.camera, s.size, world);
    const auto eye = l3d_eye_of(to_image.matrix());
    ASSERT_TRUE(eye);
    EXPECT_NEAR((*eye)[0], 3, 1e-12);
    EXPECT_NEAR((*eye)[1], 2, 1e-12);
    EXPECT_NEAR((*eye)[2], 4, 1e-12);
    EXPECT_LE(l3d_least_w_of(s.model, to_image.matrix()) / to_image.view(1).depth_scale,
              std::sqrt(29.0) - 1);
}

TEST(closed_body, has_the_same_outline_without_its_back) {
    for (const auto& patches : {ball(), inside_out(ball())})
        for (const reference::camera& eye : {at(3, 2, 4), at(-2.4, 0.3, -1.6), at(0.2, -9, 0.4)})
            for (const double tolerance : {1.0, 0.1, 0.01}) { // the last in pieces
                if (!thorough && tolerance == 0.1)
                    continue;
                const scene s(patches, eye, size);
                const reference::exact_image exact(s.patches, s.eye, s.picture());
                const reference::exact_region region(s.patches, s.eye, s.picture());
                picture drawn(size, s.camera), whole(size, s.camera);
                const l3d_dice_counts counts = dice<float>(s, tolerance, drawn);
                dice<float>(s, tolerance, whole, l3d_culling_switches::all());
                const reference::measurement m =
                    reference::measure(drawn.distances(), exact, region);
                std::printf("%ld patches, %ld blocks left out; extra %.4f, missing %.4f of %.4f "
                            "px; the picture %s\n",
                            static_cast<long>(counts.backfacing),
                            static_cast<long>(counts.back_blocks), m.max_extra_distance,
                            m.max_missing_distance, counts.bound_px,
                            drawn.words() == whole.words() ? "is the same" : "differs");
                EXPECT_GE(16 * counts.backfacing + counts.back_blocks, 6 * 16 / 3);
                EXPECT_EQ(m.holes, 0);
                EXPECT_LE(m.max_extra_distance, counts.bound_px + 1e-3);
                EXPECT_LE(m.max_missing_distance, counts.bound_px * 1.02 + 5e-3);
            }
}

TEST(closed_body, shows_its_inside_to_an_eye_in_it) {
    const scene s(ball(), at(0.3, 0.2, -0.1), size);
    picture drawn(size, s.camera);
    const l3d_dice_counts counts = dice<float>(s, 0.25, drawn);
    EXPECT_EQ(counts.backfacing + counts.back_blocks, 0);
    EXPECT_EQ(drawn.uncovered(), 0);
}

} // namespace
} // namespace dice_tests
