// SPDX-License-Identifier: MIT
// lit_words: lights the normals in pixels, once a picture's surfaces are filled.
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

/// A rectangle of a picture: its words, depths and normals. Units: pitches in elements.
struct lit_pixels {
    std::uint32_t* words;
    std::ptrdiff_t word_pitch;
    const float* depths;
    const std::uint32_t* normals;
    /// The distance between rows in `depths` and in `normals`.
    std::ptrdiff_t depth_pitch;
    std::int32_t left, top; ///< column and row of the rectangle's first pixel in the picture
    std::int32_t width, height;
    /// A colour for each pixel, in place of the materials' colours; null: the materials' colours
    /// are used. Expects: null, or a rectangle with a single row.
    const std::uint32_t* colors = nullptr;
};

/// Lights the pixels of a frame whose normals were kept in words. Lives: keep the object from frame
/// to frame, since it keeps its memory.
class lit_words {
public:
    /// Sets the shading and the materials of a frame.
    /// Expects: at most fill_words::most_lit_materials.
    /// Lives: borrows shading and materials for the frame.
    void begin(const l3d_shading& shading, std::span<const l3d_material> materials) {
        shading_ = &shading;
        frame_materials_ = materials;
        materials_.clear();
        for (const l3d_material& material : materials)
            materials_.emplace_back(material);
        if (materials.empty())
            materials_.emplace_back(l3d_material());
    }

    /// Lights all pixels with a depth other than 0; other pixels are empty. The results have the
    /// same bits as lit_shader's results for the normals that the words hold. A pixel costs some 20
    /// operations for each light and 80 more, in lanes.
    void color(const lit_pixels& pixels) const;

    /// Lights pixel by pixel with lit_shader, as the slow twin of color().
    void color_slowly(const lit_pixels& pixels) const;

private:
    const l3d_shading* shading_ = nullptr;
    std::span<const l3d_material> frame_materials_;
    std::vector<lit_material> materials_;
};

} // namespace l3d_detail

#endif
