// SPDX-License-Identifier: MIT
// band_lanes: what is found of many depths or vertices at a time.
#ifndef L3D_RASTER_BAND_LANES_P_H
#define L3D_RASTER_BAND_LANES_P_H

#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// A rectangle of depths. Shape: height rows of width floats, pitch floats apart.
struct depth_block {
    const float* depths;
    std::ptrdiff_t pitch;
    std::int32_t width, height;
};

/// The least depth. Expects: no depth is NaN.
float farthest_of(const depth_block& block);

/// How many depths are not 0.
std::int64_t covered_of(const depth_block& block);

/// Ends of some numbers, and the greatest of others beside them.
struct vertex_bounds {
    std::int32_t left, top, right, bottom;
    float nearest;
};

/// Of `count` vertices side by side. Expects: count >= 1.
vertex_bounds bounds_of(const std::int32_t* x, const std::int32_t* y, const float* inv_w,
                        std::size_t count);

} // namespace l3d_detail

#endif
