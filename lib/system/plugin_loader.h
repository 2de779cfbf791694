// SPDX-License-Identifier: MIT
// l3d_plugin_loader: makes objects whose behaviour comes from shared libraries.
#ifndef L3D_SYSTEM_PLUGIN_LOADER_H
#define L3D_SYSTEM_PLUGIN_LOADER_H

#include "base/public.h"
#include "geom/random.h"
#include "pipeline/worlds/object.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

/// Loads object plug-ins: shared libraries with the interface of object_plugin.h, which is C, has a
/// version, and does not depend on how l3d itself was built.
///
/// Lives:   the objects need the loader no more; each holds its library, which is closed with the
///          last of them.
class L3D_PUBLIC l3d_plugin_loader {
public:
    /// A loader whose lines on stderr begin with `program`. `seed` begins the random numbers of
    /// plug-ins, and `folder` is where they look for relative names of files.
    l3d_plugin_loader(std::string program, std::uint64_t seed, std::string folder = ".")
        : program_(std::move(program)), folder_(std::move(folder)), random_(seed) {}

    /// An object that the plug-in in `file` has set up with these parameters.
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

#endif
