// SPDX-License-Identifier: MIT
// panel_layout: breaks words into lines, and shares out lines among columns.
#include "raster/text/panel_layout_p.h"

#include "raster/text/utf8_p.h"

#include <algorithm>
#include <iterator>

namespace l3d_detail {

namespace {

constexpr std::string_view soft_hyphen_bytes = "\xc2\xad";

/// The number of bytes of a text that fit into a width. The number covers whole characters, at
/// least one.
std::size_t fitting(const l3d_font& font, std::string_view text, int size, int width) {
    std::vector<std::size_t> ends; // end of each character
    for (std::string_view rest = text; !rest.empty();) {
        take_character(rest);
        ends.push_back(text.size() - rest.size());
    }
    const auto fits = [&](std::size_t end) {
        return font.width(text.substr(0, end), size) <= width;
    };
    const auto beyond = std::ranges::partition_point(ends, fits);
    return beyond == ends.begin() ? ends.front() : *std::prev(beyond);
}

/// A place where a line may end, and the text of the line up to this place.
struct line_end {
    std::size_t end = 0; ///< index behind the last byte of the line; 0 for none
    bool has_hyphen = false;
};

/// Finds the last place before byte `before` at which a line may end: a blank, or a soft hyphen if
/// the line still has room for a hyphen.
line_end last_end(const l3d_font& font, std::string_view text, int size, int width,
                  std::size_t before) {
    const std::size_t space = text.rfind(' ', before);
    line_end result{space == std::string_view::npos ? 0 : space};
    for (std::size_t at = text.rfind(soft_hyphen_bytes, before);
         at != std::string_view::npos && at > result.end;
         at = at > 0 ? text.rfind(soft_hyphen_bytes, at - 1) : std::string_view::npos)
        if (font.width(std::string(text.substr(0, at)) + '-', size) <= width)
            return {at, true};
    return result;
}

} // namespace

std::vector<std::string> wrapped(const l3d_font& font, std::string_view text, int size, int width) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        line_end last{fitting(font, text, size, width)};
        if (last.end < text.size() && text[last.end] != ' ')
            if (const line_end found = last_end(font, text, size, width, last.end); found.end > 0)
                last = found;
        lines.emplace_back(text.substr(0, last.end));
        if (last.has_hyphen)
            lines.back() += '-';
        text.remove_prefix(last.end + (last.has_hyphen ? soft_hyphen_bytes.size() : 0));
        while (!text.empty() && text.front() == ' ')
            text.remove_prefix(1);
    }
    if (lines.empty())
        lines.emplace_back();
    return lines;
}

int panel_layout::key_width_of(std::span<const panel_row> rows) const {
    int most = 0;
    for (const panel_row& r : rows)
        if (!r.is_scale && !r.key.empty())
            most = std::max(most, font_.width(r.key, letter_size_) + gap());
    return most;
}

/// The width of the widest line if the rows' texts are wrapped to `most` pixels.
int panel_layout::text_width_of(std::span<const panel_row> rows, int most) const {
    const int key_width = key_width_of(rows);
    int width = 0;
    for (const panel_row& r : rows) {
        if (r.is_title) {
            for (const std::string& line : wrapped(font_, r.text, letter_size_, key_width + most))
                width = std::max(width, font_.width(line, letter_size_) - key_width);
            continue;
        }
        if (r.is_scale) {
            const int names =
                font_.width(r.key, letter_size_) + gap() + font_.width(r.text, letter_size_);
            constexpr int least_letters = 12; // shorter bars could not be read
            width = std::max({width, names, std::min(least_letters * letter_size_, most)});
            continue;
        }
        for (const std::string& line : wrapped(font_, r.text, letter_size_, most))
            width = std::max(width, font_.width(line, letter_size_));
    }
    return width;
}

void panel_layout::add_row(std::size_t row, int x, int key_width, int text_width, int& y) {
    const panel_row& r = rows_[row];
    const int line = font_.line(letter_size_);
    if (r.is_scale) {
        const int width = key_width + text_width;
        lines_.push_back({.x = x, .y = y, .text = {}, .scale_width = width, .row = row});
        y += bar_height();
        lines_.push_back({.x = x, .y = y, .text = std::string(r.key), .row = row});
        const int last = font_.width(r.text, letter_size_);
        lines_.push_back({.x = x + width - last, .y = y, .text = std::string(r.text), .row = row});
        y += line;
        return;
    }
    if (!r.key.empty())
        lines_.push_back({.x = x, .y = y, .text = std::string(r.key), .is_key = true, .row = row});
    const int indent = r.is_title ? 0 : key_width;
    for (std::string& text :
         wrapped(font_, r.text, letter_size_, key_width + text_width - indent)) {
        lines_.push_back({.x = x + indent, .y = y, .text = std::move(text), .row = row});
        y += line;
    }
}

/// The width of the widest piece that must not be torn apart: a word of the rows' texts, or the
/// part of a word up to a soft hyphen.
int panel_layout::word_width_of(std::span<const panel_row> rows) const {
    int most = 0;
    for (const panel_row& r : rows)
        for (std::string_view rest = r.text; !rest.empty();) {
            const std::size_t space = std::min(rest.find(' '), rest.size());
            const std::size_t hyphen = rest.find(soft_hyphen_bytes);
            const bool is_hyphen = hyphen < space;
            const std::size_t end = is_hyphen ? hyphen : space;
            const std::string part = std::string(rest.substr(0, end)) + (is_hyphen ? "-" : "");
            most = std::max(most, font_.width(part, letter_size_));
            rest.remove_prefix(
                std::min(end + (is_hyphen ? soft_hyphen_bytes.size() : 1), rest.size()));
        }
    return most;
}

/// Lays out some rows as a column. Returns the column's right end.
int panel_layout::add_column(std::size_t first, std::size_t end, int x, int most_width) {
    const auto rows = rows_.subspan(first, end - first);
    const int key_width = key_width_of(rows);
    const int room = std::max(1, most_width - key_width);
    const int text_width = text_width_of(rows, room);
    is_torn_ = is_torn_ || word_width_of(rows) > room;
    int y = padding();
    for (std::size_t row = first; row < end; ++row)
        add_row(row, x, key_width, text_width, y);
    lowest_ = std::max(lowest_, y);
    return x + key_width + text_width;
}

/// Lays out all rows in columns that are at most `most_width` wide.
void panel_layout::add_columns(std::size_t columns, int most_width) {
    lines_.clear();
    lowest_ = 0;
    is_torn_ = false;
    const std::size_t each = (rows_.size() + columns - 1) / columns;
    int x = padding(), right = x;
    for (std::size_t first = 0; first < rows_.size(); first += each) {
        right = add_column(first, std::min(first + each, rows_.size()), x, most_width);
        x = right + 2 * gap();
    }
    size_ = {right + padding(), lowest_ + padding()};
}

/// Lays out the rows, and returns whether they fit into `most`. Columns are as wide as their lines
/// if such columns fit, else all columns get the same width.
bool panel_layout::make(int size, int columns, l3d_size most) {
    letter_size_ = size;
    const int inside = most.width - 2 * padding() - 2 * (columns - 1) * gap();
    add_columns(static_cast<std::size_t>(columns), inside);
    if (columns > 1 && size_.width > most.width)
        add_columns(static_cast<std::size_t>(columns), inside / columns);
    return size_.width <= most.width && size_.height <= most.height && !is_torn_;
}

void panel_layout::cut(l3d_size most) {
    make(letter_size_, 1, most);
    const int line = font_.line(letter_size_);
    const int last = most.height - padding() - line; // the lowest place where a line may begin
    if (lowest_ - line > last) {
        std::erase_if(lines_, [&](const panel_line& l) { return l.y + line > last; });
        int y = padding();
        for (const panel_line& l : lines_)
            y = std::max(y, l.y + line);
        if (y <= last)
            lines_.push_back({.x = padding(), .y = y, .text = "..."});
        lowest_ = y + line;
    }
    size_ = {std::min(size_.width, most.width), std::min(lowest_ + padding(), most.height)};
}

} // namespace l3d_detail
