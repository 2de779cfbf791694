// SPDX-License-Identifier: MIT
// l3d_note_outline_edge: the edges at which a piece of surface ends.
#ifndef L3D_DICE_EDGES_OUTLINE_EDGES_H
#define L3D_DICE_EDGES_OUTLINE_EDGES_H

#include "dice/diced_piece.h"
#include "dice/edges/edge_polyline.h"

#include <cstddef>

/// Adds the stretch of an edge from t0 to t1 to the part's border, beside the quads of the grid's
/// side that have the same parameters in the middle. Triangles between grid and edge count as these
/// quads do. An edge that reaches behind the near plane counts as far as it lies before the plane.
/// Expects: as l3d_close_side or l3d_fill_gap, which came before.
/// Cost:    some 5 ns a point.
void l3d_note_outline_edge(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge,
                           const l3d_dice_view& view, double t0 = 0, double t1 = 1);

#endif
