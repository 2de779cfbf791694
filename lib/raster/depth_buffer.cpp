// SPDX-License-Identifier: MIT
// l3d_depth_buffer: counts its pixels, and converts depths to distances for files.
#include "raster/depth_buffer.h"

#include <limits>

std::int64_t l3d_covered(const l3d_depth_buffer& depth) {
    std::int64_t covered = 0;
    for (int y = 0; y < depth.size().height; ++y)
        covered += std::ranges::count_if(depth.row(y), [](float inv_w) { return inv_w > 0; });
    return covered;
}

std::vector<float> l3d_distances(const l3d_depth_buffer& depth) {
    std::vector<float> distances;
    distances.reserve(static_cast<std::size_t>(depth.size().width) *
                      static_cast<std::size_t>(depth.size().height));
    for (int y = 0; y < depth.size().height; ++y)
        for (const float inv_w : depth.row(y))
            distances.push_back(inv_w > 0 ? 1 / inv_w : std::numeric_limits<float>::infinity());
    return distances;
}
