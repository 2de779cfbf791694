// SPDX-License-Identifier: MIT
// l3d_load_model: reads a model file, and the files of materials beside it.
#ifndef L3D_SCENE_MODEL_LOADER_H
#define L3D_SCENE_MODEL_LOADER_H

#include "geom/files/model_file.h"
#include "geom/files/reading_progress_p.h"

#include <string>

/// Reads a model file, and the files of materials that it names, from the model file's folder.
/// Unreadable materials become notes. Messages call the model by `name`.
/// Errors: throws l3d_error(bad_input) with file, line and reason.
l3d_model_file l3d_load_model(const std::string& path, const std::string& name,
                              const l3d_detail::reading_progress& progress = {});

#endif
