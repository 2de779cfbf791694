// SPDX-License-Identifier: MIT
// mesh_borders: patches that share a border take the same steps along it.
#ifndef L3D_RASTER_PATHS_MESH_BORDERS_P_H
#define L3D_RASTER_PATHS_MESH_BORDERS_P_H

#include "raster/paths/mesh_steps_p.h"

#include <span>

namespace l3d_detail {

/// Lets patches whose borders have the same four control points take as many steps along them as
/// each of them needs. So do the opposite borders, and the patches that share them.
/// Expects: a dicing for each patch.
void agree_on_borders(std::span<const l3d_mesh_patch> patches, std::span<mesh_dicing> dicings);

} // namespace l3d_detail

#endif
