// SPDX-License-Identifier: MIT
// The pixels that outlines reach, against an exact judge; and that holes are nowhere else.
#include "hard_edged.h"
#include "../scene/bodies.h"
#include "../dice/scene.h"
#include "words_of.h"

#include "pipeline/pipeline_afd.h"
#include "raster/rasterizer_factory.h"
#include "reference/measure.h"
#include "reference/random_numbers.h"
#include "reference/random_patches.h"
#include "reference/second_judge.h"
#include "tool_2d/screen_memory.h"
#include "raster/pixel_bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using dice_tests::scene;
using reference::outline_kind;

struct frame {
    std::vector<std::uint32_t> words;
    l3d_depth_buffer depth;
    l3d_pixel_bits mask;
    l3d_frame_report report;
};

std::unique_ptr<l3d_pipeline_afd> pipeline_of(const scene& s, const l3d_afd_settings& settings) {
    l3d_patch_scene world;
    world.add(s.model, s.placement);
    return std::make_unique<l3d_pipeline_afd>(l3d_memory_canvas(s.size), world, s.camera, settings);
}

frame drawn(const scene& s, double tolerance, int threads = 1) {
    l3d_afd_settings settings = hard_edged();
    settings.tolerance = tolerance;
    settings.depth = settings.outlines = true;
    settings.threads = threads;
    const auto pipeline = pipeline_of(s, settings);
    pipeline->draw_event();
    frame result{words_of(pipeline->screen().pixels()), pipeline->depth(), {}, pipeline->report()};
    const l3d_pixel_bits* const mask = pipeline->outlines();
    EXPECT_NE(mask, nullptr);
    if (mask != nullptr)
        result.mask = *mask;
    EXPECT_EQ(result.report.outline_pixels, result.mask.count());
    return result;
}

/// So many levels from the exact picture are seen as wrong.
constexpr int far_levels = 20;

/// The share that a mask holds of the pixels that it must hold.
struct agreement {
    std::int64_t wanted = 0, marked = 0;
    std::int64_t missed = 0; ///< where a surface ends, jumps or breaks within the bound
    std::int64_t close = 0; ///< not marked, though another sheet lies close behind within the bound
    std::int64_t holes = 0; ///< not marked, though drawn and exact picture differ in being covered
    std::int64_t other = 0; ///< not marked, though another sheet is drawn than the exact one
    std::int64_t far = 0;   ///< not marked, though farther than far_levels from the exact level

    void add(const agreement& more) {
        wanted += more.wanted;
        marked += more.marked;
        missed += more.missed;
        close += more.close;
        holes += more.holes;
        other += more.other;
        far += more.far;
    }
    double ratio() const {
        return static_cast<double>(marked) / static_cast<double>(std::max<std::int64_t>(wanted, 1));
    }
};

agreement compare(const std::string& name, const scene& s, double tolerance) {
    const frame f = drawn(s, tolerance);
    const reference::exact_image exact(s.patches, s.eye, s.picture());
    const reference::camera_frame camera(s.eye, s.picture());
    const reference::second_judge judge(s.patches, s.eye, s.picture());
    const double bound = f.report.dice.bound_px;
    const double depth =
        std::isfinite(f.report.dice.depth_bound_px) ? f.report.dice.depth_bound_px : bound;
    const std::vector<unsigned char> levels = exact.lambert(reference::project_light);
    agreement sum;
    std::string where;
    const auto note = [&](bool is_wrong, std::int64_t& count, const char* what, int x, int y) {
        if (is_wrong && ++count <= 3)
            where +=
                std::string(" ") + what + " (" + std::to_string(x) + ", " + std::to_string(y) + ")";
    };
    for (int y = 0; y < s.size.height; ++y)
        for (int x = 0; x < s.size.width; ++x) {
            const outline_kind kind = judge.outline_within(x + 0.5, y + 0.5, bound, 2 * depth);
            const bool is_marked = f.mask.has(x, y);
            sum.wanted += kind != outline_kind::none;
            sum.marked += is_marked;
            if (is_marked)
                continue;
            const float inv_w = f.depth.row(y)[static_cast<std::size_t>(x)];
            note(kind == outline_kind::close, sum.close, "close", x, y);
            note(kind != outline_kind::close && kind != outline_kind::none, sum.missed, "missed", x,
                 y);
            note(exact.covered(x, y) != (inv_w > 0), sum.holes, "hole", x, y);
            const std::size_t at = static_cast<std::size_t>(y * s.size.width + x);
            note(std::abs(static_cast<int>(f.words[at] & 0xff) - levels[at]) > far_levels, sum.far,
                 "far", x, y);
            // The sheet is off by `depth` along the normal, and bends within the bound of place.
            note(exact.covered(x, y) && inv_w > 0 &&
                     reference::depth_error_px(exact.at(x, y), camera, x, y, 1 / inv_w) >
                         3 * (bound + depth),
                 sum.other, "other", x, y);
        }
    std::printf("%s, %.2f px: %ld pixels of outlines, %ld marked, ratio %.2f; not marked: %ld "
                "outlines, %ld close, %ld holes, %ld other sheets, %ld far levels; %.1f ms\n",
                name.c_str(), tolerance, static_cast<long>(sum.wanted),
                static_cast<long>(sum.marked), sum.ratio(), static_cast<long>(sum.missed),
                static_cast<long>(sum.close), static_cast<long>(sum.holes),
                static_cast<long>(sum.other), static_cast<long>(sum.far),
                f.report.time_ms.outlines);
    EXPECT_EQ(sum.missed, 0) << name << where;
    EXPECT_EQ(sum.holes, 0) << name << where;
    EXPECT_EQ(sum.other, 0) << name << where;
    return sum;
}

/// Sheets beside a fold that are not alike may be close a little farther from it than is foreseen.
void expect_few_are_close(const agreement& sum) {
    std::printf(
        "in all: %ld pixels of outlines, ratio %.2f; not marked: %ld close, %ld far levels\n",
        static_cast<long>(sum.wanted), sum.ratio(), static_cast<long>(sum.close),
        static_cast<long>(sum.far));
    EXPECT_LE(100 * sum.close, sum.wanted);
    EXPECT_LT(sum.ratio(), 3);
}

constexpr double tolerances[] = {1, 0.25, 0.05};
const l3d_size small{thorough ? 80 : 64, thorough ? 60 : 48};

/// In every fourth view with sanitizers, which need minutes for all of them.
TEST(outlines, of_the_teapot_lie_in_the_mask_in_every_view) {
    agreement sum;
    const auto& views = reference::project_views();
    for (std::size_t i = 0; i < views.size(); i += thorough ? 1 : 4)
        for (const double tolerance : tolerances)
            sum.add(compare("teapot, " + std::string(views[i].name),
                            dice_tests::teapot(views[i], small), tolerance));
    expect_few_are_close(sum);
}

/// From 1e5 away floats tell no depths apart that are nearer than some pixels: the bound says so,
/// and most pixels in which two bumps lie are marked.
TEST(outlines, of_bumps_and_domes_lie_in_the_mask) {
    for (const double tolerance : tolerances) {
        compare("dome",
                scene(reference::load_bpt_plain("tests/data/dome.bpt"),
                      {{0.1, 0.2, 13.94}, {0, 0, 0}, {0.1, 1, 0}, 38, 0.1}, small),
                tolerance);
        const auto bumps = reference::load_bpt_plain("tests/data/bump3.bpt");
        compare("bumps", scene(bumps, {{0, 0, 1e5}, {0, 0, 0}, {0, 1, 0}, 0.0012, 0.1}, small),
                tolerance);
        compare("near bumps", scene(bumps, {{1, 2, 4}, {0, 0, 0}, {0, 1, 0}, 38, 0.1}, small),
                tolerance);
    }
}

TEST(outlines, of_random_bodies_and_patches_lie_in_the_mask) {
    reference::random_numbers random(21);
    const reference::camera eye{{2.1, 3.2, 4.3}, {0, 0, 0}, {0.1, 1, 0.2}, 38, 0.1};
    agreement sum;
    for (const auto kind : {dice_tests::body_kind::starfish, dice_tests::body_kind::bent,
                            dice_tests::body_kind::flattened, dice_tests::body_kind::toroidal}) {
        const scene s(dice_tests::random_body(random, kind), eye, small);
        for (const double tolerance : tolerances)
            sum.add(compare("body " + std::to_string(static_cast<int>(kind)), s, tolerance));
    }
    for (const auto kind : {reference::patch_kind::moderate, reference::patch_kind::folded})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const scene s(
                reference::random_patches(seed, kind, 12, eye, {small.width, small.height}), eye,
                small);
            sum.add(compare("patches " + std::to_string(static_cast<int>(kind)), s, 0.5));
        }
    expect_few_are_close(sum);
}

scene view_of_holes() {
    return scene(reference::load_bpt_plain("data/teapot.bpt"),
                 {{3.1735171013201935, -2.0885727807874357, 1.7249202395510654},
                  {0.2625, 1.5, 0},
                  {0.11521453, 0.97436021, -0.19325578},
                  125,
                  0.00822},
                 {641, 479});
}

/// Outlines of handle and body meet there, each within its bound.
TEST(outlines, reach_the_holes_where_two_of_them_meet) {
    const scene s = view_of_holes();
    const reference::second_judge judge(s.patches, s.eye, s.picture());
    for (const double tolerance : {4.0, 2.0, 1.0, 0.5}) {
        const frame f = drawn(s, tolerance);
        int holes = 0, inner = 0;
        const auto is_drawn = [&](int x, int y) {
            return f.depth.row(y)[static_cast<std::size_t>(x)] > 0;
        };
        for (int y = 1; y + 1 < s.size.height; ++y)
            for (int x = 1; x + 1 < s.size.width; ++x)
                if (!is_drawn(x, y) && judge.look(x + 0.5, y + 0.5).covered()) {
                    ++holes;
                    inner += is_drawn(x - 1, y) && is_drawn(x + 1, y) && is_drawn(x, y - 1) &&
                             is_drawn(x, y + 1);
                    EXPECT_TRUE(f.mask.has(x, y)) << x << ", " << y;
                }
        std::printf("%.1f px: %d pixels are not drawn though covered, %d of them holes; %ld "
                    "marked\n",
                    tolerance, holes, inner, static_cast<long>(f.mask.count()));
    }
}

TEST(outlines, where_one_connected_sheet_covers_there_is_no_hole) {
    std::int64_t pixels = 0, uncovered = 0, marked = 0;
    for (std::uint64_t seed = 1; seed <= (thorough ? 60 : 8); ++seed) {
        reference::random_numbers random(seed);
        const reference::camera eye{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, random.between(20, 90), 0.1};
        const int k = static_cast<int>(random.of_any_size(1, 8.99));
        const double fold = random.between(0, 2), range = random.between(0, 4);
        const scene s(
            reference::random_tiling(seed, k, fold, range, eye, {small.width, small.height}), eye,
            small);
        const frame f = drawn(s, random.of_any_size(0.05, 4));
        marked += f.mask.count();
        for (int y = 0; y < small.height; ++y)
            for (const float inv_w : f.depth.row(y))
                uncovered += inv_w == 0;
        pixels += std::int64_t{small.width} * small.height;
    }
    std::printf("%ld of %ld pixels not covered; %ld marked\n", static_cast<long>(uncovered),
                static_cast<long>(pixels), static_cast<long>(marked));
    EXPECT_EQ(uncovered, 0);
}

TEST(outlines, are_the_same_bits_for_any_number_of_threads) {
    const scene s = dice_tests::teapot(reference::project_view("closeup"), {320, 240});
    const frame one = drawn(s, 0.25);
    EXPECT_GT(one.mask.count(), 0);
    for (const int threads : {2, 7})
        EXPECT_TRUE(drawn(s, 0.25, threads).mask == one.mask) << threads;
}

TEST(outlines, change_no_bit_of_the_picture_and_are_null_unasked) {
    const scene s = dice_tests::teapot(reference::project_view("full"), {320, 240});
    l3d_afd_settings settings = hard_edged();
    const auto without = pipeline_of(s, settings);
    without->draw_event();
    EXPECT_EQ(without->outlines(), nullptr);
    EXPECT_EQ(without->report().outline_pixels, l3d_surface_counts::none_counted);
    EXPECT_NE(without->report().json().find("\"outline_pixels\":null"), std::string::npos);
    settings.outlines = true;
    const auto with = pipeline_of(s, settings);
    with->draw_event();
    EXPECT_EQ(words_of(with->screen().pixels()), words_of(without->screen().pixels()));
    const std::int64_t count = with->report().outline_pixels;
    EXPECT_GT(count, 0);
    EXPECT_NE(with->report().json().find("\"outline_pixels\":" + std::to_string(count)),
              std::string::npos);
    EXPECT_NE(with->report().explanation().find(std::to_string(count)), std::string::npos);
    with->draw_event(); // a picture that stays keeps what was counted in it
    EXPECT_EQ(with->report().outline_pixels, count);
}

} // namespace
