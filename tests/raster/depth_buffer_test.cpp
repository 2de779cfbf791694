// SPDX-License-Identifier: MIT
// The depth buffer: resized, cleared, and as distances.
#include "raster/depth_buffer.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

TEST(DepthBuffer, ClearsEveryRowAfterEachResize) {
    l3d_depth_buffer depth;
    for (const l3d_size size : {l3d_size{7, 5}, l3d_size{3, 4}, l3d_size{11, 6}}) {
        depth.resize(size);
        depth.clear();
        EXPECT_EQ(depth.size(), size);
        for (int y = 0; y < size.height; ++y) {
            EXPECT_EQ(depth.row(y).size(), static_cast<std::size_t>(size.width));
            for (float& value : depth.row(y)) {
                EXPECT_EQ(value, 0.0f);
                value = 0.25f;
            }
        }
    }
}

TEST(DepthBuffer, DistancesAreReciprocalAndInfiniteWhereNothingIs) {
    l3d_depth_buffer depth;
    depth.resize({3, 2});
    depth.clear();
    depth.row(1)[2] = 0.125f;
    const std::vector<float> distances = l3d_distances(depth);
    ASSERT_EQ(distances.size(), 6u);
    EXPECT_EQ(distances[5], 8.0f);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_EQ(distances[i], std::numeric_limits<float>::infinity());
}

} // namespace
