// SPDX-License-Identifier: MIT
// output_names: checks of output names before anything is drawn or written.
#ifndef L3D_SYSTEM_OPTIONS_OUTPUT_NAMES_P_H
#define L3D_SYSTEM_OPTIONS_OUTPUT_NAMES_P_H

#include <filesystem>
#include <string>

namespace l3d_detail {

/// The ending of a name, in small letters, with its dot: ".png"; empty without one.
std::string ending_of(const std::string& name);

/// The place at which a file with this name would be written: where a link leads, even to a missing
/// file.
std::filesystem::path place_of(const std::string& name);

/// Whether two names lead to the same file, or both to the standard output. A device, such as
/// /dev/null, takes anything.
bool mean_one_file(const std::string& a, const std::string& b);

/// Checks that the folder is there. This comes early: a run of frames should not end with the news
/// that its folder never existed.
/// Errors:  l3d_error(failure) that names the option, its value and the folder of `file`.
void check_folder(const std::string& option, const std::string& name, const std::string& file);

/// Checks a name for --depth-output and similar options. Shape: the ending has a dot, as ".pfm".
/// Errors:  l3d_error: usage for another ending than that of the format, failure for a missing
///          folder.
void check_ending(const std::string& option, const std::string& name, const std::string& ending);

} // namespace l3d_detail

#endif
