// SPDX-License-Identifier: MIT
// l3d_read_model: chooses the reader by the beginning of the text.
#include "geom/files/model_file.h"

#include "geom/files/reading_progress_p.h"
#include "geom/files/model_reader_p.h"
#include "geom/files/stl_file_p.h"

#include <algorithm>

namespace {

using l3d_detail::text_cursor;

template <std::size_t N> bool is_one_of(std::string_view word, const std::string_view (&list)[N]) {
    return std::ranges::find(list, word) != std::end(list);
}

bool is_whole_number(std::string_view word) {
    if (word.starts_with('+') || word.starts_with('-'))
        word.remove_prefix(1);
    return !word.empty() && word.find_first_not_of("0123456789") == word.npos;
}

std::optional<l3d_model_file> read_bpt(std::string_view text, std::string_view name,
                                       std::string& why) {
    auto patches = l3d_read_bpt(text, name, why);
    if (!patches)
        return std::nullopt;
    return l3d_model_file{{}, *std::move(patches), {}};
}

/// Whether a text begins with a line of IGES. The line has 80 columns; the last 8 hold the letter
/// of the section, S, and the line's number, 1.
bool is_iges(std::string_view text) {
    constexpr std::size_t columns = 80, kind = 72;
    if (text.size() < columns)
        return false;
    const std::string_view line = text.substr(0, columns);
    return line.find_first_of("\r\n") == line.npos && line[kind] == 'S' &&
           line.find_first_not_of(" 0", kind + 1) == columns - 1 && line.back() == '1';
}

} // namespace

std::optional<l3d_model_format> l3d_model_format_of(std::string_view text) {
    if (l3d_detail::is_binary_stl(text))
        return l3d_model_format::stl;
    if (is_iges(text))
        return l3d_model_format::iges;
    text_cursor cursor(text, "", '#');
    if (!cursor.next())
        return std::nullopt;
    const std::string_view word = cursor.token();
    constexpr std::string_view asc_words[] = {"Ambient", "Named", "Page", "Background", "Solid"};
    constexpr std::string_view obj_words[] = {"v", "vt", "vn", "vp",     "f",      "o",      "g",
                                              "s", "w",  "mg", "mtllib", "usemtl", "cstype", "deg"};
    if (word == "ply")
        return l3d_model_format::ply;
    if (word == "solid" || word == "SOLID")
        return l3d_model_format::stl;
    if (word.starts_with('{') || word.starts_with("glTF"))
        return l3d_model_format::gltf;
    if (word == "ncols" || word == "NCOLS")
        return l3d_model_format::grid;
    if (word.starts_with("ISO-10303-21"))
        return l3d_model_format::step;
    if (word == "3DG1")
        return l3d_model_format::videoscape;
    if (word.ends_with("OFF"))
        return l3d_model_format::off;
    if (word.ends_with("BBP") || word.starts_with("BEZ") || word.starts_with("CBEZ"))
        return l3d_model_format::bez;
    if (is_one_of(word, asc_words))
        return l3d_model_format::asc;
    if (is_one_of(word, obj_words))
        return l3d_model_format::obj;
    if (is_whole_number(word))
        return l3d_model_format::bpt;
    return l3d_detail::is_long_binary_stl(text) ? std::optional(l3d_model_format::stl)
                                                : std::nullopt;
}

std::optional<l3d_model_file> l3d_read_model(std::string_view text, std::string_view name,
                                             std::string& why) {
    return l3d_read_model_with({}, text, name, why);
}

std::optional<l3d_model_file> l3d_read_model_with(const l3d_other_files& files,
                                                  std::string_view text, std::string_view name,
                                                  std::string& why) {
    return l3d_detail::read_model(files, text, name, why, {});
}

std::optional<l3d_model_file> l3d_detail::read_model(const l3d_other_files& files,
                                                     std::string_view text, std::string_view name,
                                                     std::string& why,
                                                     const reading_progress& progress) {
    const auto format = l3d_model_format_of(text);
    if (!format) {
        text_cursor cursor(text, name, '#');
        cursor.fail(cursor.next() ? l3d_detail::quoted(cursor.token()) +
                                        " begins none of asc, obj, off, ply, 3DG1, bpt, BBP, BEZ, "
                                        "stl, glTF, ncols, STEP and IGES"
                                  : "the text is empty");
        why = cursor.why();
        return std::nullopt;
    }
    switch (*format) {
    case l3d_model_format::asc:
        return l3d_read_asc(text, name, why);
    case l3d_model_format::obj:
        return l3d_read_obj(text, name, why);
    case l3d_model_format::off:
        return l3d_read_off(text, name, why);
    case l3d_model_format::ply:
        return l3d_read_ply(text, name, why);
    case l3d_model_format::videoscape:
        return l3d_read_videoscape(text, name, why);
    case l3d_model_format::bpt:
        return read_bpt(text, name, why);
    case l3d_model_format::bez:
        return l3d_read_bez(text, name, why);
    case l3d_model_format::stl:
        return l3d_read_stl(text, name, why);
    case l3d_model_format::grid:
        return l3d_read_grid(text, name, why);
    case l3d_model_format::gltf:
        return l3d_read_gltf(text, name, why, files);
    case l3d_model_format::step:
    case l3d_model_format::iges:
        return read_cad(text, name, why, progress);
    }
    return std::nullopt;
}
