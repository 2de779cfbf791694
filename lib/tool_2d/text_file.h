// SPDX-License-Identifier: MIT
// l3d_read_text_file: a whole file, whatever is in it.
#ifndef L3D_TOOL_2D_TEXT_FILE_H
#define L3D_TOOL_2D_TEXT_FILE_H

#include <string>

/// Every reader of files begins here, so none waits or grows without end. A file may have 4 GB. A
/// pipe or a device may give 256 MB, and a pipe waits two seconds for a program that writes into
/// it.
/// Errors: l3d_error(bad_input) that names the path, and the system's reason or the limit.
std::string l3d_read_text_file(const std::string& path);

#endif
