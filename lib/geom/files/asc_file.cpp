// SPDX-License-Identifier: MIT
// Reads 3D Studio's .asc: triangles, named objects, materials and cameras, line by line.
#include "geom/files/corner_normals_p.h"
#include "geom/files/model_reader_p.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <utility>

namespace {

using l3d_detail::quoted;
using l3d_detail::text_cursor;

constexpr std::string_view blanks = " \t\r\v\f";

/// One line, whose fields are taken from left to right.
class field_line {
public:
    explicit field_line(std::string_view text) : rest_(text) { skip_blanks(); }

    /// Takes `word` and the blanks after it, if `word` comes next.
    bool take(std::string_view word) {
        if (!rest_.starts_with(word))
            return false;
        rest_.remove_prefix(word.size());
        skip_blanks();
        return true;
    }

    /// Takes the text before the next blank or colon.
    std::string_view value() {
        const std::size_t size = std::min(rest_.find_first_of(" \t\r\v\f:"), rest_.size());
        const std::string_view result = rest_.substr(0, size);
        rest_.remove_prefix(size);
        skip_blanks();
        return result;
    }

    /// Takes the text between the next quotation mark and the last. Without two marks, takes all
    /// text.
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

/// The colour in a material's name as 3D Studio writes it: "r255g0b128a0".
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
    asc_reader(text_cursor& text, l3d_model_file& model)
        : text_(text), mesh_(model.mesh), cameras_(model.cameras), materials_(model.mesh) {}

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
        std::vector<std::uint32_t> no_patches, no_curves;
        materials_.finish(no_patches, no_curves);
        give_looks();
        forget_odd_cameras();
        return true;
    }

private:
    /// Gives materials the colours that their names encode.
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
        read_scene(line);
        return true;
    }

    /// Reads a line about a camera. A line about lights, fog or the background gets a note.
    void read_scene(field_line& line) {
        const auto takes = [&](std::initializer_list<std::string_view> words) {
            return std::ranges::any_of(words, [&](auto word) { return line.take(word); });
        };
        if (line.take("Camera"))
            begin_camera(line);
        else if (line.take("Direct light"))
            text_.note_once("lights are skipped");
        else if (line.take("Position:"))
            place_camera(line, &l3d_model_camera::eye);
        else if (line.take("Target:"))
            place_camera(line, &l3d_model_camera::target);
        else if (line.take("Bank angle:"))
            note_unless_zero(line, "bank angles are skipped: cameras stand upright");
        else if (line.take("Ambient light color:"))
            note_unless_zero(line, "ambient light is skipped");
        else if (line.take("Solid background color:"))
            note_unless_zero(line, "the background is skipped");
        else if (takes(
                     {"Fog settings:", "Dcue settings:", "Background dimmed", "Background fogged"}))
            text_.note_once("fog is skipped");
        else if (takes({"Background", "Gradient"}))
            text_.note_once("the background is skipped");
        else if (!takes({"Light color:", "Spotlight to:", "Hotspot size:", "Falloff size:"}))
            text_.note("the line " + quoted(line.rest()) + " is skipped");
    }

    void note_unless_zero(const field_line& line, const char* what) {
        if (line.rest().find_first_of("123456789") != std::string_view::npos)
            text_.note_once(what);
    }

    /// Begins a camera, whose line holds its lens: "Camera (35mm)".
    void begin_camera(field_line& line) {
        is_camera_ = std::exchange(has_new_name_, false);
        if (!is_camera_)
            return;
        constexpr double half_film = 18; // Half of a film's width, as 3D Studio has it. Units: mm.
        line.take("(");
        const std::string_view lens = line.rest().substr(0, line.rest().find_first_of("m) \t\r"));
        const double fov = 2 * std::atan(half_film / number_of(lens)) * 180 / std::numbers::pi;
        const l3d_model_camera::vector unknown(std::numeric_limits<double>::quiet_NaN());
        cameras_.push_back({object_, unknown, unknown, {0.0, 0.0, 1.0}, fov});
        camera_lines_.push_back(text_.here());
    }

    /// Reads a camera's place, "X:1 Y:2 Z:3". A light's place is skipped.
    void place_camera(field_line& line, l3d_model_camera::vector l3d_model_camera::*place) {
        constexpr std::string_view axes[] = {"X:", "Y:", "Z:"};
        for (int i = 0; is_camera_ && i < 3 && line.take(axes[i]); ++i)
            (cameras_.back().*place)[i] = number_of(line.value());
    }

    /// The number that `digits` spells; NaN if the text is no number.
    static double number_of(std::string_view digits) {
        double value = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const bool is_number = error == std::errc() && end == digits.data() + digits.size();
        return is_number ? value : std::numeric_limits<double>::quiet_NaN();
    }

    /// Drops cameras without a place, target or lens, with a note each.
    void forget_odd_cameras() {
        const auto is_odd = [](const l3d_model_camera& c) {
            const auto is_place = [](const l3d_model_camera::vector& v) {
                return std::abs(v[0]) <= l3d_bpt_largest_coordinate &&
                       std::abs(v[1]) <= l3d_bpt_largest_coordinate &&
                       std::abs(v[2]) <= l3d_bpt_largest_coordinate;
            };
            return !(is_place(c.eye) && is_place(c.target) && c.eye != c.target && c.fov > 0 &&
                     c.fov < 180);
        };
        for (std::size_t i = 0; i < cameras_.size(); ++i)
            if (is_odd(cameras_[i])) {
                text_.go_back(camera_lines_[i]);
                text_.note("the camera " + quoted(cameras_[i].name) +
                           " is skipped: its place, target or lens is missing");
            }
        std::erase_if(cameras_, is_odd);
        for (l3d_model_camera& c : cameras_)
            if (c.eye[0] == c.target[0] && c.eye[1] == c.target[1])
                c.up = {0.0, 1.0, 0.0}; // it looks along z, so y is upwards
    }

    bool begin_object(field_line& line) {
        object_ = line.in_quotes();
        has_new_name_ = true;
        is_camera_ = false;
        return true;
    }

    /// Takes "label:" and the number after it.
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
        // Lengths of "Vertex 0: X:0 Y:0 Z:0" and "Face 0: A:0 B:0 C:0" without blanks, with a
        // newline.
        constexpr std::size_t shortest_vertex = 19;
        constexpr std::size_t shortest_face = 17;
        if (!text_.plausible(vertices_, "vertices", shortest_vertex) ||
            !text_.plausible(faces_, "faces", shortest_face))
            return false;
        base_ = mesh_.vertices.size();
        first_face_ = mesh_.faces();
        if (std::exchange(has_new_name_, false)) // a long name is stored once, not per line
            mesh_.parts.push_back({object_, static_cast<std::uint32_t>(first_face_)});
        return true;
    }

    /// Whether the last object has as many vertices and faces as its header promised.
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

    /// Takes the index of a vertex or a face, and the colon after it. Indices must come in order.
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

    /// Reads the smoothing groups of the last face, from 1 to 32: "1, 2".
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
    std::vector<l3d_model_camera>& cameras_;
    std::vector<text_cursor::reading_place> camera_lines_;
    bool is_camera_ = false; ///< whether the current object is the last of cameras_
    l3d_detail::face_materials materials_;
    std::string object_; ///< the name of the current object
    /// Whether no mesh or camera has taken object_ as its name yet.
    bool has_new_name_ = false;
    std::int64_t vertices_ = 0, faces_ = 0; ///< counts that the current mesh promised
    /// Indices of the current mesh's first vertex and first face.
    std::size_t base_ = 0, first_face_ = 0;
    l3d_detail::corner_normals normals_;
    l3d_detail::odd_coordinates odd_;
};

} // namespace

std::optional<l3d_model_file> l3d_read_asc(std::string_view text, std::string_view name,
                                           std::string& why) {
    const auto read = [](text_cursor& cursor, l3d_model_file& model) {
        return asc_reader(cursor, model).read();
    };
    return l3d_detail::read_model_by(read, text, name, why);
}
