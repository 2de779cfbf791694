// SPDX-License-Identifier: MIT
// The code that readers of polygons share: materials by name, and the way a reader returns.
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

/// A mesh holds indices of 32 bits; a text that could name more is refused.
inline constexpr std::int64_t most_vertices = std::numeric_limits<std::uint32_t>::max();

/// Gives materials to faces, by name. Lives: borrows the mesh and the names' text.
class face_materials {
public:
    explicit face_materials(l3d_polygon_mesh& mesh) : mesh_(mesh) {}

    /// The index of a material, made when it is named for the first time.
    std::uint32_t named(std::string_view name) {
        const auto next = static_cast<std::uint32_t>(mesh_.materials.size());
        const auto [place, is_new] = indices_.try_emplace(std::string(name), next);
        if (is_new)
            mesh_.materials.emplace_back(name);
        return place->second;
    }

    /// Expects: there is a face.
    void give_to_last_face(std::uint32_t material) {
        mesh_.face_materials.resize(mesh_.faces() - 1, nothing);
        mesh_.face_materials.push_back(material);
    }

    /// What stands for the material of a thing that has none, until all is read.
    static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

    /// If some faces have a material, the others get one without a name, and so do patches; if none
    /// of either has, there are no materials.
    void finish(std::vector<std::uint32_t>& patches) {
        if (std::ranges::all_of(patches, [](std::uint32_t m) { return m == nothing; }))
            patches.clear();
        if (!mesh_.face_materials.empty())
            mesh_.face_materials.resize(mesh_.faces(), nothing);
        else if (patches.empty())
            mesh_.materials.clear();
        for (std::vector<std::uint32_t>* const of : {&mesh_.face_materials, &patches})
            for (std::uint32_t& material : *of)
                if (material == nothing)
                    material = named("");
    }

private:
    l3d_polygon_mesh& mesh_;
    std::unordered_map<std::string, std::uint32_t> indices_;
};

/// Colours of vertices, which become those of faces: the means of their corners.
class vertex_colors {
public:
    /// Gives the last vertex a colour. Expects: there is a vertex.
    void give(const l3d_polygon_mesh& mesh, const double* color) {
        give(mesh.vertices.size() - 1, color);
    }

    /// Gives a vertex a colour; those without one are white. Units: components from 0 to 1, held
    /// there; NaN is 1. Expects: vertices come in their order.
    void give(std::size_t vertex, const double* color) {
        colors_.resize(vertex, {1, 1, 1});
        auto& given = colors_.emplace_back();
        for (std::size_t i = 0; i < given.size(); ++i)
            given[i] =
                std::isnan(color[i]) ? 1 : static_cast<float>(std::clamp(color[i], 0.0, 1.0));
    }

    /// Expects: a mesh whose faces have no colours.
    void finish(l3d_polygon_mesh& mesh) {
        if (colors_.empty())
            return;
        colors_.resize(mesh.vertices.size(), {1, 1, 1});
        mesh.face_colors.reserve(mesh.faces());
        for (std::size_t f = 0; f < mesh.faces(); ++f) {
            std::array<double, 3> sum{};
            const auto face = mesh.face(f);
            for (const std::uint32_t corner : face)
                for (std::size_t i = 0; i < sum.size(); ++i)
                    sum[i] += double{colors_[corner][i]};
            std::uint32_t word = 0;
            for (const double component : sum)
                word = 256 * word + static_cast<std::uint32_t>(std::lround(
                                        255 * component / static_cast<double>(face.size())));
            mesh.face_colors.push_back(word);
        }
    }

private:
    std::vector<std::array<float, 3>> colors_;
};

/// What is said of such colours.
inline constexpr const char* vertex_colors_note =
    "the colours of vertices become those of faces, as means";

inline bool read_vertex(text_cursor& text, l3d_polygon_mesh& mesh) {
    std::array<double, 3> v{};
    for (double& value : v)
        if (!text.coordinate(value))
            return false;
    mesh.vertices.emplace_back(v[0], v[1], v[2]);
    return true;
}

/// The value of every reader of a format: read(cursor, model) says whether all went well. The text
/// from `comment`, if any, to the line's end is skipped.
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
