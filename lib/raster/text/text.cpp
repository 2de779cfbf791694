// SPDX-License-Identifier: MIT
// l3d_draw_text: each run of font pixels becomes a rectangle.
#include "raster/text/text.h"

#include "raster/text/font_p.h"

#include <array>
#include <cassert>

namespace {

using namespace l3d_detail;

/// Draws one row of the character whose top left corner is given.
void draw_row(l3d_rasterizer_2d& rasterizer, int character, int row, l3d_point_2d corner,
              std::uint32_t color, double scale) {
    const double top = corner.y + row * scale, bottom = top + scale;
    for (int begin = 0; begin < font_width; ++begin) {
        int end = begin;
        while (end < font_width && font_ink(character, end, row))
            ++end;
        if (end == begin)
            continue;
        const double left = corner.x + begin * scale, right = corner.x + end * scale;
        const std::array<l3d_point_2d, 4> run{
            {{left, top}, {right, top}, {right, bottom}, {left, bottom}}};
        rasterizer.draw_polygon_flatshaded(run, color);
        begin = end;
    }
}

} // namespace

void l3d_draw_text(l3d_rasterizer_2d& rasterizer, int x, int y, std::string_view text,
                   std::uint32_t color, int scale) {
    assert(scale >= 1);
    visit_characters(text, [&](int character, int from) {
        const l3d_point_2d corner{x + double(from) * scale, double(y)};
        for (int row = 0; row < font_height; ++row)
            draw_row(rasterizer, character, row, corner, color, scale);
    });
}
