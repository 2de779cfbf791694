// SPDX-License-Identifier: MIT
// facing: which side of a polygon is seen.
#ifndef L3D_RASTER_FACING_P_H
#define L3D_RASTER_FACING_P_H

#include "raster/micro_grid.h"
#include "raster/surface_rasterizer.h"

#include <cstddef>
#include <span>

namespace l3d_detail {

/// 1 if a polygon's normals point to the eye, -1 if they are to be turned round.
///
/// All corners vote, each by the length of its normal towards the eye. The polygon's own
/// orientation in the picture would not do: where a surface bends away, and in the slivers that
/// close slits, it is chance.
inline float facing(std::span<const l3d_micro_vertex> corners, const l3d_shading& shading) {
    float away = 0;
    for (const l3d_micro_vertex& corner : corners) {
        const float x = static_cast<float>(corner.x) / l3d_subpixel_one;
        const float y = static_cast<float>(corner.y) / l3d_subpixel_one;
        for (std::size_t i = 0; i < 3; ++i)
            away += corner.normal[i] *
                    (shading.ray[i] + x * shading.ray_right[i] + y * shading.ray_down[i]);
    }
    return away > 0 ? -1.0f : 1.0f;
}

} // namespace l3d_detail

#endif
