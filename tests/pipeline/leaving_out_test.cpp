// SPDX-License-Identifier: MIT
// Pictures with and without all that can be left out: the same, or within what the frame reports.
#include "hard_edged.h"
#include "../scene/bodies.h"
#include "drawn_picture.h"

#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace {

using dice_tests::scene;
using pipeline_tests::drawn;
using pipeline_tests::picture;

struct comparison {
    picture less, all;
    int differ = 0;     ///< pixels
    int most = 0;       ///< levels, where both cover a pixel
    int farther_in = 0; ///< of those that differ by more than levels: not beside an empty pixel

    comparison(const scene& s, const l3d_patch_scene& world, l3d_afd_settings settings)
        : less(drawn(s, world, settings)) {
        settings.keep = l3d_kept_work::all();
        all = drawn(s, world, settings);
        for (int y = 0; y < s.size.height; ++y)
            for (int x = 0; x < s.size.width; ++x) {
                const auto at = static_cast<std::size_t>(y * s.size.width + x);
                const int levels = std::abs(static_cast<int>(less.words[at] & 255) -
                                            static_cast<int>(all.words[at] & 255));
                differ += levels > 0;
                if (levels <= 1)
                    continue;
                if (beside_nothing(s.size, x, y))
                    continue;
                most = std::max(most, levels);
                ++farther_in;
            }
    }

private:
    bool beside_nothing(l3d_size size, int x, int y) const {
        for (int b = std::max(y - 1, 0); b <= std::min(y + 1, size.height - 1); ++b)
            for (int a = std::max(x - 1, 0); a <= std::min(x + 1, size.width - 1); ++a)
                if (less.words[static_cast<std::size_t>(b * size.width + a)] == 0)
                    return true;
        return false;
    }
};

constexpr l3d_size small{160, 120};

l3d_matrix<double> placed_at_random(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const double far = unit(random);
    l3d_matrix<double> m =
        l3d_translation<double>(8 * unit(random), 5 * unit(random), 4 - 30 * far * far);
    m = m * l3d_rotation<double>({unit(random), unit(random), 1.5}, 172 * unit(random));
    for (int k = 0; k < 3; ++k)
        for (int row = 0; row < 3; ++row)
            m(row, k) *= 0.8 + 0.4 * unit(random);
    return m;
}

TEST(leaving_out, changes_no_bit_of_a_thousand_scenes_where_it_is_exact_and_else_a_level) {
    using reference::patch_kind;
    constexpr patch_kind kinds[] = {patch_kind::moderate, patch_kind::thin, patch_kind::folded,
                                    patch_kind::coincident, patch_kind::stiff};
    std::mt19937_64 random(20260811);
    std::uniform_real_distribution<double> unit(-1, 1);
    l3d_dice_counts left_out;
    std::int64_t shades_differ = 0, outlines_differ = 0;
    for (int i = 0; i < 1000; ++i) {
        SCOPED_TRACE(i);
        reference::camera eye;
        const double far = i % 30 == 0 ? 100 : 1;
        eye.eye = {6 * unit(random), 5 * unit(random), far * (12 + 2 * unit(random))};
        eye.target = {unit(random), unit(random), unit(random)};
        const bool bodies = i % 3 == 0;
        const scene s(bodies
                          ? (i % 2 == 0 ? dice_tests::ball() : dice_tests::ring(0.9, 0.3))
                          : reference::random_patches(static_cast<std::uint64_t>(i), kinds[i % 5],
                                                      5, eye, {small.width, small.height}),
                      eye, small);
        l3d_patch_scene world(s.model);
        for (int more = bodies ? 8 : 0; more > 0; --more)
            world.add(s.model, placed_at_random(random));
        l3d_afd_settings settings = hard_edged();
        settings.tolerance = 0.1 + 0.4 * std::abs(unit(random));
        settings.shade = i % 2 == 0 ? l3d_shade::lambert : l3d_shade::gouraud;
        const comparison c(s, world, settings);
        left_out.add(c.less.report.dice);
        EXPECT_EQ(c.farther_in, 0) << "by up to " << c.most;
        const bool backs = c.less.report.dice.backfacing > 0 || c.less.report.dice.back_blocks > 0;
        const bool points = c.less.report.dice.as_points > 0;
        if (!backs && !points) {
            EXPECT_EQ(c.less.words, c.all.words);
        }
        (backs ? outlines_differ : shades_differ) += c.differ;
        EXPECT_EQ(c.all.report.dice.drawn, c.all.report.patches);
    }
    std::printf("left out: %ld offscreen, %ld subpixel, %ld hidden, %ld backfacing, %ld blocks, "
                "%ld pixels differ where points are, %ld where backs are left out\n",
                static_cast<long>(left_out.offscreen), static_cast<long>(left_out.subpixel),
                static_cast<long>(left_out.hidden), static_cast<long>(left_out.backfacing),
                static_cast<long>(left_out.back_blocks), static_cast<long>(shades_differ),
                static_cast<long>(outlines_differ));
    EXPECT_GT(left_out.offscreen, 100);
    EXPECT_GT(left_out.subpixel, 100);
    EXPECT_GT(left_out.back_blocks, 100);
}

TEST(leaving_out, changes_the_gallery_by_a_level_at_most) {
    for (const reference::view& view : reference::project_views()) {
        if (view.name == "inside" || view.name == "near_cut")
            continue; // what is clipped is diced otherwise if all is kept
        SCOPED_TRACE(view.name);
        const scene s = dice_tests::teapot(view, {320, 240});
        const l3d_patch_scene world(s.model);
        for (const double tolerance : {1.0, 0.25, 0.05}) {
            l3d_afd_settings settings = hard_edged();
            settings.tolerance = tolerance;
            const comparison lambert(s, world, settings);
            std::printf("%.*s, %.2f px: %ld of %ld polygons by planes, %d pixels differ\n",
                        static_cast<int>(view.name.size()), view.name.data(), tolerance,
                        static_cast<long>(lambert.less.report.surface.by_plane),
                        static_cast<long>(lambert.less.report.surface.quads), lambert.differ);
            for (std::size_t i = 0; i < lambert.all.words.size(); ++i)
                ASSERT_LE(std::abs(static_cast<int>(lambert.less.words[i] & 255) -
                                   static_cast<int>(lambert.all.words[i] & 255)),
                          1);
            settings.shade = l3d_shade::gouraud;
            EXPECT_EQ(comparison(s, world, settings).differ, 0);
        }
    }
}

TEST(leaving_out, of_dicing_draws_what_is_far_as_points_within_the_tolerance) {
    std::mt19937_64 random(77);
    std::uniform_real_distribution<double> unit(-1, 1);
    const scene s(dice_tests::ball(), reference::project_view("full").eye, {320, 240});
    const l3d_camera::frame axes = s.camera.axes();
    l3d_patch_scene world;
    for (int i = 0; i < 2000; ++i) {
        const auto p = s.camera.eye + axes.forward * (1500 + 400 * unit(random)) +
                       axes.right * (500 * unit(random)) + axes.up * (400 * unit(random));
        world.add(s.model, l3d_translation<double>(p[0], p[1], p[2]));
    }
    for (const double tolerance : {0.25, 0.5, 1.0}) {
        l3d_afd_settings settings = hard_edged();
        settings.tolerance = tolerance;
        const comparison c(s, world, settings);
        const l3d_dice_counts& counts = c.less.report.dice;
        std::int64_t covered = 0, lost = 0, added = 0;
        for (std::size_t i = 0; i < c.all.words.size(); ++i) {
            covered += c.all.words[i] != 0;
            lost += c.all.words[i] != 0 && c.less.words[i] == 0;
            added += c.all.words[i] == 0 && c.less.words[i] != 0;
        }
        std::printf("%.2f px: %ld of %ld patches are points, bound %.3f; of %ld pixels %ld are "
                    "lost, %ld new\n",
                    tolerance, static_cast<long>(counts.as_points), static_cast<long>(counts.drawn),
                    counts.bound_px, static_cast<long>(covered), static_cast<long>(lost),
                    static_cast<long>(added));
        EXPECT_LE(counts.bound_px, tolerance);
        EXPECT_EQ(lost, 0);
        EXPECT_EQ(c.all.report.dice.as_points, 0);
        if (tolerance > 0.9) {
            EXPECT_GT(counts.as_points, counts.drawn / 2);
        }
    }
}

TEST(leaving_out, of_backs_on_request_leaves_out_what_turns_away) {
    const scene s(dice_tests::ring(2, 0.7), reference::project_view("full").eye, {320, 240});
    const l3d_patch_scene world(s.model);
    l3d_afd_settings settings = hard_edged();
    EXPECT_EQ(drawn(s, world, settings).report.dice.back_blocks, 0);
    const picture two_sided = drawn(s, world, settings);
    settings.one_sided = true;
    const picture one_sided = drawn(s, world, settings);
    const l3d_dice_counts& counts = one_sided.report.dice;
    std::printf("%ld patches and %ld blocks of %ld turn away, %ld quads of %ld\n",
                static_cast<long>(counts.backfacing), static_cast<long>(counts.back_blocks),
                static_cast<long>(16 * one_sided.report.patches),
                static_cast<long>(counts.back_quads),
                static_cast<long>(two_sided.report.surface.quads));
    EXPECT_GT(16 * counts.backfacing + counts.back_blocks, 16 * one_sided.report.patches / 3);
    EXPECT_NE(one_sided.report.explanation().find("backfacing"), std::string::npos);
    EXPECT_GT(counts.back_quads, two_sided.report.surface.quads / 5);
    EXPECT_LT(one_sided.report.surface.samples, two_sided.report.surface.samples * 9 / 10);
    int differ = 0;
    for (std::size_t i = 0; i < one_sided.words.size(); ++i)
        differ += one_sided.words[i] != two_sided.words[i];
    EXPECT_LE(differ, 20); // along the outline; a ring's front hides its back
}

} // namespace
