// SPDX-License-Identifier: MIT
// Reader of Wavefront's .obj: polygons here, free-form surfaces in obj_surfaces.
#include "base/counted_p.h"
#include "geom/files/model_reader_p.h"
#include "geom/files/obj_surfaces_p.h"

#include <algorithm>

namespace {

using l3d_detail::counted;
using l3d_detail::quoted;
using l3d_detail::text_cursor;

/// Statements that say nothing that is read here.
constexpr std::string_view skipped_statements[] = {
    "vt",       "vp",       "l",    "p",          "mg",        "usemap", "maplib", "bevel",
    "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech",  "stech",  "curv",
    "curv2",    "con",      "call", "csh",        "cdc",       "cdp",    "res",    "bsp",
    "bzp",      "bmat",     "step", "scrv",       "sp",        "trim",   "hole"};

/// Those among them whose loss nobody would see.
constexpr std::string_view silent_statements[] = {"mg",    "lod",      "bevel",   "ctech",
                                                  "stech", "c_interp", "d_interp"};

class obj_reader {
public:
    obj_reader(text_cursor& text, l3d_model_file& model)
        : text_(text), model_(model), materials_(model.mesh), surfaces_(text, model.patches) {}

    bool read() {
        text_.join_lines_at_backslash();
        while (text_.next())
            if (!read_statement(text_.token()))
                return false;
        if (!surfaces_.finish())
            return false;
        finish_vertices();
        materials_.finish(model_.patch_materials);
        vertex_colors_.finish(mesh());
        return true;
    }

private:
    l3d_polygon_mesh& mesh() { return model_.mesh; }

    bool read_statement(std::string_view word) {
        if (word == "v")
            return read_vertex() && line_ends();
        if (word == "vn")
            return read_normal() && line_ends();
        if (word == "f" || word == "fo")
            return read_face();
        if (word == "g" || word == "o") {
            part_ = rest_of_line();
            is_new_to_faces_ = is_new_to_patches_ = true;
            return true;
        }
        if (word == "usemtl") {
            material_ = materials_.named(rest_of_line());
            return true;
        }
        if (word == "mtllib") {
            const std::size_t line = text_.line();
            std::string name = rest_of_line();
            if (name.empty())
                text_.note("mtllib names no file");
            else
                model_.material_files.push_back({std::move(name), line});
            return true;
        }
        if (word == "w")
            return this->word("a border of the window") &&
                   read_window(text_.token(), model_.window, "a border of the window");
        if (word == "s")
            return read_group_or_viewport();
        if (l3d_detail::obj_surfaces::knows(word)) {
            const std::size_t before = model_.patches.size();
            const bool is_read = surfaces_.read_statement(word, mesh().vertices, weights_);
            if (model_.patches.size() > before)
                begin_part(model_.patch_parts, is_new_to_patches_, before);
            model_.patch_materials.resize(model_.patches.size(),
                                          material_.value_or(l3d_detail::face_materials::nothing));
            return is_read && line_ends();
        }
        if (std::ranges::find(skipped_statements, word) == std::end(skipped_statements))
            return text_.fail(quoted(word) + " begins no statement of an .obj file");
        skip(word);
        return true;
    }

    /// A part begins with the first thing that belongs to it. Those without any are forgotten.
    void begin_part(std::vector<l3d_part_run>& parts, bool& is_new, std::size_t first) const {
        if (is_new && !(part_.empty() && first == 0))
            parts.push_back({part_, static_cast<std::uint32_t>(first)});
        is_new = false;
    }

    void skip(std::string_view word) {
        const auto has = [word](const auto& list) {
            return std::ranges::find(list, word) != std::end(list);
        };
        // Once for each kind: there may be one for each vertex.
        if (!has(silent_statements) && !has(noted_)) {
            noted_.push_back(word);
            text_.note("statements " + quoted(word) + " are skipped");
        }
        while (text_.next_in_line())
            ;
    }

    /// `s` and one word is a smoothing group, which says nothing here; with four numbers it is the
    /// part of the picture that the window fills.
    bool read_group_or_viewport() {
        if (!text_.next_in_line())
            return true;
        const std::string_view first = text_.token();
        if (!text_.next_in_line())
            return true;
        constexpr const char* what = "a border of the viewport";
        if (!read_window_from(first, model_.viewport, what))
            return false;
        const l3d_model_window& v = *model_.viewport;
        return (v.x0 >= 0 && v.y0 >= 0 && v.x1 <= 1 && v.y1 <= 1) ||
               text_.fail("the viewport leaves the picture, which is from 0 to 1");
    }

    bool read_window(std::string_view first, std::optional<l3d_model_window>& window,
                     const char* what) {
        return word(what) && read_window_from(first, window, what);
    }

    /// Expects: the first number was taken before the current token, which is the second.
    bool read_window_from(std::string_view first, std::optional<l3d_model_window>& window,
                          const char* what) {
        l3d_model_window w;
        const auto number = [&](std::string_view digits, double& value) {
            return text_.number_in(digits, value, what) && text_.is_coordinate(value);
        };
        if (!number(first, w.x0) || !number(text_.token(), w.y0) || !word(what) ||
            !number(text_.token(), w.x1) || !word(what) || !number(text_.token(), w.y1) ||
            !line_ends())
            return false;
        if (!(w.x0 < w.x1 && w.y0 < w.y1))
            return text_.fail(std::string(what) + " is not beyond the one opposite: "
                                                  "they are xmin ymin xmax ymax");
        window = w;
        return true;
    }

    bool line_ends() {
        return !text_.next_in_line() ||
               text_.fail(quoted(text_.token()) + " at the end of a statement");
    }

    bool word(const char* what) {
        return text_.next_in_line() ||
               text_.fail("the line ends where " + std::string(what) + " should be");
    }

    /// A name: the words left in the line, one blank between; a backslash at its end would join it
    /// to the next line when it is written.
    std::string rest_of_line() {
        std::string name;
        while (text_.next_in_line())
            name.append(name.empty() ? "" : " ").append(text_.token());
        while (!name.empty() && (name.back() == '\\' || name.back() == ' '))
            name.pop_back();
        return name;
    }

    bool read_vertex() {
        l3d_polygon_mesh::vector v(0);
        for (int i = 0; i < 3; ++i)
            if (!word("a coordinate") || !text_.number_in(text_.token(), v[i], "a coordinate") ||
                !text_.is_coordinate(v[i]))
                return false;
        mesh().vertices.push_back(v);
        l3d_polygon_mesh::index_of(mesh().vertices.size());
        // One number more is a weight. Three or four more are a colour, which some programs write,
        // with a weight before it or a fourth component behind it.
        double more[4];
        std::size_t numbers = 0;
        while (numbers < 4 && text_.next_in_line())
            if (!text_.any_number_in(text_.token(), more[numbers++], "a weight or colour"))
                return false;
        if (numbers == 1) {
            if (!text_.is_finite(more[0], "a weight"))
                return false;
            if (more[0] != 1) {
                weights_.resize(mesh().vertices.size() - 1, 1);
                weights_.push_back(more[0]);
            }
        } else if (numbers > 1) {
            if (!has_vertex_colors_)
                text_.note(l3d_detail::vertex_colors_note);
            has_vertex_colors_ = true;
            if (numbers >= 3)
                vertex_colors_.give(mesh(), numbers == 4 && more[0] == 1 ? more + 1 : more);
        }
        return true;
    }

    bool read_normal() {
        l3d_polygon_mesh::vector v(0);
        for (int i = 0; i < 3; ++i)
            if (!word("a normal") || !text_.number_in(text_.token(), v[i], "a normal"))
                return false;
        normals_.push_back(v);
        return true;
    }

    bool read_face() {
        const std::size_t begin = mesh().corners.size();
        while (text_.next_in_line())
            if (!read_corner(text_.token()))
                return false;
        if (const std::size_t corners = mesh().corners.size() - begin; corners < 3) {
            text_.note("a face of " + counted(corners, "corners") + " is skipped");
            mesh().corners.resize(begin);
            return true;
        }
        begin_part(mesh().parts, is_new_to_faces_, mesh().faces());
        mesh().end_face();
        if (material_)
            materials_.give_to_last_face(*material_);
        return true;
    }

    /// A corner: vertex, vertex/texture, vertex//normal or vertex/texture/normal. A slash may have
    /// nothing behind it.
    bool read_corner(std::string_view corner) {
        const std::size_t first = std::min(corner.find('/'), corner.size());
        std::uint32_t vertex = 0;
        if (!l3d_detail::obj_index(text_, corner.substr(0, first), mesh().vertices.size(), vertex))
            return false;
        mesh().corners.push_back(vertex);
        const std::size_t second = corner.find('/', std::min(first + 1, corner.size()));
        if (second == corner.npos || second + 1 == corner.size()) {
            some_have_no_normal_ = true;
            return true;
        }
        std::uint32_t normal = 0;
        if (!l3d_detail::obj_index(text_, corner.substr(second + 1), normals_.size(), normal))
            return false;
        normal_of_.resize(mesh().vertices.size(), unknown);
        some_have_two_normals_ = some_have_two_normals_ ||
                                 (normal_of_[vertex] != unknown && normal_of_[vertex] != normal);
        normal_of_[vertex] = normal;
        return true;
    }

    /// Whether a vertex is more than a control point of surfaces, which have copies of theirs.
    bool is_of_mesh(std::size_t vertex) const {
        const std::vector<bool>& control = surfaces_.control_points();
        return vertex >= control.size() || !control[vertex] || is_corner_[vertex];
    }

    /// Removes control points, and gives the other vertices their normals if all have one.
    void finish_vertices() {
        is_corner_.resize(mesh().vertices.size());
        for (const std::uint32_t corner : mesh().corners)
            is_corner_[corner] = true;
        normal_of_.resize(mesh().vertices.size(), unknown);
        bool normals = !normals_.empty() && !some_have_no_normal_ && !some_have_two_normals_;
        std::vector<std::uint32_t> place(mesh().vertices.size()); // where a vertex goes
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < place.size(); ++i) {
            if (!is_of_mesh(i))
                continue;
            // A vertex of no face gets the normal of its own number.
            if (normal_of_[i] == unknown && i < normals_.size())
                normal_of_[i] = static_cast<std::uint32_t>(i);
            normals = normals && normal_of_[i] != unknown;
            normal_of_[count] = normal_of_[i];
            mesh().vertices[count] = mesh().vertices[i];
            place[i] = count++;
        }
        mesh().vertices.resize(count);
        for (std::uint32_t& corner : mesh().corners)
            corner = place[corner];
        for (std::size_t i = 0; normals && i < count; ++i)
            mesh().vertex_normals.push_back(normals_[normal_of_[i]]);
        if (!normals && !normals_.empty())
            text_.note("normals are skipped: not every vertex has just one");
    }

    static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();

    text_cursor& text_;
    l3d_model_file& model_;
    l3d_detail::face_materials materials_;
    l3d_detail::obj_surfaces surfaces_;
    l3d_detail::vertex_colors vertex_colors_;
    std::optional<std::uint32_t> material_;
    std::string part_; ///< the name that faces and surfaces belong to
    bool is_new_to_faces_ = false, is_new_to_patches_ = false;
    std::vector<std::string_view> noted_; ///< statements that a note has been made of
    std::vector<double> weights_;         ///< per vertex; those left out at the end are 1
    std::vector<l3d_polygon_mesh::vector> normals_;
    std::vector<std::uint32_t> normal_of_; ///< per vertex, index or unknown
    std::vector<bool> is_corner_;          ///< per vertex
    bool has_vertex_colors_ = false;
    bool some_have_no_normal_ = false, some_have_two_normals_ = false;
};

} // namespace

std::optional<l3d_model_file> l3d_read_obj(std::string_view text, std::string_view name,
                                           std::string& why) {
    const auto read = [](text_cursor& cursor, l3d_model_file& model) {
        return obj_reader(cursor, model).read();
    };
    return l3d_detail::read_model_by(read, text, name, why, '#');
}
