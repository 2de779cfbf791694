// SPDX-License-Identifier: MIT
// Sides that meet two smaller patches: found bit for bit, inside of the surface, and without a gap.
#include "geom/teapot.h"
#include "scene/sides/halved_sides.h"
#include "scene/sides/patch_neighbours.h"
#include "scene/sides/side_pairs.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using patch = l3d_patch_model::patch;
using kind = l3d_side_pairs::kind;

/// A curved strip of two patches, the second of which is cut in two along the side that they share.
std::vector<patch> strip() {
    patch left, right;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            const double y = row / 3.0 + 0.1 * column * column;
            left.at(row, column) = {column / 3.0, y, 0.2 * row * row};
            right.at(row,
                     column) = {1 + column / 3.0,
                                0.9 + row / 3.0 + 0.6 * column / 3.0 + 0.01 * column * (column - 1),
                                0.2 * row * row};
        }
    for (int row = 0; row < 4; ++row)
        right.at(row, 0) = left.at(row, 3);
    const auto [low, high] = right.split_v();
    return {left, low, high};
}

TEST(halved_sides, are_found_where_two_patches_go_on) {
    const std::vector<patch> patches = strip();
    const auto halved = l3d_find_halved_sides(patches);
    ASSERT_EQ(halved.size(), 1U);
    EXPECT_EQ(halved[0].of.patch, 0U);
    EXPECT_EQ(halved[0].of.side, 1U);
    EXPECT_EQ(halved[0].beyond[0].patch, 1U);
    EXPECT_EQ(halved[0].beyond[1].patch, 2U);
    EXPECT_EQ(halved[0].beyond[0].side, 3U);
    EXPECT_FALSE(halved[0].turns[0]);
    const l3d_patch_model model(patches);
    EXPECT_EQ(model.halved_edges(0), 8U); // u = 1
    EXPECT_EQ(model.halved_edges(1), 0U);
}

TEST(halved_sides, differ_from_those_that_are_off_by_a_bit) {
    std::vector<patch> patches = strip();
    patches[1].at(1, 0)[0] += 0x1p-52;
    EXPECT_TRUE(l3d_find_halved_sides(patches).empty());
}

TEST(halved_sides, are_inside_of_the_surface) {
    const l3d_patch_model model(strip());
    const l3d_side_pairs sides(model);
    EXPECT_EQ(sides.at(0, 1).is, kind::halved);
    EXPECT_EQ(sides.at(1, 3).is, kind::half);
    EXPECT_EQ(sides.at(2, 3).part, 1U);
    EXPECT_EQ(sides.at(0, 0).is, kind::open);
    // Only the sides around are outlines: all but u = 1 of the first patch.
    EXPECT_EQ(l3d_patch_neighbours(model).outlines(0) & 2U,
              l3d_patch_neighbours(model).outlines(1) >> 2 & 2U);
}

TEST(halved_sides, are_none_in_the_teapot) {
    EXPECT_TRUE(l3d_patch_model::teapot().halved_sides().empty());
}

} // namespace
