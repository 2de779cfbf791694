// SPDX-License-Identifier: MIT
// The code that readers of polygons share: materials by name, and the way a reader returns.
#ifndef L3D_GEOM_FILES_MODEL_READER_P_H
#define L3D_GEOM_FILES_MODEL_READER_P_H

#include "geom/files/model_file.h"
#include "geom/files/text_cursor_p.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

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

    /// If some faces have a material, the others get one without a name; if none has, there are no
    /// materials.
    void finish() {
        if (mesh_.face_materials.empty()) {
            mesh_.materials.clear();
            return;
        }
        mesh_.face_materials.resize(mesh_.faces(), nothing);
        for (std::uint32_t& material : mesh_.face_materials)
            if (material == nothing)
                material = named("");
    }

private:
    static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();
    l3d_polygon_mesh& mesh_;
    std::unordered_map<std::string, std::uint32_t> indices_;
};

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
