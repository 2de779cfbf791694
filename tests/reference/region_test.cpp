// SPDX-License-Identifier: MIT
// Distances to the covered region, and the verdict on pictures with known faults.
#include "reference/measure.h"
#include "reference/random_patches.h"
#include "reference/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <stop_token>
#include <vector>

namespace reference {
namespace {

/// Focal length 100 px, centre (60, 45); one world unit at w = 8 is 12.5 px.
const camera straight{
    {3, 2, 9}, {3, 2, 1}, {0, 1, 0}, 2 * std::atan(0.45) * 180 / std::numbers::pi, 0.5};
constexpr picture_size window{120, 90};

/// Seen at x 22.25..97.75, y 19.75..57.75; a plane, whose w changes by `depth` along u: straight
/// lines at the left and right end, each as large as its distance makes it look the same.
patch wall(double depth) {
    patch result;
    const double left = 8 - depth / 2, right = 8 + depth / 2;
    for (std::size_t k = 0; k < 16; ++k) {
        const double u = static_cast<double>(k % 4) / 3, v = static_cast<double>(k / 4) / 3;
        const double up = (2.02 - 3.04 * v) / 8;
        result.points[k] = {3 + 3.02 / 8 * (u * right - (1 - u) * left),
                            2 + up * (u * right + (1 - u) * left), 9 - 8 - depth * (u - 0.5)};
    }
    return result;
}

double distance_to_box(double x, double y) {
    return std::hypot(std::max({22.25 - x, 0.0, x - 97.75}), std::max({19.75 - y, 0.0, y - 57.75}));
}

TEST(exact_region, distances_of_a_rectangle) {
    const patch patches[] = {wall(0)};
    const exact_region region(patches, straight, window);
    for (double y = 1.3; y < 90; y += 7.1)
        for (double x = 0.7; x < 120; x += 9.3) {
            SCOPED_TRACE(testing::Message() << x << ' ' << y);
            const double outside = distance_to_box(x, y);
            const double inside = std::min({x - 22.25, 97.75 - x, y - 19.75, 57.75 - y});
            EXPECT_EQ(region.covers(x, y), outside == 0);
            EXPECT_NEAR(region.distance_to_exact_surface(x, y), outside, 1.01e-4);
            const auto gap = region.distance_to_uncovered(x, y);
            EXPECT_LE(gap.lower, std::max(0.0, inside));
            EXPECT_GE(gap.lower, inside - 5e-3);
            EXPECT_GE(gap.upper, std::max(0.0, inside) * (1 - 1e-9));
            EXPECT_LE(gap.upper, std::max(0.0, inside) * 1.01);
        }
}

TEST(exact_region, nothing_at_all_is_infinitely_far) {
    const exact_region region({}, straight, window);
    EXPECT_EQ(region.distance_to_exact_surface(3, 4), std::numeric_limits<double>::infinity());
    EXPECT_FALSE(region.covers(3, 4));
}

TEST(exact_region, gives_up_when_it_is_told_to) {
    const patch patches[] = {wall(0)};
    std::stop_source nobody_waits;
    const exact_region region(patches, straight, window, nobody_waits.get_token());
    const exact_image exact(patches, straight, window);
    const std::vector<float> nothing(120 * 90, std::numeric_limits<float>::infinity());
    EXPECT_EQ(map_errors(nothing, exact, region, 1, nobody_waits.get_token()).compared, 0);
    nobody_waits.request_stop();
    EXPECT_THROW(region.distance_to_exact_surface(50, 4), std::runtime_error);
    EXPECT_THROW(region.distance_to_uncovered(60, 45), std::runtime_error);
    EXPECT_THROW(map_errors(nothing, exact, region, 1, nobody_waits.get_token()),
                 std::runtime_error);
    EXPECT_THROW(exact_image(patches, straight, window, nobody_waits.get_token()),
                 std::runtime_error);
}

/// A piece that is proved to be one to one is searched row by row.
TEST(find_hits, gives_up_within_a_row) {
    std::stop_source nobody_waits;
    int found = 0;
    const camera_frame frame(straight, window);
    EXPECT_THROW(find_hits(
                     make_net(wall(0), frame), straight.near, {0.5, 0.5, 1, 120, 90},
                     [&](const hit&) {
                         ++found;
                         nobody_waits.request_stop();
                     },
                     nobody_waits.get_token()),
                 std::runtime_error);
    EXPECT_GT(found, 0);
    EXPECT_LE(found, 120);
}

TEST(exact_region, near_plane_bounds_the_region) {
    // w runs from 6 to 10: near 8.4 is at u = 0.6, 3.02 / 8 (0.6 * 10 - 0.4 * 6) to the right.
    camera cut = straight;
    cut.near = 8.4;
    const double side = 60 + 100 * 3.02 / 8 * 3.6 / 8.4;
    const patch patches[] = {wall(4)};
    const exact_region region(patches, cut, window);
    EXPECT_FALSE(region.covers(side - 1e-6, 31));
    EXPECT_TRUE(region.covers(side + 1e-6, 31));
    EXPECT_NEAR(region.distance_to_exact_surface(60, 31), side - 60, 2e-4);
    EXPECT_NEAR(region.distance_to_uncovered(side + 2.5, 31).upper, 2.5, 0.03);
    EXPECT_NEAR(region.distance_to_uncovered(side + 2.5, 31).lower, 2.5, 5e-3);
}

/// Least distance over a grid of surface points: never below the true one.
double sampled_distance(std::span<const patch> patches, const camera_frame& frame, double x,
                        double y, int cells) {
    double best = std::numeric_limits<double>::infinity();
    for (const patch& surface : patches)
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) {
                const auto h =
                    exact_homogeneous(surface, frame, static_cast<long double>(i) / cells,
                                      static_cast<long double>(j) / cells);
                best =
                    std::min(best, static_cast<double>(std::hypot(h.x / h.w - x, h.y / h.w - y)));
            }
    return best;
}

TEST(exact_region, distance_agrees_with_surface_samples) {
    constexpr std::uint64_t seed = 2307;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    constexpr int cells = 150;
    const camera_frame frame(straight, window);
    int outside = 0;
    for (const auto kind : {patch_kind::moderate, patch_kind::folded, patch_kind::coincident}) {
        const auto patches = random_patches(seed, kind, 1, straight, window);
        const exact_region region(patches, straight, window);
        for (double y = 4.3; y < 90; y += 27)
            for (double x = 3.7; x < 120; x += 29) {
                const double exact = region.distance_to_exact_surface(x, y);
                const double sampled = sampled_distance(patches, frame, x, y, cells);
                outside += exact > 0;
                EXPECT_LE(exact, sampled + 1.01e-4);
                // 300 px of control polygon, 3 times as fast at most, half a cell to the sample.
                EXPECT_GE(exact, sampled - 300.0 * 3 / cells / 2);
            }
    }
    EXPECT_GT(outside, 10);
}

std::vector<float> depth_of(const exact_image& image) {
    std::vector<float> result;
    for (int y = 0; y < image.size().height; ++y)
        for (int x = 0; x < image.size().width; ++x)
            result.push_back(static_cast<float>(image.at(x, y).w));
    return result;
}

float& pixel(std::vector<float>& depth, int x, int y) {
    return depth[static_cast<std::size_t>(y * window.width + x)];
}

class measured_wall : public testing::Test {
protected:
    const std::vector<patch> patches{wall(1.5)};
    const exact_image exact{patches, straight, window};
    const exact_region region{patches, straight, window};
    std::vector<float> depth = depth_of(exact);
};

TEST_F(measured_wall, exact_picture_has_no_fault) {
    const measurement found = measure(depth, exact, region);
    EXPECT_EQ(found.covered_exact, 76 * 38); // columns 22 to 97, rows 20 to 57
    EXPECT_EQ(found.covered_product, found.covered_exact);
    EXPECT_EQ(found.holes + found.missing + found.extra, 0);
    EXPECT_GT(found.depth_compared, 70 * 34);
    EXPECT_LT(found.max_depth_relative, 1e-7);
    EXPECT_LT(found.max_depth_px, 1e-4);
}

TEST_F(measured_wall, faults_are_counted_and_their_distance_found) {
    pixel(depth, 50, 33) = std::numeric_limits<float>::infinity(); // a hole
    pixel(depth, 61, 20) = 0;                                      // on the upper side: missing
    pixel(depth, 101, 31) = 8;                                     // beyond the right side
    const measurement found = measure(depth, exact, region);
    EXPECT_EQ(found.holes, 1);
    EXPECT_EQ(found.missing, 2);
    EXPECT_EQ(found.extra, 1);
    EXPECT_TRUE(found.distances_complete);
    EXPECT_NEAR(found.max_extra_distance, 101.5 - 97.75, 1e-3);
    EXPECT_NEAR(found.max_missing_distance, 33.5 - 19.75, 0.14);
    EXPECT_EQ(found.covered_product, found.covered_exact - 1);
    EXPECT_FALSE(measure(depth, exact, region, 2).distances_complete);
}

TEST_F(measured_wall, depth_error_is_a_distance_from_the_plane) {
    // The wall runs 6.04 to the side while it goes 1.5 back.
    const int x = 60, y = 41;
    const double w = exact.at(x, y).w, pushed = w + 0.01;
    pixel(depth, x, y) = static_cast<float>(pushed);
    const double along = 0.01 / w * 100, slope = 1.5 / 6.04;
    const measurement found = measure(depth, exact, region);
    EXPECT_NEAR(found.max_depth_px, along / std::hypot(1, slope), 2e-3 * along);
    EXPECT_EQ(found.worst_depth_x, x);
    EXPECT_EQ(found.worst_depth_y, y);
    EXPECT_NEAR(found.max_depth_relative, 0.01 / w, 1e-6);
}

TEST_F(measured_wall, grey_levels_are_compared_away_from_outlines) {
    const vec3 light{0.3, 0.5, 0.9};
    auto grey = exact.lambert(light);
    EXPECT_EQ(measure_lambert(grey, depth, exact, light).max, 0);
    auto& changed = grey[static_cast<std::size_t>(33 * window.width + 50)];
    changed = static_cast<unsigned char>(changed - 7);
    const shade_difference found = measure_lambert(grey, depth, exact, light);
    EXPECT_EQ(found.max, 7);
    EXPECT_NEAR(found.mean, 7.0 / static_cast<double>(found.compared), 1e-12);
}

TEST(measure, jumps_of_depth_are_left_out) {
    const patch far_and_near[] = {wall(0.5), [] {
                                      patch result = wall(0);
                                      for (vec3& p : result.points) // half as far, a third as large
                                          p = {3 + (p.x - 2.5) / 6, 2 + (p.y - 2.2) / 6, 5};
                                      return result;
                                  }()};
    const exact_image exact(far_and_near, straight, window);
    const exact_region region(far_and_near, straight, window);
    auto depth = depth_of(exact);
    const auto untouched = measure(depth, exact, region).depth_compared;
    int jumps = 0;
    for (int y = 1; y + 1 < window.height; ++y)
        for (int x = 1; x + 1 < window.width; ++x)
            if (exact.at(x, y).patch == 0 && exact.at(x + 1, y).patch == 1) {
                pixel(depth, x, y) = static_cast<float>(exact.at(x + 1, y).w);
                ++jumps;
            }
    ASSERT_GT(jumps, 5);
    const measurement found = measure(depth, exact, region);
    EXPECT_EQ(found.depth_compared, untouched);
    EXPECT_LT(found.max_depth_px, 1e-4);
}

} // namespace
} // namespace reference
