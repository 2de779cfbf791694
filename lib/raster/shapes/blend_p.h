// SPDX-License-Identifier: MIT
// blended: moves a word towards a colour.
#ifndef L3D_RASTER_SHAPES_BLEND_P_H
#define L3D_RASTER_SHAPES_BLEND_P_H

#include <cstdint>
#include <initializer_list>

namespace l3d_detail {

/// Blends a word's three lower bytes with a colour's: each byte moves by coverage / 255 of its
/// difference from the colour's byte, rounded to the nearest.
///
/// Red and blue share one number, 16 bits each, as sums stay below 2^16. A division t / 255 is (t +
/// 1 + t / 256) / 256, where each quotient is rounded down.
inline std::uint32_t blended(std::uint32_t word, std::uint32_t color, int coverage) {
    constexpr std::uint32_t two = 0x00ff00ff;
    const auto to = static_cast<std::uint32_t>(coverage), from = 255 - to;
    const std::uint32_t even = (word & two) * from + (color & two) * to + 0x007f007f;
    const std::uint32_t odd = (word >> 8 & 255) * from + (color >> 8 & 255) * to + 127;
    return (word & 0xff000000) | ((even + 0x00010001 + (even >> 8 & two)) >> 8 & two) |
           ((odd + 1 + (odd >> 8)) & 0x0000ff00);
}

/// Blends a word that may be transparent: each colour is weighted by its share of the pixel.
inline std::uint32_t blended_over_gap(std::uint32_t word, std::uint32_t color, int coverage) {
    if (word >> 24 == 0)
        return blended(word, color, coverage);
    const int of_color = 255 * coverage;
    const int of_word = (255 - coverage) * (255 - static_cast<int>(word >> 24));
    const int sum = of_color + of_word; // not 0, as something is covered
    std::uint32_t result = static_cast<std::uint32_t>(255 - (sum + 127) / 255) << 24;
    for (const int shift : {0, 8, 16}) {
        const int from = static_cast<int>(word >> shift & 255);
        const int to = static_cast<int>(color >> shift & 255);
        result |= static_cast<std::uint32_t>((from * of_word + to * of_color + sum / 2) / sum)
                  << shift;
    }
    return result;
}

/// A share of a pixel times the opaque part of its word, rounded to the nearest. Units: 1/255.
inline int share_of(std::uint32_t word, int share) {
    const int opacity = 255 - static_cast<int>(word >> 24);
    return (share * opacity + 127) / 255;
}

} // namespace l3d_detail

#endif
