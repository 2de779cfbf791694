// SPDX-License-Identifier: MIT
// texture_lanes: the light of many places of a texture at once.
#ifndef L3D_RASTER_TEXTURES_TEXTURE_LANES_P_H
#define L3D_RASTER_TEXTURES_TEXTURE_LANES_P_H

#include "raster/color/linear_light_p.h"
#include "raster/textures/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The pixels of an l3d_texture in memory. Lives: borrows the texture.
struct texture_view {
    static constexpr std::size_t most_levels = 32; ///< at most 31 halvings, and the whole picture
    const std::uint16_t* pixels = nullptr;         ///< four numbers each, as in l3d_texture
    int width = 0, height = 0, levels = 0;
    l3d_texture_wrap wrap_u{}, wrap_v{};
    std::array<std::int32_t, most_levels> first{}; ///< index of the first pixel of each level
};

/// A place within two pictures from 0 where a repeated picture looks the same. At such places,
/// floats can hold fractions of its pixels.
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
    static constexpr std::size_t room = 64; ///< a multiple of the widest vector, 16
    using numbers = std::array<float, room>;

    std::size_t count = 0;
    /// The part of a texture that each pixel covers, as in l3d_texture_place.
    alignas(64) numbers u, v, u_right, v_right, u_down, v_down;
    /// The light of each pixel: at first of the surface's colour, then also of the texture.
    alignas(64) std::array<numbers, 3> light;
    alignas(64) std::array<std::uint32_t, room> words; ///< 0x00RRGGBB

    /// Sets the part of a texture that a pixel covers.
    void set(std::size_t i, const l3d_texture& of, const l3d_texture_place& place) {
        // A pixel that covers 2^33 pictures shows their mean. They have 2^60 pixels at most, whose
        // square is a float.
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

/// The tables of linear_light, laid out for lanes.
struct level_tables {
    static constexpr std::size_t guesses = linear_light::guesses;
    std::array<std::int32_t, guesses> first{}; ///< guesses of levels for lights from 0 to 1, at
                                               ///< most 2 too low
    std::array<float, 257> begins{};           ///< lights at which levels begin; the last entry is
                                               ///< never reached
    level_tables();
};

/// Multiplies each pixel's light by the light of the texture, as l3d_texture::light gives it. The
/// bits are the same on every processor.
/// Expects: finite places and steps.
void light_by_texture(const texture_view& texture, l3d_texture_filter filter,
                      painted_pixels& pixels);

/// Sets the words to the levels nearest to the light, as linear_light::level finds them.
void encode_light(painted_pixels& pixels);

/// Replaces words by colours where depths are not 0. A word's lowest byte is the level of its
/// colour, by the rule that l3d_material states.
void color_levels(std::uint32_t* words, const float* depths, const std::uint32_t* colors,
                  std::size_t count);

} // namespace l3d_detail

#endif
