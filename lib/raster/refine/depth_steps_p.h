// SPDX-License-Identifier: MIT
// mark_jumps: finds neighbouring pixels whose levels are far apart.
#ifndef L3D_RASTER_REFINE_DEPTH_STEPS_P_H
#define L3D_RASTER_REFINE_DEPTH_STEPS_P_H

#include "raster/pixel_bits.h"
#include "tool_2d/pixels.h"

#include <cstdint>

namespace l3d_detail {

/// The least difference between two neighbours' levels that makes an edge between them. It counts
/// in any channel, without the part that shading explains. At edges that are not refined, a picture
/// may be wrong by half of this.
///
/// Steady shading explains twice the smaller one of the differences before and behind, if they have
/// the same sign. A kink of the shading explains the larger one.
inline constexpr int jump_levels = 8;

/// The largest difference that a kink of the shading explains. If shading of 16 levels a pixel
/// begins in the middle of a pixel, the pixel's mean is wrong by an eighth: 2 levels.
inline constexpr int most_kink_levels = 16;

/// Finds the jumps of level from the pixels of `where` to those on their right and below. Marks
/// both pixels of each jump, if they lie in `band`.
/// Expects: `where` lies inside the picture. Marks have its size.
void mark_jumps(const l3d_pixels& picture, const l3d_pixel_box& where, const l3d_pixel_box& band,
                l3d_pixel_bits& marks);

} // namespace l3d_detail

#endif
