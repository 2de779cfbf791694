// SPDX-License-Identifier: MIT
// ply::header: reads the format, the elements and their properties.
#include "geom/files/ply_header_p.h"

#include "geom/files/model_reader_p.h"

#include <iterator>
#include <string>
#include <utility>

namespace l3d_detail::ply {

namespace {

struct type_name {
    std::string_view name, other_name;
    std::size_t bytes;
};

/// The names and sizes of types, in the order of number_type.
constexpr type_name type_names[] = {
    {"char", "int8", 1}, {"uchar", "uint8", 1}, {"short", "int16", 2},   {"ushort", "uint16", 2},
    {"int", "int32", 4}, {"uint", "uint32", 4}, {"float", "float32", 4}, {"double", "float64", 8}};

row_kind kind_of(std::string_view element) {
    return element == "vertex"      ? row_kind::vertex
           : element == "face"      ? row_kind::face
           : element == "tristrips" ? row_kind::strip
                                    : row_kind::other;
}

/// The meaning of a colour's property, by all the names that programs give it.
meaning color_meaning(std::string_view name) {
    constexpr std::string_view prefix = "diffuse_";
    if (name.starts_with(prefix))
        name.remove_prefix(prefix.size());
    return name == "red" || name == "r"     ? meaning::red
           : name == "green" || name == "g" ? meaning::green
           : name == "blue" || name == "b"  ? meaning::blue
                                            : meaning::nothing;
}

meaning vertex_meaning(std::string_view name) {
    constexpr std::pair<std::string_view, meaning> names[] = {{"x", meaning::x},
                                                              {"y", meaning::y},
                                                              {"z", meaning::z},
                                                              {"nx", meaning::normal_x},
                                                              {"ny", meaning::normal_y},
                                                              {"nz", meaning::normal_z},
                                                              {"s", meaning::place_u},
                                                              {"t", meaning::place_v},
                                                              {"u", meaning::place_u},
                                                              {"v", meaning::place_v},
                                                              {"texture_u", meaning::place_u},
                                                              {"texture_v", meaning::place_v}};
    const auto found = std::ranges::find(names, name, &std::pair<std::string_view, meaning>::first);
    return found == std::end(names) ? color_meaning(name) : found->second;
}

meaning face_meaning(std::string_view name, bool is_list) {
    if (is_list)
        return name == "vertex_indices" || name == "vertex_index" ? meaning::corners
               : name == "texcoord"                               ? meaning::places
                                                                  : meaning::nothing;
    return color_meaning(name);
}

/// Whether a property is a scanner's measurement, which no picture shows.
bool is_measure(std::string_view name) {
    return name == "confidence" || name == "intensity" || name == "quality";
}

} // namespace

std::size_t bytes_of(number_type type) {
    return type_names[static_cast<std::size_t>(type)].bytes;
}

const element* header::find(row_kind kind) const {
    const auto found = std::ranges::find(elements_, kind, &element::kind);
    return found == elements_.end() ? nullptr : &*found;
}

bool header::read() {
    if (!text_.next_in_line() || text_.token() != "ply")
        return text_.fail("there is no ply");
    bool has_format = false;
    while (text_.next()) {
        const std::string_view word = text_.token();
        if (word == "end_header") {
            if (!has_format)
                return text_.fail("there is no format before end_header");
            return text_.next_line() || elements_.empty() ||
                   text_.fail("the text ends after end_header");
        }
        if (word == "comment" || word == "obj_info") {
            constexpr std::string_view before = "TextureFile ";
            if (const std::string_view said = text_.name_in_line();
                said.starts_with(before) && picture_.empty())
                picture_ = said.substr(said.find_first_not_of(' ', before.size()));
            continue;
        }
        const bool well = word == "format"     ? read_format(has_format)
                          : word == "element"  ? read_element_line()
                          : word == "property" ? read_property_line()
                                               : skip_line(word);
        if (!well)
            return false;
        if (text_.next_in_line())
            return text_.fail(quoted(text_.token()) + " at the end of a line of the header");
    }
    return text_.fail("the text ends before end_header");
}

/// Skips a line. Blender up to 2.48 names a file's creator without marking this as a comment.
bool header::skip_line(std::string_view word) {
    if (word != "Created")
        text_.note_once("lines " + quoted(word) + " of the header are skipped");
    text_.name_in_line();
    return true;
}

bool header::word(const char* what) {
    return text_.next_in_line() ||
           text_.fail("the line ends where " + std::string(what) + " should be");
}

bool header::read_format(bool& has_format) {
    if (has_format)
        return text_.fail("there is a second format");
    has_format = true;
    if (!word("a format"))
        return false;
    if (text_.token() == "binary_little_endian")
        order_ = std::endian::little;
    else if (text_.token() == "binary_big_endian")
        order_ = std::endian::big;
    else if (text_.token() != "ascii")
        return text_.fail(quoted(text_.token()) + " is no format of ply");
    return word("a version") &&
           (text_.token() == "1.0" || text_.fail(quoted(text_.token()) + " is not version 1.0"));
}

bool header::read_element_line() {
    element& e = elements_.emplace_back();
    if (!word("the name of an element"))
        return false;
    e.name = text_.token();
    e.kind = kind_of(e.name);
    if (!names_.insert(e.name).second)
        return text_.fail("there is a second element " + quoted(e.name));
    return word("a number of elements") &&
           text_.integer_in_text(text_.token(), e.count, "the number of elements") &&
           text_.is_in(e.count, "the number of elements", 0, most_vertices);
}

bool header::read_type(number_type& type) {
    if (!word("a type"))
        return false;
    const auto found = std::ranges::find_if(type_names, [this](const type_name& t) {
        return t.name == text_.token() || t.other_name == text_.token();
    });
    if (found == std::end(type_names))
        return text_.fail(quoted(text_.token()) + " is no type of ply");
    type = static_cast<number_type>(found - std::begin(type_names));
    return true;
}

bool header::read_property_line() {
    if (elements_.empty())
        return text_.fail("a property of no element");
    element& e = elements_.back();
    property p;
    const bool is_list = text_.take_in_line("list");
    if (is_list) {
        number_type count{};
        if (!read_type(count))
            return false;
        if (!is_whole(count))
            return text_.fail(quoted(text_.token()) + " counts a list");
        p.count = count;
    }
    if (!read_type(p.type) || !word("the name of a property"))
        return false;
    if (e.kind == row_kind::vertex && !is_list)
        p.means = vertex_meaning(text_.token());
    else if (e.kind == row_kind::face || (e.kind == row_kind::strip && is_list))
        p.means = face_meaning(text_.token(), is_list);
    const bool is_of_strip = e.kind == row_kind::strip && p.means == meaning::places;
    if (is_of_strip || (p.means != meaning::nothing && e.has(p.means)))
        p.means = meaning::nothing;
    if (p.means == meaning::nothing && e.kind != row_kind::other && !is_measure(text_.token()))
        text_.note_once("the property " + quoted(text_.token()) + " is skipped");
    if (p.means == meaning::corners && !is_whole(p.type))
        return text_.fail("indices of vertices are not whole numbers");
    e.properties.push_back(p);
    return true;
}

} // namespace l3d_detail::ply
