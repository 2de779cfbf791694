// SPDX-License-Identifier: MIT
// mark_jumps: finds neighbouring pixels whose levels are far apart.
#ifndef L3D_RASTER_REFINE_DEPTH_STEPS_P_H
#define L3D_RASTER_REFINE_DEPTH_STEPS_P_H

#include "raster/pixel_bits.h"
#include "tool_2d/pixels.h"

#include <cstdint>

namespace l3d_detail {

/// The limit up to which the levels (0 to 255) of two neighbouring pixels may differ without an
/// edge between them. Differences count in each channel, less the part that shading explains. At an
/// edge that is not found, a pixel may be wrong by half of this limit.
///
/// Take the line through both pixels, and the differences from each pixel to its outer neighbour on
/// this line. Steady shading explains twice the smaller one of these differences, if they have the
/// same sign. A kink of the shading explains the larger one, up to most_kink_levels.
inline constexpr int jump_levels = 8;

/// The largest difference that a kink of the shading explains. If shading of 16 levels a pixel
/// begins in the middle of a pixel, the pixel's mean is wrong by an eighth: 2 levels.
inline constexpr int most_kink_levels = 16;

/// Finds the jumps of level, by jump_levels, from the pixels of `where` to the pixels on their
/// right and below. Marks both pixels of each jump, if they lie in `band`.
/// Expects: `where` lies inside the picture. `marks` has the picture's size.
void mark_jumps(const l3d_pixels& picture, const l3d_pixel_box& where, const l3d_pixel_box& band,
                l3d_pixel_bits& marks);

} // namespace l3d_detail

#endif
