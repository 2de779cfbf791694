// SPDX-License-Identifier: MIT
// color_mixer: colours mixed in double, in coded values or in linear light.
#ifndef L3D_RASTER_COLOR_COLOR_MIXER_P_H
#define L3D_RASTER_COLOR_COLOR_MIXER_P_H

#include "raster/rasterizer_2d.h"
#include "raster/color/linear_light_p.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// A colour, and the share of a place (a pixel or a part of it) that the colour covers.
struct mixed_color {
    /// Red, green and blue in the numbers of color_mixer::value, each times `opacity`.
    std::array<double, 3> values{};
    double opacity = 0; ///< the share of the place that the colour covers, from 0 to 1
};

/// Mixes colours in levels or in amounts of light, and rounds the result once, to the nearest
/// level.
class color_mixer {
public:
    explicit color_mixer(l3d_blending how)
        : light_(how == l3d_blending::linear ? &exact_light_tables() : nullptr) {}

    /// The number that stands for a level (0 to 255) while colours are mixed. It is the level's
    /// light if colours are mixed linearly, else the level itself. The function level() is the
    /// inverse.
    double value(std::uint32_t level) const {
        return light_ != nullptr ? light_->light(level) : static_cast<double>(level);
    }
    std::uint32_t level(double value) const {
        return light_ != nullptr ? light_->level(value) : static_cast<std::uint32_t>(value + 0.5);
    }

    /// A pixel word's colour that covers the given share of a place.
    mixed_color color(std::uint32_t word, double share = 1) const {
        mixed_color result{{}, share};
        for (std::size_t k = 0; k < 3; ++k)
            result.values[k] = value(channel(word, k)) * share;
        return result;
    }

    /// The pixel word of a mixed colour, without its transparency.
    std::uint32_t word(const mixed_color& color) const {
        std::uint32_t result = 0;
        for (std::size_t k = 0; k < 3; ++k)
            result |= level(color.values[k] / color.opacity) << shift_of(k);
        return result;
    }

    /// Mixes a colour over a pixel word, as if the colour's place were this share of the pixel. If
    /// the word is transparent, both colours are weighted by their coverage.
    std::uint32_t over(std::uint32_t word, const mixed_color& color, double share) const {
        const double covers = color.opacity * share;
        if (covers <= 0)
            return word;
        const std::uint32_t gap = word >> 24;
        const double rest = 1 - covers, stays = gap == 0 ? rest : rest * (255 - gap) / 255.0;
        const double sum = gap == 0 ? 1 : stays + covers;
        std::uint32_t result =
            gap == 0 ? 0 : static_cast<std::uint32_t>(255 * (1 - sum) + 0.5) << 24;
        for (std::size_t k = 0; k < 3; ++k) {
            const double mixed = value(channel(word, k)) * stays + color.values[k] * share;
            result |= level(mixed / sum) << shift_of(k);
        }
        return result;
    }

private:
    static int shift_of(std::size_t k) { return 16 - 8 * static_cast<int>(k); }
    static std::uint32_t channel(std::uint32_t word, std::size_t k) {
        return word >> shift_of(k) & 255;
    }

    /// Tables for mixing light; null: levels are mixed as they are.
    const linear_light_of<double>* light_;
};

} // namespace l3d_detail

#endif
