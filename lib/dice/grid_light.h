// SPDX-License-Identifier: MIT
// Lights vertices one after the other: turns normals to the eye, or makes levels of them.
#ifndef L3D_DICE_GRID_LIGHT_H
#define L3D_DICE_GRID_LIGHT_H

#include "geom/normal_net.h"
#include "scene/dice_view.h"
#include "dice/diced_piece.h"

#include <array>
#include <vector>

/// Brings a normal to unit length. A zero normal stays zero.
void l3d_make_unit(float (&normal)[3]);

/// Lights a vertex. If the view makes levels, the vertex' unit normal is replaced by its shade
/// level, without bends. Returns whether the normal points away from the eye; the caller then has
/// to negate the numbers in `normal`.
///
/// Shape: h is the homogeneous vertex, before the division; it may be behind the eye.
bool l3d_light_vertex(const l3d_dice_view& view, const l3d_image_point& h, float (&normal)[3]);

/// Lights a piece's grid. Turns the grid's normals to the visible side, or replaces the normals by
/// shade levels and bends. Each level is evaluated by itself. This function is the slow twin of
/// l3d_detail::levels_in_lanes.
///
/// Expects: the grid's places, unit normals and parameters are written.
/// Cost:    allocates only if `memory` is too small; the caller keeps it from piece to piece.
void l3d_light_grid(const l3d_dice_view& view, const l3d_normal_net& normals,
                    l3d_diced_piece& piece, std::array<std::vector<float>, 2>& memory);

#endif
