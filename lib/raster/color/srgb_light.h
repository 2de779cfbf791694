// SPDX-License-Identifier: MIT
// Levels of a picture and the linear light that they stand for, by the sRGB curve.
#ifndef L3D_RASTER_COLOR_SRGB_LIGHT_H
#define L3D_RASTER_COLOR_SRGB_LIGHT_H

#include <algorithm>
#include <cmath>

/// The light of a level; level 255 has light 1. The curve is convex, also above 255.
/// Units:  levels of 255, at least 0.
/// Source: IEC 61966-2-1.
inline double l3d_light_of_level(double level) {
    const double at = level / 255;
    return at <= 0.04045 ? at / 12.92 : std::pow((at + 0.055) / 1.055, 2.4);
}

/// The inverse of l3d_light_of_level, for lights from 0 to 1.
inline double l3d_level_of_light(double light) {
    const double at = std::clamp(light, 0.0, 1.0);
    return 255 * (at <= 0.0031308 ? 12.92 * at : 1.055 * std::pow(at, 1 / 2.4) - 0.055);
}

#endif
