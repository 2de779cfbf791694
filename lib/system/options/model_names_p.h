// SPDX-License-Identifier: MIT
// model_names: models that a user has by name, as they lie in l3d's data folder.
#ifndef L3D_SYSTEM_OPTIONS_MODEL_NAMES_P_H
#define L3D_SYSTEM_OPTIONS_MODEL_NAMES_P_H

#include "scene/model_loader.h"

#include <string>
#include <vector>

namespace l3d_detail {

/// The names of l3d's own models: those of their files without the ending, in order.
std::vector<std::string> model_names();

/// Reads what a user means by the name of a model, as l3d_data_file finds it.
/// Errors:  as l3d_load_model; a plain name that is none says where it was looked for.
l3d_model_file load_named_model(const std::string& name);

} // namespace l3d_detail

#endif
