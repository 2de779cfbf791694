// SPDX-License-Identifier: MIT
// contour_mixer: the light of pixels that one contour passes through.
#ifndef L3D_RASTER_REFINE_CONTOUR_MIXER_P_H
#define L3D_RASTER_REFINE_CONTOUR_MIXER_P_H

#include "raster/refine/contour_light_p.h"
#include "raster/refine/contour_pixels_p.h"
#include "raster/refine/linear_light_p.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// A picture as it was drawn, before any of its pixels is mixed. Lives: borrows all.
struct drawn_picture {
    const l3d_pixels& words;
    /// The part of it that is drawn.
    l3d_pixel_box window;
    /// inv_w of the pixels that show a surface, and the way from row to row.
    const float* depth;
    std::ptrdiff_t pitch;
    /// Whether the channels of all pixels are equal.
    bool is_grey;
    /// Whether vertices have levels of greys.
    bool has_levels;
    /// Has the fog that is before all that is drawn. Null: there is none.
    const l3d_shading* foggy;
    /// Of the materials, if there are any.
    std::span<const std::uint32_t> colors;
    /// How far vertices may be off. Less matters at no edge. Units: pixels.
    float place_error;
};

/// Mixes what is on both sides of a contour by their exact shares of the square.
///
/// A side's level is taken from the first of these that tells it:
/// - drawn pixels of that side, if their levels change steadily: the pixel itself or a neighbour
///   whose centre the contour divides from it, and the next one;
/// - the polygons on the right of the contour, which are its own surface's;
/// - drawn pixels of that side on a curve, also up to a contour at which the surface folds over;
/// - the drawn pixel alone, where the side has a small share or is behind the contour.
///
/// Lives: borrows all for a call. None of it changes meanwhile.
class contour_mixer {
public:
    contour_mixer(const drawn_picture& picture, const contour_cuts& cuts);

    /// The pixel's word. False if what is drawn does not tell enough.
    /// Expects: a simple pixel.
    bool mix(const contour_pixel& pixel, std::uint32_t& word) const;

    /// From one pixel to another.
    struct step {
        std::int32_t x, y;

        step operator-() const { return {-x, -y}; }
    };
    /// Whether light that is steep at the contour reaches into the next pixel of its surface, on
    /// the right: then the level in the middle of that is not the mean.
    bool shades_next(const contour_pixel& pixel, step& to) const;

private:
    /// A side's level in the middle of its share: the drawn ones of two pixels, `way` of the
    /// difference beyond the first; or a level of all channels.
    struct side {
        std::uint32_t first = 0, second = 0;
        float way = 0, all = -1;
        std::uint32_t color = 0xffffff; ///< of the surface with the level `all`

        float level(int shift) const {
            if (all >= 0)
                return in_color(all, color, shift);
            const auto a = static_cast<float>(first >> shift & 255);
            return a + way * (static_cast<float>(second >> shift & 255) - a);
        }
    };
    /// A pixel, and which of the four beside it are in the window: those of the same side, and
    /// those that a contour divides from it. Shape: bits in the order of `beside`.
    struct surroundings {
        std::int32_t x, y;
        unsigned joined, divided;
    };
    static constexpr std::array<step, 4> beside{{{0, -1}, {0, 1}, {-1, 0}, {1, 0}}};

    std::uint32_t word_at(std::int32_t x, std::int32_t y) const {
        return picture_.words.row(y)[static_cast<std::size_t>(x)];
    }
    /// A channel of a grey's level in a material's colour.
    static float in_color(float level, std::uint32_t color, int shift) {
        return level * (static_cast<float>(color >> shift & 255) * (1.0f / 255));
    }
    /// Whether pixels show the levels of vertices as they are.
    bool shows_levels() const { return picture_.has_levels && picture_.foggy == nullptr; }
    bool inside(std::int32_t x, std::int32_t y) const {
        const l3d_pixel_box& w = picture_.window;
        return x >= w.left && x < w.right && y >= w.top && y < w.bottom;
    }
    bool alike(std::uint32_t a, std::uint32_t b) const;
    surroundings around(std::int32_t x, std::int32_t y) const;
    /// What neighbours show of the other side: nothing, one surface, or several.
    enum class others { none, one, unlike };
    others find_other(const surroundings& here, step& to) const;
    static step to_right_of(const contour_pixel& pixel);
    static bool is_divided(const surroundings& here, step to);
    bool goes_on(std::int32_t x, std::int32_t y, step to) const;
    bool is_odd(const surroundings& here) const;
    bool find_steady(const surroundings& here, step away, float way, side& found) const;
    bool find_steep(const contour_pixel& pixel, step away, bool is_own, bool is_right, float share,
                    side& found) const;
    bool find_own_surface(const contour_pixel& pixel, step to, side& found) const;
    bool is_steep(const contour_pixel& pixel, const surface_light& middle) const;
    bool is_of_contour(const contour_pixel& pixel, step to) const;
    std::uint32_t color_of(std::uint32_t material) const;
    bool is_near(const surroundings& here, float level, std::uint32_t color) const;
    static float apart(std::uint32_t word, float level, std::uint32_t color);
    bool has_own_surface(const contour_pixel& pixel) const;
    float rise(float share, float bright, float dark, float rest) const;
    bool corner_is_seen(const contour_pixel& pixel, float share) const;
    bool rim_is_seen(const contour_pixel& pixel, float share, const side& right,
                     const side& left) const;
    float contour_level(const contour_pixel& pixel, int shift) const;
    static bool may_show_a_sliver(const contour_pixel& pixel);
    std::uint32_t mixed(const side& own, float share, const side& rest) const;

    /// A pixel whose centre is nearer to a fold than this may show a sliver of the other side.
    static constexpr float least_way = 0.1f;

    /// Levels that a surface grows brighter by from the middle of a pixel to the contour beside it.
    /// On a straight slope over 3/4 pixel, the pixel's mean light is then 8 to 10 levels above its
    /// middle's.
    static constexpr float steep_rim = 48;

    const drawn_picture& picture_;
    const contour_cuts& cuts_;
    const linear_light& tables_;
    float small_share_; ///< what a side may have that is taken for as bright as a single place
    float doubt_;       ///< levels that a curve through drawn ones may be wrong by
};

} // namespace l3d_detail

#endif
