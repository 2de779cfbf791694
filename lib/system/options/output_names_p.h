// SPDX-License-Identifier: MIT
// output_names: checks of output names before anything is drawn or written.
#ifndef L3D_SYSTEM_OPTIONS_OUTPUT_NAMES_P_H
#define L3D_SYSTEM_OPTIONS_OUTPUT_NAMES_P_H

#include <filesystem>
#include <string>

namespace l3d_detail {

/// The ending of a file's name, in small letters, with its dot, such as ".png"; empty if there is
/// none.
std::string ending_of(const std::string& name);

/// The path at which a file with this name would be written. If the name is a link, this is the
/// path that the link leads to, even if no file is there.
std::filesystem::path place_of(const std::string& name);

/// Whether two names lead to the same file, or both to the standard output. The result is false for
/// a device, such as /dev/null, since several outputs may share a device.
bool mean_one_file(const std::string& a, const std::string& b);

/// Checks that the folder of `file` exists. `option` and `name` are the option and its value, for
/// the message. Call it early: otherwise a long run of frames could fail at its end because of a
/// missing folder.
/// Errors:  l3d_error(failure) that names the option, its value and the folder of `file`.
void check_folder(const std::string& option, const std::string& name, const std::string& file);

/// Checks the name of a file for --depth-output and similar options: its ending, such as ".pfm",
/// and its folder.
/// Errors:  l3d_error: usage if the name has another ending than `ending`; failure for a missing
///          folder.
void check_ending(const std::string& option, const std::string& name, const std::string& ending);

} // namespace l3d_detail

#endif
