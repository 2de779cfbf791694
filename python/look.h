// SPDX-License-Identifier: MIT
// The settings by which frames are drawn, as keyword arguments.
#ifndef L3D_PYTHON_LOOK_H
#define L3D_PYTHON_LOOK_H

#include "arguments.h"

#include <l3d/pipeline_afd.h>
#include <l3d/pipeline_zbuffer.h>

#include <string>

namespace python {

/// The names of the settings. A function lists them after the names of its own arguments.
inline const std::string look_names =
    "tolerance shade_tolerance lateral_only shade inspection_direction inspection_scale "
    "inspection_stripe light light_color lights ambient headlight antialias fog background "
    "wireframe net one_sided depth most_samples error_map curves style rotation cull material "
    "count_pixels threads";

/// Changes the settings that are given.
/// Errors:  type_error, value_error; also for settings that only frames of patches have, or only
///          frames of polygons.
void read_look(const arguments& a, l3d_afd_settings& settings,
               std::vector<l3d_space_curve>& curves);
void read_look(const arguments& a, l3d_polygon_settings& settings);

} // namespace python

#endif
