// SPDX-License-Identifier: MIT
// Plug-ins: code that needs another library, such as a CAD kernel. l3d does without those that are
// not installed.
#ifndef L3D_GEOM_FILES_PLUGIN_P_H
#define L3D_GEOM_FILES_PLUGIN_P_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace l3d_detail {

/// The common base of the interfaces of plug-ins. An interface is a struct of functions that
/// derives from it.
///
/// Functions take and give numbers of C's own types, never l3d_real. So one plug-in serves the
/// libraries of all number types, and does not link to them.
struct plugin_interface {
    /// Counted up whenever the struct or the meaning of its functions changes.
    std::uint32_t version;
    std::uint32_t size; ///< sizeof the whole struct
};

/// Finds the plug-in libl3d_NAME.so, and returns its interface, the symbol l3d_NAME_plugin.
///
/// Searches the plugin_folders() in their order, and takes the first file with this name.
/// Lives:  the plug-in stays loaded until the process ends.
/// Errors: null, and `why` = one line that names the missing package, or the file with its fault.
///         The line does not name a model. Another version or size of the struct is a fault.
const plugin_interface* load_plugin(std::string_view name, std::uint32_t version, std::size_t size,
                                    std::string& why);

/// The folders with plug-ins. First come the folders of the environment variable L3D_PLUGIN_PATH,
/// separated by colons. Next come folders near the file with this code: lib/l3d beside a program's
/// own folder, and l3d in the folder of a shared library. The last folder is the one into which
/// plug-ins are installed. Relative folders are ignored, since code from the user's current folder
/// must not run.
std::vector<std::string> plugin_folders();

} // namespace l3d_detail

#endif
