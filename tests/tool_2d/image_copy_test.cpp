// SPDX-License-Identifier: MIT
// l3d_image: copies have words of their own, moves take them.
#include "tool_2d/image.h"

#include <gtest/gtest.h>

TEST(image, is_copied_with_its_words) {
    l3d_image first({3, 2}, 4);
    first.pixels().row(1)[2] = 0x123456;
    l3d_image second = first;
    EXPECT_EQ(second.size(), first.size());
    EXPECT_EQ(second.pixels().row(1)[2], 0x123456u);
    second.pixels().row(1)[2] = 7;
    EXPECT_EQ(first.pixels().row(1)[2], 0x123456u);

    l3d_image third = std::move(first);
    EXPECT_EQ(third.pixels().row(1)[2], 0x123456u);
    second = third;
    EXPECT_EQ(second.pixels().row(1)[2], 0x123456u);
    EXPECT_FALSE(second.pixels() == third.pixels());
    EXPECT_EQ(l3d_image(l3d_image()).size(), (l3d_size{0, 0}));
}
