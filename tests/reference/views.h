// SPDX-License-Identifier: MIT
// The project's views of the teapot, and a reader of patch files that is nobody else's.
#ifndef L3D_REFERENCE_VIEWS_H
#define L3D_REFERENCE_VIEWS_H

#include "reference/exact.h"

#include <string>
#include <string_view>
#include <vector>

namespace reference {

struct view {
    std::string_view name;
    camera eye;
};

/// The project's views: full, closeup, top, inside, near_cut, tiny, grazing.
const std::vector<view>& project_views();

/// The project's view of this name. Errors: std::out_of_range if there is no such view.
const view& project_view(std::string_view name);

inline constexpr vec3 project_light{0.4, 0.8, 0.45};

/// Reads the numbers of a .bpt file: count, then "3 3" and 16 points for each patch.
/// Errors: std::runtime_error that names the file.
std::vector<patch> load_bpt_plain(const std::string& path);

} // namespace reference

#endif
