// SPDX-License-Identifier: MIT
// The visible result: grey levels of whole pictures against the exact ones, sparks and holes.
#include "hard_edged.h"
#include "../dice/scene.h"
#include "drawn_picture.h"
#include "shown_models.h"

#include "reference/seen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using dice_tests::scene;
using pipeline_tests::shown_model;
using reference::seen_picture;

constexpr double tolerances[] = {1, 0.25, 0.05};

struct totals {
    std::int64_t pictures = 0, far = 0, far_anywhere = 0, sparks = 0, holes = 0;
    std::int64_t strange = 0;
};

/// The faults that a picture may have beside outlines. A pixel may show the level of a place that
/// is no farther off than the bound: where the shade is steep, `far` counts it. Where an outline
/// ends, quads that show both sides are lit by the wrong one here and there: `far_anywhere`,
/// `sparks`.
struct limits {
    std::size_t far = 1;
    std::int64_t shown_per_far = 1'000'000, far_anywhere = 0;
    std::size_t sparks = 0, strange = std::size_t{1} << 20;
};

void expect_seen(const shown_model& shown, std::size_t view, l3d_size size, const limits& most,
                 totals& sum) {
    const scene s(shown.patches, shown.views[view], size);
    const reference::exact_image exact(s.patches, s.eye, s.picture());
    const reference::second_judge outlines(s.patches, s.eye, s.picture());
    for (const double tolerance : tolerances) {
        l3d_afd_settings settings = hard_edged();
        settings.tolerance = tolerance;
        settings.depth = true;
        settings.outlines = true;
        l3d_patch_scene world;
        world.add(s.model, s.placement);
        const pipeline_tests::picture drawn = pipeline_tests::drawn(s, world, settings);
        std::vector<unsigned char> greys;
        for (const std::uint32_t word : drawn.words)
            greys.push_back(static_cast<unsigned char>(word & 0xff));
        const l3d_dice_counts& proven = drawn.report.dice;
        seen_picture seen = reference::judge_seen(greys, drawn.distances, exact, outlines,
                                                  {proven.bound_px, proven.depth_bound_px},
                                                  reference::project_light);
        // The pixels that outlines reach, as the frame itself reports them.
        std::erase_if(seen.far, [&](const auto& p) { return drawn.outlines.has(p.x, p.y); });
        std::erase_if(seen.sparks, [&](const auto& p) { return drawn.outlines.has(p.x, p.y); });
        std::printf("%-8s %2zu, %.2f px: %6ld shown, %5.1f %% judged; outlines %ld border, %ld "
                    "jump, %ld crease, %ld close; levels rms %.2f, judged %.2f, largest %d; depth "
                    "%.3f px; far %zu (%ld anywhere, %ld at outlines, %zu strange), sparks %zu (of "
                    "%ld; exact %ld), "
                    "holes %ld\n",
                    shown.name.c_str(), view, tolerance, static_cast<long>(seen.shown),
                    100 * seen.judged_share(), static_cast<long>(seen.outlines[1]),
                    static_cast<long>(seen.outlines[2]), static_cast<long>(seen.outlines[3]),
                    static_cast<long>(seen.outlines[4]), seen.rms, seen.judged_rms,
                    seen.judged_largest, seen.judged_depth_px, seen.far.size(),
                    static_cast<long>(seen.far_anywhere), static_cast<long>(seen.far_outlines),
                    seen.strange.size(), seen.sparks.size(), static_cast<long>(seen.drawn_sparks),
                    static_cast<long>(seen.exact_sparks), static_cast<long>(seen.holes));
        const auto where = [&](const std::vector<reference::seen_pixel>& pixels) {
            std::string text = shown.name + ", view " + std::to_string(view) + ", tolerance " +
                               std::to_string(tolerance);
            for (std::size_t i = 0; i < std::min<std::size_t>(pixels.size(), 5); ++i)
                text += "; (" + std::to_string(pixels[i].x) + ", " + std::to_string(pixels[i].y) +
                        ") " + std::to_string(pixels[i].drawn) + ", exact " +
                        std::to_string(pixels[i].exact);
            return text;
        };
        EXPECT_GT(seen.shown, 20);
        EXPECT_LE(seen.far.size(),
                  most.far + static_cast<std::size_t>(seen.shown / most.shown_per_far))
            << where(seen.far);
        EXPECT_LE(seen.far_anywhere, most.far_anywhere) << where(seen.far);
        EXPECT_LE(seen.sparks.size(), most.sparks) << where(seen.sparks);
        EXPECT_EQ(seen.holes, 0) << where(seen.far);
        EXPECT_LE(seen.strange.size(), most.strange) << where(seen.strange);
        ++sum.pictures;
        sum.far += static_cast<std::int64_t>(seen.far.size());
        sum.far_anywhere += seen.far_anywhere;
        sum.sparks += static_cast<std::int64_t>(seen.sparks.size());
        sum.holes += seen.holes;
        sum.strange += static_cast<std::int64_t>(seen.strange.size());
    }
}

/// Each `step`-th of twelve views of each model.
void expect_all_seen(l3d_size size, std::size_t step, const limits& most) {
    totals sum;
    for (const shown_model& each : pipeline_tests::shown_models())
        for (std::size_t view = 0; view < 12; view += step)
            expect_seen(each, view, size, most, sum);
    std::printf(
        "%ld pictures: %ld pixels far from the exact level (%ld anywhere within the bound), "
        "%ld sparks, %ld holes, %ld strange\n",
        static_cast<long>(sum.pictures), static_cast<long>(sum.far),
        static_cast<long>(sum.far_anywhere), static_cast<long>(sum.sparks),
        static_cast<long>(sum.holes), static_cast<long>(sum.strange));
}

/// Views 0 and 8 of each model.
TEST(seen, is_the_exact_picture_but_for_outlines) {
    expect_all_seen({320, 240}, thorough ? 8 : 12, {});
}

/// A quarter of a bowl, open above and below.
reference::patch quarter_of_a_bowl() {
    constexpr double round = 0.5523; // of a circle's quarter
    constexpr double radius[] = {0.27, 0.44, 0.4, 0.43}, height[] = {0, 0.2, 0.55, 0.8};
    reference::patch result;
    for (std::size_t row = 0; row < 4; ++row) {
        const double r = radius[row], y = height[row];
        result.points[4 * row] = {0, y, -r};
        result.points[4 * row + 1] = {-round * r, y, -r};
        result.points[4 * row + 2] = {-r, y, -round * r};
        result.points[4 * row + 3] = {-r, y, 0};
    }
    return result;
}

/// Outside it is lit, inside it is not, and the outlines where it folds end at its rims: there the
/// inside is seen beside the outside.
TEST(seen, of_folds_is_no_back_beside_its_front) {
    shown_model bowl{"bowl", {quarter_of_a_bowl()}, {}};
    for (int k = 0; k < (thorough ? 24 : 4); ++k) {
        const double around = 0.2617994 * k, below = -0.5 - 0.06 * (k % 7);
        bowl.views.push_back({{-0.2 + 1.9 * std::cos(around), below, -0.2 + 1.9 * std::sin(around)},
                              {-0.2, 0.35, -0.2},
                              {0, 1, 0.1},
                              34,
                              0.01});
    }
    totals sum;
    for (std::size_t view = 0; view < bowl.views.size(); ++view)
        expect_seen(bowl, view, {160, 120}, {.strange = 1}, sum);
    // Far quads may be seen beyond the corner of a near one: in 3 pixels of these 72 pictures.
    EXPECT_LE(sum.strange, 3);
}

/// A minute or two: twelve views of four models.
TEST(seen, DISABLED_is_the_exact_picture_from_twelve_sides) {
    expect_all_seen({320, 240}, 1, {5, 1000, 4, 1});
}

} // namespace
