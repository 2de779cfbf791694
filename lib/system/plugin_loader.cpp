// SPDX-License-Identifier: MIT
// l3d_plugin_loader: has the host's side of the interface, and calls dlopen.
#include "system/plugin_loader.h"

#include "base/error.h"
#include "base/printable_p.h"
#include "geom/polygon_mesh.h"
#include "geom/files/model_file.h"
#include "pipeline/polygons/polygon_model.h"
#include "pipeline/worlds/object_plugin.h"
#include "scene/model_loader.h"
#include "system/install_paths_p.h"
#include "tool_2d/text_file.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <dlfcn.h>
#include <filesystem>
#include <iostream>
#include <limits>
#include <optional>
#include <span>
#include <utility>

/// The argument of a plug-in's functions: an object, with the host's data for it.
struct l3d_plugin_object {
    l3d_object* object;
    std::string program, file, folder;
    l3d_random random;
    std::string complaint{}; ///< the plug-in's first complaint

    void complain(const std::string& text) {
        if (complaint.empty())
            complaint = file + ": " + text;
    }
};

namespace {

constexpr std::uint32_t most_transforms = 16;

// ---- what the host does ------------------------------------------------------------------------

/// The largest absolute value of a number of type T, up to rounding.
template <class T> constexpr double end_of() {
    if constexpr (std::floating_point<T>)
        return std::numeric_limits<T>::max();
    else
        return l3d_to_double(T::max());
}

/// Whether a plug-in's double fits l3d_real. A number that does not fit would wrap round or be
/// infinite. The result is false for NaN.
bool is_in_range(double value) {
    return std::abs(value) < end_of<l3d_real>();
}

int set_polygons(l3d_plugin_object* to, std::uint32_t vertices, const double* coordinates,
                 std::uint32_t faces, const std::uint32_t* corner_counts,
                 const std::uint32_t* corners, const std::uint32_t* colors) {
    l3d_polygon_mesh mesh;
    for (const double* c = coordinates; c != coordinates + 3 * std::size_t{vertices}; c += 3)
        mesh.vertices.push_back({c[0], c[1], c[2]});
    for (const std::uint32_t count : std::span(corner_counts, faces)) {
        mesh.add_face({corners, count});
        corners += count;
    }
    mesh.face_colors.assign(colors, colors + faces);
    const std::span all(coordinates, 3 * std::size_t{vertices});
    if (!mesh.is_valid() || !std::ranges::all_of(all, is_in_range)) {
        to->complain("set_polygons: a face has fewer than 3 corners or names no vertex, or a "
                     "coordinate is not finite, or too large");
        return 0;
    }
    to->object->set_mesh(std::move(mesh));
    return 1;
}

/// Gives a plug-in's object the polygons of a file. With `videoscape_only`, files of other formats
/// are refused. Returns 1, or 0 after a complaint.
int load(l3d_plugin_object* to, const char* file, bool videoscape_only, bool random_colors) {
    const auto path = (std::filesystem::path(to->folder) / file).string();
    try {
        const std::string text = l3d_read_text_file(path);
        const auto format = l3d_model_format_of(text);
        const bool is_videoscape = videoscape_only || format == l3d_model_format::videoscape;
        l3d_polygon_mesh mesh;
        if (is_videoscape) {
            std::string why;
            auto model = l3d_read_videoscape(text, path, why);
            if (!model) {
                to->complain(why);
                return 0;
            }
            mesh = std::move(model->mesh);
        } else
            mesh = l3d_mesh_of(l3d_load_model(path, path), path, l3d_usual_facets);
        const bool z_is_up = is_videoscape || format == l3d_model_format::asc;
        l3d_turn_left_handed(mesh, z_is_up ? l3d_model_up::z : l3d_model_up::y);
        const bool is_plain =
            mesh.face_colors.empty() && mesh.vertex_colors.empty() && mesh.looks.empty();
        if (random_colors && (is_videoscape || is_plain)) {
            mesh.face_colors.resize(mesh.faces());
            for (std::uint32_t& color : mesh.face_colors)
                color = to->random.next() >> 8;
        }
        std::vector<std::string> notes; // nobody reads these
        auto textures = l3d_read_textures(mesh, notes);
        to->object->set_mesh(std::move(mesh), std::move(textures));
        return 1;
    } catch (const l3d_error& error) {
        to->complain(error.what());
        return 0;
    }
}

int load_videoscape(l3d_plugin_object* to, const char* file, int random_colors) {
    return load(to, file, true, random_colors != 0);
}

int load_model(l3d_plugin_object* to, const char* file, int random_colors) {
    return load(to, file, false, random_colors != 0);
}

int set_name(l3d_plugin_object* to, const char* name) {
    to->object->name = name;
    return 1;
}

int set_transform(l3d_plugin_object* to, std::uint32_t index, const double* matrix) {
    if (index >= most_transforms) {
        to->complain("set_transform: there is no matrix " + std::to_string(index));
        return 0;
    }
    l3d_matrix<l3d_real> m;
    for (int i = 0; i < 16; ++i) {
        if (!is_in_range(matrix[i])) {
            to->complain("set_transform: matrix " + std::to_string(index) +
                         " has a number that is not finite, or too large");
            return 0;
        }
        m(i / 4, i % 4) = l3d_from_double<l3d_real>(matrix[i]);
    }
    to->object->set_transform(index, m);
    return 1;
}

std::uint32_t random(l3d_plugin_object* to) {
    return to->random.next();
}

void fail(l3d_plugin_object* to, const char* why) {
    to->complain(why ? why : "it failed, and does not say why");
}

const l3d_plugin_host host{sizeof(l3d_plugin_host),
                           L3D_PLUGIN_VERSION,
                           set_polygons,
                           load_videoscape,
                           set_transform,
                           random,
                           fail,
                           load_model,
                           set_name};

// ---- the library -------------------------------------------------------------------------------

/// Owns an open shared library. A library that several objects have opened stays until the last
/// object closes it.
class library {
public:
    explicit library(const std::string& file)
        // Binds all symbols at once, so that a missing one is an error here and not in mid-flight.
        // A name without a slash would be looked for in the system's folders.
        : handle_(dlopen((file.find('/') == file.npos ? "./" + file : file).c_str(),
                         RTLD_NOW | RTLD_LOCAL)) {}
    library(const library&) = delete;
    library& operator=(const library&) = delete;
    ~library() {
        if (handle_)
            dlclose(handle_);
    }

    bool is_open() const { return handle_ != nullptr; }
    const l3d_plugin_interface* plugin() const {
        return static_cast<const l3d_plugin_interface*>(dlsym(handle_, L3D_PLUGIN_SYMBOL));
    }

private:
    void* handle_;
};

/// The reason why a library cannot be used as a plug-in; empty if it can. If the library did not
/// open, the reason has the system's own words after the file's name.
std::string fault_of(const library& opened, const std::string& file) {
    if (!opened.is_open()) {
        const std::string words = dlerror();
        const std::size_t colon = words.find(": ");
        return file + (colon == words.npos ? ": " + words : words.substr(colon));
    }
    const l3d_plugin_interface* const plugin = opened.plugin();
    if (!plugin)
        return file + ": it is no plug-in: it defines no symbol " L3D_PLUGIN_SYMBOL;
    if (plugin->version != L3D_PLUGIN_VERSION)
        return file + ": it is made for version " + std::to_string(plugin->version) +
               " of the plug-in interface, this program has version " +
               std::to_string(L3D_PLUGIN_VERSION);
    if (plugin->size < sizeof(l3d_plugin_interface))
        return file + ": its interface has " + std::to_string(plugin->size) + " bytes, not " +
               std::to_string(sizeof(l3d_plugin_interface));
    if (!plugin->create || !plugin->update || !plugin->copy || !plugin->destroy)
        return file + ": it lacks one of the functions create, update, copy and destroy";
    return {};
}

/// The behaviour of an object that has a plug-in. It owns the plug-in's data for the object, and
/// the library with the plug-in's code.
class plugged_behaviour final : public l3d_object_behaviour {
public:
    /// Expects: the file is a plug-in for which fault_of() is empty.
    explicit plugged_behaviour(l3d_plugin_object context)
        : library_(context.file), context_(std::move(context)) {}
    ~plugged_behaviour() override {
        if (data_)
            library_.plugin()->destroy(data_);
    }

    bool create(const std::string& parameters, std::string& why) {
        data_ = library_.plugin()->create(&host, &context_, parameters.c_str());
        return is_set_up(why);
    }

private:
    bool is_set_up(std::string& why) {
        if (!data_)
            context_.complain("it failed, and does not say why");
        why = context_.complaint;
        return data_ && why.empty();
    }

    void do_update(l3d_object&, double seconds) override {
        const bool silent = context_.complaint.empty();
        library_.plugin()->update(data_, seconds);
        if (silent && !context_.complaint.empty())
            std::cerr << context_.program << ": " << l3d_detail::printable(context_.complaint)
                      << '\n';
    }

    std::unique_ptr<l3d_object_behaviour> do_clone(l3d_object& for_copy) const override {
        l3d_plugin_object context = context_;
        context.object = &for_copy;
        context.complaint.clear();
        auto copy = std::make_unique<plugged_behaviour>(std::move(context));
        copy->data_ = library_.plugin()->copy(data_, &copy->context_);
        std::string why;
        if (copy->is_set_up(why))
            return copy;
        std::cerr << context_.program << ": " << l3d_detail::printable(why) << '\n';
        return nullptr;
    }

    library library_;
    l3d_plugin_object context_;
    void* data_ = nullptr;
};

} // namespace

std::unique_ptr<l3d_object>
l3d_plugin_loader::load(const std::string& file, const std::string& parameters, std::string& why) {
    std::error_code unknown;
    const auto status = std::filesystem::status(file, unknown);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        why = file + ": is no regular file"; // opening a pipe would wait for its writer
        return nullptr;
    }
    const library tried(file);
    why = fault_of(tried, file);
    if (!why.empty())
        return nullptr;
    auto object = std::make_unique<l3d_object>();
    auto behaviour = std::make_unique<plugged_behaviour>(
        l3d_plugin_object{object.get(), program_, file, folder_,
                          l3d_random(std::uint64_t{random_.next()} << 32 | random_.next())});
    if (!behaviour->create(parameters, why))
        return nullptr;
    object->plug(std::move(behaviour));
    return object;
}

#ifndef L3D_PREFIX
#define L3D_PREFIX "/usr/local"
#endif

namespace {

namespace fs = std::filesystem;

std::string folder(const char* below) {
    std::error_code unknown;
    return l3d_detail::folder_beside(fs::read_symlink("/proc/self/exe", unknown), below);
}

} // namespace

fs::path l3d_detail::folder_beside(const fs::path& program, const char* below) {
    std::error_code unknown;
    const fs::path beside = program.parent_path().parent_path() / below;
    return program.is_absolute() && fs::is_directory(beside, unknown)
               ? beside
               : fs::path(L3D_PREFIX) / below;
}

std::string l3d_plugin_folder() {
    return folder("lib/l3d");
}

std::string l3d_data_folder() {
    return folder("share/l3d");
}

std::string l3d_data_file(const std::string& name) {
    std::error_code unknown;
    if (name.empty() || fs::exists(name, unknown) || fs::path(name).has_parent_path())
        return name;
    const fs::path ours = fs::path(l3d_data_folder()) / name;
    if (fs::is_regular_file(ours, unknown))
        return ours.string();
    for (const fs::directory_entry& entry : fs::directory_iterator(l3d_data_folder(), unknown))
        if (entry.path().stem() == name && entry.is_regular_file(unknown))
            return entry.path().string();
    return name;
}
