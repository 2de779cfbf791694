// SPDX-License-Identifier: MIT
// l3d_panel: searches for the largest letters that fit, and draws the panel with them.
#include "raster/text/panel.h"

#include "raster/text/panel_layout_p.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using namespace l3d_detail;

/// The smallest size of letters, as nobody can tell smaller letters apart. Units: pixels.
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

/// The colour at a place of a scale. Places run from 0 to 1.
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

/// A panel's rows in the form that panel_layout takes. They borrow the rows' texts.
template <class Rows> std::vector<panel_row> laid_out(const Rows& rows) {
    std::vector<panel_row> result;
    for (const auto& r : rows)
        result.push_back({r.key, r.text, !r.colors.empty(), r.is_title});
    return result;
}

/// The box of a panel of this size in a corner of the free part of a picture.
l3d_pixel_box place_of(l3d_size size, const l3d_pixel_box& free, l3d_corner corner) {
    const bool is_right = corner == l3d_corner::top_right || corner == l3d_corner::bottom_right;
    const bool is_low = corner == l3d_corner::bottom_left || corner == l3d_corner::bottom_right;
    const int left = is_right ? free.right - size.width : free.left;
    const int top = is_low ? free.bottom - size.height : free.top;
    return {left, top, left + size.width, top + size.height};
}

} // namespace

void l3d_panel::add(const std::string& key, const std::string& text) {
    add_lines(key, text, false);
}

void l3d_panel::add_title(const std::string& text) {
    add_lines({}, text, true);
}

void l3d_panel::add_lines(const std::string& key, const std::string& text, bool is_title) {
    std::size_t begin = 0;
    do {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        rows_.push_back({begin == 0 ? key : "", text.substr(begin, end - begin), {}, is_title});
        begin = end + 1;
    } while (begin < text.size());
}

int l3d_panel_style::size_for(l3d_size picture, double text_scale) {
    constexpr int part = 50, least = 12, most = 16;
    constexpr int largest_part = 16; // lines are 1.2 times as high as letters, so 13 have room
    const int at_usual_dots = std::clamp(picture.height / part, least, most);
    const auto wanted = static_cast<int>(std::lround(at_usual_dots * text_scale));
    return std::min(wanted, std::max(at_usual_dots, picture.height / largest_part));
}

std::vector<l3d_panel> l3d_panel::pages(l3d_size picture, const std::string& key,
                                        const l3d_panel_style& style) const {
    constexpr std::size_t fewest_rows = 4; // a page with fewer is not worth a press of a key
    l3d_panel_style looks = style;
    const auto fewest_that = [&](const auto& suit) {
        std::vector<l3d_panel> result;
        for (std::size_t count = 1; count * fewest_rows <= rows_.size(); ++count)
            if (result = divided(count, key); std::ranges::all_of(result, suit))
                return result;
        return std::vector<l3d_panel>();
    };
    const auto leaves_half = [&](const l3d_panel& page) {
        return page.leaves_half(picture, looks);
    };
    const auto has_room = [&](const l3d_panel& page) {
        return !page.box_in(l3d_whole(picture), l3d_corner::top_left, looks).empty();
    };
    for (; looks.size >= smallest_size; --looks.size) {
        auto result = fewest_that(leaves_half);
        if (result.empty())
            result = fewest_that(has_room);
        for (l3d_panel& page : result)
            page.largest_size_ = looks.size;
        if (!result.empty())
            return result;
    }
    return {*this};
}

/// Divides the panel into `count` panels of equally many rows. A last line in each new panel names
/// the key that shows the next panel.
std::vector<l3d_panel> l3d_panel::divided(std::size_t count, const std::string& key) const {
    if (count == 1)
        return {*this};
    const std::size_t each = (rows_.size() + count - 1) / count;
    std::vector<l3d_panel> result;
    for (std::size_t first = 0; first < rows_.size(); first += each) {
        const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(first);
        const std::size_t rows = std::min(each, rows_.size() - first);
        result.emplace_back().rows_.assign(begin, begin + static_cast<std::ptrdiff_t>(rows));
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
        const std::string place = std::to_string(i + 1) + " of " + std::to_string(result.size());
        result[i].add(key,
                      (i + 1 < result.size() ? "more; this is " : "the end; this is ") + place);
    }
    return result;
}

/// Whether the panel takes at most half of an empty picture with letters of the style's size.
bool l3d_panel::leaves_half(l3d_size picture, const l3d_panel_style& style) const {
    const l3d_pixel_box whole = l3d_whole(picture);
    const l3d_pixel_box box = box_in(whole, l3d_corner::top_left, style);
    return !box.empty() && 2 * box.area() <= whole.area();
}

l3d_pixel_box l3d_panel::box_in(const l3d_pixel_box& free, l3d_corner corner,
                                const l3d_panel_style& style) const {
    const int size = std::min(style.size, largest_size_);
    const l3d_pixel_box room = free.grown(-size / 2);
    if (empty() || room.empty())
        return {};
    const std::vector<panel_row> rows = laid_out(rows_);
    panel_layout layout(style.font, rows);
    for (int columns = 1; columns <= most_columns; ++columns)
        if (layout.make(size, columns, {room.right - room.left, room.bottom - room.top}))
            return place_of(layout.size(), room, corner);
    return {};
}

l3d_pixel_box l3d_panel::draw(l3d_rasterizer_2d& rasterizer, l3d_pixel_box& free, l3d_corner corner,
                              const l3d_panel_style& style) const {
    if (empty() || free.empty())
        return {};
    const std::vector<panel_row> rows = laid_out(rows_);
    const int wanted = std::min(style.size, largest_size_);
    const l3d_pixel_box room = free.grown(-wanted / 2);
    if (room.empty())
        return {};
    panel_layout layout(style.font, rows);
    const l3d_size most{room.right - room.left, room.bottom - room.top};
    bool fits = false;
    for (int size = wanted; size >= std::min(wanted, smallest_size) && !fits; --size)
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
