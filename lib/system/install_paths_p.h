// SPDX-License-Identifier: MIT
// folder_beside: a folder of the installation that a program belongs to.
#ifndef L3D_SYSTEM_INSTALL_PATHS_P_H
#define L3D_SYSTEM_INSTALL_PATHS_P_H

#include <filesystem>

namespace l3d_detail {

/// The folder `below` beside the folder of `program`, if that is there, else below the prefix which
/// l3d was built for. A program whose place is not known, or is no whole path, counts for nothing:
/// code from the folder that the user happens to be in must not run.
std::filesystem::path folder_beside(const std::filesystem::path& program, const char* below);

} // namespace l3d_detail

#endif
