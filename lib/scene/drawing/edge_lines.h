// SPDX-License-Identifier: MIT
// l3d_edge_lines: the edges of a model as lines in space.
#ifndef L3D_SCENE_EDGE_LINES_H
#define L3D_SCENE_EDGE_LINES_H

#include "scene/patch_model.h"
#include "scene/space_curve.h"

#include <vector>

/// The edges that a model's trimmed faces share, whole. A model without such edges has lines where
/// its patches are open or creased (l3d_patch_neighbours), and where trims end them. These lie on
/// the patches, those of trims nearly so.
/// Cost: as l3d_patch_neighbours.
std::vector<l3d_space_curve> l3d_edge_lines(const l3d_patch_model& model);

#endif
