// SPDX-License-Identifier: MIT
// mark_jumps: pixels whose level is far from a neighbour's.
#ifndef L3D_RASTER_REFINE_MARK_JUMPS_P_H
#define L3D_RASTER_REFINE_MARK_JUMPS_P_H

#include "raster/refine/pixel_bits_p.h"
#include "tool_2d/pixels.h"

#include <cstdint>

namespace l3d_detail {

/// How far two neighbours' levels must be apart in a channel for an edge between them, beyond twice
/// what steady shading explains. Half of it is what a picture may be wrong by at edges that are not
/// refined.
inline constexpr std::uint8_t jump_levels = 8;

/// Sets the bits of the pixels of `where` on both sides of jumps to the pixel above, below, left or
/// right of them. A straight edge that enters a pixel's square passes between its centre and that
/// of one of these four neighbours, or nearly so. Steady shading explains twice the smaller of the
/// differences before and behind, as far as these go the same way.
/// Expects: `where` lies inside the picture; picture and bits have the same size.
void mark_jumps(const l3d_pixels& picture, const l3d_pixel_box& where, pixel_bits& bits);

} // namespace l3d_detail

#endif
