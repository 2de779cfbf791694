// SPDX-License-Identifier: MIT
// font_source: a font file, as FreeType and HarfBuzz see it.
#ifndef L3D_RASTER_TEXT_FONT_SOURCE_P_H
#define L3D_RASTER_TEXT_FONT_SOURCE_P_H

#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <ft2build.h>
#include FT_FREETYPE_H
#include <harfbuzz/hb.h>

namespace l3d_detail {

/// A glyph and its place on the base line. Units: font units, y up.
struct shaped_glyph {
    unsigned index = 0; ///< the glyph's number in the font file; 0 is the sign for a missing letter
    double x = 0, y = 0;
};

/// A part of a text with one script and one direction.
struct text_run {
    /// The whole text: letters at the part's ends may join their neighbours.
    std::span<const char32_t> text;
    std::size_t begin = 0, end = 0; ///< the part's range in `text`
    hb_script_t script = HB_SCRIPT_COMMON;
    bool right_to_left = false;
};

/// One face of a font file: it finds the glyphs of texts and their places. All calls come from one
/// thread.
class font_source {
public:
    /// Opens a font file. `index` is the number of the face in a file with several faces.
    /// Errors:  returns null, and sets `why` to the reason, which names the file.
    static std::unique_ptr<font_source> open(const std::string& file, long index, std::string& why);

    FT_Face face() const { return face_.get(); }
    bool has(char32_t code) const { return FT_Get_Char_Index(face_.get(), code) != 0; }

    /// Adds the run's glyphs to `glyphs`, from left to right. HarfBuzz does kerning, ligatures and
    /// scripts that join their letters. Formats older than OpenType use their kern table.
    /// Returns: the place where a next glyph would begin.
    double shape(const text_run& run, std::vector<shaped_glyph>& glyphs) const;
    double shape_by_table(const text_run& run, std::vector<shaped_glyph>& glyphs) const;

private:
    struct closer {
        void operator()(FT_Library library) const { FT_Done_FreeType(library); }
        void operator()(FT_Face face) const { FT_Done_Face(face); }
        void operator()(hb_font_t* font) const { hb_font_destroy(font); }
    };
    template <class Handle> using unique = std::unique_ptr<std::remove_pointer_t<Handle>, closer>;

    font_source() = default;

    unique<FT_Library> library_;
    unique<FT_Face> face_;      ///< declared after FreeType's library, and so closed before it
    unique<hb_font_t*> shapes_; ///< null if HarfBuzz finds no glyphs in the file's format
};

} // namespace l3d_detail

#endif
