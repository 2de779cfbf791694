// SPDX-License-Identifier: MIT
// Picks against the exact reference, within the errors that they state.
#include "scene/patch_scene.h"

#include "bodies.h"
#include "quadric.h"
#include "teapot_studio.h"

#include "geom/transform.h"
#include "reference/random_numbers.h"
#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dice_tests {
namespace {

using reference::random_numbers;
using vector = l3d_camera::vector;

constexpr l3d_size size{157, 118};
/// A coordinate of the reference is rounded once to double.
constexpr double rounded = 4e-16;

std::vector<reference::patch> reference_patches(const l3d_patch_model& model,
                                                const l3d_matrix<double>& placement) {
    std::vector<reference::patch> result;
    for (const auto& from : model.patches()) {
        result.emplace_back();
        for (std::size_t i = 0; i < 16; ++i) {
            const auto& p = from.points[i];
            const auto w = placement * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
            result.back().points[i] = {w[0], w[1], w[2]};
        }
    }
    return result;
}

l3d_patch_model library_model(const std::vector<reference::patch>& from) {
    std::vector<l3d_patch_model::patch> patches(from.size());
    for (std::size_t p = 0; p < from.size(); ++p)
        for (std::size_t i = 0; i < 16; ++i)
            patches[p].points[i] = {from[p].points[i].x, from[p].points[i].y, from[p].points[i].z};
    return l3d_patch_model(patches);
}

reference::camera reference_camera(const l3d_camera& of) {
    const auto v = [](const vector& a) { return reference::vec3{a[0], a[1], a[2]}; };
    return {v(of.eye), v(of.target), v(of.up), of.fov, of.near_z};
}

double length(const reference::vec3& a, const vector& b) {
    return std::hypot(a.x - b[0], a.y - b[1], a.z - b[2]);
}

/// The parameters at which the exact surface is seen exactly at (x, y), by Newton's method in long
/// double from where a pick found them. Nothing if it does not come to rest.
std::optional<std::array<long double, 2>> exact_parameters(const reference::patch& patch,
                                                           const reference::camera& camera,
                                                           const l3d_pick& pick, long double x,
                                                           long double y) {
    const reference::camera_frame frame(camera, {size.width, size.height});
    const auto off = [&](long double u, long double v) {
        const auto h = reference::exact_homogeneous(patch, frame, u, v);
        return std::array{h.x - x * h.w, h.y - y * h.w};
    };
    long double u = pick.u, v = pick.v, last = 1;
    for (int i = 0; i < 40; ++i) {
        constexpr long double h = 0x1p-16L; // central differences of a cubic are off by h^2
        const auto f = off(u, v);
        const auto u0 = off(u - h, v), u1 = off(u + h, v), v0 = off(u, v - h), v1 = off(u, v + h);
        const long double a = (u1[0] - u0[0]) / (2 * h), b = (v1[0] - v0[0]) / (2 * h);
        const long double c = (u1[1] - u0[1]) / (2 * h), d = (v1[1] - v0[1]) / (2 * h);
        const long double determinant = a * d - b * c;
        if (determinant == 0)
            return std::nullopt;
        const long double du = (d * f[0] - b * f[1]) / determinant;
        const long double dv = (a * f[1] - c * f[0]) / determinant;
        u -= du;
        v -= dv;
        last = std::max(std::abs(du), std::abs(dv));
    }
    if (!(last < 1e-16L))
        return std::nullopt;
    return std::array{u, v};
}

struct tally {
    int picks = 0, unproven = 0, nothing = 0;
    double worst_point = 0, worst_normal = 0; ///< as shares of the stated errors
};

/// Compares what is picked in the middles of every `step`-th pixel with the exact picture.
void compare(const l3d_patch_scene& scene, const std::vector<reference::patch>& patches,
             const l3d_camera& camera, int step, tally& counts) {
    const reference::camera view = reference_camera(camera);
    const reference::exact_image exact(patches, view, {size.width, size.height});
    for (int i = 0; i < size.width * size.height; i += step) {
        const int x = i % size.width, y = i / size.width;
        const auto pick = l3d_pick_at(scene, {camera, size}, x + 0.5, y + 0.5);
        const reference::exact_sample& sample = exact.at(x, y);
        const std::string where = std::to_string(x) + ',' + std::to_string(y);
        if (pick && !pick->is_proven) {
            ++counts.unproven;
            continue;
        }
        ASSERT_EQ(pick.has_value(), sample.covered()) << where;
        if (!pick) {
            ++counts.nothing;
            continue;
        }
        ++counts.picks;
        // The reference says which surface is in front; its points are good to 1e-11 px.
        EXPECT_NEAR(pick->depth, sample.w, 1e-9 * sample.w) << where;
        const auto at = exact_parameters(patches[pick->patch], view, *pick, x + 0.5L, y + 0.5L);
        if (!at)
            continue;
        EXPECT_LE(std::abs(static_cast<double>((*at)[0] - pick->u)), pick->u_error) << where;
        EXPECT_LE(std::abs(static_cast<double>((*at)[1] - pick->v)), pick->v_error) << where;
        const auto point = reference::exact_point(patches[pick->patch], view,
                                                  {size.width, size.height}, (*at)[0], (*at)[1]);
        const double off = length(point.world, pick->point);
        const double size_of_point = std::hypot(point.world.x, point.world.y, point.world.z);
        EXPECT_LE(off, pick->point_error + rounded * size_of_point) << where;
        counts.worst_point = std::max(counts.worst_point, off / pick->point_error);
        if (pick->normal == vector{0.0, 0.0, 0.0})
            continue;
        const vector normal = pick->normal;
        const double off_normal =
            std::min(length(point.normal, normal), length(point.normal, -normal));
        EXPECT_LE(off_normal, pick->normal_error + rounded) << where;
        counts.worst_normal = std::max(counts.worst_normal, off_normal / pick->normal_error);
    }
}

TEST(pick, twenty_and_more_of_the_teapot_keep_their_errors) {
    tally counts;
    const l3d_patch_model teapot = teapot_model();
    const auto patches = reference_patches(teapot, l3d_identity<double>());
    compare(teapot, patches, oblique_camera(), 37, counts);
    compare(teapot, patches, {.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}}, 31, counts);
    EXPECT_GT(counts.picks, 200);
    EXPECT_GT(counts.nothing, 100);
    EXPECT_LE(counts.unproven, 1);
    EXPECT_LE(counts.worst_point, 1);
    std::printf("%d picks, %d unproven; of stated errors: points %.3f, normals %.3f\n",
                counts.picks, counts.unproven, counts.worst_point, counts.worst_normal);
}

TEST(pick, of_random_patches_of_every_kind_keep_their_errors) {
    l3d_camera camera = oblique_camera();
    for (const auto& [kind, name] : reference::patch_kinds) {
        SCOPED_TRACE(name);
        tally counts;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const auto patches = reference::random_patches(seed, kind, 12, reference_camera(camera),
                                                           {size.width, size.height});
            compare(library_model(patches), patches, camera, 61, counts);
        }
        std::printf("%s: %d picks, %d unproven; points %.3f, normals %.3f\n", name, counts.picks,
                    counts.unproven, counts.worst_point, counts.worst_normal);
        EXPECT_GT(counts.picks + counts.nothing, 500);
        EXPECT_LE(counts.unproven, 20);
    }
}

TEST(pick, names_the_part_of_what_is_shown) {
    const l3d_patch_model teapot = l3d_patch_model::teapot();
    const l3d_camera camera{.eye = {0.3, 9.0, 0.2}, .target = {3.0, 2.3, 0.0}};
    const l3d_size picture{64, 48};
    const auto spout = l3d_pick_at(teapot, {camera, picture}, 32, 24);
    ASSERT_TRUE(spout);
    EXPECT_EQ(spout->part, "spout");
    EXPECT_NE(spout->text().find("\npart spout\n"), std::string::npos) << spout->text();
    EXPECT_TRUE(spout->line().starts_with("spout, patch ")) << spout->line();
    const std::array<std::size_t, 1> hidden{*teapot.parts().find("spout")};
    const auto other = l3d_pick_at(teapot.without(hidden), {camera, picture}, 32, 24);
    EXPECT_FALSE(other && other->part == "spout");
    const auto nameless = l3d_pick_at(teapot.with_parts({}), {camera, picture}, 32, 24);
    ASSERT_TRUE(nameless);
    EXPECT_EQ(nameless->text().find("part"), std::string::npos);
}

TEST(pick, of_placed_models_tells_the_instance) {
    const auto placement = l3d_translation<double>(0.5, -1, 1) * l3d_rotation_z<double>(31) *
                           l3d_scaling<double>(-0.4, 0.5, 0.6);
    l3d_patch_scene scene;
    scene.add(teapot_model(), l3d_translation<double>(0, 0, -300));
    scene.add(teapot_model(), placement);
    const auto patches = reference_patches(teapot_model(), placement);
    tally counts;
    const l3d_camera camera = oblique_camera();
    const auto h =
        camera.image_matrix(size) * (placement * l3d_vector<double, 4>(0.0, 1.5, 0.0, 1.0));
    const auto pick = l3d_pick_at(scene, {camera, size}, size.width / 2.0 + h[0] / h[3],
                                  size.height / 2.0 + h[1] / h[3]);
    ASSERT_TRUE(pick);
    EXPECT_EQ(pick->instance, 1u);
    l3d_patch_scene alone;
    alone.add(teapot_model(), placement);
    compare(alone, patches, oblique_camera(), 41, counts);
    EXPECT_GT(counts.picks, 30);
}

TEST(pick, beyond_a_clipping_plane_is_what_lies_behind) {
    l3d_camera camera = oblique_camera();
    const l3d_patch_scene scene(teapot_model());
    const auto front = l3d_pick_at(scene, {camera, size}, 64, 40);
    ASSERT_TRUE(front);
    camera.near_z = front->depth * 1.001;
    const auto behind = l3d_pick_at(scene, {camera, size}, 64, 40);
    ASSERT_TRUE(behind);
    EXPECT_GT(behind->depth, camera.near_z);
    camera.near_z = 0.1;
    camera.far_z = front->depth * 0.999;
    EXPECT_FALSE(l3d_pick_at(scene, {camera, size}, 64, 40));
    tally counts;
    camera = oblique_camera();
    camera.near_z = l3d_length(camera.eye - camera.target);
    compare(scene, reference_patches(teapot_model(), l3d_identity<double>()), camera, 37, counts);
    EXPECT_GT(counts.picks, 50);
}

TEST(pick, curvatures_are_those_of_closed_forms) {
    const l3d_camera camera{.eye = {0.3, -0.4, 9.0}, .target = {0.1, 0.0, 0.0}};
    random_numbers random(3);
    int picks = 0;
    for (int i = 0; i < 300; ++i) {
        const double a = random.between(-2, 2), b = random.between(-2, 2),
                     c = random.between(-2, 2);
        const quadric exact{a, b, c};
        const auto pick = l3d_pick_at(exact.model(), {camera, size}, random.between(50, 100),
                                      random.between(30, 90));
        if (!pick || !pick->is_proven)
            continue;
        ++picks;
        const double x = pick->point[0], y = pick->point[1];
        EXPECT_NEAR(pick->point[2], a * x * x + b * x * y + c * y * y, 1e-13);
        const double mean = exact.mean(x, y) * (pick->normal[2] < 0 ? -1 : 1);
        // Of the closed forms themselves, since x and y are off by the pick's error.
        EXPECT_NEAR(pick->gaussian, exact.gaussian(x, y), pick->gaussian_error + 1e-13);
        EXPECT_NEAR(pick->mean, mean, pick->mean_error + 1e-13);
        EXPECT_LT(pick->gaussian_error, 1e-10);
        EXPECT_LT(pick->mean_error, 1e-10);
    }
    EXPECT_GT(picks, 150);
}

TEST(pick, at_the_tip_of_the_lid_is_proven_as_the_tip_is_a_small_plane) {
    // Seen from straight above, (0, 3, 0) is in the middle. Control points beside it are 0.002
    // away.
    const l3d_camera camera{
        .eye = {0.0, 20.0, 0.0}, .target = {0.0, 0.0, 0.0}, .up = {0.0, 0.0, -1.0}};
    for (const double beside : {0.0, 1e-12, 1e-9, 1e-6}) {
        const auto tip = l3d_pick_at(teapot_model(), {camera, {64, 48}}, 32 + beside, 24 - beside);
        ASSERT_TRUE(tip);
        EXPECT_LE(std::abs(tip->point[1] - 3), tip->point_error);
        EXPECT_LT(tip->point_error, 1e-8);
        EXPECT_LE(l3d_length(tip->normal - vector{0.0, 1.0, 0.0}), tip->normal_error + beside);
    }
}

TEST(pick, at_a_pole_where_an_edge_is_a_point_has_no_normal_and_says_so) {
    const l3d_camera camera{
        .eye = {0.0, 20.0, 0.0}, .target = {0.0, 0.0, 0.0}, .up = {0.0, 0.0, -1.0}};
    const l3d_patch_scene scene(library_model(globe()));
    const auto pole = l3d_pick_at(scene, {camera, {64, 48}}, 32, 24);
    ASSERT_TRUE(pole);
    EXPECT_FALSE(pole->is_proven);
    EXPECT_LE(l3d_length(pole->point - vector{0.0, 1.0, 0.0}), pole->point_error);
    EXPECT_LT(pole->point_error, 1e-9);
    EXPECT_EQ(pole->normal, (vector{0.0, 0.0, 0.0}));
    EXPECT_TRUE(std::isinf(pole->normal_error) && std::isinf(pole->gaussian_error));
    // A millionth of a pixel beside it there is one.
    const auto beside = l3d_pick_at(scene, {camera, {64, 48}}, 32 + 1e-6, 24 + 2e-6);
    ASSERT_TRUE(beside);
    EXPECT_TRUE(beside->is_proven);
    EXPECT_NEAR(beside->normal[1], 1, 1e-5);
}

/// A paraboloid seen from its side: the ray touches it in one point.
TEST(pick, at_a_silhouette_tells_how_blurred_it_is) {
    const l3d_camera camera{
        .eye = {0.0, -30.0, 0.0}, .target = {0.0, 0.0, 0.0}, .up = {0.0, 0.0, 1.0}};
    const l3d_patch_model hill = quadric{-1, 0, -1}.model();
    const auto touching = l3d_pick_at(hill, {camera, {64, 48}}, 32, 24);
    ASSERT_TRUE(touching);
    EXPECT_FALSE(touching->is_proven);
    EXPECT_LE(l3d_length(touching->point), touching->point_error);
    EXPECT_LT(touching->point_error, 1e-4);
    EXPECT_FALSE(l3d_pick_at(hill, {camera, {64, 48}}, 32, 24 - 1e-9)) << "just above";
    const auto below = l3d_pick_at(hill, {camera, {64, 48}}, 32, 24 + 1e-9);
    ASSERT_TRUE(below);
    EXPECT_TRUE(below->is_proven);
}

TEST(pick, of_a_plane_seen_edge_on_ends) {
    const l3d_camera camera{
        .eye = {0.2, -30.0, 0.0}, .target = {0.2, 0.0, 0.0}, .up = {0.0, 0.0, 1.0}};
    const auto edge = l3d_pick_at(quadric{0, 0, 0}.model(), {camera, {64, 48}}, 32, 24);
    ASSERT_TRUE(edge);
    EXPECT_FALSE(edge->is_proven);
    EXPECT_LE(std::abs(edge->depth - 29), edge->point_error);
}

TEST(pick, a_border_that_patches_share_has_no_gap) {
    random_numbers random(11);
    const auto patches = ball();
    const l3d_patch_scene scene(library_model(patches));
    const l3d_camera camera{.eye = {0.0, 0.0, 5.0}, .target = {0.0, 0.0, 0.0}};
    // Rays towards points of borders, as exactly as doubles tell them.
    for (int i = 0; i < 2000; ++i) {
        const auto& patch = scene.instances()[0].model().patches()[random.below(patches.size())];
        const double t = random.between(0, 1);
        const auto p = patch.evaluate(random.below(2) == 0 ? t : 1, 1.0);
        const vector arm = vector{p[0], p[1], p[2]} - camera.eye;
        if (p[2] < 0.4)
            continue;
        const double focal = camera.focal_length(size), depth = -arm[2];
        const auto pick =
            l3d_pick_at(scene, {camera, size}, size.width / 2.0 + focal * arm[0] / depth,
                        size.height / 2.0 - focal * arm[1] / depth);
        ASSERT_TRUE(pick) << t;
        // The pixel's coordinates are rounded, too: across a slanted surface that goes far.
        EXPECT_LT(l3d_length(pick->point - vector{p[0], p[1], p[2]}), 1e-10);
    }
}

TEST(pick, one_sided_looks_through_backs) {
    const auto outside = library_model(ball()), inside = library_model(inside_out(ball()));
    const l3d_camera camera{.eye = {0.0, 0.0, 5.0}, .target = {0.0, 0.0, 0.0}};
    const auto depth = [&](const l3d_patch_model& model, const l3d_matrix<double>& placement,
                           bool one_sided) {
        l3d_patch_scene scene;
        scene.add(model, placement);
        const auto pick = l3d_pick_at(scene, {camera, size, one_sided}, 70.3, 51.2);
        return pick ? pick->depth : 0;
    };
    const auto id = l3d_identity<double>(), mirrored = l3d_scaling<double>(-1, 1, 1);
    EXPECT_LT(depth(outside, id, true), 5);
    EXPECT_GT(depth(inside, id, true), 5);
    EXPECT_LT(depth(inside, id, false), 5);
    EXPECT_LT(depth(outside, mirrored, true), 5) << "a mirrored model shows the same side";
}

TEST(pick, text_names_every_value_with_its_error) {
    const auto pick = l3d_pick_at(teapot_model(), {oblique_camera(), size}, 78, 59);
    ASSERT_TRUE(pick);
    const std::string text = pick->text();
    for (const char* const name :
         {"patch ", "\npart ", "\nu ", "\nv ", "\npoint ", "\ndepth ", "\nnormal ",
          "\ngaussian-curvature ", "\nmean-curvature ", "\nproven yes\n"})
        EXPECT_NE(text.find(name), std::string::npos) << name << " in\n" << text;
    EXPECT_EQ(std::ranges::count(text, '\n'), 10);
}

} // namespace
} // namespace dice_tests
