// SPDX-License-Identifier: MIT
// model_names: lists the names of models, and reads the model of a name.
#include "system/options/model_names_p.h"

#include "base/did_you_mean_p.h"
#include "base/printable_p.h"
#include "geom/files/model_file.h"
#include "geom/nurbs_surface.h"
#include "system/options/output_names_p.h"
#include "system/plugin_loader.h"
#include "system/long_work_p.h"
#include "system/stop_key_p.h"
#include "tool_2d/text_file.h"
#include "base/error.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

std::vector<std::string> l3d_detail::model_names() {
    constexpr std::array<std::string_view, 9> endings{".asc", ".bez", ".bpt", ".glb", ".gltf",
                                                      ".obj", ".off", ".ply", ".stl"};
    std::vector<std::string> names;
    std::error_code unknown;
    for (const fs::directory_entry& entry : fs::directory_iterator(l3d_data_folder(), unknown))
        if (std::ranges::count(endings, ending_of(entry.path())) > 0)
            names.push_back(entry.path().stem().string());
    for (const std::string_view name : l3d_exact_shape_names())
        names.emplace_back(name);
    std::ranges::sort(names);
    // A name may be that of a file and of an exact shape.
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

namespace {

/// Loads a model file. This may take long, so a terminal shows the share of the file that is read,
/// and Escape stops reading.
l3d_model_file load_told(const std::string& path, const std::string& name,
                         const l3d_detail::load_watch& watch) {
    using clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds soon(500); // a shorter wait needs no message
    auto work = l3d_detail::tell_work("reading", name);
    const clock::time_point start = clock::now();
    std::optional<l3d_detail::stop_key> key;
    bool is_stopped = false;
    const auto progress = [&](double share) {
        work.set_share(share);
        if (share >= 1)
            key.reset(); // nothing can stop the rest
        else if (!key && clock::now() - start > soon)
            key.emplace();
        is_stopped = is_stopped || (key && key->is_pressed()) || (watch && !watch(name, share));
        return !is_stopped;
    };
    try {
        return l3d_load_model(path, name, progress);
    } catch (const l3d_error& error) {
        if (is_stopped)
            throw l3d_error(l3d_exit::failure, error.what());
        throw;
    }
}

} // namespace

l3d_model_file l3d_detail::load_named_model(const std::string& name, const load_watch& watch) {
    std::error_code unknown;
    if (const auto shape = l3d_exact_shape(name); shape && !fs::exists(name, unknown)) {
        l3d_model_file model;
        for (const l3d_nurbs_surface& surface : *shape)
            for (l3d_patch_points& piece : surface.pieces())
                model.patches.push_back(std::move(piece));
        return model;
    }
    const std::string path = l3d_data_file(name);
    if (fs::exists(path, unknown) || fs::path(name).has_parent_path()) {
        return load_told(path, name, watch);
    }
    const std::vector<std::string> names = model_names();
    std::string why = printable(name) + ": no such file is here, nor a model of that name in " +
                      printable(l3d_data_folder()) + ", which has";
    for (const std::string& known : names)
        why += ' ' + known;
    throw l3d_error(l3d_exit::bad_input, (names.empty() ? why + " none" : why) +
                                             did_you_mean(fs::path(name).stem().string(), names));
}

std::vector<l3d_nurbs_surface> l3d_detail::load_named_surfaces(const std::string& name) {
    std::error_code unknown;
    if (auto shape = l3d_exact_shape(name); shape && !fs::exists(name, unknown))
        return *std::move(shape);
    const std::string text = l3d_read_text_file(l3d_data_file(name));
    if (l3d_model_format_of(text) != l3d_model_format::obj)
        return {};
    std::string why;
    auto surfaces = l3d_read_obj_surfaces(text, name, why);
    if (!surfaces)
        throw l3d_error(l3d_exit::bad_input, why);
    return *std::move(surfaces);
}
