// SPDX-License-Identifier: MIT
// l3d_material: the properties of a surface that matter to light.
#ifndef L3D_GEOM_MATERIAL_H
#define L3D_GEOM_MATERIAL_H

#include "base/color.h"
#include "base/public.h"

#include <cstddef>
#include <cstdint>

/// The look of a surface: its colour, highlights, opacity and picture.
///
/// Units: colours are pixel words 0x00RRGGBB, encoded as sRGB. Where a white surface would show the
///        grey g, 0 to 255, a channel of colour c shows round(c g / 255).
struct L3D_PUBLIC l3d_material {
    l3d_color color = 0xffffff; ///< colour of light that is scattered to all sides
    l3d_color highlight = 0;    ///< colour of mirrored light; black mirrors none
    /// The sharpness of highlights: the exponent of their cosine, from 1 to most_sharpness.
    int sharpness = 32;

    /// The opacity, from 0 for invisible to 1 for opaque. An instance is transparent as a whole, so
    /// l3d_patch_scene::add_by_opacity() makes one instance for each opacity.
    float opacity = 1;

    static constexpr int most_sharpness = 1000; ///< the largest sharpness, as in .mtl files

    /// The index of the picture in l3d_polygon_mesh::pictures that is laid on the surface, or
    /// no_picture. The picture's light is multiplied by that of `color`. Patches have no picture.
    int picture = no_picture;

    static constexpr int no_picture = -1; ///< the value of `picture` that stands for none

    /// Whether a surface with this material looks like one without any material.
    bool is_plain() const {
        return color == 0xffffff && highlight == 0 && opacity == 1 && picture == no_picture;
    }

    friend bool operator==(const l3d_material&, const l3d_material&) = default;
};

/// The product of two encoded colours, channel by channel: white leaves the other colour as it is.
constexpr l3d_color l3d_product_of_colors(l3d_color a, l3d_color b) {
    std::uint32_t result = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        result = result << 8 | ((a >> shift & 255) * (b >> shift & 255) + 127) / 255;
    return result;
}

#endif
