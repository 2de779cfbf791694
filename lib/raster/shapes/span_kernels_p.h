// SPDX-License-Identifier: MIT
// The inner loops of the 2D rasterizer, in SIMD lanes.
#ifndef L3D_RASTER_SHAPES_SPAN_KERNELS_P_H
#define L3D_RASTER_SHAPES_SPAN_KERNELS_P_H

#include "raster/paths/covered_span_p.h"
#include "raster/rasterizer_2d.h"
#include "raster/shapes/scan_polygon_p.h"
#include "raster/shapes/shaded_triangle_p.h"
#include "raster/shapes/winding_scan_p.h"
#include "tool_2d/pixels.h"

#include <cstdint>
#include <span>

namespace l3d_detail {

/// Fills columns first <= x < last in each of the rows from `top` on. Columns are clipped to the
/// picture.
/// Expects: the rows are in the picture.
void fill_rows(const l3d_pixels& target, std::int32_t top, std::span<const scan_ends> rows,
               std::uint32_t color);

/// Fills spans with a colour. Expects: spans are in the picture, and not empty.
void fill_spans(const l3d_pixels& target, std::span<const pixel_span> spans, std::uint32_t color);

/// Moves the words of spans towards a colour, by the rule of l3d_rasterizer_2d::draw_coverage.
/// Expects: spans are in the picture. After the last value, as many more values may be read as a
///          vector of words has lanes.
void cover_spans(const l3d_pixels& target, std::span<const covered_span> spans,
                 const std::uint8_t* values, std::uint32_t color);

/// Fills spans, each pixel with its own colour, rounded to the nearest.
/// Expects: spans are in the picture.
void shade_spans(const l3d_pixels& target, std::span<const shaded_span> spans);

} // namespace l3d_detail

#endif
