// SPDX-License-Identifier: MIT
// Faces that meet along edges: nothing shows between them, whatever their own trims say.
#include "effort.h"
#include "hard_edged.h"
#include "solid_judge.h"
#include "solids.h"

#include "base/error.h"
#include "pipeline/pipeline_afd.h"
#include "scene/dice_view.h"
#include "scene/sides/shared_edges.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace {

using vector = solid::vector;

void judge_views(const char* name, const solid& of, int views) {
    const l3d_patch_model model = l3d_patch_model::from_surfaces(of.faces, of.edges);
    std::mt19937 random(541);
    solid_verdict sum;
    for (int i = 0; i < views; ++i) {
        // From a third of the picture to a thousandth of the body, every other one onto an edge.
        const double zoom = std::pow(10, -0.5 + 3.5 * (i / 2) / std::max(1, (views - 1) / 2));
        const camera_rays rays(view_of(of, zoom, i % 2 == 1, random), {160, 120});
        l3d_afd_settings settings = hard_edged();
        settings.tolerance = i / 2 % 2 == 0 ? 0.25 : 0.05;
        settings.one_sided = true;
        settings.depth = true;
        // Pictures are small, and patches that cross the near plane take no less in them.
        settings.most_samples = l3d_usual_samples({1024, 768}, settings.tolerance);
        l3d_pipeline_afd pipeline(l3d_memory_canvas(rays.size), model, rays.camera, settings);
        pipeline.draw_event();
        const solid_verdict before = sum;
        judge_solid(of, rays, pipeline, sum);
        if (sum.errors() > before.errors())
            std::printf("%s, view %d, zoom %g, tolerance %g: %ld uncovered, %ld beyond, %ld off, "
                        "%ld behind; bound %g, of depth %g\n",
                        name, i, zoom, settings.tolerance, sum.uncovered - before.uncovered,
                        sum.beyond - before.beyond, sum.off - before.off,
                        sum.behind - before.behind, pipeline.report().dice.bound_px,
                        pipeline.report().dice.depth_bound_px);
    }
    std::printf("%s: %ld pixels, %ld drawn, %ld on edges, %ld undecided at outlines; outlines off "
                "by %.2f of their bounds, depths by %.2f; bounds up to %.2f tolerances, "
                "of depth %.2f, and edges "
                "off by %.2f\n",
                name, sum.pixels, sum.drawn, sum.on_edges, sum.undecided, sum.worst_outline,
                sum.worst_depth, sum.most_bound, sum.most_depth_bound, sum.most_edges);
    EXPECT_GT(sum.drawn, 1000 * views);
    EXPECT_GT(sum.on_edges, 20 * views);
    EXPECT_LE(sum.most_bound, 1);
    EXPECT_LE(sum.most_depth_bound, 1.6) << "what docs/NUMERICS.md, section 27, says of rims";
    EXPECT_EQ(sum.uncovered, 0);
    EXPECT_EQ(sum.beyond, 0);
    EXPECT_EQ(sum.off, 0);
    EXPECT_EQ(sum.behind, 0);
}

const int views = thorough ? 50 : 6;

TEST(shared_edges, of_a_thread) {
    judge_views("thread", threaded_rod(5, 64), views);
}

TEST(shared_edges, of_a_plate_with_holes) {
    judge_views("plate", holed_plate(thorough ? 32 : 5), views);
}

TEST(shared_edges, of_a_plate_whose_trims_miss_them) {
    judge_views("inexact plate", holed_plate(5, {.circles = 1e-3}), views);
}

TEST(shared_edges, of_a_flange) {
    judge_views("flange", flange(8), views);
    judge_views("inexact flange", flange(8, {.circles = 1e-3}), views);
}

TEST(shared_edges, of_cylinders_with_a_fillet) {
    judge_views("fillet", filleted_cylinders(), views);
    judge_views("inexact fillet", filleted_cylinders({.circles = 1e-3}), views);
}

TEST(shared_edges, of_a_ball_that_a_cylinder_goes_through) {
    judge_views("ball", drilled_ball(64, -0.4), views);
    judge_views("inexact ball", drilled_ball(24, -0.4), views);
}

TEST(shared_edges, that_go_across_the_seam_of_a_ball) {
    judge_views("ball with a hole in its seam", drilled_ball(64, 0.4), views);
}

TEST(shared_edges, that_go_around_a_ball) {
    judge_views("ball without a cap", capped_ball(), views);
}

TEST(shared_edges, are_named_where_they_are_missing) {
    const solid of = capped_ball();
    try {
        const auto model = l3d_patch_model::from_surfaces(of.faces);
        ADD_FAILURE();
    } catch (const l3d_error& error) {
        EXPECT_STREQ(error.what(), "surfaces: patch 5: a trim follows edge 1 of 0");
    }
}

TEST(shared_edges, that_are_off_their_faces_are_told) {
    solid of = flange(3, {.circles = 1e-3});
    const auto note = [&] {
        return l3d_patch_model::from_surfaces(of.faces, of.edges).edges_note();
    };
    EXPECT_EQ(note(), "10 of 18 edges are off their faces by more than the file allows: edge 4 by "
                      "0.0014, not 0");
    const auto model = l3d_patch_model::from_surfaces(of.faces, of.edges);
    const std::vector<l3d_loose_edge> loose = model.loose_edges();
    ASSERT_EQ(loose.size(), 10U);
    for (std::size_t i = 0; i < loose.size(); ++i) {
        EXPECT_GE(loose[std::max<std::size_t>(i, 1) - 1].off, loose[i].off);
        // The place is on the edge: in the box of its points, in space.
        const l3d_nurbs_curve& edge = of.edges[loose[i].edge].curve;
        double nearest = HUGE_VAL;
        for (int k = 0; k <= 1000; ++k) {
            const double t = std::lerp(edge.along().from, edge.along().to, k / 1000.0);
            nearest = std::min(nearest, l3d_length(edge.evaluate(t) - loose[i].place));
        }
        EXPECT_LT(nearest, 1e-2) << i;
        EXPECT_GE(loose[i].pieces.size(), 2U) << "two faces meet there";
    }
    for (l3d_model_edge& edge : of.edges)
        edge.tolerance = 0.002;
    EXPECT_EQ(note(), "");
    of = flange(3);
    EXPECT_EQ(note(), "");
}

TEST(shared_edges, that_are_loose_move_no_tight_ones) {
    const auto line = [](const vector& from, const vector& to, double tolerance) {
        return l3d_model_edge{l3d_nurbs_curve::polyline({from, to}), tolerance};
    };
    const vector corner{0.0, 0.0, 0.0}, beside{-8e-4, 0.0, 0.0}, tight{1e-8, 0.0, 0.0};
    const auto edges = l3d_shared_edges(
        std::array{line({0.0, 0.0, 1.0}, beside, 1e-3), line(corner, {1.0, 0.0, 0.0}, 1e-7),
                   line({0.0, 1.0, 0.0}, tight, 1e-7), line(beside, {0.0, -1.0, 0.0}, 1e-5)},
        {});
    EXPECT_EQ(edges[1].ends[0], corner);
    EXPECT_EQ(edges[2].ends[1], corner);
    EXPECT_EQ(edges[0].ends[1], corner);
    EXPECT_NEAR(edges[0].off, 8e-4, 1e-12);
    EXPECT_EQ(edges[3].ends[0], beside);
}

TEST(shared_edges, meet_where_they_are_as_near_as_they_say) {
    const auto are_joined = [](const vector& a, const vector& b, double tolerance) {
        const vector far{0.0, 0.0, 9.0};
        const auto edges = l3d_shared_edges(
            std::array{l3d_model_edge{l3d_nurbs_curve::polyline({far, a}), tolerance},
                       l3d_model_edge{l3d_nurbs_curve::polyline({b, -far}), tolerance}},
            {});
        return edges[0].ends[1] == edges[1].ends[0];
    };
    EXPECT_TRUE(are_joined({1.0, 0.0, 0.0}, {1.0015, 0.0, 0.0}, 1e-3)) << "each is off by 0.75";
    EXPECT_FALSE(are_joined({1.0, 0.0, 0.0}, {1.0025, 0.0, 0.0}, 1e-3));
    EXPECT_TRUE(are_joined({0.3, 0.0, 0.0}, {0.1 + 0.2, 0.0, 0.0}, 0)) << "files round";
    EXPECT_FALSE(are_joined({0.3, 0.0, 0.0}, {0.3 + 1e-9, 0.0, 0.0}, 0));
}

/// An edge beside its face, as measured, is off as one whose file says so. It is off most in its
/// middle.
TEST(shared_edges, meet_where_a_face_is_off) {
    for (const double off : {0.0, 1e-3}) {
        const vector from{0.0, 0.0, 0.0}, middle{0.5, 0.0, off}, to{1.0, 0.0, 0.0};
        l3d_patch_points face{1, 1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
        const l3d_nurbs_curve bent = l3d_nurbs_curve::polyline({from, middle, to});
        face.trims = {{{{{0, 0, 1}, {1, 0, 1}}, 0, 0, bent.along().to}, {{{1, 0, 1}, {0, 0, 1}}}}};
        const auto edges = l3d_shared_edges(
            std::array{
                l3d_model_edge{bent, 0},
                l3d_model_edge{l3d_nurbs_curve::polyline({{1.0, 0.0, 5e-4}, {0.0, 0.0, 9.0}}), 0}},
            std::span(&face, 1));
        EXPECT_NEAR(edges[0].off, off, 1e-12);
        EXPECT_EQ(edges[0].worst, (off > 0 ? middle : vector(0.0)));
        EXPECT_EQ(edges[0].ends[1] == edges[1].ends[0], off > 0);
    }
}

/// A pipeline keeps what trims leave of grids, and draws as one that has kept nothing.
TEST(shared_edges, are_drawn_alike_after_other_views) {
    const solid of = flange(8);
    const l3d_patch_model model = l3d_patch_model::from_surfaces(of.faces, of.edges);
    for (const l3d_afd_settings& settings : {hard_edged(), l3d_afd_settings()}) {
        std::mt19937 random(543);
        l3d_pipeline_afd kept(l3d_memory_canvas({160, 120}), model, l3d_camera(), settings);
        for (int i = 0; i < 12; ++i) {
            if (i % 4 == 0) // from other frames, patches need a few steps more or less
                kept.camera() = view_of(of, std::pow(10, -0.5 + 0.2 * i), i % 2 == 1, random);
            else
                kept.camera().orbit(3, 2);
            kept.draw_event();
            l3d_pipeline_afd fresh(l3d_memory_canvas({160, 120}), model, kept.camera(), settings);
            fresh.draw_event();
            EXPECT_EQ(kept.report().hash, fresh.report().hash) << i;
        }
    }
}

/// Instances of a model share what trims leave of grids, those of two threads as well.
TEST(shared_edges, of_instances_are_drawn_as_those_of_models_of_their_own) {
    const solid of = flange(8);
    const auto model = [&] { return l3d_patch_model::from_surfaces(of.faces, of.edges); };
    const l3d_patch_model one = model();
    l3d_patch_scene shared, own;
    for (int i = 0; i < 6; ++i) {
        const auto place = l3d_translation<double>(4.0 * i - 8, 0.5 * i, -5.0 * i);
        shared.add(one, place);
        own.add(model(), place);
    }
    l3d_camera camera;
    camera.eye = {0.0, 6.0, 12.0};
    for (l3d_afd_settings settings : {hard_edged(), l3d_afd_settings()}) {
        settings.threads = 1;
        l3d_pipeline_afd with_own(l3d_memory_canvas({160, 120}), own, camera, settings);
        with_own.draw_event();
        settings.threads = 2;
        l3d_pipeline_afd with_shared(l3d_memory_canvas({160, 120}), shared, camera, settings);
        with_shared.draw_event();
        EXPECT_GT(with_own.report().surface.quads, 1000);
        EXPECT_EQ(with_own.report().hash, with_shared.report().hash);
    }
}

/// Lines along edges: each pixel of the exact rim that is in front is black.
TEST(shared_edges, are_drawn_as_lines) {
    const solid of = capped_ball();
    l3d_camera camera;
    camera.eye = {0.0, 4.0, 3.0};
    const camera_rays rays(camera, {160, 120});
    l3d_afd_settings settings = hard_edged();
    settings.edges = true;
    l3d_pipeline_afd pipeline(l3d_memory_canvas(rays.size),
                              l3d_patch_model::from_surfaces(of.faces, of.edges), camera, settings);
    pipeline.draw_event();
    const l3d_pixels pixels = pipeline.screen().pixels();
    for (int i = 0; i < 360; ++i) {
        const double angle = i * std::numbers::pi / 180;
        const vector p = vector{0.8 * std::cos(angle), 0.6, 0.8 * std::sin(angle)} - camera.eye;
        const double w = l3d_dot(p, rays.axes.forward);
        const double x = rays.size.width / 2.0 + l3d_dot(p, rays.axes.right) / w * rays.focal;
        const double y = rays.size.height / 2.0 - l3d_dot(p, rays.axes.up) / w * rays.focal;
        bool is_black = false;
        for (const int row : {-1, 0, 1})
            for (const int column : {-1, 0, 1}) {
                const auto at = static_cast<std::size_t>(static_cast<int>(x) + column);
                is_black = is_black || pixels.row(static_cast<int>(y) + row)[at] == 0;
            }
        EXPECT_TRUE(is_black) << i;
    }
    const auto middle =
        pixels.row(rays.size.height / 2)[static_cast<std::size_t>(rays.size.width / 2)];
    EXPECT_NE(middle, 0U);
}

} // namespace
