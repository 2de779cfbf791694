// SPDX-License-Identifier: MIT
// Slanted boxes that are culled in lanes, against their corners.
#include "scene/camera.h"
#include "scene/culling/scene_culling_p.h"
#include "raster/parallel/simd_target.h"
#include "teapot_studio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using vector = l3d_vector<double, 3>;

/// The slow twin: the eight corners of a box.
void look_at_corners(const l3d_slanted_box& box, const l3d_matrix<double>& to_image,
                     std::vector<l3d_image_point>& corners) {
    corners.clear();
    for (int corner = 0; corner < 8; ++corner) {
        vector p = box.centre;
        for (std::size_t k = 0; k < 3; ++k)
            p = (corner >> k & 1) != 0 ? p + box.axes[k] : p - box.axes[k];
        const auto h = to_image * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
        corners.push_back({h[0], h[1], h[3]});
    }
}

TEST(cull_boxes, says_what_the_corners_say_with_the_same_bits_from_every_instruction_set) {
    constexpr l3d_size odd{317, 241};
    const l3d_camera camera = dice_tests::oblique_camera();
    l3d_dice_view view;
    view.size = odd;
    view.near = 0.2;
    view.far = 300;
    const l3d_matrix<double> to_image = camera.image_matrix(odd);
    std::mt19937_64 random(660);
    std::uniform_real_distribution<double> unit(-1, 1), power(-4, 6);
    std::vector<l3d_slanted_box> slanted(1000);
    l3d_box_lanes boxes;
    for (l3d_slanted_box& box : slanted) {
        const double far = std::exp2(power(random)), size = far * std::exp2(power(random) - 4);
        box.centre = camera.eye + vector(unit(random), unit(random), unit(random)) * far;
        for (vector& axis : box.axes)
            axis = vector(unit(random), unit(random), unit(random)) * size;
        boxes.add(box);
    }
    ASSERT_EQ(boxes.count(), 1000u);
    constexpr std::size_t lanes = l3d_box_lanes::lanes;
    std::vector<l3d_detail::culled_boxes> best;
    std::vector<l3d_image_point> corners;
    double widest = 0;
    int outside = 0, projected = 0;
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        for (std::size_t first = 0; first < boxes.count(); first += lanes) {
            l3d_detail::culled_boxes culled{};
            l3d_detail::cull_boxes(boxes, first, {to_image, {}, view, view.margin()}, culled);
            if (best.size() <= first / lanes) {
                best.push_back(culled);
                for (std::size_t i = 0; i < lanes && first + i < boxes.count(); ++i) {
                    look_at_corners(slanted[first + i], to_image, corners);
                    const l3d_depth_range depth = l3d_depth_range_of(corners);
                    EXPECT_NEAR(culled.least[i], depth.least, 1e-9);
                    EXPECT_NEAR(culled.most[i], depth.most, 1e-9);
                    const double always = std::numeric_limits<double>::infinity();
                    EXPECT_EQ(culled.inside[i] < 0,
                              l3d_outside(corners, view.margin(), -always, always));
                    outside += culled.inside[i] < 0;
                    if (depth.least <= view.near || culled.inside[i] < 0)
                        continue;
                    const l3d_image_box box = l3d_image_box_of(corners);
                    EXPECT_LE(culled.left[i], box.left + 1e-9);
                    EXPECT_LE(culled.top[i], box.top + 1e-9);
                    EXPECT_GE(culled.right[i], box.right - 1e-9);
                    EXPECT_GE(culled.bottom[i], box.bottom - 1e-9);
                    // How much wider is limited by how much w changes.
                    const double even = depth.most / depth.least;
                    EXPECT_LE(culled.right[i] - culled.left[i], box.width() * even * even + 1e-9);
                    widest = std::max(widest, (culled.right[i] - culled.left[i]) / box.width());
                    ++projected;
                }
            }
            const std::size_t here = std::min(lanes, boxes.count() - first);
            const auto same = [&](const auto& a, const auto& b) {
                return std::memcmp(a.data(), b.data(), here * sizeof(double)) == 0;
            };
            const l3d_detail::culled_boxes& expected = best[first / lanes];
            EXPECT_TRUE(same(culled.least, expected.least)) << target;
            EXPECT_TRUE(same(culled.most, expected.most)) << target;
            EXPECT_TRUE(same(culled.inside, expected.inside)) << target;
            for (std::size_t i = 0; i < here; ++i)
                if (culled.inside[i] >= 0 && culled.least[i] > view.near) {
                    EXPECT_EQ(culled.left[i], expected.left[i]) << target;
                    EXPECT_EQ(culled.right[i], expected.right[i]) << target;
                    EXPECT_EQ(culled.top[i], expected.top[i]) << target;
                    EXPECT_EQ(culled.bottom[i], expected.bottom[i]) << target;
                }
        }
    }
    l3d_set_simd_target({});
    EXPECT_GT(outside, 100);
    EXPECT_GT(projected, 50);
    std::printf("boxes in lanes are at most %.3g times as wide\n", widest);
}

} // namespace
