// SPDX-License-Identifier: MIT
// l3d_color: how programs write a colour.
#ifndef L3D_BASE_COLOR_H
#define L3D_BASE_COLOR_H

#include "base/public.h"

#include <algorithm>
#include <cstdint>

/// A colour in the form that the pixels of every picture have.
/// Units:   0x00RRGGBB, encoded as sRGB. In pictures without background, the highest byte is a
///          transparency; see l3d_pixels.
using l3d_color = std::uint32_t;

/// The colour with these levels of red, green and blue.
/// Units: levels from 0 to 255; values outside of this range are clamped.
constexpr l3d_color l3d_rgb(int red, int green, int blue) {
    const auto level = [](int value) { return static_cast<l3d_color>(std::clamp(value, 0, 255)); };
    return level(red) << 16 | level(green) << 8 | level(blue);
}

#endif
