// SPDX-License-Identifier: MIT
// Faces that meet along edges: nothing shows between them, whatever their own trims say.
#include "effort.h"
#include "hard_edged.h"
#include "random_views.h"
#include "solids.h"

#include "base/error.h"
#include "pipeline/pipeline_afd.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

namespace {

using vector = solid::vector;

/// The distance along the view axis at which a ray meets the body, infinite if it does not. The
/// search goes on by the distance that is free.
double distance_of(const solid& of, const vector& from, const vector& ray) {
    const double length = l3d_length(ray);
    const vector along = ray / length;
    const double least = 1e-6 * of.radius, farthest = l3d_length(from - of.middle) + of.radius;
    double t = std::max(0.0, l3d_length(from - of.middle) - of.radius);
    for (int i = 0; i < 2000 && t < farthest; ++i) {
        const double free = of.outside(from + along * t);
        if (free < least)
            return t / length;
        t += free;
    }
    return HUGE_VAL;
}

struct judged {
    long pixels = 0, drawn = 0, uncovered = 0, beyond = 0, misplaced = 0;
};

/// Judges a picture of fronts alone, in which a gap shows the background and not the body's inside.
/// Somewhere within the bound around a pixel, the exact body shows what the pixel shows. A distance
/// is judged by those around the pixel.
void judge(const solid& of, const camera_rays& rays, const l3d_pipeline_afd& pipeline,
           judged& sum) {
    const double reach = pipeline.report().dice.bound_px + 0.01;
    ASSERT_TRUE(std::isfinite(reach));
    const std::vector<float> distances = pipeline.distances();
    for (int y = 0; y < rays.size.height; ++y)
        for (int x = 0; x < rays.size.width; ++x) {
            const double drawn =
                static_cast<double>(distances[static_cast<std::size_t>(y * rays.size.width + x)]);
            const bool is_drawn = std::isfinite(drawn);
            const double slack = is_drawn ? reach * drawn / rays.focal : 0;
            ++sum.pixels;
            sum.drawn += is_drawn;
            const double exact = distance_of(of, rays.camera.eye, rays.at(x + 0.5, y + 0.5));
            if (is_drawn ? std::abs(exact - drawn) < slack : exact == HUGE_VAL)
                continue;
            double least = exact, most = exact;
            for (int k = 0; k < 32; ++k) {
                const double angle = k * std::numbers::pi / 16;
                const double around = distance_of(
                    of, rays.camera.eye,
                    rays.at(x + 0.5 + reach * std::cos(angle), y + 0.5 + reach * std::sin(angle)));
                least = std::min(least, around);
                most = std::max(most, around);
            }
            if (!is_drawn)
                sum.uncovered += most < HUGE_VAL;
            else if (least == HUGE_VAL)
                ++sum.beyond;
            else
                sum.misplaced += drawn < least - slack || drawn > most + slack;
        }
}

void judge_views(const char* name, const solid& of, int views) {
    const l3d_patch_model model = l3d_patch_model::from_surfaces(of.faces, of.edges);
    std::mt19937 random(541);
    judged sum;
    double most = 0;
    for (int i = 0; i < views; ++i) {
        const double zoom = std::pow(10, -0.5 + 2.0 * i / views);
        l3d_camera camera = random_view(of.middle, of.radius, zoom, random);
        if (of.outside(camera.eye) < 2 * camera.near_z) // the near plane would cut it open
            continue;
        const camera_rays rays(camera, {160, 120});
        l3d_afd_settings settings = hard_edged();
        settings.tolerance = i % 2 == 0 ? 0.25 : 0.05;
        settings.one_sided = true;
        settings.depth = true;
        l3d_pipeline_afd pipeline(l3d_memory_canvas(rays.size), model, rays.camera, settings);
        pipeline.draw_event();
        most = std::max(most, pipeline.report().dice.bound_px / settings.tolerance);
        const judged before = sum;
        judge(of, rays, pipeline, sum);
        const long of_view[] = {sum.uncovered - before.uncovered, sum.beyond - before.beyond,
                                sum.misplaced - before.misplaced};
        if (of_view[0] + of_view[1] + of_view[2] > 0)
            std::printf(
                "%s, view %d, zoom %g: %ld uncovered, %ld beyond, %ld misplaced, bound %g\n", name,
                i, zoom, of_view[0], of_view[1], of_view[2], pipeline.report().dice.bound_px);
    }
    std::printf("%s: %ld pixels, %ld drawn; bounds up to %.2f tolerances\n", name, sum.pixels,
                sum.drawn, most);
    EXPECT_GT(sum.drawn, 1000 * views);
    EXPECT_EQ(sum.uncovered, 0);
    EXPECT_EQ(sum.beyond, 0);
    EXPECT_EQ(sum.misplaced, 0);
}

const int views = thorough ? 50 : 5;

TEST(shared_edges, of_a_plate_with_holes) {
    judge_views("plate", holed_plate(thorough ? 16 : 5), views);
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
    for (l3d_model_edge& edge : of.edges)
        edge.tolerance = 0.002;
    EXPECT_EQ(note(), "");
    of = flange(3);
    EXPECT_EQ(note(), "");
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
            for (const int column : {-1, 0, 1})
                is_black = is_black ||
                           pixels.row(static_cast<int>(y) + row)[static_cast<int>(x) + column] == 0;
        EXPECT_TRUE(is_black) << i;
    }
    const auto middle = pixels.row(rays.size.height / 2)[rays.size.width / 2];
    EXPECT_NE(middle, 0U);
}

} // namespace
