// SPDX-License-Identifier: MIT
// folder_beside: a folder of the installation that a program belongs to.
#ifndef L3D_SYSTEM_INSTALL_PATHS_P_H
#define L3D_SYSTEM_INSTALL_PATHS_P_H

#include <filesystem>

namespace l3d_detail {

/// Finds a folder of the installation that a program belongs to. The result is the folder `below`
/// beside the folder of `program`, if it exists, else `below` in the prefix that l3d was built for.
/// A path of the program that is empty or relative is not used, since code from the user's current
/// folder must not run.
std::filesystem::path folder_beside(const std::filesystem::path& program, const char* below);

} // namespace l3d_detail

#endif
