// SPDX-License-Identifier: MIT
// Derivatives in double against intervals that hold the exact ones, and curvatures of a torus.
#include "geom/patch_jet.h"
#include "scene/inspected_scene.h"
#include "scene/picks/surface_jet.h"

#include "bodies.h"
#include "quadric.h"
#include "teapot_studio.h"

#include "geom/transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dice_tests {
namespace {

using reference::random_numbers;
using vector = l3d_patch_model::vector;
using net = l3d_bezier_patch<double, 3>;

TEST(patch_jet, is_within_rounding_of_the_intervals_of_its_slow_twin) {
    random_numbers random(5);
    int compared = 0;
    const l3d_patch_model teapot = teapot_model();
    for (const net& patch : teapot.patches())
        for (int i = 0; i < 40; ++i) {
            const double u = random.between(0, 1), v = random.between(0, 1);
            const l3d_surface_jet slow(patch, u, v, 0, 0, 0);
            const l3d_patch_jet fast = l3d_jet_of(patch, u, v);
            const l3d_patch_place place = l3d_place_of(patch, u, v);
            EXPECT_EQ(place.point, fast.point);
            EXPECT_EQ(place.along_u, fast.along_u);
            EXPECT_EQ(place.along_v, fast.along_v);
            const auto bend = l3d_bend_of(fast);
            if (!slow.normal || !bend)
                continue;
            ++compared;
            for (int k = 0; k < 3; ++k) {
                const auto at = static_cast<std::size_t>(k);
                EXPECT_NEAR(fast.point[k], slow.point[at].middle(), 1e-14);
                EXPECT_NEAR(bend->normal[k], (*slow.normal)[at].middle(),
                            (*slow.normal)[at].radius() + 1e-12);
            }
            EXPECT_NEAR(bend->gaussian, slow.gaussian.middle(),
                        slow.gaussian.radius() + 1e-9 * (1 + std::abs(bend->gaussian)));
            EXPECT_NEAR(bend->mean, slow.mean.middle(),
                        slow.mean.radius() + 1e-9 * (1 + std::abs(bend->mean)));
        }
    EXPECT_GT(compared, 1000);
}

TEST(patch_jet, tells_how_the_normal_turns) {
    const net patch = quadric{0.4, -0.7, 0.2}.model().patches()[0];
    constexpr double u = 0.3, v = 0.8, step = 1e-6;
    const auto normal = [&](double at_u, double at_v) {
        return l3d_bend_of(l3d_jet_of(patch, at_u, at_v))->normal;
    };
    const l3d_patch_bend bend = *l3d_bend_of(l3d_jet_of(patch, u, v));
    const vector du = (normal(u + step, v) - normal(u - step, v)) / (2 * step);
    const vector dv = (normal(u, v + step) - normal(u, v - step)) / (2 * step);
    EXPECT_LT(l3d_length(du - bend.normal_u), 1e-8);
    EXPECT_LT(l3d_length(dv - bend.normal_v), 1e-8);
}

/// Arcs of 90 degrees by cubics are off by 2.7e-4 of the radius, and their curvature by up
/// to 2.1 %, at their ends. Gaussian curvature is a product of two.
TEST(patch_jet, is_that_of_a_torus_as_far_as_arcs_are_circles) {
    constexpr double radius = 2, thickness = 0.7;
    double worst = 0;
    for (const reference::patch& from : ring(radius, thickness)) {
        net patch;
        for (std::size_t i = 0; i < 16; ++i)
            patch.points[i] = {from.points[i].x, from.points[i].y, from.points[i].z};
        for (int i = 0; i <= 20; ++i)
            for (int k = 0; k <= 20; ++k) {
                const l3d_patch_jet jet = l3d_jet_of(patch, i / 20.0, k / 20.0);
                const auto bend = l3d_bend_of(jet);
                ASSERT_TRUE(bend);
                const double rho = std::hypot(jet.point[0], jet.point[2]);
                const double cosine = (rho - radius) / thickness;
                const double exact = cosine / (thickness * rho);
                worst = std::max(worst, std::abs(bend->gaussian - exact));
                const double mean = (1 / thickness + cosine / rho) / 2;
                EXPECT_NEAR(-bend->mean, mean, 0.03);
            }
    }
    const double largest = 1 / (thickness * (radius - thickness));
    EXPECT_LT(worst, 0.043 * largest);
}

TEST(patch_jet, has_no_bend_where_a_side_is_a_point) {
    net patch = quadric{1, 0, 1}.model().patches()[0];
    for (int column = 0; column < 4; ++column)
        patch.at(0, column) = patch.at(0, 0);
    EXPECT_FALSE(l3d_bend_of(l3d_jet_of(patch, 0.4, 0)));
    EXPECT_TRUE(l3d_bend_of(l3d_jet_of(patch, 0.4, 1e-6)));
}

TEST(usual_curvature, is_above_nine_tenths_of_the_area_and_round) {
    const quadric saddle{0, 1, 0};
    l3d_patch_scene scene(saddle.model());
    EXPECT_EQ(l3d_usual_curvature(scene, l3d_shade::gaussian), 1);
    EXPECT_EQ(l3d_usual_curvature(scene, l3d_shade::mean), 0.2);
    scene.place(0, l3d_scaling<double>(100.0, 100.0, 100.0));
    EXPECT_EQ(l3d_usual_curvature(scene, l3d_shade::gaussian), 1e-4);
    EXPECT_EQ(l3d_usual_curvature(scene, l3d_shade::mean), 0.002);
    EXPECT_EQ(l3d_usual_curvature(quadric{0, 0, 0}.model(), l3d_shade::mean), 1);
    EXPECT_EQ(l3d_usual_curvature(l3d_patch_scene(), l3d_shade::gaussian), 1);
}

} // namespace
} // namespace dice_tests
