// SPDX-License-Identifier: MIT
// model_names: the models of l3d's data folder, by name.
#ifndef L3D_SYSTEM_OPTIONS_MODEL_NAMES_P_H
#define L3D_SYSTEM_OPTIONS_MODEL_NAMES_P_H

#include "geom/nurbs_surface.h"
#include "scene/model_loader.h"

#include <functional>
#include <string>
#include <vector>

namespace l3d_detail {

/// The names of l3d's own models, sorted: names of files without their ending, and names of exact
/// shapes.
std::vector<std::string> model_names();

/// A function that hears of a model file while it is read, as l3d_options::watch_loads describes.
using load_watch = std::function<bool(const std::string& file, double share)>;

/// Reads the model that a user means by its name, as l3d_data_file finds it.
/// Errors:  as l3d_load_model; for an unknown name without a folder, the message names the data
///          folder and its models.
l3d_model_file load_named_model(const std::string& name, const load_watch& watch = {});

/// The NURBS surfaces of a model that load_named_model can read. The result is empty unless the
/// model is an exact shape or an .obj file of NURBS surfaces.
/// Errors:  as load_named_model.
std::vector<l3d_nurbs_surface> load_named_surfaces(const std::string& name);

} // namespace l3d_detail

#endif
