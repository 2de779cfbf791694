// SPDX-License-Identifier: MIT
// fill_pieces: what becomes of polygons that a lane cannot take as they are.
#ifndef L3D_RASTER_SURFACES_FILL_PIECES_P_H
#define L3D_RASTER_SURFACES_FILL_PIECES_P_H

#include "raster/surfaces/fill_kernel_p.h"

#include <cstddef>

namespace l3d_detail {

/// Queues the pieces of a folded or skew quad, cut as by surface_fill; or puts a polygon to the
/// rest. Expects: polygon i of the queue is folded or skew if `in_pieces` and it is a quad.
void fill_put_by(const fill_target& to, std::size_t i, bool in_pieces);

} // namespace l3d_detail

#endif
