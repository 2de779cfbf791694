// SPDX-License-Identifier: MIT
// away_from_eye: tells which side of a surface is seen.
#ifndef L3D_RASTER_SURFACES_AWAY_FROM_EYE_P_H
#define L3D_RASTER_SURFACES_AWAY_FROM_EYE_P_H

#include "raster/surface_part.h"
#include "raster/surface_rasterizer.h"

#include <cstddef>

namespace l3d_detail {

/// The product of a normal with the ray from the eye. It is positive if the normal points away from
/// the eye. Then the normal must be turned to the eye.
///
/// The product is interpolated like the normal itself. The polygon's orientation in the picture
/// would not do in place of the product. This orientation is arbitrary where a surface bends away,
/// and in the slivers that close slits.
inline float away_from_eye(const l3d_micro_vertex& vertex, const l3d_shading& shading) {
    const float x = static_cast<float>(vertex.x) / l3d_subpixel_one;
    const float y = static_cast<float>(vertex.y) / l3d_subpixel_one;
    float away = 0;
    for (std::size_t i = 0; i < 3; ++i)
        away += vertex.normal[i] *
                (shading.ray[i] + x * shading.ray_right[i] + y * shading.ray_down[i]);
    return away;
}

} // namespace l3d_detail

#endif
