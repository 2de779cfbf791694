// SPDX-License-Identifier: MIT
// Reads Wavefront's .obj: polygons here, free-form surfaces and curves in obj_surfaces.
#include "base/counted_p.h"
#include "geom/files/corner_normals_p.h"
#include "geom/files/model_reader_p.h"
#include "geom/files/obj_surfaces_p.h"
#include "geom/files/obj_tags_p.h"
#include "geom/files/model_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace {

using l3d_detail::counted;
using l3d_detail::quoted;
using l3d_detail::text_cursor;

/// Statements that are skipped without a note, since their loss cannot be seen.
constexpr std::string_view silent_statements[] = {"mg",    "lod",      "bevel",   "ctech",
                                                  "stech", "c_interp", "d_interp"};

class obj_reader {
public:
    obj_reader(text_cursor& text, l3d_model_file& model,
               std::vector<l3d_nurbs_surface>* surfaces = nullptr)
        : text_(text), model_(model), materials_(model.mesh),
          surfaces_(text, model.patches, model.curves, model.edges, surfaces) {}

    bool read() {
        text_.join_lines_at_backslash();
        while (text_.next())
            if (!read_statement(text_.token()))
                return false;
        const auto is_control_point = [this](std::size_t vertex) {
            return vertex < surfaces_.control_points().size() && surfaces_.control_points()[vertex];
        };
        if (!surfaces_.finish())
            return false;
        vertex_colors_.finish(mesh()); // while vertices have the file's indices
        if (!mesh().picture_places.empty())
            mesh().picture_places.resize(mesh().corners.size());
        finish_normals();
        if (!odd_.are_unused(text_, mesh(), is_control_point))
            return false;
        forget_control_points();
        materials_.finish(model_.patch_materials, model_.curve_materials);
        return true;
    }

private:
    l3d_polygon_mesh& mesh() { return model_.mesh; }

    bool read_statement(std::string_view word) {
        if (word == "v")
            return read_vertex() && skip_rest("a vertex");
        if (word == "vn")
            return read_normal() && skip_rest("a normal");
        if (word == "vt")
            return read_picture_place() && skip_rest("a place in a picture");
        if (word == "f" || word == "fo")
            return read_face();
        if (word == "g" || word == "o") {
            part_ = text_.name_in_line();
            is_new_to_faces_ = is_new_to_patches_ = true;
            return true;
        }
        if (word == "usemtl") {
            material_ = materials_.named(text_.name_in_line());
            return true;
        }
        if (word == "mtllib") {
            const std::string name(text_.name_in_line());
            if (name.empty())
                text_.note("mtllib names no file");
            else
                model_.material_files.push_back({name, text_.line()});
            return true;
        }
        if (word == "t")
            return l3d_detail::read_obj_tag(text_, mesh(), model_.tags);
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
            const auto material = material_.value_or(l3d_detail::face_materials::nothing);
            model_.patch_materials.resize(model_.patches.size(), material);
            model_.curve_materials.resize(model_.curves.size(), material);
            return is_read && line_ends();
        }
        skip(word);
        return true;
    }

    /// Begins the part part_ at the first face or patch that belongs to it. A name to which nothing
    /// belongs is forgotten.
    void begin_part(std::vector<l3d_part_run>& parts, bool& is_new, std::size_t first) const {
        if (is_new && !(part_.empty() && first == 0))
            parts.push_back({part_, static_cast<std::uint32_t>(first)});
        is_new = false;
    }

    void skip(std::string_view word) {
        // One note for each kind: there may be a statement for each vertex.
        if (std::ranges::find(silent_statements, word) == std::end(silent_statements))
            text_.note_once("statements " + quoted(word) + " are skipped");
        while (text_.next_in_line())
            ;
    }

    /// Reads a statement `s`. With one word, `s` sets the smoothing group; `off` or 0 is none. With
    /// four numbers, `s` sets the part of the picture that the window fills.
    bool read_group_or_viewport() {
        if (!text_.next_in_line())
            return true;
        const std::string_view first = text_.token();
        if (!text_.next_in_line()) {
            using groups = l3d_detail::corner_normals;
            const auto next = groups::numbered | (group_numbers_.size() + 1);
            group_ = first == "off" || first == "0"
                         ? 0
                         : group_numbers_.try_emplace(first, next).first->second;
            return true;
        }
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

    /// Reads a window's four numbers. Expects: `first` is the first number, and the current token
    /// is the second.
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

    /// Skips the rest of a line, with a note.
    bool skip_rest(const char* what) {
        while (text_.next_in_line())
            text_.note_once("what follows " + std::string(what) + " in its line is skipped");
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

    bool read_vertex() {
        l3d_polygon_mesh::vector v(0);
        for (int i = 0; i < 3; ++i) {
            if (!word("a coordinate") || !text_.any_number_in(text_.token(), v[i], "a coordinate"))
                return false;
            odd_.check(text_, mesh(), v[i]);
        }
        mesh().vertices.push_back(v);
        l3d_polygon_mesh::index_of(mesh().vertices.size());
        // One more number is a weight. Three or four more are a colour, which some programs write,
        // with a weight of 1 before it or a fourth component after it.
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
        } else if (numbers == 2) {
            text_.note_once("two numbers behind a vertex are skipped");
        } else if (numbers > 2) {
            vertex_colors_.give(mesh(), numbers == 4 && more[0] == 1 ? more + 1 : more);
        }
        return true;
    }

    bool read_normal() {
        l3d_polygon_mesh::vector v(0);
        for (int i = 0; i < 3; ++i)
            if (!word("a normal") || !text_.any_number_in(text_.token(), v[i], "a normal"))
                return false;
        normals_.add(v);
        return true;
    }

    /// Reads a place in a picture (vt), which files measure from the picture's bottom left corner.
    /// Missing numbers are 0, and so is the place of a corner that names none.
    bool read_picture_place() {
        double place[2] = {0, 0};
        for (int i = 0; i < 2 && text_.next_in_line(); ++i)
            if (!text_.any_number_in(text_.token(), place[i], "a place in a picture"))
                return false;
        const l3d_polygon_mesh::picture_place is{static_cast<float>(place[0]),
                                                 static_cast<float>(1 - place[1])};
        const bool is_finite = std::isfinite(is[0]) && std::isfinite(is[1]);
        if (!is_finite)
            text_.note_once("places in pictures that are not finite are taken for (0, 0)");
        picture_places_.push_back(is_finite ? is : l3d_polygon_mesh::picture_place{});
        text_.next_in_line(); // a third number is for pictures in three dimensions
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
            mesh().picture_places.resize(std::min(mesh().picture_places.size(), begin));
            return true;
        }
        begin_part(mesh().parts, is_new_to_faces_, mesh().faces());
        mesh().end_face();
        if (group_)
            normals_.give_to_last_face(mesh(), *group_);
        if (material_)
            materials_.give_to_last_face(*material_);
        return true;
    }

    /// Reads a corner: vertex, vertex/texture, vertex//normal or vertex/texture/normal. Nothing may
    /// follow a slash.
    bool read_corner(std::string_view corner) {
        const std::size_t first = std::min(corner.find('/'), corner.size());
        std::uint32_t vertex = 0;
        if (!l3d_detail::obj_index(text_, corner.substr(0, first), mesh().vertices.size(), vertex))
            return false;
        mesh().corners.push_back(vertex);
        const std::size_t second = corner.find('/', std::min(first + 1, corner.size()));
        if (const auto place =
                corner.substr(std::min(first + 1, corner.size()), second - first - 1);
            !place.empty())
            give_picture_place(place);
        if (second == corner.npos || second + 1 == corner.size())
            return true;
        std::uint32_t normal = 0;
        if (!l3d_detail::obj_index(text_, corner.substr(second + 1), normals_.count(), normal))
            return false;
        if (!normals_.give_to_last_corner(mesh(), normal))
            text_.note_once(l3d_detail::odd_normals_note);
        return true;
    }

    /// Gives the last corner the place in its picture whose number `digits` spells. A bad number
    /// stands for (0, 0), so that no model is lost.
    void give_picture_place(std::string_view digits) {
        if (picture_places_.empty())
            return;
        std::int64_t number = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), number);
        const auto count = static_cast<std::int64_t>(picture_places_.size());
        number = number < 0 ? count + number : number - 1;
        if (error != std::errc() || end != digits.data() + digits.size() || number < 0 ||
            number >= count)
            return text_.note_once("places in pictures that there are not are taken for (0, 0)");
        mesh().picture_places.resize(mesh().corners.size() - 1);
        mesh().picture_places.push_back(picture_places_[static_cast<std::size_t>(number)]);
    }

    void finish_normals() {
        if (normals_.count() > 0 && mesh().faces() > 0 && !normals_.any())
            text_.note("normals are skipped: no face names them");
        normals_.finish(mesh());
    }

    /// Drops control points, of which surfaces have copies, unless faces or tags use the vertices.
    void forget_control_points() {
        const std::vector<bool>& control = surfaces_.control_points();
        if (control.empty())
            return;
        std::vector<bool> is_kept(mesh().vertices.size());
        for (std::size_t i = 0; i < is_kept.size(); ++i)
            is_kept[i] = i >= control.size() || !control[i];
        for (const std::uint32_t corner : mesh().corners)
            is_kept[corner] = true;
        for (const auto& crease : model_.tags.creases)
            is_kept[crease.from] = is_kept[crease.to] = true;
        for (const auto& corner : model_.tags.corners)
            is_kept[corner.vertex] = true;
        std::vector<std::uint32_t> place(is_kept.size()); // a kept vertex's new index
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < place.size(); ++i) {
            if (!is_kept[i])
                continue;
            mesh().vertices[count] = mesh().vertices[i];
            if (!mesh().vertex_normals.empty())
                mesh().vertex_normals[count] = mesh().vertex_normals[i];
            if (!mesh().vertex_colors.empty())
                mesh().vertex_colors[count] = mesh().vertex_colors[i];
            place[i] = count++;
        }
        mesh().vertices.resize(count);
        if (!mesh().vertex_normals.empty())
            mesh().vertex_normals.resize(count);
        if (!mesh().vertex_colors.empty())
            mesh().vertex_colors.resize(count);
        for (std::uint32_t& corner : mesh().corners)
            corner = place[corner];
        for (auto& crease : model_.tags.creases) {
            crease.from = place[crease.from];
            crease.to = place[crease.to];
        }
        for (auto& corner : model_.tags.corners)
            corner.vertex = place[corner.vertex];
    }

    text_cursor& text_;
    l3d_model_file& model_;
    l3d_detail::face_materials materials_;
    l3d_detail::obj_surfaces surfaces_;
    l3d_detail::vertex_colors vertex_colors_;
    std::optional<std::uint32_t> material_;
    std::string part_; ///< the name of the part that comes next
    bool is_new_to_faces_ = false, is_new_to_patches_ = false;
    /// The smoothing group of the faces that follow. 0 if these faces are flat, nothing before the
    /// first `s`.
    std::optional<std::uint64_t> group_;
    std::unordered_map<std::string_view, std::uint64_t> group_numbers_;
    std::vector<l3d_polygon_mesh::picture_place> picture_places_; ///< places that corners may name
    /// Weights of vertices; 1 beyond the array's end.
    std::vector<double> weights_;
    l3d_detail::corner_normals normals_;
    l3d_detail::odd_coordinates odd_;
};

} // namespace

std::optional<l3d_model_file> l3d_read_obj(std::string_view text, std::string_view name,
                                           std::string& why) {
    const auto read = [](text_cursor& cursor, l3d_model_file& model) {
        return obj_reader(cursor, model).read();
    };
    return l3d_detail::read_model_by(read, text, name, why, '#');
}

std::optional<std::vector<l3d_nurbs_surface>>
l3d_read_obj_surfaces(std::string_view text, std::string_view name, std::string& why) {
    std::vector<l3d_nurbs_surface> surfaces;
    const auto read = [&surfaces](text_cursor& cursor, l3d_model_file& model) {
        return obj_reader(cursor, model, &surfaces).read();
    };
    if (!l3d_detail::read_model_by(read, text, name, why, '#'))
        return std::nullopt;
    return surfaces;
}
