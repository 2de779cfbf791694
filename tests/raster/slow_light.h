// SPDX-License-Identifier: MIT
// The slow, obvious twin of color_mixer: colours mixed in long double, by the curve itself.
#ifndef L3D_TESTS_RASTER_SLOW_LIGHT_H
#define L3D_TESTS_RASTER_SLOW_LIGHT_H

#include "raster/rasterizer_2d.h"

#include <cmath>
#include <cstdint>

namespace slow_light {

/// IEC 61966-2-1, of levels that need not be whole. Coded values are their own amounts.
inline long double amount(l3d_blending how, long double level) {
    if (how == l3d_blending::coded)
        return level;
    const long double at = level / 255;
    return at <= 0.04045L ? at / 12.92L : std::pow((at + 0.055L) / 1.055L, 2.4L);
}

inline long double level(l3d_blending how, long double amount) {
    if (how == l3d_blending::coded)
        return amount;
    return 255 * (amount <= 0.04045L / 12.92L ? 12.92L * amount
                                              : 1.055L * std::pow(amount, 1 / 2.4L) - 0.055L);
}

inline int channel(std::uint32_t word, int shift) {
    return static_cast<int>(word >> shift & 255);
}

} // namespace slow_light

#endif
