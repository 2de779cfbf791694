// SPDX-License-Identifier: MIT
// depth_steps: neighbours whose levels are far apart.
#ifndef L3D_RASTER_REFINE_DEPTH_STEPS_P_H
#define L3D_RASTER_REFINE_DEPTH_STEPS_P_H

#include "raster/pixel_bits.h"
#include "tool_2d/pixels.h"

#include <cstdint>

namespace l3d_detail {

/// The difference of two neighbours' levels in a channel that makes an edge between them, beyond
/// the part that shading explains. A picture may be wrong by half of it at edges that are not
/// refined.
///
/// Steady shading explains twice the smaller of the differences before and behind, as far as these
/// go the same way. A kink explains the larger of them.
inline constexpr int jump_levels = 8;

/// The largest difference that a kink explains. Where shading of 16 levels a pixel begins in a
/// pixel's middle, the mean is an eighth of it off, 2 levels.
inline constexpr int most_kink_levels = 16;

/// Jumps from pixels to their neighbours: on the right, and below.
struct level_jumps {
    l3d_pixel_bits right, down;

    void resize(l3d_size size) {
        right.resize(size);
        down.resize(size);
    }
    void clear(std::int32_t top, std::int32_t bottom) {
        right.clear(top, bottom);
        down.clear(top, bottom);
    }
};

/// Finds the jumps of the pixels of `where`.
/// Expects: `where` lies inside the picture; all have the same size; the rows' bits are clear.
void depth_steps(const l3d_pixels& picture, const l3d_pixel_box& where, level_jumps& jumps);

} // namespace l3d_detail

#endif
