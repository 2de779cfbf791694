// SPDX-License-Identifier: MIT
// Folders of plug-ins and data: beside the running program, else where l3d was to be installed.
#ifndef L3D_SYSTEM_INSTALL_PATHS_H
#define L3D_SYSTEM_INSTALL_PATHS_H

#include "base/public.h"

#include <string>

/// The folder of plug-ins. It is ../lib/l3d, seen from the program's own folder, if that exists. So
/// programs that were built or installed with l3d find it wherever they were moved. Else it is the
/// folder in the prefix which l3d was built for.
L3D_PUBLIC std::string l3d_plugin_folder();

/// The folder of models and other data, likewise: ../share/l3d.
L3D_PUBLIC std::string l3d_data_folder();

/// The file that a user means by the name of a model: the file of that name, else one in the data
/// folder, with or without its ending. If there is neither, the name as it is.
L3D_PUBLIC std::string l3d_data_file(const std::string& name);

#endif
