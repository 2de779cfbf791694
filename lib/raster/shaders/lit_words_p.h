// SPDX-License-Identifier: MIT
// lit_words: from normals to lit pixels, when a picture's surfaces are filled.
#ifndef L3D_RASTER_SHADERS_LIT_WORDS_P_H
#define L3D_RASTER_SHADERS_LIT_WORDS_P_H

#include "geom/material.h"
#include "raster/surface_rasterizer.h"
#include "raster/shaders/lit_shader_p.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Some pixels of a picture, their depths and normals. Pitches in elements.
struct lit_pixels {
    std::uint32_t* words;
    std::ptrdiff_t word_pitch;
    const float* depths;
    const std::uint32_t* normals;
    std::ptrdiff_t depth_pitch; ///< it is the pitch of normals, too
    std::int32_t left, top;     ///< the first pixel's place in the picture
    std::int32_t width, height;
    /// Those of a single row's pixels, where materials do not say them.
    const std::uint32_t* colors = nullptr;
};

/// The materials of a frame whose lanes leave normals. Lives: kept for its memory.
class lit_words {
public:
    /// Expects: at most fill_words::most_lit_materials. Lives: borrows both for the frame.
    void begin(const l3d_shading& shading, std::span<const l3d_material> materials) {
        shading_ = &shading;
        frame_materials_ = materials;
        materials_.clear();
        for (const l3d_material& material : materials)
            materials_.emplace_back(material);
        if (materials.empty())
            materials_.emplace_back(l3d_material());
    }

    /// Lights the pixels whose depth is not 0: nothing was filled elsewhere. The same bits as
    /// lit_shader, for the normals that the words tell. A pixel costs some 20 operations for each
    /// light and 80 more, in lanes.
    void color(const lit_pixels& pixels) const;

    /// The same by lit_shader. The slow twin.
    void color_slowly(const lit_pixels& pixels) const;

private:
    const l3d_shading* shading_ = nullptr;
    std::span<const l3d_material> frame_materials_;
    std::vector<lit_material> materials_;
};

} // namespace l3d_detail

#endif
