// SPDX-License-Identifier: MIT
// The note of a model file whose lines and curves are not drawn.
#ifndef L3D_SCENE_LOST_LINES_P_H
#define L3D_SCENE_LOST_LINES_P_H

#include "base/printable_p.h"
#include "geom/files/model_file.h"

#include <string>
#include <vector>

namespace l3d_detail {

/// Adds a note that a file's lines and curves are not drawn, if the file has any. The note ends
/// with "they are ", then `reason`.
inline void note_lost_lines(const l3d_model_file& file, const std::string& name,
                            const std::string& reason, std::vector<std::string>& notes) {
    if (!file.curves.empty())
        notes.push_back(printable(name) + ": lines and curves are not drawn: they are " + reason);
}

/// Adds the note of note_lost_lines for a file that is drawn as polygons. A file without surfaces
/// gets no note here, since l3d_load_model has added one.
inline void note_lines_lost_to_polygons(const l3d_model_file& file, const std::string& name,
                                        std::vector<std::string>& notes) {
    if (!file.patches.empty())
        note_lost_lines(file, name, "only beside surfaces that do not become polygons", notes);
}

} // namespace l3d_detail

#endif
