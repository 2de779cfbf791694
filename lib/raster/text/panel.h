// SPDX-License-Identifier: MIT
// l3d_panel: lines of text on a ground that the picture shines through.
#ifndef L3D_RASTER_TEXT_PANEL_H
#define L3D_RASTER_TEXT_PANEL_H

#include "base/color.h"
#include "base/public.h"
#include "raster/rasterizer_2d.h"
#include "raster/text/font.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

/// The look of a panel: its letters and colours. Units: colours are pixel words.
struct L3D_PUBLIC l3d_panel_style {
    /// The font of all text in the panel.
    l3d_font font{};

    /// The height of letters in pixels. Where letters of this size do not fit, they become smaller.
    int size = 14;

    /// The colour of the text in lines.
    std::uint32_t text = 0x00f2f2f2;

    /// The colour of the word before a line, such as a key's name.
    std::uint32_t key = 0x00ffd873;

    /// The colour behind the text.
    l3d_color ground = 0x0012161b;

    /// The opacity of the ground, from 0 to 255.
    int ground_coverage = 200;

    /// The ground_coverage of a ground that hides everything behind it. With a slow connection to
    /// the screen, text then stands still while surfaces move behind it.
    static constexpr int opaque = 255;

    /// The height of letters that suits a picture: a fiftieth of its height, but from 12 to 16
    /// pixels, times l3d_screen::text_scale. text_scale raises it to at most a sixteenth of the
    /// picture's height, to leave room for a dozen lines.
    static int size_for(l3d_size picture, double text_scale = 1);
};

/// The corner of a picture's free part in which a panel is drawn.
enum class L3D_PUBLIC l3d_corner { top_left, top_right, bottom_left, bottom_right };

/// A panel of text for help, status and legends. It fits every picture: long lines are wrapped,
/// many lines become columns, and if that does not suffice, letters become smaller.
///
///     l3d_panel panel;
///     panel.add("Hull of the ship, " + std::to_string(faces) + " faces");
///     panel.add("x", "turns it");
///     l3d_pixel_box free = l3d_whole(screen().pixels().size());
///     panel.draw(rasterizer(), free, l3d_corner::top_left);
///
/// Lives: a value; add lines, draw it, forget it.
class L3D_PUBLIC l3d_panel {
public:
    /// Adds a line, or several that \n divides. The text is UTF-8.
    void add(const std::string& text) { add({}, text); }

    /// Adds lines of text with a word before the first line, such as a key's name. The words of all
    /// lines form a column.
    void add(const std::string& key, const std::string& text);

    /// Adds a title: lines that begin at the left, in the column of the words before lines.
    void add_title(const std::string& text);

    /// Adds a scale: a bar of colours that pass into each other, with a text under each end.
    /// Expects: at least two colours, which are pixel words.
    void add_scale(std::vector<l3d_color> colors, std::string first, std::string last) {
        rows_.push_back({std::move(first), std::move(last), std::move(colors), false});
    }

    /// The number of lines and scales that were added.
    std::size_t rows() const { return rows_.size(); }

    /// Whether no line and no scale was added.
    bool empty() const { return rows_.empty(); }

    /// Divides the lines among as few panels as possible, each of which leaves half of the picture
    /// free. If there are several panels, each says that the key named `key` shows the next panel.
    /// Panels of only a few lines may still cover more than half of the picture. All panels have
    /// the same height of letters: the style's, or the largest that fits. A very small picture,
    /// where the smallest letters leave no room for a few lines, gets one panel.
    std::vector<l3d_panel> pages(l3d_size picture, const std::string& key,
                                 const l3d_panel_style& style) const;

    /// The box that draw() would cover in a free part of a picture. The box is empty if the panel
    /// does not fit into `free` with letters of the style's size.
    l3d_pixel_box box_in(const l3d_pixel_box& free, l3d_corner corner,
                         const l3d_panel_style& style) const;

    /// Draws the panel in a corner of `free`, a part of the picture, and removes its place from
    /// `free`. So the next panel is drawn above or below. Returns the covered box, which is empty
    /// for a panel without lines or without any room.
    ///
    /// Lines for which even the smallest letters leave no room are replaced by three dots.
    l3d_pixel_box draw(l3d_rasterizer_2d& rasterizer, l3d_pixel_box& free, l3d_corner corner,
                       const l3d_panel_style& style = {}) const;

private:
    friend class panel_layout;
    struct row {
        std::string key, text;
        std::vector<l3d_color> colors; ///< the colours, if the row is a scale; else empty
        bool is_title = false;
    };

    void add_lines(const std::string& key, const std::string& text, bool is_title);
    std::vector<l3d_panel> divided(std::size_t count, const std::string& key) const;
    bool leaves_half(l3d_size picture, const l3d_panel_style& style) const;

    std::vector<row> rows_;
    /// The height of letters that all pages share.
    int largest_size_ = std::numeric_limits<int>::max();
};

#endif
