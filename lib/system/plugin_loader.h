// SPDX-License-Identifier: MIT
// l3d_plugin_loader: makes objects whose behaviour comes from shared libraries; the folders of
// these and of data.
#ifndef L3D_SYSTEM_PLUGIN_LOADER_H
#define L3D_SYSTEM_PLUGIN_LOADER_H

#include "base/public.h"
#include "geom/random.h"
#include "pipeline/worlds/object.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

/// Makes objects whose behaviour comes from plug-ins: shared libraries with the interface of
/// object_plugin.h. This interface is in C, has a version, and does not depend on how l3d itself
/// was built.
///
/// Lives:   the objects do not need the loader. Each object holds its plug-in's library open. The
///          library is closed with the last object that holds it.
class L3D_PUBLIC l3d_plugin_loader {
public:
    /// Makes a loader. Its lines on stderr begin with `program`. `seed` starts the random numbers
    /// for plug-ins. Plug-ins look for relative names of files in `folder`.
    l3d_plugin_loader(std::string program, std::uint64_t seed, std::string folder = ".")
        : program_(std::move(program)), folder_(std::move(folder)), random_(seed) {}

    /// Makes an object, which the plug-in in `file` sets up by these parameters.
    ///
    /// Errors: null, and `why` gets "file: reason". Reasons are a file that is missing, is no
    ///         shared library, or has no symbol l3d_plugin. The structure l3d_plugin may also have
    ///         another version, be too short, or lack a function. The plug-in may also refuse, with
    ///         a reason of its own. Later faults of the plug-in give one line on stderr, once.
    std::unique_ptr<l3d_object> load(const std::string& file, const std::string& parameters,
                                     std::string& why);

private:
    std::string program_, folder_;
    l3d_random random_;
};

/// The folder of plug-ins: ../lib/l3d, seen from the program's own folder, if this folder exists.
/// So programs that were built or installed with l3d still find their plug-ins if all are moved
/// together. Otherwise the result is lib/l3d in the prefix that l3d was built for.
L3D_PUBLIC std::string l3d_plugin_folder();

/// The folder of models and other data: ../share/l3d, seen from the program's own folder, or
/// share/l3d in the prefix, as for l3d_plugin_folder.
L3D_PUBLIC std::string l3d_data_folder();

/// The file that a user means by the name of a model: the file of this name, else the file in the
/// data folder with this name, with or without its ending. If neither exists, the result is the
/// name itself.
L3D_PUBLIC std::string l3d_data_file(const std::string& name);

#endif
