// SPDX-License-Identifier: MIT
// Curved models: their levels, what belongs to pieces, and which level a view gets.
#include "base/error.h"
#include "geom/nurbs_surface.h"
#include "scene/levels/level_choice.h"
#include "scene/patch_scene.h"
#include "scene/levels/seen_region.h"
#include "scene/sides/shared_edges.h"
#include "geom/transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

using vector = l3d_patch_model::vector;

l3d_patch_model sphere() {
    return l3d_patch_model::from_surfaces(l3d_sphere_surfaces());
}

/// The farthest of points of the patches from the unit sphere.
double away_from_sphere(const l3d_patch_model& model) {
    double most = 0;
    for (const l3d_patch_model::patch& p : model.patches())
        for (double u = 0; u <= 1; u += 0.25)
            for (double v = 0; v <= 1; v += 0.25)
                most = std::max(most, std::abs(l3d_length(p.evaluate(u, v)) - 1));
    return most;
}

l3d_curved_error chosen(l3d_patch_scene& scene, double distance, double px, double normals = 1) {
    l3d_camera camera;
    camera.eye = {0.0, 0.0, distance};
    camera.near_z = 0.01;
    return scene.choose_levels(
        {.camera = camera, .size = {640, 480}, .places_px = px, .normals = normals});
}

/// The part of its diagonal that a level of places asks for.
double place_target(const l3d_patch_model& model, int level) {
    return std::ldexp(l3d_length(model.pieces_most() - model.pieces_least()), -10 - level);
}

} // namespace

TEST(curved_model, keeps_what_its_levels_say_and_is_closed_at_each) {
    const l3d_patch_model model = sphere();
    ASSERT_TRUE(model.is_curved());
    EXPECT_EQ(model.pieces(), 8u);
    for (int level = 0; level < 4; ++level) {
        const l3d_patch_model at = model.at_level(level, 0);
        EXPECT_LE(at.surface_error(), place_target(model, level));
        EXPECT_LE(at.normal_error(), model.normal_target(0));
        EXPECT_LE(away_from_sphere(at), at.surface_error());
        EXPECT_EQ(at.orientation(), 1); // all boundaries are met by their like, bit for bit
        EXPECT_EQ(at.source_identity(), model.source_identity());
        EXPECT_EQ(at.identity(), model.at_level(level, 0).identity());
    }
    EXPECT_LE(model.at_level(0, 1).normal_error(), model.normal_target(1));
}

TEST(curved_model, materials_and_parts_are_those_of_pieces) {
    std::vector<l3d_material> materials(8);
    for (std::size_t i = 0; i < 8; ++i)
        materials[i].color = static_cast<std::uint32_t>(i + 1);
    const std::vector<l3d_part_run> runs{{"low", 0}, {"high", 4}};
    const l3d_patch_model model = sphere().painted(materials).with_parts(runs).at_level(2, 0);
    for (std::size_t i = 0; i < model.patches().size(); ++i)
        EXPECT_EQ(model.materials()[model.material_of(i)].color, model.piece_of(i) + 1);
    const l3d_patch_model high = model.only(std::array<std::size_t, 1>{1});
    EXPECT_EQ(high.pieces(), 4u);
    EXPECT_EQ(high.materials()[high.material_of(0)].color, 5u);
    EXPECT_GE(high.least()[1], -1e-9);
    EXPECT_TRUE(high.is_curved());
}

TEST(curved_model, other_surfaces_take_the_place_of_pieces_in_their_colours_and_parts) {
    const l3d_patch_model model =
        sphere().painted({.color = 0x123456}).with_parts(std::vector<l3d_part_run>{{"ball", 0}});
    std::vector<l3d_nurbs_surface> surfaces = model.surfaces();
    ASSERT_EQ(surfaces.size(), 8u);
    surfaces[3].set_point(4, {3, 3, 3}, surfaces[3].weights()[4]);
    const l3d_patch_model other = model.reshaped(surfaces);
    EXPECT_EQ(other.surfaces()[3].points()[4], vector(3, 3, 3));
    EXPECT_EQ(other.surfaces()[2].points(), model.surfaces()[2].points());
    EXPECT_EQ(other.materials()[0].color, 0x123456u);
    EXPECT_EQ(other.parts().size_of(0), 8u);
    surfaces.pop_back();
    EXPECT_THROW(model.reshaped(surfaces), l3d_error);

    const l3d_patch_model teapot = l3d_patch_model::teapot();
    const l3d_patch_model same = teapot.reshaped(teapot.surfaces());
    for (std::size_t i = 0; i < teapot.patches().size(); ++i)
        EXPECT_EQ(same.patches()[i].points, teapot.patches()[i].points);
    EXPECT_FALSE(same.is_curved());
}

TEST(curved_model, has_polynomial_bicubic_patches_if_its_pieces_are) {
    const l3d_patch_points flat{1, 1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {2, 2, 2, 2}};
    std::string why;
    const auto model = l3d_patch_model::from_patches(std::vector{flat}, "flat", why);
    ASSERT_TRUE(model);
    EXPECT_FALSE(model->is_curved());
    EXPECT_EQ(model->most_level(), 0);
}

TEST(curved_model, is_not_cut_without_end_for_normals_that_turn_at_once) {
    // Random and all but gentle: somewhere the normals of some nearly vanish.
    std::mt19937 random(7);
    const auto any = [&random] { return static_cast<int>(random() % 65) / 32.0 - 1; };
    int without = 0;
    for (int trial = 0; trial < 30; ++trial) {
        l3d_patch_points patch{3, 3, {}, {}};
        for (int i = 0; i < 16; ++i) {
            const double x = i % 4 + 2 * any(), y = i / 4 + 2 * any();
            patch.points.push_back({x, y, 2 * any()});
            patch.weights.push_back(std::exp2(std::round(3 * any())));
        }
        std::string why;
        const auto model = l3d_patch_model::from_patches(std::vector{patch}, "cusp", why);
        ASSERT_TRUE(model);
        EXPECT_LE(model->patches().size(), 512u); // lines of cusps cut other cells, too
        EXPECT_LE(model->surface_error(), place_target(*model, 0));
        without += model->normal_error() > model->normal_target(0) ? 1 : 0;
    }
    EXPECT_GT(without, 4);
}

TEST(curved_model, refuses_what_is_no_piece) {
    const auto why_not = [](const l3d_patch_points& patch) {
        std::string why;
        EXPECT_FALSE(l3d_patch_model::from_patches(std::vector{patch}, "name", why));
        return why;
    };
    const std::vector<std::array<double, 3>> square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(why_not({16, 1, {}}), "name: patch 1 of degree 16 by 1: degrees are from 1 to 15");
    EXPECT_EQ(why_not({1, 1, square, {1, 2}}),
              "name: patch 1 of degree 1 by 1 has 4 points and 2 weights");
    EXPECT_EQ(why_not({1, 1, square, {1, 1, -2, 1}}),
              "name: patch 1: point 3 has the weight -2, which is not from 1e-100 to 1e12");
}

TEST(curved_model, gets_the_level_that_its_view_needs) {
    l3d_patch_scene scene(sphere());
    const std::size_t coarse = scene.instances()[0].model().patches().size();
    const l3d_curved_error far = chosen(scene, 10, 0.03);
    EXPECT_LE(far.places_px, 0.03);
    const std::size_t at_10 = scene.instances()[0].model().patches().size();
    const l3d_curved_error near = chosen(scene, 1.1, 0.0005);
    EXPECT_LE(near.places_px, 0.0005);
    EXPECT_GT(scene.instances()[0].model().patches().size(), at_10);
    EXPECT_EQ(scene.patch_count(),
              static_cast<std::int64_t>(scene.instances()[0].model().patches().size()));
    // What was drawn before makes no difference.
    EXPECT_EQ(chosen(scene, 10, 0.03).places_px, far.places_px);
    EXPECT_EQ(scene.instances()[0].model().patches().size(), at_10);
    EXPECT_LE(chosen(scene, 10, 1e3, 1e-4).normals, 1e-4);
    chosen(scene, 10, 1e3);
    EXPECT_EQ(scene.instances()[0].model().patches().size(), coarse);
}

TEST(curved_model, is_the_same_for_a_program_at_any_level) {
    l3d_patch_scene scene(sphere());
    scene.paint(0, l3d_material{.color = 0xff0000});
    scene.forget_changes();
    chosen(scene, 1.1, 0.0005);
    EXPECT_FALSE(scene.is_changed());
    scene.place(0, l3d_translation<double>(1, 0, 0));
    EXPECT_TRUE(scene.is_changed());
    EXPECT_TRUE(scene.instances()[0].material());
    scene.place(0, l3d_patch_model::teapot(), l3d_identity<double>());
    EXPECT_FALSE(scene.is_curved());
}

TEST(curved_model, stretched_placements_are_counted) {
    l3d_patch_scene scene;
    scene.add(sphere(), l3d_scaling<double>(1, 100, 1));
    l3d_patch_scene round(sphere());
    EXPECT_GT(chosen(scene, 500, 1e3).places_px, 50 * chosen(round, 500, 1e3).places_px);
    EXPECT_GT(chosen(scene, 500, 1e3).normals, 10 * chosen(round, 500, 1e3).normals);
}

TEST(curved_model, is_not_cut_along_whole_lines_for_a_cusp) {
    // Two pieces of degree 4, one of them with two sides that begin with three points in a corner.
    std::vector<l3d_patch_points> pieces;
    for (const double from : {0.0, 4.0}) {
        l3d_patch_points piece{4, 4, {}, {}};
        for (int i = 0; i < 25; ++i) {
            const double x = i % 5, y = from + i / 5;
            piece.points.push_back({x, y, 0.02 * x * x * y});
        }
        pieces.push_back(piece);
    }
    for (const std::size_t i : {1u, 5u})
        pieces[0].points[i] = pieces[0].points[0];
    std::string why;
    const auto model = l3d_patch_model::from_patches(pieces, "cusp", why);
    ASSERT_TRUE(model) << why;
    EXPECT_TRUE(std::isinf(model->normal_error()));
    std::size_t beside = 0;
    for (std::size_t i = 0; i < model->patches().size(); ++i)
        beside += model->piece_of(i) == 1 ? 1 : 0;
    EXPECT_LE(beside, 4u);
}

TEST(seen_region, holds_all_that_its_view_shows) {
    std::mt19937 random(4);
    const auto any = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int regions = 0;
    for (int i = 0; i < 1000; ++i) {
        l3d_camera camera;
        camera.eye = {any(-9, 9), any(-9, 9), any(-9, 9)};
        camera.target = {any(-1, 1), any(-1, 1), any(-1, 1)};
        camera.fov = std::exp(any(-12, 4.5));
        if (i % 3 == 0)
            camera.projection = l3d_projection::parallel;
        const l3d_size size{200 + i % 400, 300};
        const double least_depth = any(0.01, 5), reach = 40;
        const auto region = l3d_seen_region::of(camera, size, least_depth, reach);
        if (!region)
            continue;
        ++regions;
        const l3d_camera::frame axes = camera.axes();
        const double scale =
            camera.is_parallel() ? camera.scale_at_target(size) : camera.focal_length(size);
        for (int k = 0; k < 20; ++k) {
            // The nearest places in the corners of the rim around the picture, and others.
            const bool is_corner = k < 4;
            const double depth =
                is_corner ? least_depth : any(least_depth, camera.is_parallel() ? 12 : 30);
            const double unit = camera.is_parallel() ? 1 : depth;
            const double rim = 1 + l3d_longest_shared_chord / (std::hypot(size.width, 300) / 2);
            const double x = is_corner ? (k % 2 - 0.5) * rim : any(-0.5, 0.5);
            const double y = is_corner ? (k / 2 - 0.5) * rim : any(-0.5, 0.5);
            const vector at = camera.eye + axes.forward * depth +
                              axes.right * (x * size.width / scale * unit) +
                              axes.up * (y * size.height / scale * unit);
            const std::array<l3d_vector<double, 4>, 1> point{
                {{2 * at[0], 2 * at[1], 2 * at[2], 2}}};
            EXPECT_FALSE(region->hides(point)) << i;
            EXPECT_LE(region->least_depth(point), camera.is_parallel() ? 1 : depth) << i;
            // Six times the picture's width aside, it is hidden.
            const vector aside = at + axes.right * (6 * size.width / scale * unit);
            const std::array<l3d_vector<double, 4>, 1> far{{{aside[0], aside[1], aside[2], 1}}};
            EXPECT_TRUE(region->hides(far)) << i;
        }
    }
    EXPECT_GT(regions, 900);
}

TEST(curved_model, is_cut_where_it_is_seen_and_as_fine_as_its_depth_asks_for) {
    // Every other piece is turned round, so that boundaries run against each other.
    std::vector<l3d_patch_points> pieces;
    for (const l3d_nurbs_surface& surface : l3d_sphere_surfaces())
        for (l3d_patch_points piece : surface.pieces()) {
            if (pieces.size() % 2 == 0) {
                std::ranges::reverse(piece.points);
                std::ranges::reverse(piece.weights);
            }
            pieces.push_back(piece);
        }
    std::string why;
    l3d_patch_scene scene(*l3d_patch_model::from_patches(pieces, "sphere", why));
    const vector place{0.48, 0.64, 0.6};
    for (const double zoom : {30.0, 1e3, 1e6}) {
        l3d_camera camera;
        camera.eye = place * (1 + 1 / zoom);
        camera.target = place;
        camera.near_z = 1e-3 / zoom;
        const l3d_size size{640, 480};
        const l3d_curved_error error = scene.choose_levels(
            {.camera = camera, .size = size, .places_px = 0.03, .normals = 0.001});
        const l3d_patch_model& model = scene.instances()[0].model();
        EXPECT_LE(error.places_px, 0.03) << zoom;
        EXPECT_LE(model.patches().size(), 2000u) << zoom;
        EXPECT_LE(l3d_length(model.least() - vector(-1.0)), 1e-3) << zoom;
        // Each boundary in the picture is that of two patches, bit for bit.
        using boundary = std::array<double, 12>;
        std::map<boundary, int> met;
        for (std::size_t i = 0; i < model.patches().size(); ++i) {
            const l3d_patch_model::patch& p = model.patches()[i];
            const double off = std::abs(l3d_length(p.evaluate(0.3, 0.6)) - 1);
            EXPECT_LE(off, model.surface_error(i)) << zoom;
            for (const auto& [first, step] : {std::pair{0, 1}, {12, 1}, {0, 4}, {3, 4}}) {
                boundary there{}, back{};
                vector middle(0.0);
                for (int k = 0; k < 4; ++k) {
                    const vector& point = p.points[static_cast<std::size_t>(first + k * step)];
                    middle += point * (k % 3 == 0 ? 0.125 : 0.375);
                    for (int c = 0; c < 3; ++c) {
                        there[static_cast<std::size_t>(3 * k + c)] = point[c];
                        back[static_cast<std::size_t>(9 - 3 * k + c)] = point[c];
                    }
                }
                const double depth = camera.depth_of(middle);
                const vector seen = middle - camera.eye - camera.axes().forward * depth;
                if (depth > camera.near_z &&
                    camera.focal_length(size) * l3d_length(seen) < 240 * depth)
                    ++met[std::min(there, back)];
            }
        }
        EXPECT_GT(met.size(), 30u) << zoom;
        for (const auto& [of, count] : met)
            EXPECT_EQ(count, 2) << zoom;
    }
}

TEST(curved_model, that_nobody_sees_is_coarse) {
    l3d_patch_scene scene(sphere());
    l3d_camera camera;
    camera.eye = {0.0, 0.0, 1 + 1e-5};
    camera.target = {1.0, 0.0, 1 + 2e-5};
    camera.near_z = 1e-7;
    scene.choose_levels({.camera = camera, .size = {640, 480}, .places_px = 0.03, .normals = 0.01});
    EXPECT_LE(scene.instances()[0].model().patches().size(), 8192u);
}
