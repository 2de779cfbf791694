// SPDX-License-Identifier: MIT
// draw_coverage: each pixel by the rule, clipped, opaque and transparent; and outputs without it.
#include "raster/canvas_2d.h"
#include "level_difference.h"
#include "raster/placement_2d.h"
#include "raster/paths/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

namespace {

/// The rule, in real numbers: colours count by what they cover.
std::uint32_t mixed(std::uint32_t word, std::uint32_t color, int coverage) {
    const double of_color = coverage / 255.0;
    const double of_word = (1 - of_color) * (255 - (word >> 24)) / 255.0;
    const double sum = of_color + of_word;
    if (sum == 0)
        return word;
    auto result = static_cast<std::uint32_t>(std::lround(255 * (1 - sum))) << 24;
    for (const int shift : {0, 8, 16}) {
        const double mean =
            (of_color * (color >> shift & 255) + of_word * (word >> shift & 255)) / sum;
        result |= static_cast<std::uint32_t>(std::lround(mean)) << shift;
    }
    return result;
}

TEST(coverage_2d, is_mixed_by_the_rule_wherever_the_shape_lies) {
    constexpr int width = 23, height = 17;
    constexpr int most = std::numeric_limits<int>::max();
    std::mt19937 random(7);
    for (int n = 0; n < 3000; ++n) {
        canvas it(width, height), before(width, height);
        const bool has_gaps = n % 2 == 1;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto word = static_cast<std::uint32_t>(random());
                const std::uint32_t gap = random() % 3 == 0 ? 0xff000000u : word & 0xff000000u;
                it.at(x, y) = before.at(x, y) = (word & 0x00ffffff) | (has_gaps ? gap : 0);
            }
        l3d_coverage_2d shape{static_cast<int>(random() % 60) - 30,
                              static_cast<int>(random() % 50) - 25, static_cast<int>(random() % 40),
                              static_cast<int>(random() % 30)};
        if (n % 50 == 0)
            shape.left = most - 3;
        if (n % 50 == 1)
            shape.top = -most;
        const bool repeats = random() % 4 == 0;
        shape.pitch = repeats ? 0 : shape.width + static_cast<int>(random() % 3);
        std::vector<std::uint8_t> values(
            static_cast<std::size_t>(40 + shape.height * (shape.width + 3)));
        for (std::uint8_t& value : values)
            value = static_cast<std::uint8_t>(random() % 3 == 0 ? 255 * (random() % 2) : random());
        shape.values = values.data();
        const auto color = static_cast<std::uint32_t>(random() & 0x00ffffff);
        it.draw.draw_coverage(shape, color);
        ASSERT_TRUE(it.guards_intact());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::int64_t column = std::int64_t{x} - shape.left;
                const std::int64_t row = std::int64_t{y} - shape.top;
                const bool inside =
                    column >= 0 && column < shape.width && row >= 0 && row < shape.height;
                const std::uint32_t old = before.at(x, y);
                const int coverage =
                    inside ? shape.row(static_cast<int>(row))[static_cast<std::size_t>(column)] : 0;
                const std::uint32_t expected = coverage > 0 ? mixed(old, color, coverage) : old;
                ASSERT_LE(level_difference(it.at(x, y), expected), 1)
                    << n << ": " << x << ", " << y;
            }
    }
}

/// A kind of output that can draw lines, and no more.
class lines_only final : public l3d_rasterizer_2d_imp {
public:
    explicit lines_only(l3d_rasterizer_2d& to) : to_(to) {}

private:
    void do_set_target(l3d_pixels) override {}
    void do_clear_buffer(std::uint32_t) override {}
    void do_draw_point(int x, int y, std::uint32_t color) override { to_.draw_point(x, y, color); }
    void do_draw_lines(std::span<const l3d_line_2d> lines, std::uint32_t color) override {
        to_.draw_lines(lines, color);
    }
    void do_draw_line_antialiased(l3d_point_2d, l3d_point_2d, std::uint32_t) override {}
    void do_draw_polygon_flatshaded(l3d_outline_2d, std::uint32_t) override {}
    void do_draw_polygon_gouraudshaded(std::span<const l3d_colored_point_2d>) override {}
    void do_draw_outlines(std::span<const l3d_outline_2d>, l3d_winding, std::uint32_t) override {}

    l3d_rasterizer_2d& to_;
};

TEST(coverage_2d, of_outputs_that_cannot_mix_is_what_is_covered_by_half) {
    canvas it(9, 5);
    lines_only imp(it.draw);
    const std::vector<std::uint8_t> values{0, 127, 128, 255, 0, 200, 130, 1, 0, 129};
    l3d_rasterizer_2d(imp).draw_coverage({2, 1, 5, 2, values.data(), 5}, canvas::color);
    EXPECT_EQ(it.lit(), (pixel_set{{4, 1}, {5, 1}, {2, 2}, {3, 2}, {6, 2}}));
}

TEST(coverage_2d, single_lines_of_outputs_with_batches_alone_are_batches_of_one) {
    canvas it(9, 5);
    lines_only imp(it.draw);
    l3d_rasterizer_2d(imp).draw_line(2, 1, 4, 1, canvas::color);
    EXPECT_EQ(it.lit(), (pixel_set{{2, 1}, {3, 1}, {4, 1}}));
}

TEST(coverage_2d, of_paths_is_drawn_by_outputs_that_cannot_mix_and_curves_are_points) {
    canvas it(60, 40), curves(60, 40), smooth(60, 40), thin(60, 40);
    l3d_path path;
    path.add_circle({30.3, 20.1}, 15.4);
    lines_only imp(it.draw), imp_of_curves(curves.draw);
    l3d_rasterizer_2d(imp).draw_path(path, {.color = canvas::color});
    l3d_rasterizer_2d(imp_of_curves).draw_curves(path, canvas::color);
    smooth.draw.draw_path(path, {.color = 0x00ffffff});
    thin.draw.draw_curves(path, canvas::color);
    pixel_set half;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x)
            if ((smooth.at(x, y) & 255) >= 128)
                half.insert({x, y});
    EXPECT_EQ(it.lit(), half);
    EXPECT_GT(half.size(), 700u);
    EXPECT_EQ(curves.lit(), thin.lit());
}

TEST(coverage_2d, of_images_is_drawn_by_outputs_that_cannot_mix) {
    canvas it(60, 40), smooth(60, 40);
    std::vector<std::uint32_t> words(4, canvas::color);
    l3d_placed_image image{{words.data(), 2, 2, 2}, {{20.2, 9.7}, {17.3, 3.1}, {-2.5, 14.9}}};
    lines_only imp(it.draw);
    for (const auto filter :
         {l3d_image_filter::nearest, l3d_image_filter::linear, l3d_image_filter::area}) {
        image.filter = filter;
        it.draw.clear_buffer();
        smooth.draw.clear_buffer();
        l3d_rasterizer_2d(imp).draw_image(image);
        smooth.draw.draw_image(image);
        pixel_set half;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 60; ++x)
                if ((smooth.at(x, y) & 255) >= 64) // of 128 in the colour
                    half.insert({x, y});
        EXPECT_EQ(it.lit(), half);
        EXPECT_GT(half.size(), 700u);
    }
}

} // namespace
