// SPDX-License-Identifier: MIT
// Reads and writes geomview's .off: polygons with colours, text or binary.
#include "base/counted_p.h"
#include "geom/files/model_reader_p.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace {

using l3d_detail::counted;
using l3d_detail::text_cursor;

/// The kind of a file, by the first word: [ST][C][N][4][n]OFF.
struct off_kind {
    bool texture = false, color = false, normal = false, four = false, dimension = false;
};

std::optional<off_kind> off_kind_of(std::string_view word) {
    off_kind kind;
    const auto takes = [&word](std::string_view prefix) {
        const bool has = word.starts_with(prefix);
        if (has)
            word.remove_prefix(prefix.size());
        return has;
    };
    kind.texture = takes("ST");
    kind.color = takes("C");
    kind.normal = takes("N");
    kind.four = takes("4");
    kind.dimension = takes("n");
    return word == "OFF" ? std::optional(kind) : std::nullopt;
}

class off_reader {
public:
    off_reader(text_cursor& text, l3d_polygon_mesh& mesh) : text_(text), mesh_(mesh) {}

    bool read() {
        if (!read_header() || !read_counts())
            return false;
        mesh_.vertices.reserve(vertices_);
        for (std::size_t i = 0; i < vertices_; ++i) {
            text_.set_place(" of vertex", i, vertices_);
            if (!read_vertex())
                return false;
        }
        mesh_.face_ends.reserve(faces_);
        for (std::size_t i = 0; i < faces_; ++i) {
            text_.set_place(" of face", i, faces_);
            if (!read_face())
                return false;
        }
        text_.forget_place();
        if (!mesh_.face_colors.empty())
            mesh_.face_colors.resize(mesh_.faces(), uncolored);
        else
            vertex_colors_.finish(mesh_);
        l3d_detail::forget_odd_normals(mesh_);
        if (is_binary_ ? !text_.rest().empty() : text_.next())
            text_.note("what follows the last face is skipped");
        return odd_.are_unused(text_, mesh_);
    }

private:
    /// The colour of faces without one. geomview draws these faces in 2/3 grey: round(255 * 2 / 3)
    /// = 170.
    static constexpr std::uint32_t uncolored = 0xaaaaaa;

    bool read_header() {
        if (!text_.next())
            return text_.fail("the text ends where OFF should be");
        const auto kind = off_kind_of(text_.token());
        if (!kind)
            return text_.fail(l3d_detail::quoted(text_.token()) + " is not a kind of OFF");
        if (kind->four || kind->dimension)
            return text_.fail(l3d_detail::quoted(text_.token()) +
                              " has vertices of other than 3 coordinates");
        kind_ = *kind;
        if (kind_.texture)
            text_.note("texture coordinates are skipped");
        return true;
    }

    bool read_counts() {
        is_binary_ = text_.take_in_line("BINARY");
        if (is_binary_ && !text_.next_line())
            return text_.fail("the text ends after BINARY");
        std::int64_t vertices = 0;
        std::int64_t faces = 0;
        std::int64_t edges = 0;
        if (!whole(vertices, "the number of vertices", 0, l3d_detail::most_vertices) ||
            !whole(faces, "the number of faces", 0, l3d_detail::most_vertices) ||
            (counts_edges() &&
             !whole(edges, "the number of edges", std::numeric_limits<std::int32_t>::min(),
                    std::numeric_limits<std::int32_t>::max())))
            return false;
        // A vertex has three numbers of a digit and a blank; a face has at least its number of
        // corners.
        const std::size_t vertex = is_binary_ ? 3 * sizeof(float) : 3 * 2;
        const std::size_t face = is_binary_ ? 2 * sizeof(std::int32_t) : 2;
        vertices_ = static_cast<std::size_t>(vertices);
        faces_ = static_cast<std::size_t>(faces);
        return text_.plausible(vertices, "vertices", vertex) &&
               text_.plausible(faces, "faces", face);
    }

    /// Whether a third count follows, the number of edges. Some programs leave it out. The line
    /// then ends here, and the next line holds the several numbers of the first vertex.
    bool counts_edges() const {
        text_cursor ahead = text_;
        return is_binary_ || ahead.next_in_line() || (ahead.next() && !ahead.next_in_line());
    }

    bool read_vertex() {
        double v[3];
        for (double& value : v) {
            if (!any_real(value, "a coordinate"))
                return false;
            odd_.check(text_, mesh_, value);
        }
        mesh_.vertices.emplace_back(v[0], v[1], v[2]);
        if (kind_.normal) {
            for (double& value : v)
                if (!any_real(value, "a normal"))
                    return false;
            mesh_.vertex_normals.emplace_back(v[0], v[1], v[2]);
            if (!l3d_detail::has_direction(mesh_.vertex_normals.back()))
                text_.note_once(l3d_detail::odd_normals_note);
        }
        return read_looks();
    }

    /// Reads the last vertex's colour and texture coordinates. In a text, a line that ends one
    /// number too early leaves out the fourth component of the colour.
    bool read_looks() {
        const std::size_t numbers = (kind_.color ? 4u : 0u) + (kind_.texture ? 2u : 0u);
        const char* const what = kind_.color ? "a colour" : "a texture coordinate";
        std::array<double, 6> values{};
        std::size_t count = 0;
        for (; !is_binary_ && count < numbers && text_.next_in_line(); ++count)
            if (!text_.any_number_in(text_.token(), values[count], what))
                return false;
        const bool has_fourth = !kind_.color || count + 1 != numbers;
        for (; has_fourth && count < numbers; ++count)
            if (!any_real(values[count], what))
                return false;
        if (kind_.color)
            vertex_colors_.give(mesh_, values.data());
        return true;
    }

    bool read_face() {
        std::int64_t corners = 0;
        if (!whole(corners, "the number of corners", 0, l3d_detail::most_vertices) ||
            !text_.plausible(corners, "corners", is_binary_ ? sizeof(std::int32_t) : 2))
            return false;
        const auto begin = mesh_.corners.size();
        for (std::int64_t i = 0; i < corners; ++i) {
            std::int64_t index = 0;
            if (!whole(index, "a corner", 0, static_cast<std::int64_t>(vertices_) - 1))
                return false;
            mesh_.corners.push_back(static_cast<std::uint32_t>(index));
        }
        if (corners >= 3) {
            mesh_.end_face();
        } else {
            mesh_.corners.resize(begin);
            text_.note("a face of " + counted(static_cast<std::size_t>(corners), "corners") +
                       " is skipped");
        }
        std::size_t numbers = 0;
        std::array<double, 4> color{};
        if (!(is_binary_ ? binary_color(color, numbers) : text_color(color, numbers)))
            return false;
        if (corners >= 3)
            give(color, numbers);
        return true;
    }

    bool binary_color(std::array<double, 4>& color, std::size_t& numbers) {
        std::int64_t count = 0;
        if (!whole(count, "the number of colour components", 0, 4))
            return false;
        numbers = static_cast<std::size_t>(count);
        for (std::size_t i = 0; i < numbers; ++i)
            if (!any_real(color[i], "a colour"))
                return false;
        return true;
    }

    /// Reads a face's colour from the rest of its line: whole numbers up to 255, or fractions if
    /// any has a point or an exponent.
    bool text_color(std::array<double, 4>& color, std::size_t& numbers) {
        bool whole_numbers = true;
        while (text_.next_in_line()) {
            if (numbers == color.size()) {
                text_.note_once("what follows the colour of a face is skipped");
                continue;
            }
            if (!text_.any_number_in(text_.token(), color[numbers++], "a colour"))
                return false;
            whole_numbers =
                whole_numbers && text_.token().find_first_of(".eE") == std::string_view::npos;
        }
        if (whole_numbers && numbers >= 3)
            for (double& component : color)
                component /= 255;
        return true;
    }

    void give(const std::array<double, 4>& color, std::size_t numbers) {
        if (numbers < 3) {
            if (numbers > 0)
                text_.note_once("colours by their place in a map are skipped");
            return;
        }
        mesh_.face_colors.resize(mesh_.faces() - 1, uncolored);
        mesh_.face_colors.push_back(l3d_detail::color_of(text_, color.data()));
    }

    /// Reads a number that may be infinite or NaN.
    bool any_real(double& value, const char* what) {
        return text_.any_number_or_float(value, is_binary_, what);
    }

    bool whole(std::int64_t& value, const char* what, std::int64_t least, std::int64_t most) {
        if (!is_binary_)
            return text_.integer_in(value, what, least, most);
        std::int32_t bits = 0;
        if (!text_.binary(bits, std::endian::big, what))
            return false;
        value = bits;
        return text_.is_in(value, what, least, most);
    }

    text_cursor& text_;
    l3d_polygon_mesh& mesh_;
    l3d_detail::vertex_colors vertex_colors_;
    l3d_detail::odd_coordinates odd_;
    off_kind kind_;
    bool is_binary_ = false;
    std::size_t vertices_ = 0, faces_ = 0;
};

void append_vector(std::string& text, const l3d_polygon_mesh::vector& v, char after) {
    l3d_detail::append(text, v[0], ' ');
    l3d_detail::append(text, v[1], ' ');
    l3d_detail::append(text, v[2], after);
}

} // namespace

std::optional<l3d_model_file> l3d_read_off(std::string_view text, std::string_view name,
                                           std::string& why) {
    const auto read = [](text_cursor& cursor, l3d_model_file& model) {
        return off_reader(cursor, model.mesh).read();
    };
    return l3d_detail::read_model_by(read, text, name, why, '#');
}

std::string l3d_write_off(const l3d_polygon_mesh& mesh) {
    const bool normals = !mesh.vertex_normals.empty();
    // A reader drops the colours of vertices if a face has one.
    const bool colors = !mesh.vertex_colors.empty() && mesh.face_colors.empty();
    std::string text = std::string(colors ? "C" : "") + (normals ? "NOFF\n" : "OFF\n");
    text += std::to_string(mesh.vertices.size()) + ' ' + std::to_string(mesh.faces()) + " 0\n";
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        append_vector(text, mesh.vertices[i], normals ? ' ' : '\n');
        if (normals)
            append_vector(text, mesh.vertex_normals[i], '\n');
        if (colors) {
            l3d_detail::append_color(text, mesh.vertex_colors[i]);
            text.insert(text.size() - 1, " 1"); // opaque
        }
    }
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
        text += std::to_string(mesh.face(i).size());
        for (const std::uint32_t corner : mesh.face(i))
            text += ' ' + std::to_string(corner);
        for (int shift = 16; !mesh.face_colors.empty() && shift >= 0; shift -= 8)
            text += ' ' + std::to_string(mesh.face_colors[i] >> shift & 255);
        text += '\n';
    }
    return text;
}
