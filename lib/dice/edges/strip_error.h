// SPDX-License-Identifier: MIT
// l3d_strip_error: how far a strip may be from the edge at which it ends.
#ifndef L3D_DICE_EDGES_STRIP_ERROR_H
#define L3D_DICE_EDGES_STRIP_ERROR_H

#include "dice/edges/shared_polylines.h"

/// The largest distance from an edge of the points of a strip that the picture may show.
///
/// It is measured at the drawn corners, and holds wherever these are (docs/NUMERICS.md, section
/// 27). It is infinite if a corner cannot be drawn.
/// Shape: the strip lies between a b and the polyline's points `first` to `last`.
l3d_drawn_distance l3d_strip_error(const l3d_shared_polyline& line, std::size_t first,
                                   std::size_t last, const l3d_clip_vertex& a,
                                   const l3d_clip_vertex& b, const l3d_dice_view& view);

#endif
