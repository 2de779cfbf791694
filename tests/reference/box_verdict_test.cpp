// SPDX-License-Identifier: MIT
// A judge of promises finds those that are broken, and says whom it did not judge.
#include "reference/box_verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace reference {
namespace {

constexpr picture_size size{20, 15};
constexpr vec3 light{0.3, 0.5, 1};

/// A sheet that is turned and covers a part of the picture, 10 away.
box_image sheet_image(double background = 0) {
    patch sheet;
    for (std::size_t k = 0; k < 16; ++k) {
        const std::size_t row = k / 4;
        const double s = static_cast<double>(k % 4) - 1.5, t = static_cast<double>(row) - 1.5;
        sheet.points[k] = {s - 0.3 * t, t + 0.3 * s, 0};
    }
    const std::vector<patch> patches{sheet};
    return {patches, {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30, 0.1}, size, light, {background}};
}

std::vector<double> levels_of(const box_image& image) {
    std::vector<double> result;
    for (const box_pixel& each : image.pixels())
        result.push_back(each.level);
    return result;
}

std::vector<float> bounds_of(const box_image& image, float bound) {
    return std::vector<float>(image.pixels().size(), bound);
}

TEST(box_verdict, an_exact_picture_breaks_no_promise) {
    for (const double background : {0.0, 90.0}) {
        const box_image exact = sheet_image(background);
        const box_verdict found = judge_boxes(levels_of(exact), exact, bounds_of(exact, 0));
        EXPECT_EQ(found.pixels, 300);
        EXPECT_EQ(found.judged, 300);
        EXPECT_EQ(found.judged_share(), 1);
        EXPECT_EQ(found.judged_shown_share(), 1);
        EXPECT_GT(found.shown, 50);
        EXPECT_LT(found.shown, 250);
        EXPECT_GT(found.edges, 20);
        EXPECT_LT(found.edges, found.shown);
        EXPECT_EQ(found.exceptions, 0);
        EXPECT_EQ(found.rms, 0);
        EXPECT_EQ(found.largest, 0);
        EXPECT_LT(found.largest_unsure, 0.5);
    }
}

TEST(box_verdict, bytes_are_within_their_rounding) {
    const box_image exact = sheet_image();
    std::vector<unsigned char> bytes;
    for (const double level : levels_of(exact))
        bytes.push_back(static_cast<unsigned char>(std::lround(level)));
    const box_verdict found = judge_boxes(bytes, exact, bounds_of(exact, 0));
    EXPECT_EQ(found.exceptions, 0);
    EXPECT_GT(found.largest, 0.1);
    EXPECT_LE(found.largest, 0.5);
}

TEST(box_verdict, lists_what_is_farther_off_than_promised) {
    const box_image exact = sheet_image();
    std::vector<double> drawn = levels_of(exact);
    constexpr std::size_t much = 7 * 20 + 10, little = 8 * 20 + 9, kept = 8 * 20 + 10;
    drawn[much] -= 9;
    drawn[little] += 2.7;
    drawn[kept] += 2.4;
    const box_verdict found = judge_boxes(drawn, exact, bounds_of(exact, 2));
    ASSERT_EQ(found.exceptions, 2);
    ASSERT_EQ(found.worst.size(), 2u);
    EXPECT_EQ(found.worst[0].x, 10);
    EXPECT_EQ(found.worst[0].y, 7);
    EXPECT_NEAR(found.worst[0].beyond, 6.5, 0.1);
    EXPECT_NEAR(found.worst[1].beyond, 0.2, 0.1);
    EXPECT_NEAR(found.largest, 9, 1e-9);
    EXPECT_EQ(found.largest_x, 10);
    EXPECT_EQ(found.largest_y, 7);
    const double squares = 9 * 9 + 2.7 * 2.7 + 2.4 * 2.4;
    EXPECT_NEAR(found.rms, std::sqrt(squares / static_cast<double>(found.shown)), 1e-9);
    EXPECT_EQ(found.edge_rms, 0);
    EXPECT_EQ(found.mean_bound, 2);
}

TEST(box_verdict, no_more_than_sixteen_are_listed_and_all_are_counted) {
    const box_image exact = sheet_image();
    std::vector<double> drawn = levels_of(exact);
    for (std::size_t k = 0; k < drawn.size(); ++k)
        drawn[k] += 10 + static_cast<double>(k) / 100;
    const box_verdict found = judge_boxes(drawn, exact, bounds_of(exact, 1));
    EXPECT_EQ(found.shown, 300) << "what is drawn where nothing is, is shown";
    EXPECT_EQ(found.exceptions, 300);
    ASSERT_EQ(found.worst.size(), 16u);
    EXPECT_GE(found.worst[0].beyond, found.worst[15].beyond);
    EXPECT_EQ(found.worst[0].y, 14);
}

TEST(box_verdict, says_what_it_does_not_judge) {
    const box_image exact = sheet_image();
    std::vector<double> drawn = levels_of(exact);
    std::vector<float> bounds = bounds_of(exact, 1);
    constexpr std::size_t covered = 7 * 20 + 10, empty = 0, vague = 8 * 20 + 9;
    bounds[covered] = std::numeric_limits<float>::infinity();
    bounds[empty] = std::numeric_limits<float>::quiet_NaN();
    bounds[vague] = 255;
    drawn[covered] = 0;
    const box_verdict found = judge_boxes(drawn, exact, bounds);
    EXPECT_EQ(found.judged, 298);
    EXPECT_EQ(found.judged_shown, found.shown - 1);
    EXPECT_NEAR(found.judged_share(), 298.0 / 300, 1e-12);
    EXPECT_EQ(found.vacuous, 1);
    EXPECT_EQ(found.exceptions, 0);
    EXPECT_GT(found.rms, 5) << "errors count where nothing is promised, too";
    EXPECT_NEAR(found.largest, exact.at(10, 7).level, 1e-9);
}

TEST(box_verdict, a_level_that_is_no_number_breaks_every_promise) {
    const box_image exact = sheet_image();
    std::vector<double> drawn = levels_of(exact);
    drawn[5] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(judge_boxes(drawn, exact, bounds_of(exact, 3)).exceptions, 1);
}

} // namespace
} // namespace reference
