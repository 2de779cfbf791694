// SPDX-License-Identifier: MIT
// l3d_measured: places, normals and radii of surfaces that are known in closed form.
#include "scene/measured_place.h"

#include "geom/nurbs_surface.h"
#include "geom/transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace {

using vector = l3d_measured_place::vector;

constexpr l3d_size size{60, 60};

l3d_patch_model shape(const char* name) {
    return l3d_patch_model::from_surfaces(*l3d_exact_shape(name));
}

/// Calls `judge` for each place that picks find in a picture of the scene.
template <class Judge> void for_each_place(const l3d_patch_scene& scene, const Judge& judge) {
    const l3d_camera camera{.eye = {2.0, 3.0, 5.0}};
    int found = 0;
    for (int y = 0; y < size.height; y += 3)
        for (int x = 0; x < size.width; x += 3)
            if (const auto pick = l3d_pick_at(scene, {camera, size}, x + 0.37, y + 0.21)) {
                ++found;
                judge(l3d_measured(scene, *pick), camera);
            }
    EXPECT_GT(found, 20);
}

TEST(measured_place, of_a_sphere_is_the_exact_sphere) {
    for_each_place(shape("sphere"), [](const l3d_measured_place& at, const l3d_camera&) {
        EXPECT_LE(std::abs(l3d_length(at.point) - 1), at.point_error);
        EXPECT_LT(at.point_error, 1e-12);
        if (!std::isfinite(at.curvature_error))
            return; // at a pole
        EXPECT_LE(l3d_length(at.normal - at.point), at.normal_error + at.point_error);
        for (const double curvature : at.curvatures)
            EXPECT_LE(std::abs(curvature + 1), at.curvature_error);
    });
}

TEST(measured_place, of_a_torus_has_both_radii_under_its_placement) {
    l3d_patch_scene scene;
    scene.add(shape("torus"),
              l3d_translation<double>(0.3, -0.2, 0.1) * l3d_scaling<double>(0.5, 0.5, 0.5));
    for_each_place(scene, [](const l3d_measured_place& at, const l3d_camera& camera) {
        const vector p = (at.point - vector{0.3, -0.2, 0.1}) * 2.0;
        const double ring = std::hypot(p[0], p[2]);
        EXPECT_LE(std::abs(std::hypot(ring - 1, p[1]) - 0.4), 4 * at.point_error);
        EXPECT_GT(l3d_dot(at.normal, camera.eye - at.point), 0);
        // A tube of radius 0.2, and the way round: the cosine over the distance from the axis.
        const double across = 1 / 0.2, round = 2 * ((ring - 1) / 0.4) / ring;
        EXPECT_LE(std::abs(at.curvatures[0] + std::min(across, round)), at.curvature_error + 1e-13);
        EXPECT_LE(std::abs(at.curvatures[1] + std::max(across, round)), at.curvature_error + 1e-13);
        EXPECT_LT(at.curvature_error, 1e-4);
    });
}

TEST(measured_place, of_bicubic_patches_is_the_picks) {
    const l3d_patch_model teapot = l3d_patch_model::teapot();
    const l3d_patch_scene scene(teapot);
    const l3d_camera camera{.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}};
    const auto pick = l3d_pick_at(scene, {camera, size}, 30.2, 33.1);
    ASSERT_TRUE(pick);
    const l3d_measured_place at = l3d_measured(scene, *pick);
    EXPECT_EQ(at.point, pick->point);
    EXPECT_EQ(at.normal, pick->normal);
    const double mean = (at.curvatures[0] + at.curvatures[1]) / 2;
    EXPECT_NEAR(mean, pick->mean, at.curvature_error + pick->mean_error);
    EXPECT_NEAR(at.curvatures[0] * at.curvatures[1], pick->gaussian, 1e-6);
}

TEST(measured_place, tells_radii_with_their_error) {
    l3d_measured_place at;
    EXPECT_EQ(at.radii(), "");
    at.curvatures = {0.5, -2};
    at.curvature_error = 1e-9;
    EXPECT_EQ(at.radii(), "radii 0.5 and 2 units, good to 3e-10 and 4e-09");
    at.curvatures = {0, -2};
    EXPECT_EQ(at.radii(), "radius 0.5 units, good to 3e-10, and flat across");
    at.curvatures = {0, 0};
    EXPECT_EQ(at.radii(), "flat: no radius below 1e+09 units");
}

} // namespace
