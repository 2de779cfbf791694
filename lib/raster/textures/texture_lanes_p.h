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
    /// The largest number of mip levels, which are the picture and its smaller copies. A width or
    /// height can be halved 31 times.
    static constexpr std::size_t most_levels = 32;
    /// The pixels of all mip levels. Each word has the square roots of the light of red, green and
    /// blue, from the highest bit on. The largest numbers stand for the light of white. Each mip
    /// level has a border of one pixel, which shows what lies beyond the level's sides.
    const std::uint32_t* texels = nullptr;
    static constexpr std::array<int, 3> bits{11, 11, 10};
    int width = 0, height = 0, levels = 0;
    l3d_texture_wrap wrap_u{}, wrap_v{};
    /// Index of each mip level's first pixel in `texels`.
    std::array<std::int32_t, most_levels> first{};

    /// The distance from row to row, in words, in a mip level of this width.
    static constexpr int pitch(int width) { return width + 2; }
};

/// Moves a place in a repeated or mirrored picture by whole periods, to a place from 0 to 2. The
/// picture looks the same at the new place. Near 0, floats can hold fractions of the picture's
/// pixels.
inline double place_near_zero(double place, l3d_texture_wrap wrap) {
    if (wrap == l3d_texture_wrap::clamp)
        return place;
    const double period = wrap == l3d_texture_wrap::mirror ? 2 : 1;
    return place - period * std::floor(place / period);
}

/// Pixels of a picture that are coloured together, with an array for each of their numbers.
///
/// Shape: elements from `count` to the next multiple of 16 are read and written, too; set them to 0
///        at first.
struct painted_pixels {
    static constexpr std::size_t most = 64;
    /// The number of elements of each array, with room for the widest vector behind the last.
    static constexpr std::size_t room = most + 16;
    template <class T> using row = std::array<T, room>;
    using numbers = row<float>;

    /// The part of a texture that each pixel covers, as in l3d_texture_place.
    alignas(64) numbers u, v, u_right, v_right, u_down, v_down;
    /// The light of each pixel: at first the light of the surface's colour, then its product with
    /// the texture's light.
    alignas(64) std::array<numbers, 3> light;
    alignas(64) row<std::uint32_t> words; ///< the colour of each pixel, 0x00RRGGBB

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

/// Neighbouring elements [begin, end) of painted_pixels.
struct pixel_range {
    std::size_t begin = 0, end = 0;
};

/// A table that turns light into levels from 0 to 255, for lanes.
///
/// A step of the table is a range of floats with the same upper 16 bits. From `least` on, a step is
/// no longer than 1/128 of its light, and levels begin at least 1/115 of their light apart. So at
/// most one level begins in a step.
struct level_steps {
    /// The light at which the table begins; it is below the light of half a level.
    static constexpr float least = 0x1p-13F;
    static constexpr int lower_bits = 16;
    /// The number of steps; the last step begins at light 1.
    static constexpr std::size_t steps = 13 * 128 + 1;
    /// An entry for each step. Its lowest byte is the level where the step begins. Its upper three
    /// bytes are a threshold: floats of this step whose lower 16 bits are at least as large belong
    /// to the next level.
    std::array<std::int32_t, steps> level{};
    level_steps();
};

/// Multiplies each pixel's light by the light of the texture, as l3d_texture::light gives it. The
/// bits are the same on every processor.
/// Expects: finite places and steps.
void light_by_texture(const texture_view& texture, l3d_texture_filter filter,
                      const pixel_range& range, painted_pixels& pixels);

/// Sets each pixel's word to the levels nearest to its light, as linear_light::level finds them.
void encode_light(const pixel_range& range, painted_pixels& pixels);

/// Stands for the name in pixels that show no polygon.
inline constexpr std::uint32_t no_name = ~std::uint32_t{0};

/// Pixels of a row, and the names (numbers of material) of the polygons that they show.
struct named_pixels {
    /// A name for each pixel; no_name also behind the last pixel.
    alignas(64) painted_pixels::row<std::uint32_t> names;
    std::size_t count = 0;
    /// The first pixel's middle, in pixels from the picture's top left corner; x rises by 1.
    double x = 0, y = 0;
};

/// Takes the pixels' names from the upper three bytes of their words; no_name where a depth is 0.
void take_names(const std::uint32_t* words, const float* depths, std::size_t count,
                named_pixels& to);

/// Replaces words by colours where depths are not 0. The lowest byte of a word is a grey level. The
/// rule of l3d_material combines this level and the pixel's colour in `colors`.
void color_levels(std::uint32_t* words, const float* depths, const std::uint32_t* colors,
                  std::size_t count);

} // namespace l3d_detail

#endif
