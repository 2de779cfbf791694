// SPDX-License-Identifier: MIT
// Steps: enough, hardly too many, and as the square root of the tolerance.
#include "nasty.h"
#include "odd_view.h"
#include "dice/step_plan.h"
#include "planned_error.h"
#include "raster/parallel/simd_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>

namespace dice_tests {
namespace {

l3d_dice_view view_with(double tolerance) {
    return odd_view(tolerance, 0.1);
}

/// A sheet of about 250 x 180 pixels with waves of `bend` pixels, at distances 3 to 4.
l3d_image_patch sheet(random_numbers& random, double bend) {
    l3d_image_patch result;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            const double w = random.between(3, 4);
            const double x = -100 + 83 * c + random.between(-bend, bend);
            const double y = -70 + 60 * r + random.between(-bend, bend);
            result.at(r, c) = {x * w, y * w, w};
        }
    return result;
}

int total(const std::array<int, 4>& steps) {
    return std::accumulate(steps.begin(), steps.end(), 0);
}

l3d_step_plan plan_of(const l3d_image_patch& patch, double budget,
                      l3d_quad_kind kind = l3d_quad_kind::whole) {
    return l3d_plan_steps(patch, l3d_blocks_of(patch), view_with(budget), budget, kind);
}

/// Whether with one step less along u quads of a strip would be larger than they may be.
bool needs_more_for_size(const l3d_step_plan& plan, const l3d_block_needs& needs,
                         std::size_t strip) {
    double least = 0;
    for (std::size_t b = 0; b < 4; ++b)
        least = std::max(least, needs.least_u[4 * b + strip]);
    return plan.nu[strip] - 1 < least;
}

TEST(step_plan, every_visible_block_is_within_the_budget_and_no_strip_has_a_step_to_spare) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        random_numbers random(seed);
        const l3d_image_patch patch = sheet(random, random.of_any_size(1, 100));
        const double budget = random.of_any_size(0.05, 2);
        const l3d_step_plan plan = plan_of(patch, budget);
        ASSERT_TRUE(plan.visible);
        const l3d_block_needs needs = l3d_needs_of(patch, l3d_blocks_of(patch), view_with(budget),
                                                   budget, l3d_quad_kind::whole);
        const auto error = [&](std::size_t a, std::size_t b, int nu, int nv) {
            return planned_error(needs, a, b, nu, nv);
        };
        double largest = 0;
        for (std::size_t a = 0; a < 4; ++a) {
            double with_one_less = 0;
            for (std::size_t b = 0; b < 4; ++b) {
                largest = std::max(largest, error(a, b, plan.nu[a], plan.nv[b]));
                if (plan.nu[a] > 1)
                    with_one_less =
                        std::max(with_one_less, error(a, b, plan.nu[a] - 1, plan.nv[b]));
            }
            const bool too_large = needs_more_for_size(plan, needs, a);
            if (plan.nu[a] > 1 && !too_large) {
                EXPECT_GT(with_one_less, budget) << "seed " << seed;
            }
        }
        EXPECT_LE(largest, budget) << "seed " << seed;
        EXPECT_DOUBLE_EQ(largest, plan.chord_error) << "seed " << seed;
    }
}

/// The largest error of blocks for which `counts` holds.
template <class Counts>
double largest_error(const l3d_block_needs& needs, const l3d_step_plan& plan,
                     const Counts& counts) {
    double largest = 0;
    for (std::size_t b = 0; b < 4; ++b)
        for (std::size_t a = 0; a < 4; ++a)
            if (counts(4 * b + a))
                largest = std::max(largest, planned_error(needs, a, b, plan.nu[a], plan.nv[b]));
    return largest;
}

TEST(step_plan, blocks_that_may_fold_are_finer_and_no_others_are_coarser) {
    constexpr double budget = 0.25;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        random_numbers random(seed);
        const l3d_image_patch patch = sheet(random, random.of_any_size(1, 100));
        l3d_block_needs needs = l3d_needs_of(patch, l3d_blocks_of(patch), view_with(budget), budget,
                                             l3d_quad_kind::whole);
        needs.finer_outlines = random.between(1, 5);
        needs.folds = 1U << random.below(16);
        const l3d_step_plan plan = l3d_plan_steps(needs, budget, l3d_quad_kind::whole);
        const double everywhere = largest_error(needs, plan, [](std::size_t) { return true; });
        const double at_fold =
            largest_error(needs, plan, [&](std::size_t i) { return (needs.folds >> i & 1) != 0; });
        EXPECT_LE(everywhere, budget) << "seed " << seed;
        EXPECT_DOUBLE_EQ(everywhere, plan.chord_error) << "seed " << seed;
        // Mixed derivatives, by which balance moves vertices, are those of the whole piece.
        EXPECT_LE(at_fold, 1.25 * budget / needs.finer_outlines) << "seed " << seed;
    }
}

TEST(step_plan, convex_quads_need_no_share_of_the_mixed_difference) {
    constexpr double budget = 0.25;
    long convex_quads = 0, quads = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        random_numbers random(seed);
        const l3d_image_patch patch = sheet(random, random.of_any_size(1, 100));
        const l3d_block_needs needs = l3d_needs_of(patch, l3d_blocks_of(patch), view_with(budget),
                                                   budget, l3d_quad_kind::whole);
        const l3d_step_plan plan = l3d_plan_steps(needs, budget, l3d_quad_kind::convex);
        l3d_block_needs untwisted = needs;
        untwisted.uv = {};
        untwisted.uuv = untwisted.uvv = 0;
        double most = 0;
        for (std::size_t i = 0; i < 16; ++i) {
            const std::size_t a = i % 4, b = i / 4;
            EXPECT_LE(plan.errors[i], planned_error(untwisted, a, b, plan.nu[a], plan.nv[b]));
            most = std::max(most, plan.errors[i]);
        }
        EXPECT_LE(most, plan.chord_error) << "seed " << seed;
        EXPECT_LE(plan.chord_error, budget) << "seed " << seed;
        const auto everywhere = [](std::size_t) { return true; };
        EXPECT_DOUBLE_EQ(plan.fan_error, largest_error(needs, plan, everywhere));
        const l3d_step_plan whole = l3d_plan_steps(needs, budget, l3d_quad_kind::whole);
        EXPECT_DOUBLE_EQ(whole.fan_error, whole.chord_error);
        convex_quads += total(plan.nu) * total(plan.nv);
        quads += total(whole.nu) * total(whole.nv);
    }
    EXPECT_LT(convex_quads, quads * 9 / 10);
}

TEST(step_plan, outlines_are_no_reason_to_cut_a_piece) {
    random_numbers random(7);
    const l3d_image_patch patch = sheet(random, 60);
    l3d_block_needs needs =
        l3d_needs_of(patch, l3d_blocks_of(patch), view_with(0.01), 0.01, l3d_quad_kind::whole);
    const l3d_step_plan usual = l3d_plan_steps(needs, 0.02, l3d_quad_kind::whole);
    ASSERT_LE(std::max(usual.most_u(), usual.most_v()), l3d_most_steps_whole);
    needs.finer_outlines = 100;
    const l3d_step_plan finer = l3d_plan_steps(needs, 0.02, l3d_quad_kind::whole);
    EXPECT_EQ(finer.nu, usual.nu);
    EXPECT_EQ(finer.nv, usual.nv);
}

TEST(step_plan, blocks_of_pieces_may_fold_where_those_of_their_patch_may) {
    l3d_dice_view view = view_with(0.25);
    view.shading.antialias = true;
    view.folds = 1U << (4 * 2 + 3); // the third row, the last column
    l3d_block_needs needs;
    needs.strips = 4;
    const auto folds_of = [&](const l3d_patch_part& piece) {
        l3d_ask_for_outlines(piece, view, needs);
        return needs.folds;
    };
    EXPECT_EQ(folds_of({{}, 0, 1, 0, 1}), view.folds);
    EXPECT_DOUBLE_EQ(needs.finer_outlines, 3); // 1 + (1/4) / (1/8)
    EXPECT_EQ(folds_of({{}, 0, 0.5, 0, 1}), 0U);
    EXPECT_EQ(folds_of({{}, 0.5, 1, 0.5, 1}), 0x00ccU);
    EXPECT_EQ(folds_of({{}, 0.75, 1, 0.5, 0.75}), 0xffffU);
    needs.strips = 1;
    EXPECT_EQ(folds_of({{}, 0, 1, 0, 1}), 1U);
    view.shading.antialias = false;
    l3d_ask_for_outlines({{}, 0, 1, 0, 1}, view, needs);
    EXPECT_DOUBLE_EQ(needs.finer_outlines, 1);
}

TEST(step_plan, a_finer_tolerance_never_takes_fewer_quads) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        random_numbers random(seed);
        const l3d_image_patch patch = sheet(random, random.of_any_size(1, 100));
        for (const auto kind : {l3d_quad_kind::whole, l3d_quad_kind::triangles}) {
            int before = 0;
            for (double budget = 4; budget > 0.01; budget /= 1.5) {
                const l3d_step_plan plan = plan_of(patch, budget, kind);
                EXPECT_GE(total(plan.nu) * total(plan.nv), before)
                    << "seed " << seed << " budget " << budget;
                before = total(plan.nu) * total(plan.nv);
            }
        }
    }
}

TEST(step_plan, steps_grow_as_the_inverse_root_of_the_tolerance) {
    random_numbers random(7);
    const l3d_image_patch patch = sheet(random, 60);
    const l3d_step_plan coarse = plan_of(patch, 0.16), fine = plan_of(patch, 0.16 / 16);
    EXPECT_GT(total(coarse.nu), 12);
    EXPECT_NEAR(total(fine.nu) / double(total(coarse.nu)), 4, 0.5);
    EXPECT_NEAR(total(fine.nv) / double(total(coarse.nv)), 4, 0.5);
}

TEST(step_plan, triangles_need_more_than_quads) {
    random_numbers random(9);
    const l3d_image_patch patch = sheet(random, 60);
    const l3d_step_plan quads = plan_of(patch, 0.1);
    const l3d_step_plan triangles = plan_of(patch, 0.1, l3d_quad_kind::triangles);
    EXPECT_GT(total(triangles.nu) * total(triangles.nv), total(quads.nu) * total(quads.nv));
}

TEST(step_plan, of_trims_counts_the_triangles_that_they_cut) {
    l3d_block_needs needs; // a saddle: its quads are exact, and triangles are not
    needs.visible = true;
    needs.uv[0] = 16;
    const auto steps_of = [&](l3d_quad_kind kind) {
        const l3d_step_plan plan = l3d_plan_steps(needs, 0.1, kind);
        EXPECT_LE(plan.chord_error, 0.1);
        EXPECT_NEAR(plan.chord_error * plan.nu[0] * plan.nv[0],
                    kind == l3d_quad_kind::whole ? 1 : 4, 1e-12);
        return plan.nu[0] * plan.nv[0];
    };
    EXPECT_EQ(steps_of(l3d_quad_kind::trimmed), steps_of(l3d_quad_kind::triangles));
    EXPECT_LT(steps_of(l3d_quad_kind::whole), steps_of(l3d_quad_kind::trimmed) / 3);
}

TEST(step_plan, a_plane_takes_one_step_and_a_hidden_patch_is_not_visible) {
    l3d_image_patch plane, hidden;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            plane.at(r, c) = {-90.0 + 50 * c + 7 * r, 20.0 + 30 * r, 3 + 0.25 * c};
            hidden.at(r, c) = {4 * (-900.0 + 50 * c * c), 4 * (20.0 + 30 * r * c), 4};
        }
    const l3d_step_plan flat = plan_of(plane, 0.05);
    EXPECT_TRUE(flat.visible);
    EXPECT_EQ(total(flat.nu), 4);
    EXPECT_EQ(total(flat.nv), 4);
    EXPECT_LT(flat.chord_error, 1e-9);
    EXPECT_FALSE(plan_of(hidden, 0.05).visible);
}

TEST(step_plan, sides_of_quads_stay_within_48_pixels) {
    l3d_image_patch plane;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            plane.at(r, c) = {4.0 * (-250 + 160 * c), 4.0 * (-170 + 70 * r), 4};
    const l3d_step_plan plan = plan_of(plane, 0.5);
    // Blocks of 120 by 52.5 pixels.
    EXPECT_EQ(plan.nu, (std::array{3, 3, 3, 3}));
    EXPECT_EQ(plan.nv, (std::array{2, 2, 2, 2}));
}

TEST(step_plan, near_the_eye_the_exact_w_stays_above_half_the_near_plane) {
    // Depth changes sign in a parabola: without its own budget 1 step would do on the axis.
    l3d_image_patch through;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            through.at(r, c) = {1e-6 * c, 2e-6 * r, 5.0 - 4 * c + 3 * (c == 3)};
    const auto blocks = l3d_blocks_of(through);
    const l3d_step_plan plan = plan_of(through, 0.5, l3d_quad_kind::triangles);
    for (std::size_t a = 0; a < 4; ++a) {
        const l3d_depth_range depth = l3d_depth_range_of(blocks[a].points);
        if (depth.most <= 0.1 || depth.least > 0.1)
            continue;
        const double bend = l3d_depth_bounds_of(blocks[a]).uu / (8.0 * plan.nu[a] * plan.nu[a]);
        EXPECT_LE(bend, 0.05);
        EXPECT_GT(plan.nu[a], 1);
    }
}

/// A net of 60 x 60 pixels at distance 3 whose middle rises by `bend` pixels.
l3d_image_patch small_sheet(double bend) {
    l3d_image_patch result;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            const double up = bend * (r % 3 == 0 ? 0 : 1) * (c % 3 == 0 ? 0 : 1);
            result.at(r, c) = {3 * (20.0 * c - 30), 3 * (20.0 * r - 30 + up), 3.0};
        }
    return result;
}

TEST(step_plan, nets_are_one_block_where_three_steps_keep_the_budget) {
    const l3d_dice_view view = view_with(0.5);
    int blocks = 0;
    for (double bend = 0; bend < 10; bend += 0.125) {
        const l3d_image_patch net = small_sheet(bend);
        if (!l3d_is_one_block(net, l3d_image_box_of(net.points), view))
            continue;
        ++blocks;
        const l3d_step_plan plan =
            l3d_plan_steps(l3d_image_net(net), std::span(&net, 1), view, 0.5, l3d_quad_kind::whole);
        EXPECT_EQ(plan.strips, 1);
        EXPECT_LE(plan.chord_error, 0.5);
        // Quads of at most l3d_largest_quad pixels may want four steps.
        EXPECT_LE(std::max(plan.nu[0], plan.nv[0]), l3d_most_steps_of_one_block + 1);
    }
    EXPECT_GT(blocks, 4);
    EXPECT_LT(blocks, 40);
}

TEST(step_plan, small_nets_are_one_block_and_large_ones_are_not) {
    const l3d_dice_view view = view_with(0.5);
    for (const double size : {0.3, 1.8}) {
        l3d_image_patch net = small_sheet(size < 1 ? 10 : 0);
        for (l3d_image_point& p : net.points)
            p = {p[0] * size, p[1] * size, p[2]};
        EXPECT_EQ(l3d_is_one_block(net, l3d_image_box_of(net.points), view), size < 1);
        EXPECT_EQ(l3d_is_one_strip(net.row(0), l3d_image_box_of(net.row(0).points), view),
                  size < 1);
    }
}

TEST(step_plan, an_edge_is_one_strip_in_both_directions_or_in_none) {
    int strips = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        random_numbers random(seed);
        l3d_dice_view view = view_with(0.5);
        view.focal = seed % 2 == 0 ? 500 : 0;
        l3d_image_curve edge = small_sheet(0).row(0);
        for (l3d_image_point& p : edge.points)
            for (int k = 0; k < 3; ++k)
                p[k] += random.between(-1, 1) * (k == 2 ? 0.01 : 4);
        l3d_image_curve other = edge;
        std::reverse(other.points.begin(), other.points.end());
        const l3d_image_box hull = l3d_image_box_of(edge.points);
        EXPECT_EQ(l3d_is_one_strip(edge, hull, view), l3d_is_one_strip(other, hull, view));
        strips += l3d_is_one_strip(edge, hull, view);
    }
    EXPECT_GT(strips, 200);
    EXPECT_LT(strips, 1800);
}

TEST(net_bends, are_those_of_differences_one_by_one_with_every_instruction_set) {
    constexpr double focal = 800;
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        random_numbers random(7);
        for (int i = 0; i < 200; ++i) {
            const l3d_image_patch net = sheet(random, random.of_any_size(0.1, 40));
            const l3d_image_box hull = l3d_image_box_of(net.points);
            const double x = (hull.left + hull.right) / 2, y = (hull.top + hull.bottom) / 2;
            const auto raise = [&](double& most, const auto& difference) {
                const double w = difference(2), dx = difference(0) - x * w,
                             dy = difference(1) - y * w, dw = focal * w;
                most = std::max(most, std::sqrt(dx * dx + dy * dy + dw * dw));
            };
            l3d_net_bends expected;
            expected.least_w = net.points[0][2];
            for (const l3d_image_point& p : net.points)
                expected.least_w = std::min(expected.least_w, p[2]);
            for (int r = 0; r < 4; ++r)
                for (int c = 0; c < 4; ++c) {
                    const auto at = [&](int row, int column, int k) {
                        return net.at(row, column)[k];
                    };
                    if (c < 2)
                        raise(expected.uu, [&](int k) {
                            return at(r, c, k) + at(r, c + 2, k) - 2 * at(r, c + 1, k);
                        });
                    if (r < 2)
                        raise(expected.vv, [&](int k) {
                            return at(r, c, k) + at(r + 2, c, k) - 2 * at(r + 1, c, k);
                        });
                    if (r < 3 && c < 3)
                        raise(expected.uv, [&](int k) {
                            return at(r, c, k) - at(r, c + 1, k) - at(r + 1, c, k) +
                                   at(r + 1, c + 1, k);
                        });
                }
            const l3d_net_bends bends = l3d_bends_of(net, hull, focal);
            ASSERT_EQ(bends.uu, expected.uu) << target;
            ASSERT_EQ(bends.vv, expected.vv) << target;
            ASSERT_EQ(bends.uv, expected.uv) << target;
            ASSERT_EQ(bends.least_w, expected.least_w) << target;
        }
    }
    l3d_set_simd_target({});
}

} // namespace
} // namespace dice_tests
