// SPDX-License-Identifier: MIT
// panel_layout: finds the places of the words of a panel.
#ifndef L3D_RASTER_TEXT_PANEL_LAYOUT_P_H
#define L3D_RASTER_TEXT_PANEL_LAYOUT_P_H

#include "raster/text/font.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace l3d_detail {

/// A row of a panel as the panel's caller added it, before it is wrapped into lines.
struct panel_row {
    /// The word before the text, and the text; for a scale: the texts at its ends.
    std::string_view key, text;
    bool is_scale = false;
    bool is_title = false; ///< whether the row begins at the left, in the column of keys
};

/// A piece of text, or the bar of a scale. Units: pixels from the panel's top left corner.
struct panel_line {
    int x = 0, y = 0;
    std::string text;
    bool is_key = false;
    int scale_width = 0; ///< width of the bar; 0 for a piece of text
    std::size_t row = 0; ///< index of the row that the line belongs to
};

/// Breaks a text into lines no wider than `width`: at spaces and soft hyphens, else between
/// characters. A line has at least one character, however wide.
std::vector<std::string> wrapped(const l3d_font& font, std::string_view text, int size, int width);

/// Lays out a panel: wraps rows and puts them into columns.
/// Lives: borrows font and rows.
class panel_layout {
public:
    panel_layout(const l3d_font& font, std::span<const panel_row> rows)
        : font_(font), rows_(rows) {}

    /// Lays out all rows in columns, with letters of this size. Returns false if the columns do not
    /// fit into `most`, or a word must be broken.
    bool make(int size, int columns, l3d_size most);

    /// Removes from the last layout the lines that do not fit into `most`, and adds three dots in
    /// place of these lines.
    void cut(l3d_size most);

    const std::vector<panel_line>& lines() const { return lines_; }
    l3d_size size() const { return size_; }
    int letter_size() const { return letter_size_; }
    int bar_height() const { return letter_size_; }

private:
    /// The lines into which a row was wrapped.
    struct block {
        std::vector<std::string> text;
        int height = 0;
    };

    int padding() const { return letter_size_ / 2; }
    int gap() const { return letter_size_; }
    int text_width_of(std::span<const panel_row> rows, int most) const;
    int key_width_of(std::span<const panel_row> rows) const;
    int word_width_of(std::span<const panel_row> rows) const;
    int add_column(std::size_t first, std::size_t end, int x, int most_width);
    void add_columns(std::size_t columns, int most_width);
    void add_row(std::size_t row, int x, int key_width, int text_width, int& y);

    const l3d_font& font_;
    std::span<const panel_row> rows_;
    std::vector<panel_line> lines_;
    l3d_size size_;
    int letter_size_ = 1;
    int lowest_ = 0;       ///< the lower end of the longest column
    bool is_torn_ = false; ///< whether a word is wider than its column
};

} // namespace l3d_detail

#endif
