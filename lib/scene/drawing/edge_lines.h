// SPDX-License-Identifier: MIT
// l3d_edge_lines: the edges of a model as lines in space.
#ifndef L3D_SCENE_EDGE_LINES_H
#define L3D_SCENE_EDGE_LINES_H

#include "scene/patch_model.h"
#include "scene/space_curve.h"

#include <vector>

/// The lines that show a model's edges. They are the whole edges that the model's trimmed faces
/// share. If the faces share no edges, the lines run along trims, and along sides of patches that
/// are open or creased (l3d_patch_neighbours). Lines along sides lie exactly on the patches. Lines
/// along trims lie nearly on the patches.
/// Cost: as l3d_patch_neighbours.
std::vector<l3d_space_curve> l3d_edge_lines(const l3d_patch_model& model);

#endif
