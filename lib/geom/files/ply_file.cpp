// SPDX-License-Identifier: MIT
// Reads Stanford's .ply: text, and binary of either byte order.
#include "base/counted_p.h"
#include "geom/files/model_reader_p.h"
#include "geom/files/ply_header_p.h"

#include <cmath>

namespace {

using l3d_detail::counted;
using l3d_detail::quoted;
using l3d_detail::text_cursor;
using l3d_detail::ply::element;
using l3d_detail::ply::is_whole;
using l3d_detail::ply::meaning;
using l3d_detail::ply::number_type;
using l3d_detail::ply::property;
using l3d_detail::ply::row_kind;

class ply_reader {
public:
    ply_reader(text_cursor& text, l3d_polygon_mesh& mesh)
        : text_(text), mesh_(mesh), header_(text) {}

    bool read() {
        if (!header_.read() || !check())
            return false;
        order_ = header_.order();
        for (const element& e : header_.elements())
            if (!read_element(e))
                return false;
        text_.forget_place();
        if (!mesh_.face_colors.empty())
            mesh_.face_colors.resize(mesh_.faces(), uncolored);
        vertex_colors_.finish(mesh_);
        lay_picture();
        l3d_detail::forget_odd_normals(mesh_);
        if (order_ ? !text_.rest().empty() : !text_.at_end())
            text_.note("what follows the last element is skipped");
        return odd_.are_unused(text_, mesh_);
    }

private:
    /// Checks the header as a whole, and notes which data vertices and faces have.
    bool check() {
        for (const element& e : header_.elements()) {
            if (e.properties.empty() && e.count > 0)
                return text_.fail("the element " + quoted(e.name) + " has no properties");
            if (e.kind == row_kind::other)
                text_.note("the element " + quoted(e.name) + " is skipped");
        }
        const element* const vertex = header_.find(row_kind::vertex);
        const element* const face = header_.find(row_kind::face);
        const element* const strip = header_.find(row_kind::strip);
        if (!vertex)
            return text_.fail("there is no element vertex");
        for (const auto& [axis, name] :
             {std::pair(meaning::x, "x"), std::pair(meaning::y, "y"), std::pair(meaning::z, "z")})
            if (!vertex->has(axis))
                return text_.fail("vertices have no " + std::string(name));
        if (face && !face->has(meaning::corners))
            return text_.fail("faces have no list vertex_indices");
        if (strip && !strip->has(meaning::corners))
            return text_.fail("tristrips have no list vertex_indices");
        vertices_ = vertex->count;
        has_normals_ = vertex->has(meaning::normal_x) && vertex->has(meaning::normal_y) &&
                       vertex->has(meaning::normal_z);
        has_colors_ = face && face->has_color();
        has_vertex_colors_ = !has_colors_ && vertex->has_color();
        const bool has_picture = !header_.picture().empty();
        has_places_ = face && face->has(meaning::places);
        has_vertex_places_ = vertex->has(meaning::place_u) && vertex->has(meaning::place_v);
        if (has_picture != (has_places_ || has_vertex_places_))
            text_.note(has_picture
                           ? "the picture " + quoted(header_.picture()) +
                                 " is skipped: no corner has a place in it"
                           : "places in pictures are skipped: no comment TextureFile names a "
                             "picture");
        has_places_ = has_places_ && has_picture;
        has_vertex_places_ = has_vertex_places_ && has_picture && !has_places_;
        return true;
    }

    // ---- the elements

    bool read_element(const element& e) {
        std::size_t shortest = 0;
        for (const property& p : e.properties)
            shortest += order_ ? l3d_detail::ply::bytes_of(p.count.value_or(p.type))
                               : 2; // a digit and a blank
        text_.forget_place();
        // No blank need follow the last number of a text.
        const std::size_t room = text_.rest().size() + (order_ ? 0 : 1);
        if (e.count > 0 && static_cast<std::uint64_t>(e.count) > room / shortest)
            return text_.fail("the text is too short for " + std::to_string(e.count) +
                              " of the element " + quoted(e.name));
        const auto count = static_cast<std::size_t>(e.count);
        if (e.kind == row_kind::vertex)
            mesh_.vertices.reserve(count);
        if (e.kind == row_kind::vertex && has_normals_)
            mesh_.vertex_normals.reserve(count);
        if (e.kind == row_kind::face)
            mesh_.face_ends.reserve(mesh_.face_ends.size() + count);
        for (std::size_t i = 0; i < count; ++i) {
            text_.set_place(place_of(e.kind), i, count);
            if (!read_properties(e))
                return false;
            add_row(e.kind);
        }
        return true;
    }

    static const char* place_of(row_kind kind) {
        return kind == row_kind::vertex  ? " of vertex"
               : kind == row_kind::face  ? " of face"
               : kind == row_kind::strip ? " of strip"
                                         : " of element";
    }

    void add_row(row_kind kind) {
        switch (kind) {
        case row_kind::vertex:
            return add_vertex();
        case row_kind::face:
            return add_face();
        case row_kind::strip:
            return add_strip();
        case row_kind::other:
            break;
        }
    }

    bool read_properties(const element& e) {
        face_.clear();
        face_places_.clear();
        // In a strip, -1 ends a run of triangles.
        const std::int64_t least = e.kind == row_kind::strip ? -1 : 0;
        for (const property& p : e.properties) {
            double value = 0;
            if (!p.count) {
                if (!number(p, value, "a number"))
                    return false;
                if (p.means >= meaning::x && p.means <= meaning::z)
                    odd_.check(text_, mesh_, value);
                seen_[static_cast<std::size_t>(p.means)] = scaled(p, value);
                continue;
            }
            if (!number({meaning::corners, *p.count, {}}, value, "the length of a list"))
                return false;
            const auto length = static_cast<std::int64_t>(value);
            if (!text_.is_in(length, "the length of a list", 0, l3d_detail::most_vertices))
                return false;
            for (std::int64_t i = 0; i < length; ++i) {
                if (!number(p, value, "a member of a list") ||
                    (p.means == meaning::corners && !add_corner(value, least)))
                    return false;
                if (p.means == meaning::places && has_places_)
                    face_places_.push_back(value);
            }
        }
        return true;
    }

    /// Scales a component of a colour to the range from 0 to 1. Floats stay as they are. Whole
    /// numbers are divided by the largest number of their type, but numbers of four bytes by 255.
    static double scaled(const property& p, double value) {
        if (!is_color(p.means) || !is_whole(p.type))
            return value;
        return value / (p.type == number_type::uint16  ? 65535
                        : p.type == number_type::int16 ? 32767
                        : p.type == number_type::int8  ? 127
                                                       : 255);
    }

    static bool is_color(meaning what) {
        return what == meaning::red || what == meaning::green || what == meaning::blue;
    }

    bool add_corner(double value, std::int64_t least) {
        const auto index = static_cast<std::int64_t>(value);
        if (!text_.is_in(index, "a corner", least, vertices_ - 1))
            return false;
        face_.push_back(static_cast<std::uint32_t>(index));
        return true;
    }

    double seen(meaning what) const { return seen_[static_cast<std::size_t>(what)]; }

    void add_vertex() {
        mesh_.vertices.emplace_back(seen(meaning::x), seen(meaning::y), seen(meaning::z));
        if (has_normals_) {
            mesh_.vertex_normals.emplace_back(seen(meaning::normal_x), seen(meaning::normal_y),
                                              seen(meaning::normal_z));
            if (!l3d_detail::has_direction(mesh_.vertex_normals.back()))
                text_.note_once(l3d_detail::odd_normals_note);
        }
        const double color[] = {seen(meaning::red), seen(meaning::green), seen(meaning::blue)};
        if (has_vertex_colors_)
            vertex_colors_.give(mesh_, color);
        if (has_vertex_places_)
            vertex_places_.push_back(place(seen(meaning::place_u), seen(meaning::place_v)));
    }

    /// A place in the picture, from a file's place (u, v), which is measured from the bottom left
    /// corner.
    l3d_polygon_mesh::picture_place place(double u, double v) {
        const l3d_polygon_mesh::picture_place is{static_cast<float>(u), static_cast<float>(1 - v)};
        if (std::isfinite(is[0]) && std::isfinite(is[1]))
            return is;
        text_.note_once("places in pictures that are not finite are taken for (0, 0)");
        return {};
    }

    /// Gives the last face its places in the picture. Corners of earlier faces without places get
    /// (0, 0).
    void add_places() {
        mesh_.picture_places.resize(mesh_.corners.size() - face_.size());
        if (face_places_.size() == 2 * face_.size())
            for (std::size_t i = 0; i < face_places_.size(); i += 2)
                mesh_.picture_places.push_back(place(face_places_[i], face_places_[i + 1]));
        else
            text_.note_once("lists texcoord without two numbers for each corner are skipped");
    }

    /// Lays the picture on all faces.
    void lay_picture() {
        if (!(has_places_ || has_vertex_places_) || mesh_.faces() == 0)
            return;
        mesh_.picture_places.resize(has_places_ ? mesh_.corners.size() : 0);
        if (has_vertex_places_)
            for (const std::uint32_t corner : mesh_.corners)
                mesh_.picture_places.push_back(vertex_places_[corner]);
        mesh_.materials = {"picture"};
        mesh_.face_materials.assign(mesh_.faces(), 0);
        mesh_.looks = {{.picture = 0}};
        mesh_.pictures = {{std::string(header_.picture())}};
    }

    void add_face() {
        if (face_.size() < 3)
            return text_.note("a face of " + counted(face_.size(), "corners") + " is skipped");
        mesh_.add_face(face_);
        if (has_places_)
            add_places();
        if (!has_colors_)
            return;
        const double color[] = {seen(meaning::red), seen(meaning::green), seen(meaning::blue)};
        mesh_.face_colors.resize(mesh_.faces() - 1, uncolored);
        mesh_.face_colors.push_back(l3d_detail::color_of(text_, color));
    }

    /// Adds the triangles of a strip: each corner makes a triangle with the two corners before it.
    /// The first two corners of every second triangle are swapped, so that all triangles are
    /// counterclockwise from the same side. Degenerate triangles, which join strips, are left out.
    void add_strip() {
        std::size_t run = 0; // where the current strip begins
        for (std::size_t i = 0; i < face_.size(); ++i) {
            if (face_[i] == ends_strip) {
                run = i + 1;
                continue;
            }
            if (i < run + 2)
                continue;
            const bool swaps = (i - run) % 2 != 0;
            const std::array<std::uint32_t, 3> corners{face_[swaps ? i - 1 : i - 2],
                                                       face_[swaps ? i - 2 : i - 1], face_[i]};
            if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
                mesh_.add_face(corners);
        }
    }

    // ---- numbers

    /// Reads the number of a property. Whole numbers are exact in a double; floats may be infinite
    /// or NaN.
    bool number(const property& p, double& value, const char* what) {
        if (order_)
            return bits_of(p.type, value, what);
        return is_whole(p.type) ? text_number(value, what) : text_.any_number(value, what);
    }

    bool bits_of(number_type type, double& value, const char* what) {
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

    bool text_number(double& value, const char* what) {
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
        return true;
    }

    text_cursor& text_;
    l3d_polygon_mesh& mesh_;
    /// The grey of faces without a colour, such as those of strips. It is the same grey as for .off
    /// files.
    static constexpr std::uint32_t uncolored = 0xaaaaaa;
    /// The index -1, which ends a strip.
    static constexpr std::uint32_t ends_strip = std::numeric_limits<std::uint32_t>::max();

    l3d_detail::ply::header header_;
    std::optional<std::endian> order_; ///< a binary file's byte order
    std::int64_t vertices_ = 0;
    bool has_normals_ = false, has_colors_ = false, has_vertex_colors_ = false;
    /// Whether corners have places in the picture, and whether vertices have.
    bool has_places_ = false, has_vertex_places_ = false;
    l3d_detail::vertex_colors vertex_colors_;
    l3d_detail::odd_coordinates odd_;
    std::array<double, static_cast<std::size_t>(meaning::corners) + 1> seen_{};
    std::vector<std::uint32_t> face_;
    std::vector<double> face_places_; ///< places of the current face: u, v per corner
    std::vector<l3d_polygon_mesh::picture_place> vertex_places_;
};

} // namespace

std::optional<l3d_model_file> l3d_read_ply(std::string_view text, std::string_view name,
                                           std::string& why) {
    const auto read = [](text_cursor& cursor, l3d_model_file& model) {
        return ply_reader(cursor, model.mesh).read();
    };
    return l3d_detail::read_model_by(read, text, name, why);
}
