// SPDX-License-Identifier: MIT
// Reader of 3D Studio's .asc: triangles, named objects and materials, line by line.
#include "geom/files/corner_normals_p.h"
#include "geom/files/model_reader_p.h"

#include <algorithm>
#include <charconv>

namespace {

using l3d_detail::quoted;
using l3d_detail::text_cursor;

constexpr std::string_view blanks = " \t\r\v\f";

/// One line, from which fields are taken from left to right.
class field_line {
public:
    explicit field_line(std::string_view text) : rest_(text) { skip_blanks(); }

    /// Takes `word`, and blanks behind it, if it is next.
    bool take(std::string_view word) {
        if (!rest_.starts_with(word))
            return false;
        rest_.remove_prefix(word.size());
        skip_blanks();
        return true;
    }

    /// Takes what stands before the next blank or colon.
    std::string_view value() {
        const std::size_t size = std::min(rest_.find_first_of(" \t\r\v\f:"), rest_.size());
        const std::string_view result = rest_.substr(0, size);
        rest_.remove_prefix(size);
        skip_blanks();
        return result;
    }

    /// Takes what stands between the next quotation mark and the last, or all if there are not two.
    std::string_view in_quotes() {
        const std::size_t begin = rest_.find('"');
        const std::size_t end = rest_.rfind('"');
        const bool has_two = begin != rest_.npos && end != begin;
        const std::string_view result = has_two
                                            ? rest_.substr(begin + 1, end - begin - 1)
                                            : rest_.substr(0, rest_.find_last_not_of(blanks) + 1);
        rest_ = {};
        return result;
    }

    std::string_view rest() const { return rest_; }

private:
    void skip_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    }

    std::string_view rest_;
};

/// The colour that 3D Studio names a material by: "r255g0b128a0".
std::optional<std::uint32_t> color_of(std::string_view name) {
    std::uint32_t word = 0;
    for (const char letter : {'r', 'g', 'b'}) {
        unsigned component = 0;
        if (!name.starts_with(letter))
            return std::nullopt;
        name.remove_prefix(1);
        const auto [end, error] =
            std::from_chars(name.data(), name.data() + name.size(), component);
        if (error != std::errc() || component > 255)
            return std::nullopt;
        name.remove_prefix(static_cast<std::size_t>(end - name.data()));
        word = word << 8 | component;
    }
    return name.empty() || name.starts_with('a') ? std::optional(word) : std::nullopt;
}

class asc_reader {
public:
    asc_reader(text_cursor& text, l3d_polygon_mesh& mesh)
        : text_(text), mesh_(mesh), materials_(mesh) {}

    bool read() {
        bool any = false;
        while (text_.next_line()) {
            field_line line(text_.token());
            if (line.rest().empty())
                continue;
            any = true;
            if (!read_line(line))
                return false;
        }
        if (!any)
            return text_.fail("the text is empty");
        if (!is_complete() || !odd_.are_unused(text_, mesh_))
            return false;
        if (mesh_.faces() == 0)
            return text_.fail("the text ends without a triangle");
        normals_.finish(mesh_);
        std::vector<std::uint32_t> no_patches;
        materials_.finish(no_patches);
        give_looks();
        return true;
    }

private:
    /// Materials whose names say a colour look like that.
    void give_looks() {
        for (std::size_t i = 0; i < mesh_.materials.size(); ++i)
            if (const auto color = color_of(mesh_.materials[i])) {
                mesh_.looks.resize(mesh_.materials.size());
                mesh_.looks[i].color = *color;
            }
    }

    bool read_line(field_line& line) {
        if (line.take("Page"))
            return true; // a printer's page begins
        if (line.take("Vertex list:") || line.take("Face list:"))
            return true;
        if (line.take("Smoothing:"))
            return read_smoothing(line);
        if (line.take("Vertex"))
            return read_vertex(line);
        if (line.take("Face"))
            return read_face(line);
        if (line.take("Material:"))
            return read_material(line);
        if (line.take("Mapped")) {
            text_.note_once("texture coordinates are skipped");
            return true;
        }
        if (line.take("Named object:"))
            return is_complete() && begin_object(line);
        if (line.take("Tri-mesh"))
            return is_complete() && begin_mesh(line);
        return is_of_scene(line);
    }

    /// Lights, cameras, their values, and what else a scene has beside its objects.
    bool is_of_scene(field_line& line) {
        constexpr std::string_view beginnings[] = {"Direct light", "Camera"};
        constexpr std::string_view colors[] = {"Ambient light color:", "Background", "Solid"};
        constexpr std::string_view values[] = {
            "Position:",     "Light color:", "Spotlight to:", "Hotspot size:",
            "Falloff size:", "Target:",      "Bank angle:"};
        if (std::ranges::any_of(beginnings, [&](auto word) { return line.take(word); })) {
            text_.note("the light or camera " + quoted(object_) + " is skipped");
            return true;
        }
        if (std::ranges::any_of(colors, [&](auto word) { return line.take(word); })) {
            if (line.rest().find_first_of("123456789") != std::string_view::npos)
                text_.note_once("ambient light and background of the scene are skipped");
            return true;
        }
        if (std::ranges::any_of(values, [&](auto word) { return line.take(word); }))
            return true;
        text_.note("the line " + quoted(line.rest()) + " is skipped");
        return true;
    }

    bool begin_object(field_line& line) {
        object_ = line.in_quotes();
        return true;
    }

    /// Takes "label:" and the number behind it.
    bool labelled(field_line& line, std::string_view label, std::string_view& digits) {
        if (!line.take(label) || !line.take(":"))
            return text_.fail(std::string(label) + ": is missing");
        digits = line.value();
        return true;
    }

    bool index(field_line& line, std::string_view label, const char* what, std::int64_t most,
               std::int64_t& value) {
        std::string_view digits;
        return labelled(line, label, digits) && text_.integer_in_text(digits, value, what) &&
               text_.is_in(value, what, 0, most);
    }

    bool begin_mesh(field_line& line) {
        line.take(",");
        if (!index(line, "Vertices", "the number of vertices", l3d_detail::most_vertices,
                   vertices_) ||
            !index(line, "Faces", "the number of faces", l3d_detail::most_vertices, faces_))
            return false;
        // "Vertex 0: X:0 Y:0 Z:0" and "Face 0: A:0 B:0 C:0" without their blanks, with a newline.
        constexpr std::size_t shortest_vertex = 19;
        constexpr std::size_t shortest_face = 17;
        if (!text_.plausible(vertices_, "vertices", shortest_vertex) ||
            !text_.plausible(faces_, "faces", shortest_face))
            return false;
        base_ = mesh_.vertices.size();
        first_face_ = mesh_.faces();
        mesh_.parts.push_back({object_, static_cast<std::uint32_t>(first_face_)});
        return true;
    }

    /// Whether the object before has all that it promised.
    bool is_complete() {
        const std::size_t vertices = mesh_.vertices.size() - base_;
        const std::size_t faces = mesh_.faces() - first_face_;
        return (vertices == static_cast<std::size_t>(vertices_) ||
                text_.fail(quoted(object_) + " has " + std::to_string(vertices) + " of " +
                           std::to_string(vertices_) + " vertices")) &&
               (faces == static_cast<std::size_t>(faces_) ||
                text_.fail(quoted(object_) + " has " + std::to_string(faces) + " of " +
                           std::to_string(faces_) + " faces"));
    }

    /// Takes the number of a vertex or a face and the colon; they come one after another.
    bool is_next(field_line& line, const char* what, std::size_t next, std::int64_t count) {
        std::int64_t number = 0;
        if (!text_.integer_in_text(line.value(), number, what) ||
            !text_.is_in(number, what, 0, count - 1))
            return false;
        if (number != static_cast<std::int64_t>(next))
            return text_.fail(std::string(what) + " is " + std::to_string(number) + ", not " +
                              std::to_string(next));
        return line.take(":") || text_.fail("there is no colon behind " + std::string(what));
    }

    bool read_vertex(field_line& line) {
        if (!is_next(line, "the number of a vertex", mesh_.vertices.size() - base_, vertices_))
            return false;
        l3d_polygon_mesh::vector v(0);
        constexpr std::string_view axes[] = {"X", "Y", "Z"};
        for (int i = 0; i < 3; ++i) {
            std::string_view digits;
            if (!labelled(line, axes[i], digits) ||
                !text_.any_number_in(digits, v[i], "a coordinate"))
                return false;
            odd_.check(text_, mesh_, v[i], digits);
        }
        mesh_.vertices.push_back(v);
        return true;
    }

    bool read_face(field_line& line) {
        if (!is_next(line, "the number of a face", mesh_.faces() - first_face_, faces_))
            return false;
        std::uint32_t corners[3];
        constexpr std::string_view labels[] = {"A", "B", "C"};
        for (std::size_t i = 0; i < 3; ++i) {
            std::int64_t corner = 0;
            if (!index(line, labels[i], "a corner", vertices_ - 1, corner))
                return false;
            corners[i] = static_cast<std::uint32_t>(base_ + static_cast<std::size_t>(corner));
        }
        mesh_.add_face(corners);
        return true;
    }

    /// The groups of the last face, from 1 to 32: "1, 2".
    bool read_smoothing(field_line& line) {
        if (mesh_.faces() == first_face_)
            return text_.fail("smoothing groups before the first face of an object");
        constexpr std::int64_t most = 32;
        std::uint64_t groups = 0;
        while (!line.rest().empty()) {
            const std::string_view digits = line.rest().substr(
                0, std::min(line.rest().find_first_of(" ,\t\r"), line.rest().size()));
            std::int64_t group = 0;
            if (!text_.integer_in_text(digits, group, "a smoothing group") ||
                !text_.is_in(group, "a smoothing group", 0, most))
                return false;
            groups |= group > 0 ? std::uint64_t{1} << (group - 1) : 0;
            line.take(digits);
            line.take(",");
        }
        normals_.give_to_last_face(mesh_, groups);
        return true;
    }

    bool read_material(field_line& line) {
        if (mesh_.faces() == first_face_)
            return text_.fail("a material before the first face of an object");
        materials_.give_to_last_face(materials_.named(line.in_quotes()));
        return true;
    }

    text_cursor& text_;
    l3d_polygon_mesh& mesh_;
    l3d_detail::face_materials materials_;
    std::string object_;                    ///< the name of the current object
    std::int64_t vertices_ = 0, faces_ = 0; ///< numbers that the current mesh promised
    std::size_t base_ = 0, first_face_ = 0; ///< beginnings of the current mesh
    l3d_detail::corner_normals normals_;
    l3d_detail::odd_coordinates odd_;
};

} // namespace

std::optional<l3d_model_file> l3d_read_asc(std::string_view text, std::string_view name,
                                           std::string& why) {
    const auto read = [](text_cursor& cursor, l3d_model_file& model) {
        return asc_reader(cursor, model.mesh).read();
    };
    return l3d_detail::read_model_by(read, text, name, why);
}
