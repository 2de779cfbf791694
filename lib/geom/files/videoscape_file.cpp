// SPDX-License-Identifier: MIT
// Reads Videoscape's 3DG1: polygons with a colour each.
#include "base/counted_p.h"
#include "geom/files/model_reader_p.h"

#include <charconv>
#include <iterator>

namespace {

using l3d_detail::counted;
using l3d_detail::quoted;
using l3d_detail::text_cursor;

/// The colours of numbers below 256, by the lowest four bits. The higher bits are kinds of surface.
/// Source: E. Wright's table in the mailing list lightwave-l, September 1994.
constexpr std::uint32_t palette[16] = {0x000000, 0x0050a0, 0x008c00, 0x008c8c, 0xa00000, 0x8c00a0,
                                       0xa07800, 0x8c8c8c, 0x000000, 0x0078f0, 0x00f000, 0x00f0f0,
                                       0xf00000, 0xc800f0, 0xf0c800, 0xf0f0f0};

/// Reads a colour. Decimal numbers below 256 name a colour of the palette. Greater numbers, and all
/// hexadecimal numbers, are 0xBBGGRR.
bool read_color(text_cursor& text, std::uint32_t& color) {
    if (!text.next())
        return text.fail("the text ends where the colour of a face should be");
    std::string_view digits = text.token();
    const bool hexadecimal = digits.starts_with("0x") || digits.starts_with("0X");
    std::int64_t value = 0;
    if (hexadecimal) {
        digits.remove_prefix(2);
        const char* const end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, value, 16);
        if (error != std::errc() || stop != end)
            return text.fail(quoted(text.token()) + ", the colour of a face, is not a number");
    } else if (!text.integer_in_text(digits, value, "the colour of a face")) {
        return false;
    }
    if (value < 0 && !hexadecimal)
        return text.fail(quoted(text.token()) + ", the colour of a face, announces detail "
                                                "polygons, which are not read");
    if (!text.is_in(value, "the colour of a face", 0, 0xffffff))
        return false;
    const auto word = static_cast<std::uint32_t>(value);
    if (!hexadecimal && word <= 255 && word >= std::size(palette))
        text.note_once(
            "kinds of surface, such as glossy ones, are skipped: faces have their colours");
    color = hexadecimal || word > 255 ? (word & 255) << 16 | (word & 0xff00) | word >> 16
                                      : palette[word % 16];
    return true;
}

bool read_face(text_cursor& text, l3d_polygon_mesh& mesh, std::vector<std::uint32_t>& face) {
    // The number of corners has been taken as a token, to see whether there is a face.
    std::int64_t corners = 0;
    if (!text.integer_in_text(text.token(), corners, "the number of corners") ||
        !text.plausible(corners, "corners", 2))
        return false;
    face.resize(static_cast<std::size_t>(corners));
    for (std::uint32_t& corner : face) {
        std::int64_t index = 0;
        if (!text.integer_in(index, "a corner of a face", 0,
                             static_cast<std::int64_t>(mesh.vertices.size()) - 1))
            return false;
        corner = static_cast<std::uint32_t>(index);
    }
    std::uint32_t color = 0;
    if (!read_color(text, color))
        return false;
    if (face.size() < 3) {
        text.note("a face of " + counted(static_cast<std::size_t>(corners), "corners") +
                  " is skipped");
        return true;
    }
    mesh.add_face(face);
    mesh.face_colors.push_back(color);
    return true;
}

bool read_mesh(text_cursor& text, l3d_polygon_mesh& mesh) {
    if (!text.next() || text.token() != "3DG1")
        return text.fail("there is no 3DG1");
    std::int64_t vertices = 0;
    // A vertex has three numbers of a digit and a blank.
    if (!text.integer_in(vertices, "the number of vertices", 0, l3d_detail::most_vertices) ||
        !text.plausible(vertices, "vertices", 3 * 2))
        return false;
    const auto count = static_cast<std::size_t>(vertices);
    mesh.vertices.reserve(count);
    l3d_detail::odd_coordinates odd;
    while (mesh.vertices.size() < count) {
        text.set_place(" of vertex", mesh.vertices.size(), count);
        if (!l3d_detail::read_vertex(text, mesh, odd))
            return false;
    }
    text.forget_place();
    std::vector<std::uint32_t> face;
    while (text.next())
        if (!read_face(text, mesh, face))
            return false;
    return odd.are_unused(text, mesh);
}

} // namespace

std::optional<l3d_model_file> l3d_read_videoscape(std::string_view text, std::string_view name,
                                                  std::string& why) {
    const auto read = [](text_cursor& cursor, l3d_model_file& model) {
        return read_mesh(cursor, model.mesh);
    };
    return l3d_detail::read_model_by(read, text, name, why);
}
