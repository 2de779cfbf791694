// SPDX-License-Identifier: MIT
// load_plugin: looks for the file, opens it, and compares versions.
#include "geom/files/plugin_p.h"

#include "base/printable_p.h"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace fs = std::filesystem;

#ifndef L3D_LIBDIR
#define L3D_LIBDIR "/usr/local/lib"
#endif

std::vector<std::string> l3d_detail::plugin_folders() {
    std::vector<std::string> folders;
    const auto add = [&](const fs::path& folder) {
        if (folder.is_absolute())
            folders.push_back(folder.lexically_normal().string());
    };
    // The environment is ignored in programs that run with another user's rights.
    if (const char* const path = secure_getenv("L3D_PLUGIN_PATH"))
        for (std::string_view rest = path; !rest.empty();) {
            const std::size_t end = rest.find(':');
            add(rest.substr(0, end));
            rest = end == rest.npos ? std::string_view() : rest.substr(end + 1);
        }
    Dl_info ours{};
    std::error_code unknown;
    // dladdr gives a program the name that it was started with, which may be relative.
    if (dladdr(reinterpret_cast<const void*>(&load_plugin), &ours) != 0 && ours.dli_fname) {
        const fs::path named = ours.dli_fname;
        const fs::path file = named.is_absolute() ? fs::canonical(named, unknown)
                                                  : fs::read_symlink("/proc/self/exe", unknown);
        add(file.parent_path().parent_path() / "lib/l3d");
        add(file.parent_path() / "l3d");
    }
    add(L3D_LIBDIR "/l3d");
    return folders;
}

const l3d_detail::plugin_interface* l3d_detail::load_plugin(std::string_view name,
                                                            std::uint32_t version, std::size_t size,
                                                            std::string& why) {
    const std::string plain = "libl3d_" + std::string(name) + ".so";
    const std::string symbol = "l3d_" + std::string(name) + "_plugin";
    for (const std::string& folder : plugin_folders()) {
        const std::string file = fs::path(folder) / plain;
        std::error_code unknown;
        if (!fs::is_regular_file(file, unknown))
            continue;
        // Binds all symbols at once, so that a missing symbol is an error here, not at its first
        // call.
        void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!handle) {
            why = "the plug-in cannot be loaded: " + printable(dlerror());
            return nullptr;
        }
        const auto* const found =
            static_cast<const plugin_interface*>(dlsym(handle, symbol.c_str()));
        if (found && found->version == version && found->size == size)
            return found;
        why = printable(file) + ": ";
        if (!found)
            why += "it is no plug-in of l3d: it defines no symbol " + symbol;
        else if (found->version != version)
            why += "the plug-in has version " + std::to_string(found->version) +
                   " of its interface, and this program needs version " + std::to_string(version);
        else
            why += "the plug-in's interface has " + std::to_string(found->size) + " bytes, not " +
                   std::to_string(size);
        dlclose(handle);
        return nullptr;
    }
    why = "it takes the package l3d-" + std::string(name) + ", which is not installed (" + plain +
          " is in no folder of plug-ins)";
    return nullptr;
}
