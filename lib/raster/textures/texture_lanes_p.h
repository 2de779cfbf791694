// SPDX-License-Identifier: MIT
// texture_lanes: looks up the light of many places of a texture at once.
#ifndef L3D_RASTER_TEXTURES_TEXTURE_LANES_P_H
#define L3D_RASTER_TEXTURES_TEXTURE_LANES_P_H

#include "raster/textures/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The pixels of an l3d_texture in memory. Lives: borrows the texture.
struct texture_view {
    /// As many as any width or height can be halved, and one more.
    static constexpr std::size_t most_levels = 32;
    /// Each word has the roots of the light of red, green and blue, from the highest bit on. The
    /// largest numbers stand for the light of level 255. A border of one pixel around each picture
    /// shows what lies beyond it.
    const std::uint32_t* texels = nullptr;
    static constexpr std::array<int, 3> bits{11, 11, 10};
    int width = 0, height = 0, levels = 0;
    l3d_texture_wrap wrap_u{}, wrap_v{};
    std::array<std::int32_t, most_levels> first{}; ///< place of a level's first pixel

    /// The distance from row to row, in words, in a level of this width.
    static constexpr int pitch(int width) { return width + 2; }
};

/// Moves a place in a repeated picture to within two pictures from 0, where the picture looks the
/// same. There, floats can hold fractions of the picture's pixels.
inline double place_near_zero(double place, l3d_texture_wrap wrap) {
    if (wrap == l3d_texture_wrap::clamp)
        return place;
    const double period = wrap == l3d_texture_wrap::mirror ? 2 : 1;
    return place - period * std::floor(place / period);
}

/// Pixels that are coloured together, with an array for each number.
///
/// Shape: elements from `count` to the next multiple of 16 are read and written, too; set them to 0
///        at first.
struct painted_pixels {
    static constexpr std::size_t most = 64;
    /// Elements, with room for the widest vector behind the last.
    static constexpr std::size_t room = most + 16;
    template <class T> using row = std::array<T, room>;
    using numbers = row<float>;

    /// Parts of a texture, as l3d_texture_place has them.
    alignas(64) numbers u, v, u_right, v_right, u_down, v_down;
    /// The light of each pixel: at first of the surface's colour, then also of the texture.
    alignas(64) std::array<numbers, 3> light;
    alignas(64) row<std::uint32_t> words; ///< 0x00RRGGBB

    /// Sets the part of a texture that a pixel covers.
    void set(std::size_t i, const l3d_texture& of, const l3d_texture_place& place) {
        // A pixel that covers 2^33 pictures shows their mean. So wide a part has 2^60 pixels at
        // most, whose square is a float.
        const auto way = [](double w) {
            return static_cast<float>(std::clamp(w, -0x1p33, 0x1p33));
        };
        u[i] = static_cast<float>(place_near_zero(place.u, of.wrap_u()));
        v[i] = static_cast<float>(place_near_zero(place.v, of.wrap_v()));
        u_right[i] = way(place.u_right);
        v_right[i] = way(place.v_right);
        u_down[i] = way(place.u_down);
        v_down[i] = way(place.v_down);
    }
};

/// Some neighbours among painted_pixels.
struct pixel_range {
    std::size_t begin = 0, end = 0;
};

/// A table that turns light into levels, for lanes.
///
/// A step is a range of floats with the same upper 16 bits. From `least` on, a step is no longer
/// than 1/128 of its light, and levels begin at least 1/115 of their light apart. So at most one
/// level begins in a step.
struct level_steps {
    static constexpr float least = 0x1p-13F; ///< less than half a level
    static constexpr int lower_bits = 16;
    static constexpr std::size_t steps = 13 * 128 + 1; ///< the last one is 1
    /// The lowest byte is the level where the step begins. The upper bytes are the least lower bits
    /// of a float in this step that belong to the next level.
    std::array<std::int32_t, steps> level{};
    level_steps();
};

/// Multiplies each pixel's light by the light of the texture, as l3d_texture::light gives it. The
/// bits are the same on every processor.
/// Expects: finite places and steps.
void light_by_texture(const texture_view& texture, l3d_texture_filter filter,
                      const pixel_range& range, painted_pixels& pixels);

/// The words of the nearest levels of the light, as linear_light::level finds them.
void encode_light(const pixel_range& range, painted_pixels& pixels);

/// The name of a pixel that shows no polygon.
inline constexpr std::uint32_t no_name = ~std::uint32_t{0};

/// Pixels of a row, the names of the polygons that they show, and their places.
struct named_pixels {
    alignas(64) painted_pixels::row<std::uint32_t> names; ///< no_name behind the last pixel, too
    std::size_t count = 0;
    double x = 0, y = 0; ///< place of the first one; the others follow by 1
};

/// Takes the names from the upper three bytes of words; no_name where a depth is 0.
void take_names(const std::uint32_t* words, const float* depths, std::size_t count,
                named_pixels& to);

/// Replaces words by colours where depths are not 0. A word's lowest byte is the level of its
/// colour, by the rule that l3d_material states.
void color_levels(std::uint32_t* words, const float* depths, const std::uint32_t* colors,
                  std::size_t count);

} // namespace l3d_detail

#endif
