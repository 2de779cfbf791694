// SPDX-License-Identifier: MIT
// Bounds of blocks in lanes, against those of each block by itself.
#include "nasty.h"
#include "odd_view.h"
#include "dice/lanes/lane_bounds_p.h"
#include "dice/piece_bounds.h"
#include "planned_error.h"
#include "scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>

namespace dice_tests {
namespace {

l3d_dice_view view_with(double tolerance) {
    return odd_view(tolerance, 0.1);
}

/// A turned and bent sheet of 4 to 2000 pixels that touches the window, w changing up to tenfold.
l3d_image_patch sheet(random_numbers& random) {
    const double size = random.of_any_size(4, 2000), bend = random.of_any_size(0.01, 1);
    const double x0 = random.between(-400, 400), y0 = random.between(-300, 300);
    const double angle = random.between(0, 6.28), aspect = random.of_any_size(0.05, 1);
    const double near = random.of_any_size(0.2, 100), depth = random.of_any_size(1.001, 10);
    l3d_image_patch result;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            const double u = size * (c / 3.0 - 0.5 + bend * random.between(-0.5, 0.5));
            const double v = size * aspect * (r / 3.0 - 0.5 + bend * random.between(-0.5, 0.5));
            const double x = x0 + std::cos(angle) * u - std::sin(angle) * v;
            const double y = y0 + std::sin(angle) * u + std::cos(angle) * v;
            const double w = near * random.of_any_size(1, depth);
            result.at(r, c) = {x * w, y * w, w};
        }
    return result;
}

/// The error that the slow twin finds for a block with these steps, as a part of the allowed one; 0
/// if hidden.
double used_up(const l3d_block_needs& needs, const l3d_step_plan& plan, double budget) {
    double worst = 0;
    const auto strips = static_cast<std::size_t>(needs.strips);
    for (std::size_t b = 0; b < strips; ++b)
        for (std::size_t a = 0; a < strips; ++a) {
            const std::size_t i = strips * b + a;
            const l3d_second_bounds depth{needs.depth_uu[i], needs.depth_uv[i], needs.depth_vv[i]};
            worst = std::max({worst, planned_error(needs, a, b, plan.nu[a], plan.nv[b]) / budget,
                              depth.quad_error(plan.nu[a], plan.nv[b])});
        }
    return worst;
}

long quads_of(const l3d_step_plan& plan) {
    const auto total = [&](const std::array<int, 4>& steps) {
        return std::accumulate(steps.begin(), steps.begin() + plan.strips, 0L);
    };
    return total(plan.nu) * total(plan.nv);
}

TEST(lane_bounds, give_the_plans_of_the_slow_twin) {
    const std::uint64_t patches = thorough ? 100000 : 2000;
    int compared = 0, different = 0;
    long quads = 0, wanted_quads = 0;
    for (std::uint64_t seed = 1; seed <= patches; ++seed) {
        random_numbers random(seed);
        const l3d_image_patch patch = sheet(random);
        const l3d_dice_view view = view_with(random.of_any_size(0.02, 2));
        const double budget = 0.98 * view.tolerance;
        const l3d_piece_bounds<double> nets(patch, view);
        l3d_detail::lane_bounds bounds;
        bounds_in_lanes(patch, view, bounds);
        ASSERT_EQ(bounds.ordinary, nets.whole()) << "seed " << seed;
        if (!bounds.ordinary)
            continue;
        ASSERT_EQ(bounds.needs.strips, nets.blocks().size() == 1 ? 1 : 4) << "seed " << seed;
        const auto kind = l3d_quad_kind::whole;
        const l3d_block_needs slow = l3d_needs_of(patch, nets.blocks(), view, budget, kind);
        const l3d_step_plan wanted = l3d_plan_steps(slow, budget, kind);
        const l3d_step_plan plan = l3d_plan_steps(bounds.needs, budget, kind);
        if (wanted.visible) {
            ASSERT_TRUE(plan.visible) << "seed " << seed;
        }
        ASSERT_LE(used_up(slow, plan, budget), 1 + 1e-12) << "seed " << seed;
        ++compared;
        different += plan.nu != wanted.nu || plan.nv != wanted.nv;
        quads += quads_of(plan);
        wanted_quads += quads_of(wanted);
    }
    std::printf("%d plans, %d differ; %ld quads, %ld of the slow twin\n", compared, different,
                quads, wanted_quads);
    EXPECT_GT(compared, patches * 9 / 10);
    // Rounding of floats counts most where patches of 2000 pixels meet tolerances of 0.02.
    EXPECT_LT(different, compared / 20);
    EXPECT_LT(quads, wanted_quads + wanted_quads / 500);
}

TEST(lane_bounds, are_bounds_and_hardly_larger_than_the_slow_twins) {
    for (std::uint64_t seed = 1; seed <= (thorough ? 5000 : 200); ++seed) {
        random_numbers random(seed);
        const l3d_image_patch patch = sheet(random);
        const l3d_dice_view view = view_with(0.5);
        l3d_detail::lane_bounds bounds;
        bounds_in_lanes(patch, view, bounds);
        if (!bounds.ordinary)
            continue;
        const l3d_piece_bounds<double> nets(patch, view);
        const l3d_block_needs slow =
            l3d_needs_of(patch, nets.blocks(), view, view.tolerance, l3d_quad_kind::whole);
        // 2^-16 of the patch's size, and as much of what there is; six and nine times.
        const double reach = bounds.hull.width() + bounds.hull.height();
        const double slack = 9 * 0x1p-16 * reach * bounds.most_w / bounds.least_w;
        const auto compare = [&](const auto& lanes, const auto& exact) {
            for (std::size_t i = 0; i < nets.blocks().size(); ++i) {
                EXPECT_GE(lanes[i], exact[i]) << "seed " << seed << " block " << i;
                if (exact[i] > 0) {
                    EXPECT_LE(lanes[i], exact[i] * 1.0001 + 2 * slack)
                        << "seed " << seed << " block " << i;
                }
            }
        };
        compare(bounds.needs.uu, slow.uu);
        compare(bounds.needs.uv, slow.uv);
        compare(bounds.needs.vv, slow.vv);
        ASSERT_EQ(bounds.needs.balanced, slow.balanced) << "seed " << seed;
        const std::array<double, 3> lanes{bounds.needs.uuv, bounds.needs.uvv, bounds.needs.uuvv};
        const std::array<double, 3> exact{slow.uuv, slow.uvv, slow.uuvv};
        for (std::size_t i = 0; i < exact.size(); ++i) {
            EXPECT_GE(lanes[i], exact[i]) << "seed " << seed;
            EXPECT_LE(lanes[i], exact[i] * 1.0001 + 2 * slack) << "seed " << seed;
        }
    }
}

TEST(lane_bounds, refuse_what_is_not_ordinary) {
    random_numbers random(4);
    const l3d_image_patch good = sheet(random);
    const auto ordinary = [&](std::size_t at, const l3d_image_point& p) {
        l3d_image_patch patch = good;
        patch.points[at] = p;
        l3d_detail::lane_bounds bounds;
        bounds_in_lanes(patch, view_with(0.5), bounds);
        return bounds.ordinary;
    };
    EXPECT_TRUE(ordinary(7, {7, 8, 2}));
    EXPECT_FALSE(ordinary(7, {7, 8, 0.1}));
    EXPECT_FALSE(ordinary(3, {7, 8, -2}));
    EXPECT_FALSE(ordinary(12, {0, 0, 0}));
    EXPECT_FALSE(ordinary(9, {2 * l3d_guard_band, 8, 2}));
    EXPECT_FALSE(ordinary(9, {4, -2 * l3d_guard_band, 2}));
    EXPECT_FALSE(ordinary(15, {7, 8, INFINITY}));
    for (int k = 0; k < 3; ++k)
        for (const std::size_t at : {std::size_t{0}, std::size_t{6}, std::size_t{15}}) {
            l3d_image_point p{7, 8, 2};
            p[k] = NAN;
            EXPECT_FALSE(ordinary(at, p)) << k << " " << at;
        }
}

} // namespace
} // namespace dice_tests
