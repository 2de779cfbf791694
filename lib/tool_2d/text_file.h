// SPDX-License-Identifier: MIT
// l3d_read_text_file: a whole file as text.
#ifndef L3D_TOOL_2D_TEXT_FILE_H
#define L3D_TOOL_2D_TEXT_FILE_H

#include <string>

/// Errors: l3d_error(bad_input) that names the path and the system's reason.
std::string l3d_read_text_file(const std::string& path);

#endif
