// SPDX-License-Identifier: MIT
// Lines in a depth buffer: what is in front of them hides them, their own surface does not.
#include "raster/shapes/hidden_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace {

constexpr l3d_size size{64, 64};

/// Pixels lit by a triangle's sides over a surface whose 1/w is `at(x, y)` at pixel centres.
template <class At> std::int64_t lit_over(At at, const l3d_painter_triangle& triangle) {
    l3d_depth_buffer depth;
    depth.resize(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            depth.row(y)[static_cast<std::size_t>(x)] = static_cast<float>(at(x + 0.5, y + 0.5));
    std::vector<std::uint32_t> words(std::size_t(size.width) * std::size_t(size.height));
    l3d_draw_seen_sides({words.data(), size.width, size.height, size.width}, depth,
                        std::array{triangle}, 1);
    return std::ranges::count(words, 1u);
}

/// A triangle of the picture, on the plane 1/w = at(x, y).
template <class At> l3d_painter_triangle triangle_on(At at) {
    l3d_painter_triangle result;
    constexpr std::array<std::array<int, 2>, 3> corners{{{5, 8}, {50, 12}, {20, 55}}};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [x, y] = corners[k];
        result.v[k].x = x * l3d_subpixel_one;
        result.v[k].y = y * l3d_subpixel_one;
        result.v[k].inv_w = static_cast<float>(at(x, y));
    }
    return result;
}

double level(double, double) {
    return 0.5;
}
double slope(double x, double y) {
    return 0.3 + 0.004 * x - 0.002 * y;
}
constexpr double rise = 0.004 + 0.002; // of the slope, over a pixel in x and in y

TEST(HiddenLines, OfASurfaceAreSeenOnIt) {
    const std::int64_t all = lit_over([](double, double) { return 0; }, triangle_on(level));
    EXPECT_GT(all, 100);
    EXPECT_EQ(lit_over(level, triangle_on(level)), all);
    EXPECT_EQ(lit_over(slope, triangle_on(slope)), all);
}

TEST(HiddenLines, AreHiddenByWhatIsALittleInFront) {
    const auto in_front_of = [](auto of, double by) {
        return [=](double x, double y) { return of(x, y) + by; };
    };
    EXPECT_EQ(lit_over(in_front_of(level, 1e-5), triangle_on(level)), 0);
    EXPECT_EQ(lit_over(in_front_of(slope, 2.1 * rise), triangle_on(slope)), 0);
}

TEST(HiddenLines, AreSeenBeforeWhatIsBehind) {
    const std::int64_t all = lit_over([](double, double) { return 0; }, triangle_on(level));
    EXPECT_EQ(lit_over([](double x, double y) { return slope(x, y) - 1e-4; }, triangle_on(slope)),
              all);
}

} // namespace
