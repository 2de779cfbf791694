// SPDX-License-Identifier: MIT
// Reader of Stanford's .ply: text, and binary of either byte order.
#include "geom/files/model_reader_p.h"

#include <algorithm>
#include <cmath>

namespace {

using l3d_detail::quoted;
using l3d_detail::text_cursor;

enum class number_type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct type_name {
    std::string_view name, other_name;
    std::size_t bytes;
};

/// In the order of number_type.
constexpr type_name type_names[] = {
    {"char", "int8", 1}, {"uchar", "uint8", 1}, {"short", "int16", 2},   {"ushort", "uint16", 2},
    {"int", "int32", 4}, {"uint", "uint32", 4}, {"float", "float32", 4}, {"double", "float64", 8}};

std::size_t bytes_of(number_type type) {
    return type_names[static_cast<std::size_t>(type)].bytes;
}

bool is_whole(number_type type) {
    return type < number_type::float32;
}

/// The meaning of a property to us. All other properties are read and thrown away.
enum class meaning { nothing, x, y, z, normal_x, normal_y, normal_z, red, green, blue, corners };

struct property {
    meaning means = meaning::nothing;
    number_type type = number_type::float32;
    std::optional<number_type> count; ///< of a list
};

struct element {
    std::string name;
    std::int64_t count = 0;
    std::vector<property> properties;

    bool has(meaning what) const {
        return std::ranges::any_of(properties,
                                   [what](const property& p) { return p.means == what; });
    }

    bool has_color() const {
        return has(meaning::red) && has(meaning::green) && has(meaning::blue);
    }
};

meaning vertex_meaning(std::string_view name) {
    constexpr std::pair<std::string_view, meaning> names[] = {
        {"x", meaning::x},         {"y", meaning::y},         {"z", meaning::z},
        {"nx", meaning::normal_x}, {"ny", meaning::normal_y}, {"nz", meaning::normal_z},
        {"red", meaning::red},     {"green", meaning::green}, {"blue", meaning::blue}};
    const auto found = std::ranges::find(names, name, &std::pair<std::string_view, meaning>::first);
    return found == std::end(names) ? meaning::nothing : found->second;
}

meaning face_meaning(std::string_view name, bool is_list) {
    if (is_list)
        return name == "vertex_indices" || name == "vertex_index" ? meaning::corners
                                                                  : meaning::nothing;
    return name == "red"     ? meaning::red
           : name == "green" ? meaning::green
           : name == "blue"  ? meaning::blue
                             : meaning::nothing;
}

class ply_reader {
public:
    ply_reader(text_cursor& text, l3d_polygon_mesh& mesh) : text_(text), mesh_(mesh) {}

    bool read() {
        if (!read_header() || !check())
            return false;
        for (const element& e : elements_)
            if (!read_element(e))
                return false;
        text_.forget_place();
        vertex_colors_.finish(mesh_);
        const bool ends = order_ ? text_.rest().empty() : text_.at_end();
        return ends || text_.fail("more follows the last element");
    }

private:
    // ---- the header, line by line

    bool read_header() {
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
                text_.next_line();
                continue;
            }
            const bool well = word == "format"     ? read_format(has_format)
                              : word == "element"  ? read_element_line()
                              : word == "property" ? read_property_line()
                                                   : text_.fail(quoted(word) + " in the header");
            if (!well)
                return false;
            if (text_.next_in_line())
                return text_.fail(quoted(text_.token()) + " at the end of a line of the header");
        }
        return text_.fail("the text ends before end_header");
    }

    bool word(const char* what) {
        return text_.next_in_line() ||
               text_.fail("the line ends where " + std::string(what) + " should be");
    }

    bool read_format(bool& has_format) {
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
        return word("a version") && (text_.token() == "1.0" ||
                                     text_.fail(quoted(text_.token()) + " is not version 1.0"));
    }

    bool read_element_line() {
        element& e = elements_.emplace_back();
        if (!word("the name of an element"))
            return false;
        e.name = text_.token();
        const auto same = [&e](const element& other) { return other.name == e.name; };
        if (std::any_of(elements_.begin(), elements_.end() - 1, same))
            return text_.fail("there is a second element " + quoted(e.name));
        return word("a number of elements") &&
               text_.integer_in_text(text_.token(), e.count, "the number of elements") &&
               text_.is_in(e.count, "the number of elements", 0, l3d_detail::most_vertices);
    }

    bool read_type(number_type& type) {
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

    bool read_property_line() {
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
        if (e.name == "vertex" && !is_list)
            p.means = vertex_meaning(text_.token());
        else if (e.name == "face")
            p.means = face_meaning(text_.token(), is_list);
        if (p.means != meaning::nothing && e.has(p.means))
            return text_.fail("there is a second property " + quoted(text_.token()));
        if (p.means == meaning::corners && !is_whole(p.type))
            return text_.fail("indices of vertices are not whole numbers");
        e.properties.push_back(p);
        return true;
    }

    /// Whether the header makes sense as a whole.
    bool check() {
        const element* vertex = nullptr;
        const element* face = nullptr;
        for (const element& e : elements_) {
            if (e.properties.empty() && e.count > 0)
                return text_.fail("the element " + quoted(e.name) + " has no properties");
            if (e.name == "vertex")
                vertex = &e;
            else if (e.name == "face")
                face = &e;
            else
                text_.note("the element " + quoted(e.name) + " is skipped");
        }
        if (!vertex)
            return text_.fail("there is no element vertex");
        for (const auto& [axis, name] :
             {std::pair(meaning::x, "x"), std::pair(meaning::y, "y"), std::pair(meaning::z, "z")})
            if (!vertex->has(axis))
                return text_.fail("vertices have no " + std::string(name));
        if (face && !face->has(meaning::corners))
            return text_.fail("faces have no list vertex_indices");
        vertices_ = vertex->count;
        has_normals_ = vertex->has(meaning::normal_x) && vertex->has(meaning::normal_y) &&
                       vertex->has(meaning::normal_z);
        has_colors_ = face && face->has_color();
        has_vertex_colors_ = !has_colors_ && vertex->has_color();
        if (has_vertex_colors_)
            text_.note(l3d_detail::vertex_colors_note);
        return true;
    }

    // ---- the elements

    bool read_element(const element& e) {
        std::size_t shortest = 0;
        for (const property& p : e.properties)
            shortest += order_ ? bytes_of(p.count.value_or(p.type)) : 2; // a digit and a blank
        text_.forget_place();
        // The last number of a text may have no blank behind it.
        const std::size_t room = text_.rest().size() + (order_ ? 0 : 1);
        if (e.count > 0 && static_cast<std::uint64_t>(e.count) > room / shortest)
            return text_.fail("the text is too short for " + std::to_string(e.count) +
                              " of the element " + quoted(e.name));
        const auto count = static_cast<std::size_t>(e.count);
        const bool vertex = e.name == "vertex";
        const bool face = e.name == "face";
        if (vertex)
            mesh_.vertices.reserve(count);
        if (vertex && has_normals_)
            mesh_.vertex_normals.reserve(count);
        if (face)
            mesh_.face_ends.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            text_.set_place(vertex ? " of vertex" : face ? " of face" : " of element", i, count);
            if (!read_properties(e) || (vertex && !add_vertex()) || (face && !add_face()))
                return false;
        }
        return true;
    }

    bool read_properties(const element& e) {
        face_.clear();
        for (const property& p : e.properties) {
            double value = 0;
            if (!p.count) {
                if (!number(p.type, value, "a number"))
                    return false;
                seen_[static_cast<std::size_t>(p.means)] = scaled(p, value);
                continue;
            }
            if (!number(*p.count, value, "the length of a list"))
                return false;
            const auto length = static_cast<std::int64_t>(value);
            if (!text_.is_in(length, "the length of a list", 0, l3d_detail::most_vertices))
                return false;
            for (std::int64_t i = 0; i < length; ++i)
                if (!number(p.type, value, "a member of a list") ||
                    (p.means == meaning::corners && !add_corner(value)))
                    return false;
        }
        return true;
    }

    /// Components of colours are whole numbers up to 255, or fractions up to 1.
    static double scaled(const property& p, double value) {
        const bool color =
            p.means == meaning::red || p.means == meaning::green || p.means == meaning::blue;
        return color && is_whole(p.type) ? value / 255 : value;
    }

    bool add_corner(double value) {
        const auto index = static_cast<std::int64_t>(value);
        if (!text_.is_in(index, "a corner", 0, vertices_ - 1))
            return false;
        face_.push_back(static_cast<std::uint32_t>(index));
        return true;
    }

    double seen(meaning what) const { return seen_[static_cast<std::size_t>(what)]; }

    bool add_vertex() {
        const l3d_polygon_mesh::vector v(seen(meaning::x), seen(meaning::y), seen(meaning::z));
        for (int i = 0; i < 3; ++i)
            if (!text_.is_coordinate(v[i]))
                return false;
        mesh_.vertices.push_back(v);
        if (has_normals_)
            mesh_.vertex_normals.emplace_back(seen(meaning::normal_x), seen(meaning::normal_y),
                                              seen(meaning::normal_z));
        const double color[] = {seen(meaning::red), seen(meaning::green), seen(meaning::blue)};
        if (has_vertex_colors_)
            vertex_colors_.give(mesh_, color);
        return true;
    }

    bool add_face() {
        if (face_.size() < 3) {
            text_.note("a face of " + std::to_string(face_.size()) + " corners is skipped");
            return true;
        }
        mesh_.add_face(face_);
        std::uint32_t word = 0;
        for (const meaning what : {meaning::red, meaning::green, meaning::blue}) {
            if (!has_colors_)
                return true;
            if (!(seen(what) >= 0 && seen(what) <= 1))
                return text_.fail("the colour of a face is out of range");
            word = 256 * word + static_cast<std::uint32_t>(std::lround(255 * seen(what)));
        }
        mesh_.face_colors.push_back(word);
        return true;
    }

    // ---- numbers

    /// Takes a number of any type; whole ones are exact in a double.
    bool number(number_type type, double& value, const char* what) {
        if (!order_)
            return text_number(type, value, what);
        switch (type) {
        case number_type::int8:
            return bits<std::int8_t>(value, what);
        case number_type::uint8:
            return bits<std::uint8_t>(value, what);
        case number_type::int16:
            return bits<std::int16_t>(value, what);
        case number_type::uint16:
            return bits<std::uint16_t>(value, what);
        case number_type::int32:
            return bits<std::int32_t>(value, what);
        case number_type::uint32:
            return bits<std::uint32_t>(value, what);
        case number_type::float32:
            return bits<float>(value, what);
        case number_type::float64:
            return bits<double>(value, what);
        }
        return false;
    }

    bool text_number(number_type type, double& value, const char* what) {
        if (!is_whole(type))
            return text_.number(value, what);
        std::int64_t whole = 0;
        if (!text_.integer_in(whole, what, std::numeric_limits<std::int32_t>::min(),
                              std::numeric_limits<std::uint32_t>::max()))
            return false;
        value = static_cast<double>(whole);
        return true;
    }

    template <class T> bool bits(double& value, const char* what) {
        T number{};
        if (!text_.binary(number, *order_, what))
            return false;
        value = static_cast<double>(number);
        return text_.is_finite(value, what);
    }

    text_cursor& text_;
    l3d_polygon_mesh& mesh_;
    std::vector<element> elements_;
    std::optional<std::endian> order_; ///< of a binary file
    std::int64_t vertices_ = 0;
    bool has_normals_ = false, has_colors_ = false, has_vertex_colors_ = false;
    l3d_detail::vertex_colors vertex_colors_;
    std::array<double, static_cast<std::size_t>(meaning::corners) + 1> seen_{};
    std::vector<std::uint32_t> face_;
};

} // namespace

std::optional<l3d_model_file> l3d_read_ply(std::string_view text, std::string_view name,
                                           std::string& why) {
    const auto read = [](text_cursor& cursor, l3d_model_file& model) {
        return ply_reader(cursor, model.mesh).read();
    };
    return l3d_detail::read_model_by(read, text, name, why);
}
