// SPDX-License-Identifier: MIT
// Two judges that share no code, on the same pictures.
#include "reference/second_judge.h"
#include "reference/measure.h"
#include "reference/random_patches.h"
#include "reference/ray_clip.h"
#include "reference/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace reference {
namespace {

struct exhibit {
    std::string name;
    std::vector<patch> patches;
    camera eye;
    picture_size size{160, 120};
};

constexpr camera oblique{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2};

/// Twenty: the teapot's views, surfaces towards the eye, and random ones, folded ones among them.
std::vector<exhibit> exhibits() {
    std::vector<exhibit> result;
    const std::vector<patch> teapot = load_bpt_plain("data/teapot.bpt");
    for (const view& each : project_views())
        result.push_back({std::string(each.name), teapot, each.eye});
    const auto tiny = std::find_if(result.begin(), result.end(),
                                   [](const exhibit& each) { return each.name == "tiny"; });
    tiny->size = {1024, 768}; // 30 pixels wide there
    result.push_back({"full, large", teapot, project_view("full").eye, {320, 240}});
    const std::vector<patch> dome = load_bpt_plain("tests/data/dome.bpt");
    result.push_back({"dome", dome, {{0, 0, 13.94}, {0, 0, 0}, {0, 1, 0}, 38, 0.1}});
    result.push_back(
        {"dome, from below", dome, {{2, 0.3, 0.1}, {0, 0, 0.2}, {0, 1, 0.2}, 60, 0.1}});
    const std::vector<patch> bumps = load_bpt_plain("tests/data/bump3.bpt");
    result.push_back({"bumps, far", bumps, {{0, 0, 1e5}, {0, 0, 0}, {0, 1, 0}, 0.0012, 0.1}});
    result.push_back({"bumps", bumps, {{5, 4, 12}, {0, 0, 4}, {0, 1, 0}, 38, 0.1}});
    const std::pair<const char*, patch_kind> kinds[] = {
        {"moderate", patch_kind::moderate},     {"thin", patch_kind::thin},
        {"folded", patch_kind::folded},         {"folded, others", patch_kind::folded},
        {"coincident", patch_kind::coincident}, {"stiff", patch_kind::stiff}};
    std::uint64_t seed = 2026;
    for (const auto& [name, kind] : kinds)
        result.push_back({name, random_patches(++seed, kind, 20, oblique, {160, 120}), oblique});
    result.push_back({"tiles", random_tiling(7, 3, 0.3, 0.2, oblique, {160, 120}), oblique});
    result.push_back({"folded tiles", random_tiling(8, 3, 2, 0.5, oblique, {160, 120}), oblique});
    return result;
}

struct agreement {
    std::int64_t covered = 0, compared = 0; ///< by the first; by both
    std::int64_t alone = 0;                 ///< covered by one of both
    std::vector<double> depth_px;           ///< from the first's tangent plane
    std::vector<int> levels;
};

agreement compare(const exhibit& shown) {
    const exact_image first(shown.patches, shown.eye, shown.size);
    const second_judge second(shown.patches, shown.eye, shown.size);
    const camera_frame frame(shown.eye, shown.size);
    const auto greys = first.lambert(project_light);
    agreement result;
    std::size_t k = 0;
    for (int y = 0; y < shown.size.height; ++y)
        for (int x = 0; x < shown.size.width; ++x, ++k) {
            const second_sample seen = second.look(x + 0.5, y + 0.5);
            const exact_sample& known = first.at(x, y);
            result.covered += known.covered();
            result.alone += known.covered() != seen.covered();
            if (!known.covered() || !seen.covered())
                continue;
            ++result.compared;
            result.depth_px.push_back(depth_error_px(known, frame, x, y, seen.w));
            result.levels.push_back(
                std::abs(greys[k] - second.grey(seen, x + 0.5, y + 0.5, project_light)));
        }
    std::sort(result.depth_px.begin(), result.depth_px.end());
    std::sort(result.levels.begin(), result.levels.end());
    return result;
}

TEST(second_judge, sees_what_the_first_sees) {
    const auto shown = exhibits();
    ASSERT_EQ(shown.size(), 20u);
    for (const exhibit& each : shown) {
        const agreement found = compare(each);
        ASSERT_GT(found.compared, 50) << each.name;
        const std::size_t at = (found.depth_px.size() - 1) * 999 / 1000;
        std::printf("%-17s %6ld pixels covered, %8.4f %% compared, %ld by one alone; depth 99.9 %% "
                    "%.1e px, largest %.1e; grey 99.9 %% %d, largest %d\n",
                    each.name.c_str(), static_cast<long>(found.covered),
                    100 * judged_share(found.compared, found.covered),
                    static_cast<long>(found.alone), found.depth_px[at], found.depth_px.back(),
                    found.levels[at], found.levels.back());
        EXPECT_EQ(found.compared, found.covered) << each.name;
        EXPECT_EQ(found.alone, 0) << each.name;
        EXPECT_LT(found.depth_px.back(), 1e-6) << each.name;
        EXPECT_LE(found.levels.back(), 1) << each.name;
    }
}

/// About the origin, 2 `half` wide and 6 high; z = slope x.
patch sheet(double half, double slope) {
    patch result;
    for (std::size_t k = 0; k < 16; ++k) {
        const std::size_t row = k / 4;
        const double x = half * (2 * static_cast<double>(k % 4) / 3 - 1);
        result.points[k] = {x, 2 * static_cast<double>(row) - 3, slope * x};
    }
    return result;
}

/// From 10 away, by a focal length of 100 px: a unit is 10 px wide at z = 0. The flat sheet ends in
/// columns 20 and 80; the slanted one, whose right half is in front, crosses it in column 50 and
/// ends 8 away in column 50 + 100 * 2 / 8 = 75.
TEST(second_judge, finds_borders_jumps_and_crossings_where_they_are) {
    const std::vector<patch> sheets{sheet(3, 0), sheet(2, 1)};
    const double fov = 2 * std::atan(0.4) * 180 / 3.14159265358979323846;
    const second_judge judge(sheets, {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, fov, 0.1}, {100, 80});
    using enum outline_kind;
    const std::pair<double, outline_kind> outlines[] = {
        {20, border}, {50, crease}, {75, jump}, {80, border}};
    const double y = 41.3;
    for (const auto& [column, kind] : outlines)
        for (const double off : {-0.7, -0.3, 0.2, 0.6}) {
            const double x = column + off;
            EXPECT_EQ(judge.outline_within(x, y, 0.99 * std::abs(off)), none) << x;
            EXPECT_EQ(judge.outline_within(x, y, 1.01 * std::abs(off)), kind) << x;
        }
    for (const double x : {17.0, 23.0, 44.4, 53.0, 65.0, 78.0})
        EXPECT_EQ(judge.outline_within(x, y, 1.9), none) << x;
    // 3 px to the left of the crossing the slanted sheet is 3 px behind the flat one.
    EXPECT_EQ(judge.outline_within(47, y, 0.01, 2.9), none);
    EXPECT_EQ(judge.outline_within(47, y, 0.01, 3.1), close);
}

} // namespace
} // namespace reference
