// SPDX-License-Identifier: MIT
// The light of vertices, one after the other: normals turned to the eye, or levels.
#ifndef L3D_DICE_GRID_LIGHT_H
#define L3D_DICE_GRID_LIGHT_H

#include "geom/normal_net.h"
#include "scene/dice_view.h"
#include "dice/diced_piece.h"

#include <array>
#include <vector>

/// Brings a normal to unit length; a zero normal stays.
void l3d_make_unit(float (&normal)[3]);

/// Replaces a vertex's unit normal by its level without bends, if levels are wanted. Returns
/// whether the normal points away from the eye, so that the result has to be negated.
///
/// Shape: h is the vertex before the division; it may be behind the eye.
bool l3d_light_vertex(const l3d_dice_view& view, const l3d_image_point& h, float (&normal)[3]);

/// Turns the normals of a piece's grid to the side that is seen, or replaces them by levels and
/// bends that are evaluated one by one. The slow twin of l3d_detail::levels_in_lanes.
///
/// Expects: the grid's places, unit normals and parameters are there.
/// Cost:    `memory` is kept from piece to piece.
void l3d_light_grid(const l3d_dice_view& view, const l3d_normal_net& normals,
                    l3d_diced_piece& piece, std::array<std::vector<float>, 2>& memory);

#endif
