// SPDX-License-Identifier: MIT
// l3d_background and l3d_fog: the picture's colours where no surface is, and those that far
// surfaces fade to.
#ifndef L3D_RASTER_BACKGROUND_H
#define L3D_RASTER_BACKGROUND_H

#include "base/color.h"
#include "base/public.h"
#include "tool_2d/pixels.h"
#include "tool_2d/screen_info.h"

#include <algorithm>
#include <cstdint>
#include <optional>

/// The bits that make a pixel word transparent by this share. They are the word's highest byte: 255
/// times the share, rounded.
/// Expects: a share from 0 to 1.
inline std::uint32_t l3d_transparency_of(float share) {
    return static_cast<std::uint32_t>(255 * share + 0.5f) << 24;
}

/// The background of a picture: one colour, two colours that pass into each other from top to
/// bottom, or nothing. By default it is black.
///
/// Each row has one colour. So a pixel's background is the same whether a frame draws the whole
/// picture or a part of it.
struct L3D_PUBLIC l3d_background {
    std::uint32_t top = 0;    ///< the pixel word of the first row
    std::uint32_t bottom = 0; ///< the pixel word of the last row

    /// A background of one colour. Units: 0x00RRGGBB.
    static constexpr l3d_background color(std::uint32_t word) { return {word, word}; }

    /// A quiet bluish background, darker above. Even dark grey surfaces stand out from its hue.
    static constexpr l3d_background gradient() { return {0x00333b46, 0x00707a86}; }

    /// No background: its pixel words are l3d_pixels::transparent, and a PNG gets an alpha channel.
    static constexpr l3d_background none() { return color(l3d_pixels::transparent); }

    /// Whether this is the background of none(): nothing is behind the surfaces.
    constexpr bool is_none() const { return top == l3d_pixels::transparent; }

    /// Whether red, green and blue are equal in each row.
    constexpr bool is_grey() const { return is_grey(top) && is_grey(bottom); }

    /// The background's pixel word in a row, if the picture has this height. Each channel changes
    /// linearly from the first to the last row, and is rounded to the nearest level.
    /// Expects: 0 <= row < height.
    constexpr std::uint32_t word(int row, int height) const {
        if (top == bottom)
            return top;
        const std::int64_t last = height > 1 ? height - 1 : 1;
        std::uint32_t result = 0;
        for (int shift = 0; shift < 32; shift += 8) {
            const std::int64_t from = top >> shift & 255, to = bottom >> shift & 255;
            const std::int64_t sum = from * (last - row) + to * row;
            result |= static_cast<std::uint32_t>((2 * sum + last) / (2 * last)) << shift;
        }
        return result;
    }

    /// Fills a box of a picture with this background. Expects: the box lies in the picture.
    void fill(const l3d_pixels& picture, const l3d_pixel_box& box) const {
        for (int row = box.top; row < box.bottom; ++row)
            std::ranges::fill(l3d_row(picture, row, box), word(row, picture.height));
    }
    /// Fills a picture with this background.
    void fill(const l3d_pixels& picture) const { fill(picture, l3d_whole(picture.size())); }

    friend bool operator==(const l3d_background&, const l3d_background&) = default;

private:
    static constexpr bool is_grey(std::uint32_t word) {
        return (word >> 16 & 255) == (word & 255) && (word >> 8 & 255) == (word & 255);
    }
};

/// Fog, or depth cueing if its colour is black. Surfaces nearer than `from` look as without fog;
/// surfaces at `to` and beyond have the fog's colour. Between these distances, fog grows linearly.
/// By default there is no fog.
///
/// Units: distances along the view axis, in world units.
struct L3D_PUBLIC l3d_fog {
    float from = 0; ///< distance at which fog begins
    float to = 0;   ///< distance at which fog hides everything
    /// The fog's pixel word. Without a word, fog has the background's colour in each row.
    std::optional<l3d_color> color{};

    /// Whether there is any fog.
    bool is_on() const { return to > from; }

    /// The amount of fog between the eye and a surface, from 0 to 255. Expects: is_on().
    std::uint32_t amount(float distance) const {
        const float share = (distance - from) / (to - from);
        const float held = share > 0 ? (share < 1 ? share : 1.0F) : 0.0F;
        return static_cast<std::uint32_t>(255 * held + 0.5F);
    }

    /// The colour of a surface behind fog: in each channel, the mean of the surface's and the fog's
    /// colour, weighted by the amount of fog.
    /// Units: pixel words without transparency; the amount from 0 to 255.
    static std::uint32_t word(std::uint32_t surface, std::uint32_t fog, std::uint32_t amount) {
        return l3d_screen_info::light_native(surface, 255 - amount) +
               l3d_screen_info::light_native(fog, amount);
    }

    /// The fog's colour in a row, if the picture has this height.
    std::uint32_t in_row(const l3d_background& background, int row, int height) const {
        return color ? *color : background.word(row, height);
    }

    friend bool operator==(const l3d_fog&, const l3d_fog&) = default;
};

#endif
