// SPDX-License-Identifier: MIT
// text_shaper: the glyphs of a line of text, with their fonts and places.
#ifndef L3D_RASTER_TEXT_TEXT_SHAPER_P_H
#define L3D_RASTER_TEXT_TEXT_SHAPER_P_H

#include "raster/text/font_fallbacks_p.h"
#include "raster/text/font_source_p.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace l3d_detail {

/// A glyph of a line, and the font that has the glyph. Units: font units of the line's first font.
struct placed_glyph : shaped_glyph {
    const font_source* source = nullptr;
};

/// A line of glyphs from left to right. Units: font units of its first font.
struct shaped_line {
    std::vector<placed_glyph> glyphs;
    double width = 0; ///< the line's width: the place where a next letter would begin
};

/// Lays out lines of text: directions by the Unicode algorithm, letters by HarfBuzz, and letters
/// that the first font lacks from other fonts.
///
/// A tab goes to the next multiple of eight blanks. Other control characters and soft hyphens are
/// left out. If a line begins with a script from right to left, the whole line has that direction.
/// Lives:   borrows the first font.
/// Cost:    a line is laid out once, if no more than `most_lines` other lines come between its
///          uses.
class text_shaper {
public:
    explicit text_shaper(const font_source& first) : first_(first) {}

    /// Lays out a line. Lives: until the next call.
    const shaped_line& shape(std::string_view text);

private:
    /// The number of lines whose layouts are kept. Help has some dozens of lines, each of which is
    /// tried in several widths.
    static constexpr std::size_t most_lines = 1024;

    /// A run of text, and the font that has its letters; the font is null for a tab.
    struct run : text_run {
        const font_source* source = nullptr;
        unsigned level = 0; ///< depth of nested directions; odd: the run goes from right to left
    };

    void find_levels();
    void find_scripts();
    void find_sources();
    std::vector<run> runs_from_left() const;
    void place(const std::vector<run>& runs, shaped_line& line) const;

    const font_source& first_;
    font_fallbacks others_;
    std::map<std::string, shaped_line, std::less<>> lines_;
    // For each character of the line that is laid out:
    std::vector<char32_t> text_;
    std::vector<unsigned> levels_;
    std::vector<hb_script_t> scripts_;
    std::vector<const font_source*> sources_;
};

} // namespace l3d_detail

#endif
