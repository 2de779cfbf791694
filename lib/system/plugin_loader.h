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

/// Loads object plug-ins: shared libraries with the interface of object_plugin.h. This interface is
/// C, has a version, and does not depend on how l3d itself was built.
///
/// Lives:   the objects do not need the loader. Each holds its library, which is closed with the
///          last object that holds it.
class L3D_PUBLIC l3d_plugin_loader {
public:
    /// A loader whose lines on stderr begin with `program`. `seed` begins the random numbers of
    /// plug-ins, and `folder` is where they look for relative names of files.
    l3d_plugin_loader(std::string program, std::uint64_t seed, std::string folder = ".")
        : program_(std::move(program)), folder_(std::move(folder)), random_(seed) {}

    /// Makes an object that the plug-in in `file` has set up with these parameters.
    ///
    /// Errors: null, and `why` = "file: reason". There may be no such file, or it is no shared
    ///         library, or it has no symbol l3d_plugin. The symbol may be of another version, too
    ///         short, or lack a function. The plug-in may refuse, with its own reason. A later
    ///         fault of the plug-in gives one line on stderr, once.
    std::unique_ptr<l3d_object> load(const std::string& file, const std::string& parameters,
                                     std::string& why);

private:
    std::string program_, folder_;
    l3d_random random_;
};

/// The folder of plug-ins. It is ../lib/l3d, seen from the program's own folder, if that exists. So
/// programs that were built or installed with l3d find it wherever they were moved. Otherwise it is
/// lib/l3d in the prefix that l3d was built for.
L3D_PUBLIC std::string l3d_plugin_folder();

/// The folder of models and other data: ../share/l3d, found as l3d_plugin_folder finds its own.
L3D_PUBLIC std::string l3d_data_folder();

/// The file that a user means by the name of a model. It is the file of that name, else the one in
/// the data folder, with or without its ending. If there is neither, the name is returned as it is.
L3D_PUBLIC std::string l3d_data_file(const std::string& name);

#endif
