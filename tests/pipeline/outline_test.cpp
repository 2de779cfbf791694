// SPDX-License-Identifier: MIT
// The pixels that outlines reach, against an exact judge; and that holes are nowhere else.
#include "../dice/bodies.h"
#include "../dice/scene.h"
#include "words_of.h"

#include "pipeline/pipeline_afd.h"
#include "raster/rasterizer_factory_sw.h"
#include "reference/random_numbers.h"
#include "reference/random_patches.h"
#include "reference/second_judge.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
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
    l3d_outline_mask mask;
    l3d_frame_report report;
};

std::unique_ptr<l3d_pipeline_afd> pipeline_of(const scene& s, const l3d_afd_settings& settings) {
    l3d_screen_request request;
    request.size = s.size;
    l3d_service refusal;
    l3d_patch_scene world;
    world.add(s.model, s.placement);
    return std::make_unique<l3d_pipeline_afd>(l3d_screen_factory_memory().create(request, refusal),
                                              l3d_rasterizer_factory_sw(), world, s.camera,
                                              settings);
}

frame drawn(const scene& s, double tolerance, int threads = 1) {
    l3d_afd_settings settings;
    settings.tolerance = tolerance;
    settings.depth = settings.outlines = true;
    settings.threads = threads;
    const auto pipeline = pipeline_of(s, settings);
    pipeline->draw_event();
    frame result{words_of(pipeline->screen().pixels()), pipeline->depth(), {}, pipeline->report()};
    const l3d_outline_mask* const mask = pipeline->outlines();
    EXPECT_NE(mask, nullptr);
    if (mask != nullptr)
        result.mask = *mask;
    EXPECT_EQ(result.report.outline_pixels, result.mask.count());
    return result;
}

/// What a mask holds of what it must hold.
struct agreement {
    std::int64_t pixels = 0, wanted = 0, marked = 0, missed = 0, holes = 0;
    std::array<std::int64_t, 5> missed_kinds{};

    void add(const agreement& other) {
        pixels += other.pixels;
        wanted += other.wanted;
        marked += other.marked;
        missed += other.missed;
        holes += other.holes;
    }
};

agreement compare(const std::string& name, const scene& s, double tolerance) {
    const frame f = drawn(s, tolerance);
    const reference::second_judge judge(s.patches, s.eye, s.picture());
    const double bound = f.report.dice.bound_px;
    const double depth =
        std::isfinite(f.report.dice.depth_bound_px) ? f.report.dice.depth_bound_px : bound;
    agreement sum;
    std::string where;
    for (int y = 0; y < s.size.height; ++y)
        for (int x = 0; x < s.size.width; ++x) {
            const outline_kind kind = judge.outline_within(x + 0.5, y + 0.5, bound, 2 * depth);
            const bool marked = f.mask.at(x, y);
            ++sum.pixels;
            sum.wanted += kind != outline_kind::none;
            sum.marked += marked;
            if (kind != outline_kind::none && !marked) {
                ++sum.missed;
                if (++sum.missed_kinds[static_cast<std::size_t>(kind)] <= 5)
                    where += " (" + std::to_string(x) + ", " + std::to_string(y) + "; " +
                             std::to_string(static_cast<int>(kind)) + ")";
            }
            const bool covered = judge.look(x + 0.5, y + 0.5).covered();
            if (covered && f.depth.row(y)[static_cast<std::size_t>(x)] == 0 && !marked)
                ++sum.holes;
        }
    std::printf("%s, %.2f px: %ld pixels of outlines, %ld marked, ratio %.2f, missed %ld (border "
                "%ld, jump %ld, crease %ld, close %ld), %.1f ms\n",
                name.c_str(), tolerance, static_cast<long>(sum.wanted),
                static_cast<long>(sum.marked),
                static_cast<double>(sum.marked) /
                    static_cast<double>(std::max<std::int64_t>(sum.wanted, 1)),
                static_cast<long>(sum.missed), static_cast<long>(sum.missed_kinds[1]),
                static_cast<long>(sum.missed_kinds[2]), static_cast<long>(sum.missed_kinds[3]),
                static_cast<long>(sum.missed_kinds[4]), f.report.time_ms.outlines);
    EXPECT_EQ(sum.missed, 0) << name << where;
    EXPECT_EQ(sum.holes, 0) << name;
    return sum;
}

constexpr double tolerances[] = {1, 0.25, 0.05};
constexpr l3d_size small{dice_tests::sanitized ? 80 : 128, dice_tests::sanitized ? 60 : 96};

TEST(outlines, of_the_teapot_lie_in_the_mask_in_every_view) {
    for (const reference::view& view : reference::project_views())
        for (const double tolerance : tolerances)
            compare("teapot, " + std::string(view.name), dice_tests::teapot(view, small),
                    tolerance);
}

TEST(outlines, of_bumps_and_domes_lie_in_the_mask) {
    for (const double tolerance : tolerances) {
        compare("dome",
                scene(reference::load_bpt_plain("tests/data/dome.bpt"),
                      {{0, 0, 13.94}, {0, 0, 0}, {0, 1, 0}, 38, 0.1}, small),
                tolerance);
        compare("bumps",
                scene(reference::load_bpt_plain("tests/data/bump3.bpt"),
                      {{0, 0, 1e5}, {0, 0, 0}, {0, 1, 0}, 0.0012, 0.1}, small),
                tolerance);
    }
}

TEST(outlines, of_random_bodies_and_patches_lie_in_the_mask) {
    reference::random_numbers random(21);
    const reference::camera eye{{2.1, 3.2, 4.3}, {0, 0, 0}, {0.1, 1, 0.2}, 38, 0.1};
    for (const auto kind : {dice_tests::body_kind::starfish, dice_tests::body_kind::bent,
                            dice_tests::body_kind::flattened, dice_tests::body_kind::toroidal}) {
        const scene s(dice_tests::random_body(random, kind), eye, small);
        for (const double tolerance : tolerances)
            compare("body " + std::to_string(static_cast<int>(kind)), s, tolerance);
    }
    for (const auto kind : {reference::patch_kind::moderate, reference::patch_kind::folded})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const scene s(
                reference::random_patches(seed, kind, 12, eye, {small.width, small.height}), eye,
                small);
            compare("patches " + std::to_string(static_cast<int>(kind)), s, 0.5);
        }
}

} // namespace
