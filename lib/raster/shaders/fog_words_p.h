// SPDX-License-Identifier: MIT
// fog_words: fog in front of the surfaces of a picture.
#ifndef L3D_RASTER_SHADERS_FOG_WORDS_P_H
#define L3D_RASTER_SHADERS_FOG_WORDS_P_H

#include "raster/surface_rasterizer.h"
#include "raster/shaders/material_words_p.h"

#include <cstdint>

namespace l3d_detail {

/// Puts fog before the pixels whose depth is not 0.
/// Units: `top` is the row of the picture that the first row of `pixels` is in; `height` is the
///        height of the picture.
/// Expects: final colours; fog that is on.
inline void put_fog(const l3d_shading& shading, const material_pixels& pixels, std::int32_t top,
                    std::int32_t height) {
    const l3d_fog& fog = shading.fog;
    for (std::int32_t row = 0; row < pixels.height; ++row) {
        const std::uint32_t color = fog.in_row(shading.background, top + row, height);
        std::uint32_t* const words = pixels.words + row * pixels.word_pitch;
        const float* const depths = pixels.depths + row * pixels.depth_pitch;
        for (std::int32_t x = 0; x < pixels.width; ++x)
            if (depths[x] > 0)
                words[x] = shading.fogged(words[x], color, depths[x]);
    }
}

} // namespace l3d_detail

#endif
