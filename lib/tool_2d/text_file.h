// SPDX-License-Identifier: MIT
// l3d_read_text_file: reads a whole file of any contents.
#ifndef L3D_TOOL_2D_TEXT_FILE_H
#define L3D_TOOL_2D_TEXT_FILE_H

#include <string>

/// Reads a whole file for all readers of formats. Limits of size and time keep readers from hanging
/// or growing without end. A file may have 4 GB, a pipe or a device 256 MB. The function gives up a
/// pipe if nobody opens its other end within two seconds.
/// Errors: l3d_error(bad_input) that names the path, and the system's reason or the limit.
std::string l3d_read_text_file(const std::string& path);

#endif
