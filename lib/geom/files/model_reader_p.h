// SPDX-License-Identifier: MIT
// The code that readers of polygons share: materials by name, colours, normals and results.
#ifndef L3D_GEOM_FILES_MODEL_READER_P_H
#define L3D_GEOM_FILES_MODEL_READER_P_H

#include "geom/files/model_file.h"
#include "geom/files/text_cursor_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace l3d_detail {

/// The most vertices of a mesh, whose indices have 32 bits. A text that announces more vertices is
/// refused.
inline constexpr std::int64_t most_vertices = std::numeric_limits<std::uint32_t>::max();

/// Gives materials to faces, by name. Lives: borrows the mesh and the names' text.
class face_materials {
public:
    explicit face_materials(l3d_polygon_mesh& mesh) : mesh_(mesh) {}

    /// The index of the material `name`. The first use of a name makes the material.
    std::uint32_t named(std::string_view name) {
        const auto next = static_cast<std::uint32_t>(mesh_.materials.size());
        const auto [place, is_new] = indices_.try_emplace(std::string(name), next);
        if (is_new)
            mesh_.materials.emplace_back(name);
        return place->second;
    }

    /// Gives the last face a material. Expects: there is a face.
    void give_to_last_face(std::uint32_t material) {
        mesh_.face_materials.resize(mesh_.faces() - 1, nothing);
        mesh_.face_materials.push_back(material);
    }

    /// Stands for a missing material until the whole text is read.
    static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

    /// Completes the materials of faces, patches and curves, once the whole text is read. If only
    /// some faces have a material, the others get one without a name; likewise for patches and for
    /// curves. If nothing has a material, the mesh keeps no names of materials.
    void finish(std::vector<std::uint32_t>& patches, std::vector<std::uint32_t>& curves) {
        for (std::vector<std::uint32_t>* const of : {&patches, &curves})
            if (std::ranges::all_of(*of, [](std::uint32_t m) { return m == nothing; }))
                of->clear();
        if (!mesh_.face_materials.empty())
            mesh_.face_materials.resize(mesh_.faces(), nothing);
        else if (patches.empty() && curves.empty())
            mesh_.materials.clear();
        for (std::vector<std::uint32_t>* const of : {&mesh_.face_materials, &patches, &curves})
            for (std::uint32_t& material : *of)
                if (material == nothing)
                    material = named("");
    }

private:
    l3d_polygon_mesh& mesh_;
    std::unordered_map<std::string, std::uint32_t> indices_;
};

/// Collects the colours of vertices. If all corners of each face have the same colour, the mesh
/// gets colours of faces instead, which are drawn faster.
class vertex_colors {
public:
    /// Gives the last vertex a colour. Expects: there is a vertex.
    void give(const l3d_polygon_mesh& mesh, const double* color) {
        give(mesh.vertices.size() - 1, color);
    }

    /// Gives a vertex a colour; vertices without a colour are white.
    /// Units:   components from 0 to 1 or, if any component in the file is 2 or more, from 0 to
    ///          255. Values outside are clamped; NaN counts as the largest.
    /// Expects: vertices come in their order.
    void give(std::size_t vertex, const double* color) {
        colors_.resize(vertex, white);
        auto& given = colors_.emplace_back();
        for (std::size_t i = 0; i < given.size(); ++i) {
            given[i] = std::isnan(color[i]) ? white[i]
                                            : static_cast<float>(std::clamp(color[i], 0.0, 255.0));
            largest_ = std::max(largest_, std::isnan(color[i]) ? 0 : given[i]);
        }
    }

    /// Gives the mesh its colours, once the whole text is read. Expects: faces have no colours.
    void finish(l3d_polygon_mesh& mesh) {
        if (colors_.empty())
            return;
        colors_.resize(mesh.vertices.size(), white);
        const float most = largest_ < 2 ? 1 : 255;
        for (auto& color : colors_)
            for (float& component : color)
                component = std::min(component / most, 1.0F);
        std::vector<std::uint32_t> words;
        words.reserve(colors_.size());
        for (const auto& color : colors_) {
            std::uint32_t& word = words.emplace_back(0);
            for (const float component : color)
                word = 256 * word + static_cast<std::uint32_t>(std::lround(255 * component));
        }
        for (std::size_t f = 0; f < mesh.faces(); ++f) {
            const std::uint32_t first = words[mesh.face(f)[0]];
            if (!std::ranges::all_of(mesh.face(f),
                                     [&](std::uint32_t v) { return words[v] == first; })) {
                mesh.face_colors.clear();
                mesh.vertex_colors = std::move(words);
                return;
            }
            mesh.face_colors.push_back(first);
        }
    }

private:
    /// The colour white, for vertices without a colour. Its components are above 255, so that they
    /// are clamped to 1 whether components end at 1 or at 255.
    static constexpr std::array<float, 3> white{256, 256, 256};

    std::vector<std::array<float, 3>> colors_;
    float largest_ = 0;
};

/// A face's colour as 0x00RRGGBB. Components beyond 0 to 1 are clamped, with a note.
inline std::uint32_t color_of(text_cursor& text, const double* components) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool is_in = components[i] >= 0 && components[i] <= 1;
        if (!is_in)
            text.note_once("colours out of range are taken for the nearest");
        const double held = std::isnan(components[i]) ? 1 : std::clamp(components[i], 0.0, 1.0);
        word = 256 * word + static_cast<std::uint32_t>(std::lround(255 * held));
    }
    return word;
}

/// Appends a colour, 0x00RRGGBB, as three fractions of 1, to a line that has just ended.
inline void append_color(std::string& text, std::uint32_t word) {
    text.back() = ' '; // takes back the line's end
    append(text, (word >> 16 & 255) / 255.0, ' ');
    append(text, (word >> 8 & 255) / 255.0, ' ');
    append(text, (word & 255) / 255.0, '\n');
}

/// The note on vertices without a finite place.
inline constexpr const char* odd_places_note =
    "vertices that no face uses are not finite, or beyond 1e12: they are skipped";

/// Collects coordinates of vertices that are not finite, or beyond 1e12. Some programs write
/// vertices with such coordinates, but no face uses these vertices. The vertices are moved to the
/// origin.
class odd_coordinates {
public:
    /// Checks a coordinate of the next vertex. The current token, or `digits` in it, is the
    /// coordinate's text. A coordinate that is not allowed is collected, and set to 0.
    void check(const text_cursor& text, const l3d_polygon_mesh& mesh, double& value,
               std::string_view digits = {}) {
        if (std::abs(value) <= l3d_bpt_largest_coordinate)
            return;
        found_.push_back({mesh.vertices.size(), value, digits, text.here()});
        value = 0;
    }

    /// Whether all vertices with collected coordinates are unused: no corner uses them, and
    /// is_used(index) is false for them.
    /// Errors: as text_cursor::is_coordinate, for the first coordinate in the text that is
    ///         collected and used.
    template <class Used>
    bool are_unused(text_cursor& text, l3d_polygon_mesh& mesh, const Used& is_used) {
        if (found_.empty())
            return true;
        std::vector<bool> is_corner(mesh.vertices.size());
        for (const std::uint32_t corner : mesh.corners)
            is_corner[corner] = true;
        for (const found& odd : found_) {
            if (is_corner[odd.vertex] || is_used(odd.vertex)) {
                text.go_back(odd.at);
                return text.is_coordinate(odd.value, odd.digits);
            }
            mesh.vertices[odd.vertex] = l3d_polygon_mesh::vector(0);
        }
        text.go_back(found_.front().at);
        text.note(odd_places_note);
        return true;
    }
    bool are_unused(text_cursor& text, l3d_polygon_mesh& mesh) {
        return are_unused(text, mesh, [](std::size_t) { return false; });
    }

private:
    struct found {
        std::size_t vertex;
        double value;
        std::string_view digits;
        text_cursor::reading_place at;
    };
    std::vector<found> found_;
};

/// Reads the three coordinates of the next vertex.
inline bool read_vertex(text_cursor& text, l3d_polygon_mesh& mesh, odd_coordinates& odd) {
    std::array<double, 3> v{};
    for (double& value : v) {
        if (!text.any_number(value, "a coordinate"))
            return false;
        odd.check(text, mesh, value);
    }
    mesh.vertices.emplace_back(v[0], v[1], v[2]);
    return true;
}

/// Whether a vector has a direction: not zero, nor infinite, nor NaN.
inline bool has_direction(const l3d_polygon_mesh::vector& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]) &&
           (v[0] != 0 || v[1] != 0 || v[2] != 0);
}

inline constexpr const char* odd_normals_note =
    "normals that are zero or no numbers are computed from the faces";

/// Sets normals without a direction to zero. If the normals of all corners are zero, the mesh loses
/// its normals.
inline void forget_odd_normals(l3d_polygon_mesh& mesh) {
    const l3d_polygon_mesh::vector zero(0);
    if (mesh.vertex_normals.empty())
        return;
    for (l3d_polygon_mesh::vector& normal : mesh.vertex_normals)
        if (!has_direction(normal))
            normal = zero;
    const auto is_zero = [&](std::uint32_t corner) { return mesh.vertex_normals[corner] == zero; };
    if (!mesh.corners.empty() && std::ranges::all_of(mesh.corners, is_zero))
        mesh.vertex_normals.clear();
}

/// Reads a model by read(cursor, model), which returns whether it succeeded. The readers of all
/// formats end with a call of this function. If `comment` is given, this character begins a
/// comment, which is skipped to the end of the line.
/// Errors: nothing, and the cursor's reason in `why`.
template <class Read>
std::optional<l3d_model_file> read_model_by(Read read, std::string_view text, std::string_view name,
                                            std::string& why, char comment = '\0') {
    text_cursor cursor(text, name, comment);
    l3d_model_file model;
    const auto reads = [&] {
        try {
            return read(cursor, model);
        } catch (const std::length_error& too_long) {
            return cursor.fail(too_long.what());
        }
    };
    if (!reads()) {
        why = cursor.why();
        return std::nullopt;
    }
    model.notes = cursor.take_notes();
    return model;
}

} // namespace l3d_detail

#endif
