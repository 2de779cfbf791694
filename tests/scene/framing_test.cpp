// SPDX-License-Identifier: MIT
// Cameras that frame a scene: what is seen of its points then.
#include "effort.h"
#include "scene/patch_scene.h"

#include "bodies.h"
#include "teapot_studio.h"

#include "geom/transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace dice_tests {
namespace {

using vector = l3d_camera::vector;

constexpr std::array sizes{l3d_size{1024, 768}, l3d_size{300, 900}, l3d_size{900, 300},
                           l3d_size{64, 64}};

/// The box of what a picture shows of a scene, in shares of half its width and height; and the
/// least depth.
struct seen_box {
    double left = 1e300, right = -1e300, top = 1e300, bottom = -1e300, depth = 1e300;

    double share() const { return std::max(right - left, bottom - top) / 2; }
    bool is_inside() const { return left >= -1 && right <= 1 && top >= -1 && bottom <= 1; }
};

seen_box seen(const l3d_patch_scene& scene, const l3d_camera& camera, l3d_size size) {
    const l3d_matrix<double> m = camera.image_matrix(size);
    constexpr int steps = 40;
    seen_box box;
    for (const l3d_patch_instance& instance : scene.instances())
        for (const auto& patch : instance.model().patches())
            for (int i = 0; i <= steps * steps; ++i) {
                const int row = i / steps, column = i % (steps + 1);
                const auto p = patch.evaluate(column / double{steps}, row / double{steps});
                const auto h =
                    m * (instance.placement() * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0));
                const double x = h[0] / h[3] / size.width * 2, y = h[1] / h[3] / size.height * 2;
                box = {std::min(box.left, x), std::max(box.right, x), std::min(box.top, y),
                       std::max(box.bottom, y), std::min(box.depth, h[3])};
            }
    return box;
}

/// Teapots that are tiny, huge, flat, long, far away and turned.
std::vector<std::pair<std::string, l3d_patch_scene>> scenes() {
    const l3d_patch_model teapot = teapot_model();
    std::vector<std::pair<std::string, l3d_patch_scene>> result;
    const auto add = [&](const char* name, const l3d_matrix<double>& placement) {
        result.emplace_back(name, l3d_patch_scene());
        result.back().second.add(teapot, placement);
    };
    const auto id = l3d_identity<double>();
    add("as it is", id);
    add("tiny", l3d_scaling<double>(1e-9, 1e-9, 1e-9));
    add("huge", l3d_scaling<double>(1e9, 1e9, 1e9));
    add("flat", l3d_scaling<double>(1, 1, 1e-6));
    add("a line", l3d_scaling<double>(1e-5, 1, 1e-5));
    add("along the line of sight", l3d_scaling<double>(0.1, 0.1, 3));
    add("off centre", l3d_translation<double>(1e4, -3e5, 2e3));
    add("turned", l3d_rotation_x<double>(77) * l3d_rotation_y<double>(191));
    add("upside down", l3d_rotation_z<double>(180) * l3d_scaling<double>(40, 3, 7));
    add("two of them", id);
    result.back().second.add(teapot, l3d_translation<double>(30, 20, -50));
    return result;
}

TEST(framing, fills_85_percent_of_the_picture_whatever_the_model) {
    l3d_camera any = oblique_camera();
    for (const auto& [name, scene] : scenes())
        for (const l3d_size size : sizes)
            for (const double fov : {20.0, 41.0, 110.0}) {
                if (!thorough && fov == 41.0)
                    continue;
                if (fov > 100 && name == "along the line of sight")
                    continue; // the eye is nearer than the points that are looked at are dense
                any.fov = fov;
                const l3d_camera camera = l3d_framed(any, size, l3d_reach_of(scene));
                const seen_box box = seen(scene, camera, size);
                const std::string what = name + ' ' + std::to_string(size.width);
                ASSERT_TRUE(camera.is_valid()) << what << camera.complaint();
                EXPECT_TRUE(box.is_inside()) << what;
                EXPECT_NEAR(box.share(), l3d_framed_share, 0.01) << what;
                EXPECT_GT(box.depth, camera.near_z) << what;
                // The side that fills less has its model in the middle, as perspective allows.
                const double middle = name == "along the line of sight" ? 0.8 : 0.4;
                EXPECT_LT(std::abs(box.left + box.right), middle) << what;
                EXPECT_LT(std::abs(box.top + box.bottom), middle) << what;
                const vector was = l3d_normalized(any.target - any.eye);
                const vector is = l3d_normalized(camera.target - camera.eye);
                EXPECT_LT(l3d_length(is - was), 1e-6) << what;
            }
}

TEST(framing, is_of_the_surface_and_not_of_its_control_points) {
    l3d_patch_model::patch hill;
    for (std::size_t i = 0; i < 16; ++i)
        hill.points[i] = {static_cast<double>(i % 4), static_cast<double>(i / 4), 0.0};
    for (const std::size_t i : {5U, 6U, 9U, 10U})
        hill.points[i][2] = 100; // the surface rises to 100 x (3/4)^2
    const l3d_patch_scene scene{l3d_patch_model(std::vector{hill})};
    const l3d_reach reach = l3d_reach_of(scene);
    EXPECT_NEAR(reach({0.0, 0.0, 1.0}), 56.25, 0.02);
    EXPECT_GE(reach({0.0, 0.0, 1.0}), 56.25);
    EXPECT_NEAR(reach({0.0, 0.0, -1.0}), 0, 0.02);
    EXPECT_NEAR(reach({-2.0, 0.0, 0.0}), 0, 1e-12);
}

TEST(framing, reaches_are_those_of_many_points) {
    reference::random_numbers random(7);
    for (const body_kind kind : {body_kind::bent, body_kind::toroidal, body_kind::starfish}) {
        std::vector<l3d_patch_model::patch> patches;
        for (const reference::patch& from : random_body(random, kind)) {
            patches.emplace_back();
            for (std::size_t i = 0; i < 16; ++i)
                patches.back().points[i] = {from.points[i].x, from.points[i].y, from.points[i].z};
        }
        l3d_patch_scene scene;
        scene.add(l3d_patch_model(patches),
                  l3d_translation<double>(3, 1, 2) * l3d_rotation_y<double>(40));
        const vector direction{random.between(-1, 1), random.between(-1, 1), 0.7};
        double most = -std::numeric_limits<double>::infinity();
        for (const auto& patch : patches)
            for (int i = 0; i <= 64 * 65; ++i) {
                const auto p = patch.evaluate(i % 65 / 64.0, i / 65 / 64.0);
                const auto w =
                    scene.instances()[0].placement() * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
                most = std::max(most, l3d_dot(direction, vector{w[0], w[1], w[2]}));
            }
        EXPECT_GE(l3d_reach_of(scene)(direction), most);
        EXPECT_NEAR(l3d_reach_of(scene)(direction), most, 2e-3);
    }
}

TEST(framing, by_parallel_projection_goes_by_the_targets_distance) {
    l3d_camera seen_from = oblique_camera();
    seen_from.projection = l3d_projection::parallel;
    for (const auto& [name, scene] : scenes())
        for (const l3d_size size : sizes) {
            const l3d_reach reach = l3d_reach_of(scene);
            const l3d_camera camera = l3d_framed(seen_from, size, reach);
            ASSERT_TRUE(camera.is_valid()) << name;
            const double pixels =
                camera.focal_length(size) / l3d_length(camera.target - camera.eye);
            const auto share = [&](const vector& axis, int side) {
                return (reach(axis) + reach(-axis)) * pixels / side;
            };
            const auto axes = camera.axes();
            EXPECT_NEAR(std::max(share(axes.right, size.width), share(axes.up, size.height)),
                        l3d_framed_share, 1e-6)
                << name;
        }
}

TEST(framing, of_nothing_and_of_a_point_leaves_a_camera) {
    const l3d_camera camera = oblique_camera();
    const l3d_patch_scene nothing;
    EXPECT_EQ(l3d_framed(camera, {64, 48}, l3d_reach_of(nothing)), camera);
    for (const double place : {0.0, 3e-7, 5.0, -7e11}) {
        l3d_patch_model::patch point;
        point.points.fill({place, -place, place});
        const l3d_patch_scene scene{l3d_patch_model(std::vector{point})};
        const l3d_camera framed = l3d_framed(camera, {64, 48}, l3d_reach_of(scene));
        EXPECT_TRUE(framed.is_valid()) << place << framed.complaint();
        EXPECT_GT(framed.depth_of({place, -place, place}), framed.near_z) << place;
    }
}

TEST(framing, shows_the_whole_of_the_largest_models) {
    l3d_patch_scene scene;
    scene.add(teapot_model(), l3d_scaling<double>(2.8e11, 2.8e11, 2.8e11));
    for (const l3d_size size : sizes)
        for (const double fov : {2.0, 38.0, 90.0}) {
            l3d_camera usual = oblique_camera();
            usual.fov = fov;
            const l3d_camera camera = l3d_framed(usual, size, l3d_reach_of(scene));
            ASSERT_TRUE(camera.is_valid()) << camera.complaint();
            const seen_box box = seen(scene, camera, size);
            EXPECT_TRUE(box.is_inside()) << fov;
            EXPECT_NEAR(box.share(), l3d_framed_share, 0.01) << fov;
            EXPECT_EQ(l3d_why_unseen(camera, size, l3d_reach_of(scene)), "") << fov;
        }
}

TEST(framing, never_leaves_the_world) {
    l3d_patch_scene scene;
    scene.add(teapot_model(), l3d_scaling<double>(2e11, 2e11, 2e11));
    l3d_camera usual = oblique_camera();
    usual.fov = 1e-3;
    const l3d_camera camera = l3d_framed(usual, {64, 48}, l3d_reach_of(scene));
    EXPECT_TRUE(camera.is_valid()) << camera.complaint();
}

TEST(framing, keeps_a_view_that_shows_all_of_it_large_enough) {
    const l3d_patch_scene scene(teapot_model());
    const l3d_reach reach = l3d_reach_of(scene);
    const l3d_camera usual{.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}};
    EXPECT_EQ(l3d_framed_unless_well(usual, {1024, 768}, reach), usual);
    EXPECT_NE(l3d_framed_unless_well(usual, {300, 900}, reach), usual) << "cut at its sides";
    l3d_camera far = usual;
    far.approach(2);
    EXPECT_FALSE(l3d_shows_well(far, {1024, 768}, reach)) << "smaller than 60 %";
    l3d_camera behind = usual;
    behind.eye = usual.eye + (usual.eye - usual.target);
    behind.target = behind.eye + (usual.eye - usual.target);
    EXPECT_FALSE(l3d_shows_well(behind, {1024, 768}, reach));
}

/// A ball of a tenth of the picture's depth that wanders from the middle to a border.
TEST(framing, keeps_no_view_that_has_a_model_at_one_side) {
    const l3d_camera camera{.eye = {0, 0, 10}, .target = {0, 0, 0}};
    const l3d_size size{400, 400};
    const double half = 10 * size.width / 2.0 / camera.focal_length(size);
    const auto shows_well = [&](double x, double y, double radius) {
        const l3d_reach reach = [=](const vector& direction) {
            return direction[0] * x + direction[1] * y + radius * l3d_length(direction);
        };
        return l3d_shows_well(camera, size, reach);
    };
    const double radius = 0.62 * half;
    EXPECT_TRUE(shows_well(0, 0, radius));
    const double room = half - radius;
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        EXPECT_TRUE(shows_well(0.1 * room * x, 0.1 * room * y, radius));
        EXPECT_FALSE(shows_well(0.7 * room * x, 0.7 * room * y, radius)) << x << ", " << y;
    }
}

TEST(framing, why_nothing_is_seen_is_told_in_words) {
    const l3d_patch_scene scene(teapot_model());
    const l3d_reach reach = l3d_reach_of(scene);
    const l3d_camera usual{.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}};
    const auto why = [&](l3d_camera camera, bool parallel = false) {
        if (parallel)
            camera.projection = l3d_projection::parallel;
        return l3d_why_unseen(camera, {64, 48}, reach);
    };
    EXPECT_EQ(why(usual), "");
    const l3d_patch_scene nothing;
    EXPECT_EQ(l3d_why_unseen(usual, {64, 48}, l3d_reach_of(nothing)), "without any surface");
    l3d_camera camera = usual;
    camera.target = camera.eye + (usual.eye - usual.target);
    EXPECT_EQ(why(camera), "behind the eye");
    EXPECT_EQ(why(camera, true), "") << "nothing is behind the eye there";
    camera = usual;
    camera.near_z = 100;
    EXPECT_EQ(why(camera), "nearer than the near plane");
    camera.near_z = 0.1;
    camera.far_z = 0.2;
    EXPECT_EQ(why(camera), "beyond the far plane");
    for (const auto& by : {vector{15.0, 0.0, 0.0}, vector{-12.0, 0.0, 0.0}, vector{0.0, 8.0, 0.0},
                           vector{0.0, -8.0, 0.0}})
        for (const bool parallel : {false, true}) {
            camera = usual;
            camera.move(by);
            EXPECT_EQ(why(camera, parallel), "outside of the picture");
        }
    camera = usual;
    camera.approach(100);
    EXPECT_EQ(why(camera), "smaller than a pixel");
    EXPECT_EQ(why(camera, true), "smaller than a pixel");
    camera = usual;
    camera.approach(20);
    EXPECT_EQ(why(camera), "") << "a pixel or two";
}

TEST(upright, is_what_a_person_sees_who_stands_before_a_model) {
    const l3d_upright y({0.0, 2.0, 0.0}), z({0.0, 0.0, 1e-200});
    EXPECT_EQ(y.right, (vector{1.0, 0.0, 0.0}));
    EXPECT_EQ(y.front, (vector{0.0, 0.0, 1.0}));
    EXPECT_EQ(z.right, (vector{1.0, 0.0, 0.0}));
    EXPECT_EQ(z.front, (vector{0.0, -1.0, 0.0}));
    EXPECT_EQ(z.at(2, 3, 5), (vector{2.0, -5.0, 3.0}));
}

} // namespace
} // namespace dice_tests
