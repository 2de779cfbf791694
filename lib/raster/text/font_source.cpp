// SPDX-License-Identifier: MIT
// font_source: opens font files, and finds the glyphs of a run.
#include "raster/text/font_source_p.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <ranges>
#include <system_error>

namespace l3d_detail {

namespace {

struct harfbuzz_closer {
    void operator()(hb_blob_t* blob) const { hb_blob_destroy(blob); }
    void operator()(hb_face_t* face) const { hb_face_destroy(face); }
    void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
};
template <class T> using owned = std::unique_ptr<T, harfbuzz_closer>;

/// Opens a font for HarfBuzz, in its own units. Returns null for formats in which HarfBuzz finds no
/// glyphs.
hb_font_t* harfbuzz_font(const std::string& file, long index) {
    const owned<hb_blob_t> blob(hb_blob_create_from_file_or_fail(file.c_str()));
    if (!blob)
        return nullptr;
    const owned<hb_face_t> face(hb_face_create(blob.get(), static_cast<unsigned>(index)));
    return hb_face_get_glyph_count(face.get()) > 0 ? hb_font_create(face.get()) : nullptr;
}

} // namespace

std::unique_ptr<font_source> font_source::open(const std::string& file, long index,
                                               std::string& why) {
    std::unique_ptr<font_source> result(new font_source);
    FT_Library opened = nullptr;
    if (FT_Init_FreeType(&opened) != 0) {
        why = file + ": FreeType does not start";
        return nullptr;
    }
    result->library_.reset(opened);
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        why = file + ": " + std::strerror(error ? error.value() : ENOENT);
        return nullptr;
    }
    if (!std::filesystem::is_regular_file(status)) { // opening a pipe would wait for its writer
        why = file + ": is no regular file";
        return nullptr;
    }
    FT_Face face = nullptr;
    if (FT_New_Face(opened, file.c_str(), index, &face) != 0) {
        why = file + ": is no font that can be read";
        return nullptr;
    }
    result->face_.reset(face);
    if (!FT_IS_SCALABLE(face)) {
        why = file + ": has letters of one size alone";
        return nullptr;
    }
    result->shapes_.reset(harfbuzz_font(file, index));
    return result;
}

double font_source::shape(const text_run& run, std::vector<shaped_glyph>& glyphs) const {
    if (!shapes_)
        return shape_by_table(run, glyphs);
    const owned<hb_buffer_t> buffer(hb_buffer_create());
    static_assert(sizeof(char32_t) == sizeof(hb_codepoint_t));
    const std::vector<hb_codepoint_t> codes(run.text.begin(), run.text.end());
    hb_buffer_add_codepoints(buffer.get(), codes.data(), static_cast<int>(codes.size()),
                             static_cast<unsigned>(run.begin),
                             static_cast<int>(run.end - run.begin));
    hb_buffer_set_direction(buffer.get(), run.right_to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer.get(), run.script);
    hb_shape(shapes_.get(), buffer.get(), nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* const places = hb_buffer_get_glyph_positions(buffer.get(), &count);
    double x = 0;
    for (unsigned i = 0; i < count; ++i) {
        glyphs.push_back(
            {infos[i].codepoint, x + places[i].x_offset, static_cast<double>(places[i].y_offset)});
        x += places[i].x_advance;
    }
    return x;
}

double font_source::shape_by_table(const text_run& run, std::vector<shaped_glyph>& glyphs) const {
    double x = 0;
    FT_UInt last = 0;
    for (std::size_t i = run.begin; i < run.end; ++i) {
        const std::size_t at = run.right_to_left ? run.begin + run.end - 1 - i : i;
        const FT_UInt index = FT_Get_Char_Index(face(), run.text[at]);
        FT_Vector moved{};
        if (last != 0 && index != 0 && FT_HAS_KERNING(face()) &&
            FT_Get_Kerning(face(), last, index, FT_KERNING_UNSCALED, &moved) == 0)
            x += static_cast<double>(moved.x);
        glyphs.push_back({index, x, 0});
        if (FT_Load_Glyph(face(), index, FT_LOAD_NO_SCALE) == 0)
            x += static_cast<double>(face()->glyph->metrics.horiAdvance);
        last = index;
    }
    return x;
}

} // namespace l3d_detail
