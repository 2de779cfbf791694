// SPDX-License-Identifier: MIT
// panel_layout: where the words of a panel stand.
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

/// A row as it was asked for.
struct panel_row {
    std::string_view key, text; ///< for a scale: the names of its ends
    bool is_scale = false;
    bool is_title = false; ///< it takes the room of keys, too
};

/// A piece of text, or the bar of a scale. Units: pixels from the panel's top left corner.
struct panel_line {
    int x = 0, y = 0;
    std::string text;
    bool is_key = false;
    int scale_width = 0; ///< width of the bar
    std::size_t row = 0; ///< that it belongs to
};

/// Breaks a text into lines that are no wider than that, at spaces if there are some.
std::vector<std::string> wrapped(const l3d_font& font, std::string_view text, int size, int width);

/// Wraps rows and puts them into columns.
/// Lives: borrows font and rows.
class panel_layout {
public:
    panel_layout(const l3d_font& font, std::span<const panel_row> rows)
        : font_(font), rows_(rows) {}

    /// Lays all out with letters of a size in so many columns. False if that does not fit, or tears
    /// a word apart.
    bool make(int size, int columns, l3d_size most);

    /// Leaves out of the last layout what does not fit, and says so by three dots.
    void cut(l3d_size most);

    const std::vector<panel_line>& lines() const { return lines_; }
    l3d_size size() const { return size_; }
    int letter_size() const { return letter_size_; }
    int bar_height() const { return letter_size_; }

private:
    /// A row, wrapped.
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
    int lowest_ = 0;       ///< where the longest column ends
    bool is_torn_ = false; ///< a word does not fit into its column
};

} // namespace l3d_detail

#endif
