// SPDX-License-Identifier: MIT
// Things left out, judged by exact pictures of random bodies and of tiny things.
#include "hard_edged.h"
#include "../scene/bodies.h"
#include "../dice/scene.h"
#include "drawn_picture.h"

#include "reference/measure.h"
#include "scene/culling/facing_cones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

namespace {

using dice_tests::body_kind;
using dice_tests::scene;
using pipeline_tests::picture;
using reference::random_numbers;
using reference::vec3;

constexpr l3d_size size{96, 72};

/// The accuracy of the reference (picture_test).
constexpr double reference_error = 5e-3, reference_part = 0.02;

struct judge {
    explicit judge(const scene& s)
        : exact(s.patches, s.eye, s.picture()), region(s.patches, s.eye, s.picture()) {}

    reference::exact_image exact;
    reference::exact_region region;
};

double determinant(const l3d_matrix<double>& m) {
    const auto column = [&](int k) { return l3d_vector<double, 3>(m(0, k), m(1, k), m(2, k)); };
    return l3d_dot(column(0), l3d_cross<double>(column(1), column(2)));
}

/// Whether the exact picture shows the side of a surface that dS/du x dS/dv points to.
bool shows_front(const scene& s, const reference::exact_sample& sample, int x, int y) {
    const reference::camera_frame frame(s.eye, s.picture());
    const vec3 at = frame.unproject(x + 0.5, y + 0.5, sample.w);
    const vec3& n = sample.normal;
    const double away =
        (at.x - s.eye.eye.x) * n.x + (at.y - s.eye.eye.y) * n.y + (at.z - s.eye.eye.z) * n.z;
    return away * determinant(s.placement) < 0;
}

/// A block of a patch: what is left out at once.
std::size_t block_of(double u, double v) {
    const auto quarter = [](double t) {
        return std::min(static_cast<std::size_t>(4 * t), std::size_t{3});
    };
    return 4 * quarter(v) + quarter(u);
}

struct seen_count {
    int fronts = 0, backs = 0;           ///< pixels of the exact picture
    int fronts_lost = 0, backs_lost = 0; ///< of them, those that show what dicing left out
    l3d_dice_counts dice;
};

seen_count seen_of(const scene& s, const reference::exact_image& exact, double tolerance,
                   bool one_sided) {
    std::vector<unsigned> left_out(s.patches.size(), l3d_facing_cones::all);
    seen_count result;
    result.dice = dice_tests::scene_dicer<float>().dice(
        s, tolerance,
        [&](std::size_t patch, dice_tests::diced pieces, double) {
            if (!pieces.empty())
                left_out[patch] = pieces.size() == 1 ? pieces[0].part.unseen : 0;
        },
        {}, one_sided);
    for (int y = 0; y < s.size.height; ++y)
        for (int x = 0; x < s.size.width; ++x)
            if (const reference::exact_sample& sample = exact.at(x, y); sample.covered()) {
                const unsigned blocks = left_out[static_cast<std::size_t>(sample.patch)];
                const bool lost = (blocks >> block_of(sample.u, sample.v) & 1) != 0;
                const bool front = shows_front(s, sample, x, y);
                ++(front ? result.fronts : result.backs);
                (front ? result.fronts_lost : result.backs_lost) += lost;
            }
    return result;
}

/// Everything that is covered is covered within the bound, and nothing else.
reference::measurement expect_within_bound(const picture& drawn, const judge& by) {
    const reference::measurement m = reference::measure(drawn.distances, by.exact, by.region);
    const double bound = drawn.report.dice.bound_px;
    EXPECT_TRUE(m.distances_complete);
    EXPECT_LE(m.max_extra_distance, bound + reference_error);
    EXPECT_LE(m.max_missing_distance, bound * (1 + reference_part) + reference_error);
    // The error of the depth is compared in the mean, as nothing more is promised.
    EXPECT_LE(m.mean_depth_px, bound + reference_error);
    return m;
}

/// Where the pictures differ, they are beside an outline: where a front ends, a back may have
/// begun.
int expect_same_but_for_outlines(const picture& less, const picture& all, const judge& by) {
    const double bound = less.report.dice.bound_px;
    int differ = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto i = static_cast<std::size_t>(y * size.width + x);
            if (less.distances[i] == all.distances[i])
                continue;
            ++differ;
            EXPECT_LE(by.region.distance_to_outline(x + 0.5, y + 0.5),
                      bound * (1 + reference_part) + reference_error)
                << x << ", " << y << ": " << less.distances[i] << " and " << all.distances[i];
        }
    return differ;
}

/// With nothing left out.
picture all_of(const scene& s, const l3d_patch_scene& world, l3d_afd_settings settings) {
    settings.keep = l3d_kept_work::all();
    return pipeline_tests::drawn(s, world, settings);
}

/// Pixels that are covered only if nothing is left out.
int lost(const picture& less, const picture& all) {
    int count = 0;
    for (std::size_t i = 0; i < all.distances.size(); ++i)
        count += std::isfinite(all.distances[i]) && !std::isfinite(less.distances[i]);
    return count;
}

l3d_matrix<double> random_placement(random_numbers& random) {
    l3d_matrix<double> m = l3d_translation<double>(random.between(-9, 9), random.between(-9, 9),
                                                   random.between(-9, 9));
    m = m * l3d_rotation<double>({random.between(-1, 1), random.between(-1, 1), 1.2},
                                 random.between(-172, 172));
    for (int k = 0; k < 3; ++k) {
        const double scale = random.between(0.5, 2) * (random.below(2) == 0 ? 1 : -1);
        for (int row = 0; row < 3; ++row)
            m(row, k) *= scale;
    }
    return m;
}

enum class eye_place { far, near, inside };

/// The eye as the body sees it. Inside: a point that all of a kind's bodies have inside.
l3d_vector<double, 4> random_eye(random_numbers& random, body_kind kind, eye_place where) {
    if (where == eye_place::inside)
        return {kind == body_kind::toroidal ? 1.2 : 0.01, 0.002, 0.003, 1.0};
    const double distance =
        where == eye_place::far ? random.between(2.5, 8) : random.between(1.2, 2.5);
    const double height = random.between(-1, 1), around = random.between(-3.2, 3.2);
    const double out = distance * std::sqrt(1 - height * height);
    return {out * std::cos(around), distance * height, out * std::sin(around), 1.0};
}

scene random_scene(random_numbers& random, body_kind kind, eye_place where) {
    const std::vector<reference::patch> body = dice_tests::random_body(random, kind);
    const l3d_matrix<double> placement = random_placement(random);
    const auto eye = placement * random_eye(random, kind, where);
    const auto target = placement * l3d_vector<double, 4>(random.between(-0.4, 0.4), 0.1,
                                                          random.between(-0.4, 0.4), 1.0);
    reference::camera view;
    view.eye = {eye[0], eye[1], eye[2]};
    view.target = {target[0], target[1], target[2]};
    view.up = {random.between(-0.3, 0.3), 1, 0.2};
    view.near = where == eye_place::far ? 0.1 : 0.001;
    return {body, placement, view, size};
}

TEST(leaving_out, of_random_bodies_backs_loses_nothing_of_the_exact_picture) {
    const int scenes = thorough ? 120 : 24;
    std::int64_t blocks = 0, closed = 0, differ = 0, pixels = 0, inside = 0;
    std::int64_t covered = 0, judged = 0;
    for (int i = 0; i < scenes; ++i) {
        SCOPED_TRACE(i);
        random_numbers random(static_cast<std::uint64_t>(i));
        const auto kind = static_cast<body_kind>(i % 4);
        const auto where = static_cast<eye_place>(i / 4 % 3);
        const scene s = random_scene(random, kind, where);
        const judge by(s);
        l3d_afd_settings settings = hard_edged();
        settings.tolerance = random.of_any_size(0.05, 2);
        settings.depth = true;
        settings.one_sided = random.below(3) == 0;
        const seen_count seen = seen_of(s, by.exact, settings.tolerance, settings.one_sided);
        EXPECT_EQ(seen.fronts_lost, 0) << "of " << seen.fronts;
        if (!settings.one_sided) {
            EXPECT_EQ(seen.backs_lost, 0) << "of " << seen.backs;
        }
        blocks += 16 * seen.dice.backfacing + seen.dice.back_blocks;
        closed += s.model.orientation() != 0;
        pixels += seen.fronts + seen.backs;
        inside += seen.backs;
        if (settings.one_sided && seen.backs > 0)
            continue; // they are not to be seen
        l3d_patch_scene world;
        world.add(s.model, s.placement);
        const picture less = pipeline_tests::drawn(s, world, settings);
        const reference::measurement m = expect_within_bound(less, by);
        EXPECT_EQ(m.holes, 0);
        covered += m.covered_exact;
        judged += m.depth_compared;
        const picture all = all_of(s, world, settings);
        if (all.report.dice.clipped == 0)
            differ += expect_same_but_for_outlines(less, all, by);
    }
    std::printf(
        "of %d bodies %ld are proven closed, %ld blocks left out; %ld pixels covered, %ld of "
        "them by insides, %ld differ; depth judged in %.1f %%\n",
        scenes, static_cast<long>(closed), static_cast<long>(blocks), static_cast<long>(pixels),
        static_cast<long>(inside), static_cast<long>(differ),
        100 * reference::judged_share(judged, covered));
    EXPECT_GT(reference::judged_share(judged, covered), 0.8);
    EXPECT_GT(closed, scenes / 4);
    EXPECT_GT(blocks, 20 * scenes);
    EXPECT_GT(inside, 500 * scenes);
}

/// Many bodies, whose patches are a twentieth of a pixel to two pixels wide.
scene tiny_patches(random_numbers& random, int bodies) {
    reference::camera view;
    view.eye = {2, 3, 50};
    const double focal = size.height / 2.0 / std::tan(view.fov_degrees * 3.14159265358979 / 360);
    const reference::camera_frame frame(view, {size.width, size.height});
    std::vector<reference::patch> patches;
    for (int i = 0; i < bodies; ++i) {
        const double width = random.of_any_size(0.05, 1.5), w = focal / width;
        const vec3 at =
            frame.unproject(random.between(0, size.width), random.between(0, size.height), w);
        const auto place =
            l3d_translation<double>(at.x, at.y, at.z) *
            l3d_rotation<double>({random.between(-1, 1), 1.0, 0.3}, random.between(-172, 172));
        const auto kind = static_cast<body_kind>(random.below(4));
        for (const reference::patch& p :
             dice_tests::placed(dice_tests::random_body(random, kind), place))
            patches.push_back(p);
    }
    return {std::move(patches), view, size};
}

TEST(leaving_out,
     of_dicing_of_thousands_of_tiny_patches_covers_the_exact_picture_within_the_bound) {
    const int scenes = thorough ? 6 : 2;
    std::int64_t points = 0, patches = 0, covered = 0;
    double worst = 0;
    for (int i = 0; i < scenes; ++i) {
        random_numbers random(static_cast<std::uint64_t>(1000 + i));
        const scene s = tiny_patches(random, 160);
        const judge by(s);
        for (const double tolerance : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) {
            SCOPED_TRACE(testing::Message() << i << ", tolerance " << tolerance);
            const seen_count seen = seen_of(s, by.exact, tolerance, false);
            EXPECT_EQ(seen.fronts_lost + seen.backs_lost, 0);
            l3d_afd_settings settings = hard_edged();
            settings.tolerance = tolerance;
            settings.depth = true;
            const picture less = pipeline_tests::drawn(s, s.model, settings);
            const l3d_dice_counts& counts = less.report.dice;
            EXPECT_LE(counts.bound_px, tolerance);
            expect_within_bound(less, by);
            EXPECT_EQ(lost(less, all_of(s, s.model, settings)), 0);
            points += counts.as_points;
            patches += counts.drawn;
            covered += seen.fronts + seen.backs;
            worst = std::max(worst, counts.bound_px);
        }
    }
    std::printf("%ld of %ld patches are points; %ld pixels covered; bound at most %.3f\n",
                static_cast<long>(points), static_cast<long>(patches), static_cast<long>(covered),
                worst);
    EXPECT_GT(points, 300 * scenes);
}

TEST(leaving_out, of_backs_on_request_shows_fronts_to_an_eye_in_a_body) {
    reference::camera view;
    view.eye = {0.1, 0.2, -0.1};
    view.target = {1, 0.3, 0.2};
    const scene s(dice_tests::inside_out(dice_tests::ball()), view, size);
    ASSERT_EQ(s.model.orientation(), -1);
    const reference::exact_image exact(s.patches, s.eye, s.picture());
    const seen_count seen = seen_of(s, exact, 0.25, true);
    EXPECT_EQ(seen.fronts, size.width * size.height);
    EXPECT_EQ(seen.fronts_lost, 0);
}

} // namespace
