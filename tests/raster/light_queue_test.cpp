// SPDX-License-Identifier: MIT
// light_queue against fill_wide_rows: the same bits of each triangle, whenever it is lit.
#include "raster/parallel/simd_target.h"
#include "raster/shapes/attribute_plane_p.h"
#include "raster/zsort/light_queue_p.h"
#include "raster/shapes/triangle_runs_p.h"
#include "surface_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace l3d_detail;

constexpr l3d_size size{150, 90};

/// Triangles of up to so many steps of the grid from a middle, small and large ones in turn.
std::vector<unlit_triangle> random_triangles(unsigned seed, int count) {
    random_polygons random(seed, size);
    std::vector<unlit_triangle> all;
    while (std::ssize(all) < count) {
        const int extent = all.size() % 4 == 0 ? 20'000 : 600;
        const int x = random.number(0, 256 * size.width), y = random.number(0, 256 * size.height);
        unlit_triangle next{
            {}, {}, {0.36f, 0.48f, 0.8f}, all.size() % 3 == 0 ? 0x12cd80U : 0xffffffU};
        for (std::size_t k = 0; k < 3; ++k) {
            next.corners[k] = {x + random.number(-extent, extent),
                               y + random.number(-extent, extent)};
            for (float& number : next.normals[k])
                number = random.real(-1, 1);
        }
        if (cross(next.corners[1] - next.corners[0], next.corners[2] - next.corners[0]) != 0)
            all.push_back(next);
    }
    return all;
}

/// A picture that triangles are filled into, as fill(band, triangle, runs) does it.
struct filled {
    std::vector<std::uint32_t> words =
        std::vector<std::uint32_t>(std::size_t(size.width) * std::size_t(size.height));
    std::int64_t count = 0;
    fill_band band{.words = words.data(),
                   .word_pitch = size.width,
                   .depths = nullptr,
                   .depth_pitch = 0,
                   .width = size.width,
                   .top = 0,
                   .bottom = size.height};

    template <class Fill> void add(const unlit_triangle& of, const Fill& fill) {
        triangle_runs rows(of.corners, {0, size.height});
        wide_runs runs;
        while (rows.next(size.width, runs))
            count += fill(band, of, runs);
    }
};

std::int64_t fill_at_once(const fill_band& band, const unlit_triangle& of, const wide_runs& runs) {
    constexpr std::size_t numbers = 1 + unlit_triangle::numbers; // 1/w comes first
    std::array<std::array<float, numbers>, 3> values{};
    for (std::size_t k = 0; k < 3; ++k)
        std::ranges::copy(of.normals[k], values[k].begin() + 1);
    const auto& p = of.corners;
    const attribute_planes<numbers> planes(p, values, cross(p[1] - p[0], p[2] - p[0]));
    return fill_wide_rows(band,
                          {.planes = planes.view(),
                           .light = {.by = row_light::kind::normal, .light = of.light},
                           .color = of.color},
                          runs);
}

TEST(LightQueue, HasTheBitsOfRowsThatAreFilledAtOnce) {
    const auto triangles = random_triangles(7, 2000);
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        filled at_once, later;
        light_queue queue;
        for (const unlit_triangle& of : triangles) {
            at_once.add(of, fill_at_once);
            later.add(of, [&](const auto&... what) { return queue.add(what...); });
        }
        queue.finish();
        EXPECT_EQ(at_once.words, later.words) << target;
        EXPECT_EQ(at_once.count, later.count) << target;
        EXPECT_GT(at_once.count, 100'000) << target;
        ASSERT_TRUE(l3d_set_simd_target(""));
    }
}

} // namespace
