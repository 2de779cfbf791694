// SPDX-License-Identifier: MIT
// l3d_load_model: looks for materials where the model is.
#include "scene/model_loader.h"

#include "tool_2d/error.h"
#include "tool_2d/text_file.h"

#include <filesystem>
#include <utility>
#include <vector>

namespace {

/// A file that another one names: beside it, also if it is named by a place on another machine.
std::string beside(const std::string& path, const std::string& named) {
    const std::filesystem::path other(named);
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    return (folder / (other.is_absolute() ? other.filename() : other)).string();
}

/// The text of a file, or why there is none.
std::string text_of(const std::string& path, std::string& why) {
    try {
        return l3d_read_text_file(path);
    } catch (const l3d_error& error) {
        why = error.what();
        return "";
    }
}

void read_materials(const std::string& path, const std::string& name, l3d_model_file& model) {
    std::vector<l3d_named_material> materials;
    for (const l3d_material_file& file : model.material_files) {
        const std::string place = beside(path, file.name);
        std::string why;
        const std::string text = text_of(place, why);
        if (!why.empty())
            model.notes.push_back(name + ':' + std::to_string(file.line) + ": " + why +
                                  "; its materials are white");
        for (l3d_named_material& material : l3d_read_mtl(text, place, model.notes))
            materials.push_back(std::move(material));
    }
    if (!materials.empty())
        l3d_give_looks(model.mesh, materials);
}

} // namespace

l3d_model_file l3d_load_model(const std::string& path, const std::string& name) {
    std::string why;
    auto model = l3d_read_model(l3d_read_text_file(path), name, why);
    if (!model)
        throw l3d_error(l3d_exit::bad_input, why);
    read_materials(path, name, *model);
    return *std::move(model);
}
