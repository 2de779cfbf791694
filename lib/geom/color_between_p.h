// SPDX-License-Identifier: MIT
// color_between: interpolates colours, as where an edge is cut.
#ifndef L3D_GEOM_COLOR_BETWEEN_P_H
#define L3D_GEOM_COLOR_BETWEEN_P_H

#include <cstdint>

namespace l3d_detail {

/// Interpolates between two encoded colours, channel by channel: a share of 0 gives the first, 1
/// the second.
/// Expects: a share of 0 to 1.
constexpr std::uint32_t color_between(std::uint32_t a, std::uint32_t b, double share) {
    std::uint32_t result = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const double from = a >> shift & 255, to = b >> shift & 255;
        result = result << 8 | static_cast<std::uint32_t>(from + (to - from) * share + 0.5);
    }
    return result;
}

} // namespace l3d_detail

#endif
