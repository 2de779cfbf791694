// SPDX-License-Identifier: MIT
// material_words: turns levels of materials into colours, once a picture is filled.
#ifndef L3D_RASTER_SHADERS_MATERIAL_WORDS_P_H
#define L3D_RASTER_SHADERS_MATERIAL_WORDS_P_H

#include "geom/material.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// The words and depths of a rectangle of a picture. Units: pitches in elements.
struct material_pixels {
    std::uint32_t* words;
    std::ptrdiff_t word_pitch;
    const float* depths;
    std::ptrdiff_t depth_pitch;
    std::int32_t width, height;
};

/// The colour of a material's surface at a grey level, by the rule that l3d_material states.
inline std::uint32_t color_of_level(std::uint32_t color, std::uint32_t level) {
    return l3d_product_of_colors(color, level * 0x010101);
}

/// Replaces the levels of a frame's materials by colours, after all polygons are filled. Lives:
/// keep the object from frame to frame, since it keeps its memory.
class material_words {
public:
    void begin(std::span<const l3d_material> materials) {
        colors_.clear();
        for (const l3d_material& material : materials)
            colors_.push_back(material.color);
    }

    /// The colour of each material.
    std::span<const std::uint32_t> colors() const { return colors_; }

    /// Whether the frame's words are levels of materials, which are to be replaced by colours.
    bool wanted() const { return !colors_.empty(); }

    /// Replaces words that are levels of materials (fill_words) by colours. Pixels with depth 0 are
    /// empty, and stay as they are.
    void color(const material_pixels& pixels) const;

    /// Colours pixel by pixel, as the slow twin of color().
    void color_slowly(const material_pixels& pixels) const;

private:
    std::vector<std::uint32_t> colors_;
};

} // namespace l3d_detail

#endif
