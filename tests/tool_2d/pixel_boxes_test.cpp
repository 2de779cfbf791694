// SPDX-License-Identifier: MIT
// l3d_pixel_boxes: few, disjoint, around all, and not around what lies between.
#include "tool_2d/pixel_boxes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace {

bool holds(const l3d_pixel_boxes& boxes, const l3d_pixel_box& box) {
    for (const l3d_pixel_box& each : boxes.boxes())
        if (each.intersected(box) == box)
            return true;
    return false;
}

TEST(pixel_boxes, hold_all_that_was_added_and_no_pixel_twice) {
    std::mt19937_64 random(23);
    const auto below = [&](int end) {
        return static_cast<std::int32_t>(random() % static_cast<std::uint64_t>(end));
    };
    for (int round = 0; round < 2000; ++round) {
        l3d_pixel_boxes boxes;
        std::vector<l3d_pixel_box> added;
        const int count = 1 + below(9);
        for (int i = 0; i < count; ++i) {
            const std::int32_t left = below(900), top = below(700);
            const std::int32_t width = 1 + below(90), height = 1 + below(60);
            added.push_back({left, top, left + width, top + height});
            boxes.add(added.back());
            boxes.add({left, top, left, top + 5}); // nothing
        }
        l3d_pixel_box around;
        for (const l3d_pixel_box& box : added) {
            EXPECT_TRUE(holds(boxes, box)) << round;
            around = around.united(box);
        }
        EXPECT_EQ(boxes.around(), around) << round;
        const auto found = boxes.boxes();
        ASSERT_LE(found.size(), l3d_pixel_boxes::most) << round;
        for (std::size_t i = 0; i < found.size(); ++i)
            for (std::size_t k = i + 1; k < found.size(); ++k)
                EXPECT_TRUE(found[i].intersected(found[k]).empty()) << round;
    }
}

TEST(pixel_boxes, leave_out_what_is_between_and_unite_neighbours) {
    l3d_pixel_boxes boxes(l3d_pixel_box{3, 5, 40, 30});
    boxes.add({800, 600, 850, 640});
    EXPECT_EQ(boxes.area(), 37 * 25 + 50 * 40);
    boxes.add({42, 5, 61, 31});
    EXPECT_EQ(boxes.boxes().size(), 2u);
    EXPECT_EQ(boxes.area(), 58 * 26 + 50 * 40);
    EXPECT_EQ(boxes.around(), (l3d_pixel_box{3, 5, 850, 640}));
}

} // namespace
