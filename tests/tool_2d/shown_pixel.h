// SPDX-License-Identifier: MIT
// shown_pixel: which native pixel shows a word at a place; the slow, obvious twin of pixel_writer.
#ifndef L3D_TEST_TOOL_2D_SHOWN_PIXEL_H
#define L3D_TEST_TOOL_2D_SHOWN_PIXEL_H

#include "tool_2d/screen_info.h"

#include <array>
#include <cmath>

/// In which order the pixels of a square go up to the next level, written out.
inline constexpr std::array<std::array<int, 8>, 8> dither_order{{{0, 32, 8, 40, 2, 34, 10, 42},
                                                                 {48, 16, 56, 24, 50, 18, 58, 26},
                                                                 {12, 44, 4, 36, 14, 46, 6, 38},
                                                                 {60, 28, 52, 20, 62, 30, 54, 22},
                                                                 {3, 35, 11, 43, 1, 33, 9, 41},
                                                                 {51, 19, 59, 27, 49, 17, 57, 25},
                                                                 {15, 47, 7, 39, 13, 45, 5, 37},
                                                                 {63, 31, 55, 23, 61, 29, 53, 21}}};

/// The level that shows a channel value at a place of the picture.
inline int shown_level(int value, int levels, int x, int y) {
    const auto value_of = [&](int level) { return std::floor(level * 255.0 / (levels - 1) + 0.5); };
    if (levels == 1)
        return 0;
    if (levels == 256)
        return value; // each has a level of its own
    int below = 0;
    while (below + 2 < levels && value_of(below + 1) <= value)
        ++below;
    const double share = (value - value_of(below)) / (value_of(below + 1) - value_of(below));
    // As many of 64 pixels go up as come nearest to the share.
    const double raised = std::floor(64 * share + 0.5);
    return dither_order[static_cast<std::size_t>(y % 8)][static_cast<std::size_t>(x % 8)] < raised
               ? below + 1
               : below;
}

inline std::uint32_t shown_pixel(const l3d_screen_info& info, std::uint32_t word, int x, int y) {
    const auto channel = [&](int shift) { return static_cast<int>(word >> shift & 255); };
    if (!info.has_palette()) {
        std::uint32_t pixel = info.opaque_bits();
        int shift = 16;
        for (const l3d_channel place : {info.red(), info.green(), info.blue()}) {
            if (place.width > 8)
                return info.to_display(word);
            const int level = shown_level(channel(shift), 1 << place.width, x, y);
            pixel |= static_cast<std::uint32_t>(level) << place.shift;
            shift -= 8;
        }
        return pixel;
    }
    const auto& palette = info.palette();
    const int gray = static_cast<int>(
        std::floor((299 * channel(16) + 587 * channel(8) + 114 * channel(0)) / 1000.0 + 0.5));
    const int red = shown_level(palette.is_ramp() ? gray : channel(16), palette.red, x, y);
    const int green = shown_level(channel(8), palette.green, x, y);
    const int blue = shown_level(channel(0), palette.blue, x, y);
    const int place = (red * palette.green + green) * palette.blue + blue;
    return palette.pixels[static_cast<std::size_t>(place)];
}

#endif
