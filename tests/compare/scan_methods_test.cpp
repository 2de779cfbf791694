// SPDX-License-Identifier: MIT
// The three scan line methods apart: on plain patches they agree with the exact picture, on folded
// ones iterations fail, and those are counted.
#include "hard_edged.h"
#include "dice/scene.h"

#include "compare/plotters/blinn_plotter.h"
#include "compare/dicers/lane_carpenter_dicer.h"
#include "compare/method_choice.h"
#include "compare/method_patches.h"
#include "compare/plotters/scan_edges.h"
#include "compare/plotters/silhouette.h"
#include "compare/plotters/whitted_plotter.h"
#include "pipeline/pipeline_afd.h"
#include "reference/exact.h"
#include "scene/camera_shading.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace dice_tests {
namespace {

constexpr l3d_size size{200, 150};
constexpr const char* names[] = {"whitted", "blinn", "lane-carpenter"};

const reference::camera before{{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 40, 0.1};

/// A sheet 3 wide and high. Its middle is drawn over its right by `fold`: with 0 it is plain, with
/// 6 it folds over itself, beginning and ending in cusps.
reference::patch sheet(double fold) {
    reference::patch result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            const bool is_middle = row == 1 || row == 2;
            const double shift = !is_middle ? 0 : column == 1 ? fold : column == 2 ? -fold : 0;
            const double height = column == 1 ? 1 : column == 2 ? -1 : 0;
            result.points[static_cast<std::size_t>(4 * row + column)] = {
                column - 1.5 + shift, row - 1.5 + 0.2 * column, is_middle ? height : 0.1 * column};
        }
    return result;
}

struct drawn {
    l3d_frame_report report;
    std::vector<float> distances;
};

drawn draw(const scene& s, const std::string& method, double tolerance = 0.25) {
    l3d_afd_settings settings = hard_edged();
    std::string why;
    settings.method = l3d_method_choice::from_name(method, why).value().factory();
    settings.depth = true;
    settings.tolerance = tolerance;
    l3d_pipeline_afd pipeline(l3d_memory_canvas(s.size), s.model, s.camera, settings);
    pipeline.draw_event();
    return {pipeline.report(), l3d_distances(pipeline.depth())};
}

/// Pixels that only one of both covers, or whose distance is off by more than a hundredth.
int wrong_pixels(const scene& s, const std::vector<float>& distances) {
    const reference::exact_image exact(s.patches, s.eye, s.picture());
    int wrong = 0;
    for (int y = 0; y < s.size.height; ++y)
        for (int x = 0; x < s.size.width; ++x) {
            const double w = double(distances[static_cast<std::size_t>(y * s.size.width + x)]);
            const auto& there = exact.at(x, y);
            wrong += there.covered() != std::isfinite(w) ||
                     (there.covered() && std::abs(w / there.w - 1) > 0.01);
        }
    return wrong;
}

TEST(scan_methods, draw_a_plain_sheet_exactly_and_without_failures) {
    const scene s({sheet(0)}, before, size);
    for (const char* name : names) {
        const drawn picture = draw(s, name, 0.05);
        EXPECT_EQ(picture.report.dice.failures, 0) << name;
        EXPECT_LE(wrong_pixels(s, picture.distances), 5) << name;
        EXPECT_GT(
            std::ranges::count_if(picture.distances, [](float w) { return std::isfinite(w); }),
            5000)
            << name;
    }
}

TEST(scan_methods, count_the_iterations_that_fail_at_folds) {
    const scene s({sheet(6)}, before, size);
    for (const char* name : {"blinn", "whitted"}) {
        const drawn picture = draw(s, name);
        EXPECT_GT(picture.report.dice.failures, 0) << name;
        // Most of the sheet is there all the same.
        EXPECT_LT(wrong_pixels(s, picture.distances), size.width * size.height / 5) << name;
        std::printf("%s: %ld failures, %d wrong pixels\n", name,
                    static_cast<long>(picture.report.dice.failures),
                    wrong_pixels(s, picture.distances));
    }
    // What cuts patches until they are plain knows no folds.
    for (const char* name : {"lane-carpenter", "scanline", "afd"}) {
        const drawn picture = draw(s, name, 0.05);
        EXPECT_EQ(picture.report.dice.failures, 0) << name;
        EXPECT_LE(wrong_pixels(s, picture.distances), 40) << name;
    }
}

/// A failure is all rounds for nothing; an iteration that succeeds takes a few.
TEST(scan_methods, tell_what_failures_cost) {
    const scene s({sheet(6)}, before, size);
    l3d_patch_scene world(s.model);
    const l3d_image_transform to_image(s.camera, s.size, world);
    const l3d_dice_view view = to_image.view(0.25);
    const l3d_shading shading =
        l3d_camera_shading(s.camera, s.size, l3d_shade::lambert, l3d_usual_light);
    std::vector<std::uint32_t> words(static_cast<std::size_t>(size.width * size.height));
    l3d_depth_buffer depth;
    depth.resize(size);
    depth.clear();
    l3d_point_canvas canvas;
    canvas.begin({words.data(), size.width, size.height, size.width}, depth, shading);
    l3d_dice_counts counts;
    l3d_blinn_plotter plotter;
    plotter.plot(l3d_placed_net(to_image.matrix(), s.model.patches()[0]),
                 {s.model.normals(0), view, canvas, counts});
    const l3d_scan_effort& effort = plotter.effort();
    EXPECT_EQ(effort.failed, counts.failures);
    EXPECT_GT(effort.failed, 0);
    EXPECT_GT(effort.solved, 1000);
    EXPECT_GE(effort.solved_rounds, effort.solved);
    EXPECT_LT(effort.solved_rounds, 5 * effort.solved);
    EXPECT_LE(effort.failed_rounds, 10 * effort.failed);
}

TEST(scan_edges, meet_a_line_where_halving_finds_it) {
    std::mt19937 random(17);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 0x1p32;
    };
    int met = 0;
    for (int i = 0; i < 200; ++i) {
        l3d_image_curve curve;
        for (auto& point : curve.points) {
            const double w = between(1, 2);
            point = {between(-90, 90) * w, between(-90, 90) * w, w};
        }
        std::vector<l3d_scan_edge> edges;
        l3d_add_scan_edges(curve, {0, 0, 0}, {1, 0, 0}, edges);
        for (const l3d_scan_edge& edge : edges)
            for (double y = std::ceil(edge.top); y < edge.bottom; ++y) {
                const l3d_scan_crossing exact = l3d_guarded_crossing(edge, y);
                const l3d_image_point h = curve.evaluate(exact.root.u);
                ASSERT_NEAR(h[1] / h[2], y, 1e-5);
                ASSERT_NEAR(h[0] / h[2], exact.x, 1e-5);
                int rounds = 0;
                const auto t = l3d_newton_crossing(edge, y, l3d_chord_start(edge, y), 1e-9, rounds);
                ASSERT_GE(rounds, 1);
                ASSERT_LE(rounds, 10);
                if (!t)
                    continue;
                ++met;
                ASSERT_NEAR(l3d_between(edge.from, edge.to, *t).u, exact.root.u, 1e-4);
            }
    }
    EXPECT_GT(met, 5000);
}

TEST(scan_edges, parts_of_curves_are_the_curve) {
    const l3d_image_curve curve{
        {{{0.0, 1.0, 1.0}, {3.0, 2.0, 1.5}, {5.0, -4.0, 2.0}, {9.0, 7.0, 1.0}}}};
    const l3d_image_curve part = l3d_curve_part(curve, 0.3, 0.7);
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
        const l3d_image_point a = part.evaluate(t), b = curve.evaluate(0.3 + 0.4 * t);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(a[i], b[i], 1e-12);
    }
}

/// Derivatives of the determinant against differences, and its zeros against the surface.
TEST(silhouette, is_where_the_surface_turns) {
    const scene s({sheet(6)}, before, size);
    l3d_patch_scene world(s.model);
    const l3d_image_transform to_image(s.camera, s.size, world);
    const l3d_image_patch net = l3d_placed_net(to_image.matrix(), s.model.patches()[0]);
    const l3d_scan_piece piece(net);
    for (const double u : {0.1, 0.4, 0.8})
        for (const double v : {0.2, 0.5, 0.9}) {
            constexpr double h = 1e-5;
            const l3d_scan_turn turn = l3d_turn_at(piece, u, v);
            const auto value = [&](double at_u, double at_v) {
                return l3d_turn_at(piece, at_u, at_v).value;
            };
            const double scale = std::abs(turn.by_u) + std::abs(turn.by_v);
            EXPECT_NEAR(turn.by_u, (value(u + h, v) - value(u - h, v)) / (2 * h), 1e-5 * scale);
            EXPECT_NEAR(turn.by_v, (value(u, v + h) - value(u, v - h)) / (2 * h), 1e-5 * scale);
        }
    int rounds = 0;
    const auto found = l3d_silhouette_on_line(piece, 0.5, {0.25, 0.5, 0}, 0.01, rounds);
    ASSERT_TRUE(found);
    const auto at = piece.at(found->u, found->v).value;
    EXPECT_NEAR(at[1] / at[2], 0.5, 0.01);
    const l3d_scan_turn turn = l3d_turn_at(piece, found->u, found->v);
    EXPECT_NEAR(turn.value / (std::abs(turn.by_u) + std::abs(turn.by_v)), 0, 1e-4);
}

TEST(lane_carpenter, takes_for_a_polygon_what_is_one) {
    const scene s({sheet(0)}, before, size);
    l3d_patch_scene world(s.model);
    const l3d_image_transform to_image(s.camera, s.size, world);
    const l3d_dice_view view = to_image.view(0.25);
    l3d_patch_model::patch plane = s.model.patches()[0];
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            plane.at(row, column) = {column - 1.5, row - 1.5, 0.3 * column - 0.2 * row};
    const auto placed = [&](const l3d_patch_model::patch& p) {
        return l3d_placed_net(to_image.matrix(), p);
    };
    EXPECT_TRUE(l3d_is_polygon(placed(plane), view, 1e-6));
    plane.at(1, 1)[2] += 0.1;
    EXPECT_FALSE(l3d_is_polygon(placed(plane), view, 0.25));
    EXPECT_TRUE(l3d_is_polygon(placed(plane), view, 10));
    plane.at(1, 1)[2] -= 0.1;
    plane.at(0, 1)[1] += 0.1; // a bent side
    EXPECT_FALSE(l3d_is_polygon(placed(plane), view, 0.25));
}

} // namespace
} // namespace dice_tests
