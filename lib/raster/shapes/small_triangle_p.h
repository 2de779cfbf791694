// SPDX-License-Identifier: MIT
// Fills triangles of a few pixels, in SIMD lanes.
#ifndef L3D_RASTER_SHAPES_SMALL_TRIANGLE_P_H
#define L3D_RASTER_SHAPES_SMALL_TRIANGLE_P_H

#include "raster/rasterizer_2d.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// The limit of the width and the height of triangles that fill_small_triangle takes, in pixels. In
/// lattice units the limit is 2^13. Products of two differences, and sums of such products, stay
/// below 2^28.
inline constexpr int small_side = 32;

/// Fills a small triangle by its three edge functions, at all pixels of its box, which costs less
/// than finding spans. Returns false, and draws nothing, if the triangle is not small or not wholly
/// in the picture.
/// Shape:   three corners of any winding; coordinates may be NaN.
/// Expects: `ends` = {width, height} of the picture, or less, and at most 2^15.
bool fill_small_triangle(const l3d_pixels& target, std::span<const l3d_point_2d, 3> corners,
                         const std::array<double, 2>& ends, std::uint32_t color);

} // namespace l3d_detail

#endif
