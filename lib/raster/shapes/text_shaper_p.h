// SPDX-License-Identifier: MIT
// text_shaper: which glyphs of a font file a text has, and where.
#ifndef L3D_RASTER_SHAPES_TEXT_SHAPER_P_H
#define L3D_RASTER_SHAPES_TEXT_SHAPER_P_H

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <ft2build.h>
#include FT_FREETYPE_H

struct hb_font_t;

namespace l3d_detail {

/// A glyph and its place on the base line. Units: those of the font, y up.
struct placed_glyph {
    unsigned index = 0; ///< in the file; 0 is its sign for what it does not have
    double x = 0, y = 0;
};

/// Places glyphs one after another. HarfBuzz knows kerning, ligatures and scripts that join their
/// letters; without it, the file's kern table moves pairs.
/// Lives:   borrows the face.
class text_shaper {
public:
    /// Without the file's name, the kern table counts.
    text_shaper(FT_Face face, const std::string& file);

    /// The glyphs of a text in UTF-8, and in `width` where a next letter would begin.
    /// Lives:   until the next call.
    const std::vector<placed_glyph>& shape(std::string_view text, double& width);

private:
    double shape_by_harfbuzz(std::string_view text);
    double shape_by_table(std::string_view text);

    FT_Face face_;
    std::unique_ptr<hb_font_t, void (*)(hb_font_t*)> harfbuzz_;
    std::vector<placed_glyph> glyphs_;
};

} // namespace l3d_detail

#endif
