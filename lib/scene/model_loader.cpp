// SPDX-License-Identifier: MIT
// l3d_load_model: looks for materials where the model is.
#include "scene/model_loader.h"

#include "base/printable_p.h"
#include "base/error.h"
#include "geom/files/patch_file.h"
#include "scene/drawing/lost_lines_p.h"
#include "tool_2d/png_levels_p.h"
#include "tool_2d/text_file.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

namespace {

/// The path at which a file `named` in the file `path` is looked for. The result is in the folder
/// of `path`, even if `named` is a path on another machine or of Windows. A model from a pipe has
/// no folder; the current folder stands for it.
std::string beside(const std::string& path, std::string named) {
    std::error_code unknown;
    const bool is_file = std::filesystem::is_regular_file(path, unknown);
    const auto place = [&] {
        const std::filesystem::path other(named);
        const std::filesystem::path folder =
            is_file ? std::filesystem::path(path).parent_path() : std::filesystem::path();
        return (folder / (other.is_absolute() ? other.filename() : other)).string();
    };
    std::string result = place();
    if (named.find('\\') == named.npos || std::filesystem::exists(result, unknown))
        return result;
    std::ranges::replace(named, '\\', '/');
    if (named.size() > 1 && named[1] == ':')
        named.erase(0, 2); // a drive's letter
    return place();
}

/// The text of a file; "" with the reason in `why` if the file cannot be read.
std::string text_of(const std::string& path, std::string& why) {
    try {
        return l3d_read_text_file(path);
    } catch (const l3d_error& error) {
        why = error.what();
        return "";
    }
}

/// Adds a note about a model's materials that no file describes. The note names the first five.
void note_unknown(std::span<const l3d_named_material> known, const std::string& name,
                  l3d_model_file& model) {
    constexpr std::size_t most = 5;
    std::string unknown;
    std::size_t count = 0;
    for (const std::string& material : model.mesh.materials)
        if (!material.empty() &&
            std::ranges::find(known, material, &l3d_named_material::name) == known.end() &&
            ++count <= most)
            unknown += (count > 1 ? ", '" : "'") + l3d_detail::printable(material) + '\'';
    if (count > most)
        unknown += " and " + std::to_string(count - most) + " more";
    if (count > 0)
        model.notes.push_back(l3d_detail::printable(name) + ": no .mtl file describes " + unknown +
                              "; such materials are white");
}

/// A file of materials that was looked for: its path, and its text or the reason why there is none.
struct material_text {
    std::string place, why, text;

    material_text(const std::string& path, const std::string& named)
        : place(beside(path, named)), text(text_of(place, why)) {}
};

/// The files of materials that a statement of a model file names. A statement may name several
/// files, and a name may have spaces. The whole statement is one name if there is such a file, or
/// if none of its words names a file.
std::vector<material_text> texts_of(const std::string& path, const std::string& named) {
    const material_text whole(path, named);
    std::vector<material_text> each;
    std::istringstream words(named);
    for (std::string word; !whole.why.empty() && words >> word;)
        each.emplace_back(path, word);
    if (std::ranges::all_of(each, [](const auto& file) { return !file.why.empty(); }))
        return {whole};
    return each;
}

void read_materials(const std::string& path, const std::string& name, l3d_model_file& model) {
    std::vector<l3d_named_material> materials;
    bool is_complete = true;
    for (const l3d_material_file& named : model.material_files)
        for (const material_text& file : texts_of(path, named.name)) {
            is_complete = is_complete && file.why.empty();
            if (!file.why.empty())
                model.notes.push_back(
                    l3d_detail::printable(name) + ':' + std::to_string(named.line) + ": " +
                    l3d_detail::printable(file.why) + "; its materials are white");
            for (l3d_named_material& material : l3d_read_mtl(file.text, file.place, model.notes)) {
                if (!material.picture.name.empty())
                    material.picture.name = beside(file.place, material.picture.name);
                materials.push_back(std::move(material));
            }
        }
    if (!materials.empty())
        l3d_give_looks(model.mesh, materials);
    const auto has_picture = [&](std::uint32_t material) {
        return model.mesh.looks[material].picture != l3d_material::no_picture;
    };
    if (!model.mesh.looks.empty() && std::ranges::any_of(model.patch_materials, has_picture))
        model.notes.push_back(l3d_detail::printable(name) +
                              ": pictures on patches are not drawn, only those on polygons");
    if (is_complete)
        note_unknown(materials, name, model);
}

/// Makes a model of hills from a picture. Each pixel's grey is a height, and pixels are one unit
/// apart. White is higher than black by a quarter of the picture's longer side. With this height,
/// the hills of most pictures look neither flat nor like needles.
l3d_model_file heights_of(const std::string& bytes, const std::string& name) {
    l3d_detail::png_levels picture = l3d_detail::decoded_png_levels(bytes, name, l3d_most_heights);
    const double white = std::max(picture.size.width, picture.size.height) / 4.0;
    l3d_height_field field{static_cast<std::size_t>(picture.size.width), std::move(picture.means),
                           1};
    for (double& height : field.heights)
        height *= white;
    const std::string why = field.complaint();
    if (!why.empty())
        throw l3d_error(l3d_exit::bad_input, l3d_detail::printable(name) + ": " + why);
    l3d_model_file model;
    model.patches = l3d_height_patches(field);
    return model;
}

} // namespace

l3d_model_file l3d_load_model(const std::string& path, const std::string& name,
                              const l3d_detail::reading_progress& progress) {
    std::string why;
    const std::string text = l3d_read_text_file(path);
    if (text.starts_with("\x89PNG"))
        return heights_of(text, name);
    const auto read_beside = [&](const std::string& named,
                                 std::string& reason) -> std::optional<std::string> {
        reason.clear();
        std::string other = text_of(beside(path, named), reason);
        return reason.empty() ? std::optional(std::move(other)) : std::nullopt;
    };
    auto model = l3d_detail::read_model(read_beside, text, name, why, progress);
    if (!model)
        throw l3d_error(l3d_exit::bad_input, why);
    if (model->patches.empty())
        l3d_detail::note_lost_lines(*model, name, "only beside surfaces", model->notes);
    const auto format = l3d_model_format_of(text);
    if (format == l3d_model_format::obj)
        read_materials(path, name, *model);
    if (format == l3d_model_format::ply)
        for (l3d_mesh_picture& picture : model->mesh.pictures)
            picture.name = beside(path, picture.name);
    return *std::move(model);
}
