// SPDX-License-Identifier: MIT
// output_names: what the name of an output tells before anything is drawn or written.
#ifndef L3D_SYSTEM_OPTIONS_OUTPUT_NAMES_P_H
#define L3D_SYSTEM_OPTIONS_OUTPUT_NAMES_P_H

#include <filesystem>
#include <string>

namespace l3d_detail {

/// How a name ends, in small letters, with its dot: ".png"; empty without one.
std::string ending_of(const std::string& name);

/// Where a file with this name would be written. A link may lead to what is not there yet.
std::filesystem::path place_of(const std::string& name);

/// Whether two names lead to one place that can hold only one thing. A device, such as /dev/null,
/// takes anything.
bool mean_one_file(const std::string& a, const std::string& b);

/// A run of frames should not end with the news that its folder never was there.
/// Errors:  l3d_error(failure) that names the option, its value and the folder of `file`.
void check_folder(const std::string& option, const std::string& name, const std::string& file);

/// Errors:  l3d_error for what --depth-output and its like cannot write: usage for an ending that
///          is another format's, failure for a folder that is not there.
void check_pfm(const std::string& option, const std::string& name);

} // namespace l3d_detail

#endif
