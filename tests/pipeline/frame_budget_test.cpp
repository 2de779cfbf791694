// SPDX-License-Identifier: MIT
// The budget of a frame: spikes through the near plane, each of which would take as much as it
// gets.
#include "hard_edged.h"
#include "drawn_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace pipeline_tests {
namespace {

/// Patches about the origin, each with one control point that is 1e5 away.
dice_tests::scene spikes(int count, l3d_size size) {
    std::mt19937_64 random(20);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<reference::patch> patches(static_cast<std::size_t>(count));
    for (reference::patch& p : patches) {
        for (reference::vec3& point : p.points)
            point = {unit(random), unit(random), unit(random)};
        p.points[6] = {1e5 * unit(random), 1e5 * unit(random), 1e5 * unit(random)};
    }
    reference::camera eye;
    eye.eye = {0.3, 0.2, 3};
    eye.target = {0, 0, 0};
    eye.up = {0, 1, 0};
    eye.fov_degrees = 50;
    eye.near = 0.05;
    return {patches, eye, size};
}

l3d_afd_settings settings_of(double tolerance) {
    l3d_afd_settings settings = hard_edged();
    settings.tolerance = tolerance;
    return settings;
}

/// Vertices alone, those of edges not counted, are at most as many as the budget; edges are drawn
/// in any case, since neighbours have them, too.
TEST(frame_budget, limits_what_spikes_cost) {
    for (const l3d_size size : {l3d_size{16, 16}, l3d_size{160, 120}}) {
        const dice_tests::scene s = spikes(20, size);
        const picture p = drawn(s, s.model, settings_of(0.5));
        EXPECT_LE(p.report.dice.samples, l3d_usual_samples(size, 0.5)) << size.width;
        EXPECT_LE(l3d_piece_cost * p.report.dice.pieces, l3d_usual_samples(size, 0.5))
            << size.width;
        EXPECT_GT(p.report.dice.unfinished, 0);
        EXPECT_GE(p.report.dice.coarse, p.report.dice.unfinished);
        EXPECT_EQ(p.report.dice.coarsest.bound_px, p.report.dice.bound_px);
        EXPECT_NE(p.report.json().find(R"("over_tolerance":{"patches":)"), std::string::npos);
        EXPECT_NE(p.report.explanation().find("--most-samples"), std::string::npos);
    }
}

TEST(frame_budget, draws_the_same_bits_with_any_number_of_threads) {
    const dice_tests::scene s = spikes(20, {64, 48});
    const picture one = drawn(s, s.model, settings_of(0.5));
    for (const int threads : {2, 3}) {
        l3d_afd_settings settings = settings_of(0.5);
        settings.threads = threads;
        const picture more = drawn(s, s.model, settings);
        EXPECT_EQ(more.words, one.words);
        EXPECT_EQ(more.report.dice.bound_px, one.report.dice.bound_px);
        EXPECT_EQ(more.report.dice.coarsest.patch, one.report.dice.coarsest.patch);
    }
}

TEST(frame_budget, lowers_the_bound_where_it_is_larger) {
    const dice_tests::scene s = spikes(3, {16, 16});
    l3d_afd_settings settings = settings_of(0.5);
    double last = std::numeric_limits<double>::infinity();
    for (const std::int64_t most : {100LL, 10'000LL, 1'000'000LL, 1'000'000'000LL}) {
        settings.most_samples = most;
        const l3d_dice_counts counts = drawn(s, s.model, settings).report.dice;
        EXPECT_LE(counts.bound_px, last);
        last = counts.bound_px;
    }
    EXPECT_LE(last, 0.5);
}

TEST(frame_budget, may_be_used_up_before_the_last_patches) {
    const dice_tests::scene s = spikes(300, {16, 16}); // patches are diced 64 at a time
    l3d_afd_settings settings = settings_of(0.5);
    settings.most_samples = 1000;
    EXPECT_GT(drawn(s, s.model, settings).report.dice.unfinished, 0);
}

TEST(frame_budget, is_more_than_ordinary_scenes_need) {
    for (const reference::view& view : reference::project_views())
        for (const auto& [size, tolerance] : {std::pair{l3d_size{64, 48}, 0.25},
                                              {l3d_size{160, 120}, 0.1},
                                              {l3d_size{1024, 768}, 0.02}}) {
            const dice_tests::scene s = dice_tests::teapot(view, size);
            const picture p = drawn(s, s.model, settings_of(tolerance));
            EXPECT_EQ(p.report.dice.unfinished, 0) << view.name << ' ' << size.width;
        }
}

} // namespace
} // namespace pipeline_tests
