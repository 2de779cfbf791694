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

/// Where the pixels of an l3d_texture are. Lives: borrows the texture.
struct texture_view {
    static constexpr std::size_t most_levels = 32; ///< halvings of any width or height, and one
    const std::uint16_t* pixels = nullptr;         ///< four numbers each, as l3d_texture has them
    int width = 0, height = 0, levels = 0;
    l3d_texture_wrap wrap_u{}, wrap_v{};
    std::array<std::int32_t, most_levels> first{}; ///< place of a level's first pixel
};

/// The place where a picture that repeats shows the same, less than two pictures from 0: floats
/// hold fractions of its pixels there.
inline double place_near_zero(double place, l3d_texture_wrap wrap) {
    if (wrap == l3d_texture_wrap::clamp)
        return place;
    const double period = wrap == l3d_texture_wrap::mirror ? 2 : 1;
    return place - period * std::floor(place / period);
}

/// Pixels that are coloured together, each number an array.
///
/// Shape: elements from `count` to the next multiple of 16 are read and written, too: make them 0
///        at first.
struct painted_pixels {
    static constexpr std::size_t room = 64; ///< a multiple of the widest vector, 16
    using numbers = std::array<float, room>;

    std::size_t count = 0;
    /// Parts of a texture, as l3d_texture_place has them.
    alignas(64) numbers u, v, u_right, v_right, u_down, v_down;
    /// Light of the surface: of its colour, and then also of the texture.
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

/// The tables of linear_light, for lanes.
struct level_tables {
    static constexpr std::size_t guesses = linear_light::guesses;
    std::array<std::int32_t, guesses> first{}; ///< levels of light from 0 to 1, or up to 2 less
    std::array<float, 257> begins{};           ///< where levels begin; the last one never does
    level_tables();
};

/// Multiplies the light by that of the texture at the places, as l3d_texture::light says. The same
/// bits on every processor.
/// Expects: finite places and ways.
void light_by_texture(const texture_view& texture, l3d_texture_filter filter,
                      painted_pixels& pixels);

/// The words of the nearest levels of the light, as linear_light::level finds them.
void encode_light(painted_pixels& pixels);

/// Makes words whose lowest bytes are levels to these levels of colours, by the rule that
/// l3d_material states, where depths are not 0.
void color_levels(std::uint32_t* words, const float* depths, const std::uint32_t* colors,
                  std::size_t count);

} // namespace l3d_detail

#endif
