// SPDX-License-Identifier: MIT
// Checks that must hold for any text given to any reader of models: for fuzzing, and for the tests.
#ifndef L3D_TESTS_FUZZ_CHECK_MODEL_H
#define L3D_TESTS_FUZZ_CHECK_MODEL_H

#include "base/printable_p.h"
#include "geom/files/model_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using l3d_model_reader = std::optional<l3d_model_file>(std::string_view, std::string_view,
                                                       std::string&);

/// l3d_read_bpt as a reader of models.
inline std::optional<l3d_model_file> read_bpt_model(std::string_view text, std::string_view name,
                                                    std::string& why) {
    auto patches = l3d_read_bpt(text, name, why);
    return patches ? std::optional(l3d_model_file{{}, *std::move(patches), {}}) : std::nullopt;
}

/// l3d_read_gltf without other files.
inline std::optional<l3d_model_file> read_gltf_model(std::string_view text, std::string_view name,
                                                     std::string& why) {
    return l3d_read_gltf(text, name, why);
}

struct named_model_reader {
    const char* name; ///< of the folder of its corpus, too
    l3d_model_reader* read;
    bool has_plain_names = true; ///< names have nothing that an .obj file could not hold
    std::size_t always = 0;      ///< bytes that may be taken, whatever the text's length
    std::size_t per_byte = 80;   ///< bytes that may be taken for each byte of the text
};
inline constexpr std::array<named_model_reader, 10> model_readers{
    {{"asc", l3d_read_asc, false},
     {"bez", l3d_read_bez},
     {"bpt", read_bpt_model},
     {"gltf", read_gltf_model, false, std::size_t{40} << 20}, // 16 MB, and vectors that grow
     {"grid", l3d_read_grid, true, 0, 300}, // 600 bytes for each height, of two characters
     {"obj", l3d_read_obj},
     {"off", l3d_read_off},
     {"ply", l3d_read_ply},
     {"stl", l3d_read_stl, false},
     {"videoscape", l3d_read_videoscape}}};

/// Printable text of bounded length that begins with the file's name.
inline bool is_message(const std::string& text) {
    return text.starts_with("name:") && text.size() < 250 && l3d_detail::printable(text) == text;
}

inline bool is_within_limits(const l3d_model_file& model) {
    const auto within = [](double value) { return std::abs(value) <= l3d_bpt_largest_coordinate; };
    for (const l3d_polygon_mesh::vector& v : model.mesh.vertices)
        if (!within(v[0]) || !within(v[1]) || !within(v[2]))
            return false;
    for (const l3d_patch_points& patch : model.patches) {
        const int points = (patch.degree_u + 1) * (patch.degree_v + 1);
        if (patch.degree_u < 1 || patch.degree_u > l3d_bpt_largest_degree || patch.degree_v < 1 ||
            patch.degree_v > l3d_bpt_largest_degree ||
            patch.points.size() != static_cast<std::size_t>(points))
            return false;
        for (const std::array<double, 3>& p : patch.points)
            if (!std::all_of(p.begin(), p.end(), within))
                return false;
        if (!patch.weights.empty() && patch.weights.size() != patch.points.size())
            return false;
        for (const double weight : patch.weights)
            if (!(weight > 0) || !within(weight))
                return false;
    }
    return true;
}

/// Neither writer has places of pictures.
inline void forget_what_lies_on_faces(l3d_polygon_mesh& mesh) {
    mesh.picture_places.clear();
    mesh.pictures.clear();
}

/// Compares a mesh with the result of the writer and the reader of .off, apart from what these may
/// lose.
inline bool survives_off(const l3d_polygon_mesh& mesh) {
    l3d_polygon_mesh kept = mesh;
    forget_what_lies_on_faces(kept);
    kept.parts.clear();
    kept.materials.clear();
    kept.looks.clear();
    kept.face_materials.clear();
    std::string why;
    const auto again = l3d_read_off(l3d_write_off(mesh), "again", why);
    return again && again->mesh == kept;
}

/// A part without a face has no place in an .obj file; nor has the name of what has none.
inline void forget_empty(std::vector<l3d_part_run>& parts, std::size_t count) {
    std::vector<l3d_part_run> kept;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t end = i + 1 < parts.size() ? parts[i + 1].first : count;
        if (parts[i].first < end && !(parts[i].first == 0 && parts[i].name.empty()))
            kept.push_back(parts[i]);
    }
    parts = kept;
}

/// The writer of .obj has no edges, so trims that follow them are curves of their own.
inline l3d_model_file without_edges(l3d_model_file model) {
    for (l3d_patch_points& patch : model.patches)
        for (l3d_trim_loop& loop : patch.trims)
            for (l3d_trim_curve& curve : loop)
                curve = {.points = std::move(curve.points)};
    model.edges.clear();
    return model;
}

inline bool survives_obj(const l3d_model_file& model) {
    l3d_model_file kept = without_edges(model);
    forget_empty(kept.mesh.parts, kept.mesh.faces());
    forget_empty(kept.patch_parts, kept.patches.size());
    forget_what_lies_on_faces(kept.mesh);
    kept.mesh.face_colors.clear();
    kept.mesh.looks.clear();
    kept.notes.clear();
    std::string why;
    const auto again = l3d_read_obj(l3d_write_obj(model), "again", why);
    return again && *again == kept;
}

/// The writer has no trims.
inline bool survives_bpt(const l3d_model_file& model) {
    std::vector<l3d_patch_points> kept = model.patches;
    for (l3d_patch_points& patch : kept)
        patch.trims.clear();
    std::string why;
    return kept.empty() || l3d_read_bpt(l3d_write_bpt(model.patches), "again", why) == kept;
}

/// Reads the text and says what is wrong with the reader; nothing if all is well.
/// `has_plain_names`: names have nothing that an .obj file could not hold.
inline std::string wrong_with(l3d_model_reader& read, std::string_view text, bool has_plain_names) {
    std::string why;
    const auto model = read(text, "name", why);
    if (!model)
        return is_message(why) ? "" : "bad message: " + why;
    if (!why.empty())
        return "a reason without an error: " + why;
    if (!model->mesh.is_valid())
        return "the mesh is not valid";
    if (!is_within_limits(*model))
        return "beyond the limits";
    if (model->notes.size() > 21 ||
        !std::all_of(model->notes.begin(), model->notes.end(), is_message))
        return "bad notes";
    if (!survives_off(model->mesh))
        return "changed by .off";
    if (has_plain_names && !survives_obj(*model))
        return "changed by .obj";
    if (!survives_bpt(*model))
        return "changed by .bpt";
    return "";
}

#endif
