// SPDX-License-Identifier: MIT
// Tells binary .stl files, which have no word of their own, from all other models.
#ifndef L3D_GEOM_FILES_STL_FILE_P_H
#define L3D_GEOM_FILES_STL_FILE_P_H

#include <string_view>

namespace l3d_detail {

/// Whether a file has the size that its number of triangles asks for. A text would have to be
/// longer than 6 GB: the bytes of its number are blanks and more, so it is at least 0x09090909.
bool is_binary_stl(std::string_view text);

/// Whether a text may be a binary .stl file with more bytes behind its triangles. Other binary
/// files may be taken for one, so this is asked last.
bool is_long_binary_stl(std::string_view text);

} // namespace l3d_detail

#endif
