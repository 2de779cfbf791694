// SPDX-License-Identifier: MIT
// Clouds: light through many cells against what one exponential says, and polygons within.
#include "compare/cells/cloud.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

l3d_cloud even_cloud(int side, float density, float light) {
    return l3d_cloud(side, [=](const l3d_cloud::place&) {
        return l3d_cloud::matter{density, light};
    });
}

/// Along any ray, even matter weakens by its whole length within the cube.
TEST(cloud, lets_through_what_its_length_says) {
    const l3d_cloud cloud = even_cloud(24, 0.05f, 1);
    std::mt19937 random(9);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 0x1p32;
    };
    for (int ray = 0; ray < 2000; ++ray) {
        const l3d_cloud::place from{between(-9, -1), between(0, 24), between(0, 24)};
        const l3d_cloud::place to{between(25, 33), between(0, 24), between(0, 24)};
        l3d_cloud::place along;
        double length = 0, enters = 0, leaves = 1;
        for (std::size_t i = 0; i < 3; ++i) {
            along[i] = to[i] - from[i];
            length += along[i] * along[i];
            const double a = (0 - from[i]) / along[i], b = (24 - from[i]) / along[i];
            enters = std::max(enters, std::min(a, b));
            leaves = std::min(leaves, std::max(a, b));
        }
        const auto seen = cloud.look(from, along, 0, infinity);
        const double way = std::max(0.0, leaves - enters) * std::sqrt(length);
        ASSERT_NEAR(seen.let_through, std::exp(-double(0.05f) * way), 1e-9) << ray;
        ASSERT_NEAR(seen.light, 1 - seen.let_through, 1e-9) << ray;
        // What ends at a polygon is weakened by the way to it alone.
        const double middle = (enters + leaves) / 2;
        const auto half = cloud.look(from, along, 0, middle);
        ASSERT_NEAR(half.let_through, std::exp(-double(0.05f) * way / 2), 1e-9) << ray;
        ASSERT_LT(half.cells, seen.cells + 1);
    }
}

/// Near matter hides far matter: the order counts.
TEST(cloud, weakens_light_from_behind) {
    const l3d_cloud cloud(10, [](const l3d_cloud::place& at) {
        return l3d_cloud::matter{0.3f, at[0] < 5 ? 1.0f : 0.0f};
    });
    const auto front = cloud.look({-1, 5.5, 5.5}, {1, 0, 0}, 0, infinity);
    const auto back = cloud.look({11, 5.5, 5.5}, {-1, 0, 0}, 0, infinity);
    EXPECT_NEAR(front.light, 1 - std::exp(-double(0.3f) * 5), 1e-9);
    EXPECT_NEAR(back.light, std::exp(-double(0.3f) * 5) * (1 - std::exp(-double(0.3f) * 5)), 1e-9);
    EXPECT_EQ(front.cells, 10);
}

TEST(cloud, ends_at_the_polygons_of_a_picture) {
    constexpr l3d_size size{40, 30};
    std::vector<std::uint32_t> words(40 * 30, 0x404040);
    const l3d_pixels picture{words.data(), size.width, size.height, size.width};
    l3d_depth_buffer depth;
    depth.resize(size);
    depth.clear();
    // A wall at distance 5 in the left half, which is the middle of the cube.
    for (int y = 0; y < size.height; ++y)
        for (std::size_t x = 0; x < 20; ++x)
            depth.row(y)[x] = 1.0f / 5;
    const l3d_camera camera{{0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 2, 0.1, 100};
    const l3d_cloud cloud = even_cloud(16, 0.1f, 1);
    const std::int64_t met = l3d_lay_over(picture, depth, camera, cloud, {{-1.0, -1.0, -1.0}, 2});
    const auto expected = [](double cells) {
        const double passes = std::exp(-0.1f * cells);
        return static_cast<double>(std::lround(0x40 * passes + 255 * (1 - passes)));
    };
    EXPECT_NEAR(words[15 * 40 + 10] & 255, expected(8), 1);
    EXPECT_NEAR(words[15 * 40 + 30] & 255, expected(16), 1);
    EXPECT_GT(met, 40 * 30 * 11);
}

} // namespace
