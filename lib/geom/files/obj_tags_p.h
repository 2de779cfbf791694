// SPDX-License-Identifier: MIT
// read_obj_tag: the tags of subdivision surfaces in .obj files, `t`.
#ifndef L3D_GEOM_FILES_OBJ_TAGS_P_H
#define L3D_GEOM_FILES_OBJ_TAGS_P_H

#include "geom/files/model_file.h"
#include "geom/files/text_cursor_p.h"

#include <string>

namespace l3d_detail {

/// Reads a tag of .obj after the word `t`. The tag consists of a name, three numbers such as
/// "2/1/0", and arguments. The numbers count the integers, reals and words among the arguments.
/// Vertices and faces are counted from 0. Tags with unknown names are skipped with a note.
/// Errors: false, after text.fail.
/// Source: the shape files of OpenSubdiv, whose tags other programs write, too.
bool read_obj_tag(text_cursor& text, const l3d_polygon_mesh& mesh, l3d_cage_tags& tags);

/// The lines of all tags for an .obj file. Reading these lines gives the same tags.
std::string obj_tags(const l3d_cage_tags& tags);

} // namespace l3d_detail

#endif
