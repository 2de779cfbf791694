// SPDX-License-Identifier: MIT
// l3d_light_bounds: least and most light of each channel.
#ifndef L3D_DICE_CERTIFICATE_LIGHT_BOUNDS_H
#define L3D_DICE_CERTIFICATE_LIGHT_BOUNDS_H

#include "raster/color/srgb_light.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

/// A colour as parts of white, red first.
using l3d_color_parts = std::array<double, 3>;

/// The colour of a pixel word as parts of white.
inline l3d_color_parts l3d_parts_of(std::uint32_t word) {
    return {(word >> 16 & 0xff) / 255.0, (word >> 8 & 0xff) / 255.0, (word & 0xff) / 255.0};
}

/// Bounds of the light in each colour channel, for a pixel or a part of a pixel. Units: linear
/// light from 0 to 1; red first.
struct l3d_light_bounds {
    std::array<double, 3> least{}, most{};

    static l3d_light_bounds none() { return {}; }
    static l3d_light_bounds any() { return {{0, 0, 0}, {1, 1, 1}}; }

    /// Makes bounds by calling of(part) for each channel. The call returns the least and the most
    /// light of a channel whose colour is `part` of white.
    template <class Of> static l3d_light_bounds by_parts(const l3d_color_parts& parts, Of of) {
        l3d_light_bounds result;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const bool is_known = i > 0 && parts[i] == parts[i - 1]; // as for greys
            const std::array<double, 2> bounds =
                is_known ? std::array{result.least[i - 1], result.most[i - 1]} : of(parts[i]);
            result.least[i] = bounds[0];
            result.most[i] = bounds[1];
        }
        return result;
    }

    /// Adds the bounds of another light, times `part`.
    void add(const l3d_light_bounds& other, double part = 1) {
        for (std::size_t i = 0; i < least.size(); ++i) {
            least[i] += part * other.least[i];
            most[i] += part * other.most[i];
        }
    }

    /// Widens the bounds so that they hold for another light, too.
    void include(const l3d_light_bounds& other) {
        for (std::size_t i = 0; i < least.size(); ++i) {
            least[i] = std::min(least[i], other.least[i]);
            most[i] = std::max(most[i], other.most[i]);
        }
    }

    /// How many levels of 255 the bounds are apart in the worst channel.
    double levels_apart() const {
        double result = 0;
        for (std::size_t i = 0; i < least.size(); ++i)
            if (i == 0 || least[i] != least[i - 1] || most[i] != most[i - 1])
                result =
                    std::max(result, l3d_level_of_light(most[i]) - l3d_level_of_light(least[i]));
        return result;
    }
};

/// The verdict on a cell of the exact picture: what is certain in it, and bounds of its light.
struct l3d_doubt_verdict {
    /// Whether one surface of one colour, or the background, fills the cell.
    bool is_certain = false;
    /// Whether a surface of one colour, not the background, fills the cell.
    bool is_covered = false;
    l3d_light_bounds light = l3d_light_bounds::any(); ///< bounds of the mean light over the cell
    double spread = 0; ///< how uncertain the light is, in levels of 255
};

#endif
