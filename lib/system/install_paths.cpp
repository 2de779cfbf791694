// SPDX-License-Identifier: MIT
// Folders, found from the program's own.
#include "system/install_paths.h"

#include "system/install_paths_p.h"

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
