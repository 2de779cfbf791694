// SPDX-License-Identifier: MIT
// Tells binary .stl files, which begin with no keyword, from all other models.
#ifndef L3D_GEOM_FILES_STL_FILE_P_H
#define L3D_GEOM_FILES_STL_FILE_P_H

#include <string_view>

namespace l3d_detail {

/// Whether a file is a binary .stl: its size agrees with its number of triangles, or its header
/// begins with "solid" and holds a zero byte. A text below 7 GB never has a size that agrees. Its
/// bytes are 9 (a tab) or more, so the number of triangles would be at least 0x09090909.
bool is_binary_stl(std::string_view text);

/// Whether a file may be a binary .stl with more bytes behind its triangles. Files of other binary
/// formats may seem to be one, so call this after all other tests.
bool is_long_binary_stl(std::string_view text);

} // namespace l3d_detail

#endif
