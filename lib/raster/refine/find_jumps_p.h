// SPDX-License-Identifier: MIT
// find_jumps: neighbours whose levels are far apart.
#ifndef L3D_RASTER_REFINE_FIND_JUMPS_P_H
#define L3D_RASTER_REFINE_FIND_JUMPS_P_H

#include "raster/refine/pixel_bits_p.h"
#include "tool_2d/pixels.h"

#include <cstdint>

namespace l3d_detail {

/// How far two neighbours' levels must be apart in a channel for an edge between them, beyond twice
/// what steady shading explains. Half of it is what a picture may be wrong by at edges that are not
/// refined.
inline constexpr std::uint8_t jump_levels = 8;

/// What steady shading explains: the differences before and behind, as far as these go the same
/// way.
enum class jump_rule {
    any,   ///< the smaller of both: edges of facets count, too
    smooth ///< the larger: surfaces are lit so that only their contours and cuts are edges
};

/// Jumps from pixels to their neighbours: on the right, and below.
struct level_jumps {
    pixel_bits right, down;

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
void find_jumps(const l3d_pixels& picture, jump_rule rule, const l3d_pixel_box& where,
                level_jumps& jumps);

} // namespace l3d_detail

#endif
