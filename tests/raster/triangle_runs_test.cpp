// SPDX-License-Identifier: MIT
// Rows of triangles in lanes against scan_polygon, which follows each side by itself.
#include "raster/parallel/simd_target.h"
#include "raster/shapes/attribute_plane_p.h"
#include "raster/shapes/triangle_runs_p.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <span>
#include <string>

namespace {

using namespace l3d_detail;

using triangle = std::array<scan_point, 3>;

constexpr std::int32_t width = 131;

/// Small ones, large ones, those that reach as far as any may, level sides, and slivers.
triangle random_triangle(std::mt19937& random, int kind) {
    const std::int32_t reach = kind % 3 == 0 ? 256 * 9 : kind % 3 == 1 ? 256 * 400 : scan_limit;
    const auto number = [&](std::int32_t most) {
        return std::uniform_int_distribution<std::int32_t>(-most, most)(random);
    };
    const scan_point middle =
        reach == scan_limit ? scan_point{} : scan_point{number(40000), number(40000)};
    triangle t;
    for (scan_point& corner : t)
        corner = {middle.x + number(reach), middle.y + number(reach)};
    if (kind % 5 == 0)
        t[1].y = t[0].y;
    if (kind % 7 == 0)
        t[2].y = t[1].y + 1; // nearly level
    if (kind % 11 == 0)
        t[2] = {std::min(t[1].x, scan_limit - 3) + 3, t[1].y};
    if (kind % 4 == 0)
        for (scan_point& corner : t) // on the centres of pixels
            corner = {corner.x / 256 * 256 + 128, corner.y / 256 * 256 + 128};
    for (scan_point& corner : t)
        corner = {std::clamp(corner.x, -scan_limit, scan_limit),
                  std::clamp(corner.y, -scan_limit, scan_limit)};
    return t;
}

void expect_the_rows_of(const triangle& t, scan_rows kept, const std::string& what) {
    scan_polygon scan;
    scan.set_rows(kept);
    const std::int64_t area2 = cross(t[1] - t[0], t[2] - t[0]);
    scan_rows rows = scan.convert(std::span<const scan_point, 3>(t), area2 > 0);
    if (area2 == 0 || rows.top >= rows.bottom)
        rows = {};
    triangle_runs fast(t, kept);
    wide_runs runs;
    std::int32_t row = rows.top;
    while (fast.next(width, runs))
        for (std::size_t i = 0; i < runs.count; ++i, ++row) {
            ASSERT_LT(row, rows.bottom) << what;
            ASSERT_EQ(runs.row[i], row) << what;
            ASSERT_EQ(runs.start[i], scan.first(row)) << what << ", row " << row;
            ASSERT_EQ(runs.begin[i], std::max(scan.first(row), 0)) << what << ", row " << row;
            ASSERT_EQ(runs.end[i], std::min(scan.last(row), width)) << what << ", row " << row;
        }
    ASSERT_EQ(row, rows.bottom) << what;
}

TEST(TriangleRuns, AreThoseOfTheSidesWithAnyInstructions) {
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        std::mt19937 random(7);
        for (int i = 0; i < 4000; ++i) {
            const scan_rows kept = i % 2 == 0 ? scan_rows{0, 200} : scan_rows{37, 60};
            expect_the_rows_of(random_triangle(random, i), kept,
                               target + ", triangle " + std::to_string(i));
            if (HasFatalFailure())
                break;
        }
        ASSERT_TRUE(l3d_set_simd_target(""));
    }
}

} // namespace
