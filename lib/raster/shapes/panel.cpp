// SPDX-License-Identifier: MIT
// l3d_panel: a search for the largest letters that fit, and the drawing of what was found.
#include "raster/shapes/panel.h"

#include "raster/shapes/panel_layout_p.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using namespace l3d_detail;

/// Letters are not made smaller: one cannot tell them apart. Units: pixels.
constexpr int smallest_size = 8;
constexpr int most_columns = 3;

void fill(l3d_rasterizer_2d& rasterizer, const l3d_pixel_box& box, std::uint32_t color,
          int coverage) {
    const std::vector<std::uint8_t> row(static_cast<std::size_t>(box.right - box.left),
                                        static_cast<std::uint8_t>(coverage));
    rasterizer.draw_coverage({.left = box.left,
                              .top = box.top,
                              .width = box.right - box.left,
                              .height = box.bottom - box.top,
                              .values = row.data(),
                              .pitch = 0},
                             color);
}

/// The colour at a place of a scale, from 0 to 1.
std::uint32_t color_at(const std::vector<std::uint32_t>& colors, double place) {
    const double at = place * static_cast<double>(colors.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(at), colors.size() - 2);
    const double way = at - static_cast<double>(first);
    std::uint32_t word = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        const double from = colors[first] >> shift & 255, to = colors[first + 1] >> shift & 255;
        word |= static_cast<std::uint32_t>(std::lround(from + way * (to - from))) << shift;
    }
    return word;
}

void draw_scale(l3d_rasterizer_2d& rasterizer, const l3d_pixel_box& box,
                const std::vector<std::uint32_t>& colors) {
    const int last = std::max(1, box.right - box.left - 1);
    for (int x = box.left; x < box.right; ++x)
        rasterizer.draw_line(x, box.top, x, box.bottom - 1,
                             color_at(colors, static_cast<double>(x - box.left) / last));
}

/// The panel's place in the free part of a picture.
l3d_pixel_box place_of(l3d_size size, const l3d_pixel_box& free, l3d_corner corner) {
    const bool is_right = corner == l3d_corner::top_right || corner == l3d_corner::bottom_right;
    const bool is_low = corner == l3d_corner::bottom_left || corner == l3d_corner::bottom_right;
    const int left = is_right ? free.right - size.width : free.left;
    const int top = is_low ? free.bottom - size.height : free.top;
    return {left, top, left + size.width, top + size.height};
}

} // namespace

void l3d_panel::add(const std::string& key, const std::string& text) {
    std::size_t begin = 0;
    do {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        rows_.push_back({begin == 0 ? key : "", text.substr(begin, end - begin), {}});
        begin = end + 1;
    } while (begin < text.size());
}

int l3d_panel_style::size_for(l3d_size picture, double text_scale) {
    constexpr int part = 50, least = 12, most = 16;
    const int at_usual_dots = std::clamp(picture.height / part, least, most);
    return static_cast<int>(std::lround(at_usual_dots * text_scale));
}

l3d_pixel_box l3d_panel::draw(l3d_rasterizer_2d& rasterizer, l3d_pixel_box& free, l3d_corner corner,
                              const l3d_panel_style& style) const {
    if (empty() || free.empty())
        return {};
    std::vector<panel_row> rows;
    for (const row& r : rows_)
        rows.push_back({r.key, r.text, !r.colors.empty()});
    const l3d_pixel_box room = free.grown(-style.size / 2);
    if (room.empty())
        return {};
    panel_layout layout(style.font, rows);
    const l3d_size most{room.right - room.left, room.bottom - room.top};
    bool fits = false;
    for (int size = style.size; size >= std::min(style.size, smallest_size) && !fits; --size)
        for (int columns = 1; columns <= most_columns && !fits; ++columns)
            fits = layout.make(size, columns, most);
    if (!fits)
        layout.cut(most);
    if (layout.lines().empty())
        return {};
    const l3d_pixel_box box = place_of(layout.size(), room, corner);
    fill(rasterizer, box, style.ground, style.ground_coverage);
    for (const panel_line& line : layout.lines()) {
        const int x = box.left + line.x, y = box.top + line.y;
        if (line.scale_width > 0)
            draw_scale(rasterizer, {x, y, x + line.scale_width, y + layout.bar_height()},
                       rows_[line.row].colors);
        else
            style.font.draw(rasterizer, x, y, line.text, line.is_key ? style.key : style.text,
                            layout.letter_size());
    }
    if (corner == l3d_corner::top_left || corner == l3d_corner::top_right)
        free.top = box.bottom;
    else
        free.bottom = box.top;
    return box;
}
