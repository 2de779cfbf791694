// SPDX-License-Identifier: MIT
// contour_mixer: the light of pixels that one contour passes through.
#ifndef L3D_RASTER_REFINE_CONTOUR_MIXER_P_H
#define L3D_RASTER_REFINE_CONTOUR_MIXER_P_H

#include "raster/refine/contour_pixels_p.h"
#include "raster/refine/linear_light_p.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// Mixes what is on both sides of a contour by their exact shares of the square. One side's level
/// is that of the pixel, drawn at its centre; the other's is that of a neighbour whose centre the
/// contour divides from it. Each is brought from where it was drawn to the middle of its share, as
/// steadily as it changes beyond.
///
/// Lives: borrows all for a call. None of it changes meanwhile.
class contour_mixer {
public:
    contour_mixer(const l3d_pixels& picture, const l3d_pixel_box& window, const contour_cuts& cuts,
                  bool is_grey, bool has_levels)
        : picture_(picture), window_(window), cuts_(cuts), is_grey_(is_grey),
          has_levels_(has_levels), tables_(linear_light_tables()) {}

    /// The pixel's word. False if neighbours show nothing of the other side, or several surfaces.
    /// Expects: a simple pixel.
    bool mix(const contour_pixel& pixel, std::uint32_t& word) const;

private:
    struct step {
        std::int32_t x, y;

        step operator-() const { return {-x, -y}; }
    };
    /// A side's level in the middle of its share, as a sum of drawn ones.
    struct side {
        std::array<std::uint32_t, 3> words{};
        std::array<float, 3> weights{};
        float constant = 0;

        float level(int shift) const {
            float sum = constant;
            for (std::size_t i = 0; i < words.size(); ++i)
                sum += weights[i] * static_cast<float>(words[i] >> shift & 255);
            return sum;
        }
    };
    static constexpr step beside[] = {{0, -1}, {0, 1}, {-1, 0}, {1, 0}};

    bool inside(std::int32_t x, std::int32_t y) const {
        return x >= window_.left && x < window_.right && y >= window_.top && y < window_.bottom;
    }
    std::uint32_t word_at(std::int32_t x, std::int32_t y) const {
        return picture_.row(y)[static_cast<std::size_t>(x)];
    }
    bool divided(std::int32_t x, std::int32_t y, step to) const;
    bool find_other(const contour_pixel& pixel, step& to) const;
    bool is_odd(std::int32_t x, std::int32_t y) const;
    bool goes_on(std::int32_t x, std::int32_t y, step to) const;
    bool find_fold(const contour_pixel& pixel, step& to) const;
    bool find_steady(std::int32_t x, std::int32_t y, step away, float way, side& found) const;
    bool find_steep(const contour_pixel& pixel, step away, bool is_own, bool is_right, float share,
                    side& found) const;

    const l3d_pixels& picture_;
    l3d_pixel_box window_;
    const contour_cuts& cuts_;
    bool is_grey_;    ///< the channels of all pixels are equal
    bool has_levels_; ///< contours have levels, too
    const linear_light& tables_;
};

} // namespace l3d_detail

#endif
