// SPDX-License-Identifier: MIT
// Reads .stl, text or binary, and welds the corners of its separate triangles to vertices.
#include "base/counted_p.h"
#include "base/number_hash_p.h"
#include "geom/files/model_reader_p.h"
#include "geom/files/stl_file_p.h"

#include <cctype>

namespace {

using l3d_detail::counted;
using l3d_detail::quoted;
using l3d_detail::text_cursor;

constexpr std::size_t header_bytes = 80, count_bytes = 4;
constexpr std::size_t begin_bytes = header_bytes + count_bytes;
/// The size of a triangle: a normal and three corners of three floats, and two bytes for any use.
constexpr std::size_t triangle_bytes = 12 * sizeof(float) + 2;

/// The number of triangles that a binary file promises. Expects: the text has a whole header.
std::uint64_t promised(std::string_view text) {
    std::uint64_t count = 0;
    for (std::size_t i = count_bytes; i-- > 0;)
        count = count << 8 | static_cast<unsigned char>(text[header_bytes + i]);
    return count;
}

/// Welds corners at the same place to one vertex, so that faces become neighbours.
class welded_vertices {
public:
    explicit welded_vertices(l3d_polygon_mesh& mesh) : mesh_(mesh) {}

    /// Adds a corner to the current face.
    void add_corner(const std::array<double, 3>& at) {
        const auto next = l3d_polygon_mesh::index_of(mesh_.vertices.size());
        const auto [place, is_new] = places_.try_emplace(at, next);
        if (is_new)
            mesh_.vertices.emplace_back(at[0], at[1], at[2]);
        mesh_.corners.push_back(place->second);
    }

private:
    l3d_polygon_mesh& mesh_;
    std::unordered_map<std::array<double, 3>, std::uint32_t, l3d_detail::number_hash> places_;
};

class stl_reader {
public:
    stl_reader(text_cursor& text, l3d_polygon_mesh& mesh)
        : text_(text), mesh_(mesh), vertices_(mesh) {}

    bool read_text() {
        while (text_.next())
            if (!is_word("solid"))
                return text_.fail(quoted(text_.token()) + " where a solid should begin");
            else if (!read_solid())
                return false;
        return true;
    }

    bool read_binary() {
        std::uint8_t byte = 0;
        for (std::size_t i = 0; i < header_bytes; ++i)
            if (!text_.binary(byte, std::endian::little, "the header"))
                return false;
        std::uint32_t count = 0;
        if (!text_.binary(count, std::endian::little, "the number of triangles"))
            return false;
        if (text_.rest().size() < count * triangle_bytes)
            return text_.fail(counted(count, "triangles") + (count == 1 ? " takes " : " take ") +
                              std::to_string(count * triangle_bytes) + " bytes; there are " +
                              std::to_string(text_.rest().size()));
        bool has_more = false;
        for (std::uint32_t i = 0; i < count; ++i) {
            text_.set_place(" of triangle", i + 1, count);
            if (!read_triangle(has_more))
                return false;
        }
        if (!text_.rest().empty())
            text_.note("what follows the last triangle is skipped");
        if (has_more)
            text_.note("what stands behind triangles, such as colours, is skipped");
        return true;
    }

private:
    /// Whether the token is `word`, in capitals or not.
    bool is_word(std::string_view word) const {
        return std::ranges::equal(text_.token(), word, [](char a, char b) {
            return std::tolower(static_cast<unsigned char>(a)) == b;
        });
    }

    bool take(std::string_view word) {
        if (!text_.next())
            return text_.fail("the text ends where '" + std::string(word) + "' should be");
        return is_word(word) ||
               text_.fail(quoted(text_.token()) + " where '" + std::string(word) + "' should be");
    }

    /// Reads a solid after its first word.
    bool read_solid() {
        mesh_.parts.push_back(
            {std::string(text_.name_in_line()), static_cast<std::uint32_t>(mesh_.faces())});
        for (;;) {
            if (!text_.next())
                return text_.fail("the text ends in a solid, before its endsolid");
            if (is_word("endsolid"))
                break;
            if (!is_word("facet"))
                return text_.fail(quoted(text_.token()) + " where 'facet' or 'endsolid' should be");
            if (!read_facet())
                return false;
        }
        text_.name_in_line(); // the name, repeated
        return true;
    }

    bool read_facet() {
        double unused = 0;
        if (!take("normal") || !text_.any_number(unused, "a normal") ||
            !text_.any_number(unused, "a normal") || !text_.any_number(unused, "a normal") ||
            !take("outer") || !take("loop"))
            return false;
        const std::size_t begin = mesh_.corners.size();
        while (text_.next() && is_word("vertex")) {
            std::array<double, 3> at{};
            for (double& value : at)
                if (!text_.coordinate(value))
                    return false;
            vertices_.add_corner(at);
        }
        if (!is_word("endloop"))
            return text_.fail(quoted(text_.token()) + " where 'vertex' or 'endloop' should be");
        if (const std::size_t corners = mesh_.corners.size() - begin; corners < 3) {
            text_.note("a facet of " + counted(corners, "corners") + " is skipped");
            mesh_.corners.resize(begin);
        } else {
            mesh_.end_face();
        }
        return take("endfacet");
    }

    bool read_triangle(bool& has_more) {
        float value = 0;
        for (int i = 0; i < 3; ++i) // ignored, since the corners give the normal
            if (!text_.binary(value, std::endian::little, "a normal"))
                return false;
        for (int corner = 0; corner < 3; ++corner) {
            std::array<double, 3> at{};
            for (double& coordinate : at) {
                if (!text_.binary(value, std::endian::little, "a coordinate"))
                    return false;
                coordinate = double{value};
                if (!text_.is_coordinate(coordinate))
                    return false;
            }
            vertices_.add_corner(at);
        }
        mesh_.end_face();
        std::uint16_t more = 0;
        if (!text_.binary(more, std::endian::little, "what stands behind a triangle"))
            return false;
        has_more = has_more || more != 0;
        return true;
    }

    text_cursor& text_;
    l3d_polygon_mesh& mesh_;
    welded_vertices vertices_;
};

} // namespace

bool l3d_detail::is_binary_stl(std::string_view text) {
    if (text.size() < begin_bytes)
        return false;
    if (text.size() - begin_bytes == promised(text) * triangle_bytes)
        return true;
    // A binary file of a wrong size: most programs begin headers with "solid", and a text has no
    // zero bytes.
    return text.starts_with("solid") && text.substr(0, begin_bytes).find('\0') != text.npos;
}

bool l3d_detail::is_long_binary_stl(std::string_view text) {
    return text.size() >= begin_bytes && promised(text) > 0 &&
           text.size() - begin_bytes > promised(text) * triangle_bytes &&
           text.substr(0, begin_bytes).find('\0') != text.npos;
}

std::optional<l3d_model_file> l3d_read_stl(std::string_view text, std::string_view name,
                                           std::string& why) {
    const bool is_binary = l3d_detail::is_binary_stl(text) || l3d_detail::is_long_binary_stl(text);
    const auto read = [is_binary](text_cursor& cursor, l3d_model_file& model) {
        stl_reader reader(cursor, model.mesh);
        return is_binary ? reader.read_binary() : reader.read_text();
    };
    return l3d_detail::read_model_by(read, text, name, why);
}
