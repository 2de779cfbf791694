// SPDX-License-Identifier: MIT
// l3d_draw_text: a line of text from a small built-in font.
#ifndef L3D_RASTER_TEXT_TEXT_H
#define L3D_RASTER_TEXT_TEXT_H

#include "base/public.h"
#include "raster/rasterizer_2d.h"

#include <cstdint>
#include <string_view>

/// A character is 5 by 7 font pixels; the next one starts 6 further right, the next line 9 lower.
inline constexpr int l3d_text_advance = 6;
/// The distance from one line of text to the next, in font pixels.
inline constexpr int l3d_text_line = 9;

/// Draws one line of text with its top left corner at (x, y), each font pixel scale by scale
/// pixels.
///
/// The text is UTF-8. Characters outside printable ASCII are drawn as a box each. Tabs, control
/// characters and soft hyphens are as in l3d_font::draw. Clipped to the target.
/// Expects: scale >= 1.
/// Cost:    one small polygon for each horizontal run of font pixels.
L3D_PUBLIC void l3d_draw_text(l3d_rasterizer_2d& rasterizer, int x, int y, std::string_view text,
                              std::uint32_t color, int scale = 1);

#endif
