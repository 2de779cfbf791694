// SPDX-License-Identifier: MIT
// plain_lines: lines of one colour, a pixel wide, with hard edges.
#ifndef L3D_RASTER_LINES_PLAIN_LINES_P_H
#define L3D_RASTER_LINES_PLAIN_LINES_P_H

#include "tool_2d/pixels.h"

#include <cstdint>

namespace l3d_detail {

/// Draws a line by the rule of l3d_rasterizer_2d::draw_line, between any whole numbers.
void draw_plain_line(const l3d_pixels& target, int x0, int y0, int x1, int y1, std::uint32_t color);

} // namespace l3d_detail

#endif
