// SPDX-License-Identifier: MIT
// l3d_load_any_model: looks at the file once, and chooses the kind of model.
#include "pipeline/any_model.h"

#include "pipeline/polygons/polygon_model.h"
#include "scene/drawing/lost_lines_p.h"
#include "scene/model_loader.h"
#include "base/error.h"

namespace {

/// Loads a model file as l3d_load_any_model does. `Patches` is l3d_patch_model or l3d_patch_scene,
/// for files of patches alone.
template <class Patches>
std::variant<Patches, l3d_polygon_model> load(const std::string& file,
                                              std::vector<std::string>* notes) {
    const l3d_model_file read = l3d_load_model(file, file);
    if (notes)
        notes->insert(notes->end(), read.notes.begin(), read.notes.end());
    if (read.patches.empty() || read.mesh.faces() > 0) {
        const l3d_polygon_model plain(l3d_mesh_of(read, file, l3d_usual_facets));
        std::vector<std::string> lost;
        l3d_detail::note_lines_lost_to_polygons(read, file, lost);
        auto textures = l3d_read_textures(plain.mesh(), lost);
        if (notes)
            notes->insert(notes->end(), lost.begin(), lost.end());
        return plain.textured(std::move(textures));
    }
    std::string why;
    const auto patches = Patches::from_file(read, file, why);
    if (!patches)
        throw l3d_error(l3d_exit::bad_input, why);
    return *patches;
}

} // namespace

l3d_any_model l3d_load_any_model(const std::string& file, std::vector<std::string>* notes) {
    return load<l3d_patch_model>(file, notes);
}

l3d_any_scene l3d_load_any_scene(const std::string& file, std::vector<std::string>* notes) {
    return load<l3d_patch_scene>(file, notes);
}
