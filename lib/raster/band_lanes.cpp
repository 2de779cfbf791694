// SPDX-License-Identifier: MIT
// band_lanes: plain loops, which the compiler turns into lanes.
#include "raster/band_lanes_p.h"

#include <algorithm>

namespace l3d_detail {

float farthest_of(const depth_block& block) {
    float farthest = block.depths[0];
    for (std::int32_t row = 0; row < block.height; ++row)
        for (std::int32_t column = 0; column < block.width; ++column)
            farthest = std::min(farthest, block.depths[row * block.pitch + column]);
    return farthest;
}

std::int64_t covered_of(const depth_block& block) {
    std::int32_t covered = 0;
    for (std::int32_t row = 0; row < block.height; ++row)
        for (std::int32_t column = 0; column < block.width; ++column)
            covered += block.depths[row * block.pitch + column] > 0;
    return covered;
}

vertex_bounds bounds_of(const std::int32_t* x, const std::int32_t* y, const float* inv_w,
                        std::size_t count) {
    vertex_bounds b{x[0], y[0], x[0], y[0], inv_w[0]};
    for (std::size_t i = 1; i < count; ++i) {
        b.left = std::min(b.left, x[i]);
        b.right = std::max(b.right, x[i]);
        b.top = std::min(b.top, y[i]);
        b.bottom = std::max(b.bottom, y[i]);
        b.nearest = std::max(b.nearest, inv_w[i]);
    }
    return b;
}

} // namespace l3d_detail
