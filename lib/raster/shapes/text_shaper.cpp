// SPDX-License-Identifier: MIT
// text_shaper: the only source that knows HarfBuzz.
#include "raster/shapes/text_shaper_p.h"

#include "raster/shapes/utf8_p.h"

#include <cstdint>

#include <hb.h>

namespace l3d_detail {
namespace {

struct buffer_closer {
    void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
};
struct blob_closer {
    void operator()(hb_blob_t* blob) const { hb_blob_destroy(blob); }
};
struct face_closer {
    void operator()(hb_face_t* face) const { hb_face_destroy(face); }
};

/// A font that counts in units of its own.
hb_font_t* harfbuzz_font(const std::string& file) {
    const std::unique_ptr<hb_blob_t, blob_closer> blob(
        hb_blob_create_from_file_or_fail(file.c_str()));
    if (!blob)
        return nullptr;
    const std::unique_ptr<hb_face_t, face_closer> face(hb_face_create(blob.get(), 0));
    // Formats older than OpenType have no glyphs here.
    return hb_face_get_glyph_count(face.get()) > 0 ? hb_font_create(face.get()) : nullptr;
}

void close_font(hb_font_t* font) {
    hb_font_destroy(font);
}

} // namespace

text_shaper::text_shaper(FT_Face face, const std::string& file)
    : face_(face), harfbuzz_(harfbuzz_font(file), close_font) {}

const std::vector<placed_glyph>& text_shaper::shape(std::string_view text, double& width) {
    glyphs_.clear();
    width = harfbuzz_ ? shape_by_harfbuzz(text) : shape_by_table(text);
    return glyphs_;
}

/// Characters are read here, so that broken bytes mean the same as everywhere.
double text_shaper::shape_by_harfbuzz(std::string_view text) {
    double x = 0;
    std::vector<hb_codepoint_t> codes;
    while (!text.empty())
        codes.push_back(static_cast<hb_codepoint_t>(take_character(text)));
    const std::unique_ptr<hb_buffer_t, buffer_closer> buffer(hb_buffer_create());
    const int count = static_cast<int>(codes.size());
    hb_buffer_add_codepoints(buffer.get(), codes.data(), count, 0, count);
    hb_buffer_guess_segment_properties(buffer.get());
    hb_shape(harfbuzz_.get(), buffer.get(), nullptr, 0);
    unsigned length = 0;
    const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer.get(), &length);
    const hb_glyph_position_t* const places = hb_buffer_get_glyph_positions(buffer.get(), &length);
    for (unsigned i = 0; i < length; ++i) {
        glyphs_.push_back(
            {infos[i].codepoint, x + places[i].x_offset, static_cast<double>(places[i].y_offset)});
        x += places[i].x_advance;
    }
    return x;
}

double text_shaper::shape_by_table(std::string_view text) {
    double x = 0;
    FT_UInt last = 0;
    while (!text.empty()) {
        const FT_UInt index = FT_Get_Char_Index(face_, take_character(text));
        FT_Vector moved{};
        if (last != 0 && index != 0 && FT_HAS_KERNING(face_) &&
            FT_Get_Kerning(face_, last, index, FT_KERNING_UNSCALED, &moved) == 0)
            x += static_cast<double>(moved.x);
        glyphs_.push_back({index, x, 0});
        if (FT_Load_Glyph(face_, index, FT_LOAD_NO_SCALE) == 0)
            x += static_cast<double>(face_->glyph->metrics.horiAdvance);
        last = index;
    }
    return x;
}

} // namespace l3d_detail
