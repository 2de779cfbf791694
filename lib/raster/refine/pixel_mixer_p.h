// SPDX-License-Identifier: MIT
// pixel_mixer: the mean light of the polygons that are seen in marked pixels.
#ifndef L3D_RASTER_REFINE_PIXEL_MIXER_P_H
#define L3D_RASTER_REFINE_PIXEL_MIXER_P_H

#include "raster/refine/band_fragments_p.h"
#include "raster/refine/pair_measures_p.h"
#include "raster/refine/sampled_pixel_p.h"
#include "raster/surface_rasterizer.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace l3d_detail {

/// Finds the mean light over the square of each marked pixel. All polygons of a pixel are taken
/// together, so neighbours that share an edge leave no seam.
///
/// Polygons of which nothing is hidden count by their exact area. The others share what these
/// leave: all of it comes from one surface where a single outline passes. Where it matters which of
/// them has how much, sampled_pixel draws the pixel.
/// Lives: of one worker, kept for its memory.
class pixel_mixer {
public:
    /// Makes the words of the band's marked pixels, in a picture of that height; its polygons have
    /// the colours of materials if `has_color`. Expects: its pairs are sorted.
    void draw(const band_fragments& band, const l3d_shading& shading,
              std::span<const l3d_material> materials, bool has_color, int height);

    /// One for each of the band's pixels, in their order.
    std::span<const std::uint32_t> words() const { return words_; }

    /// Pixels that were sampled, since the last call.
    std::int64_t take_sampled() { return std::exchange(sampled_, 0); }

private:
    /// A polygon that reaches into the pixel.
    struct fragment {
        std::uint32_t pair, polygon;
        float area;               ///< in the pixel
        std::uint64_t mask, seen; ///< the samples that it covers; those of them where it is seen
        float farthest, nearest;  ///< of the polygon's inv_w
        bool clockwise;
    };

    /// What is behind all surfaces of a pixel.
    struct ground {
        std::uint32_t word;
        light_sum light; ///< black if there is nothing
        bool is_none() const { return word == l3d_pixels::transparent; }
    };
    /// What the areas in a pixel sum up to.
    struct mixture {
        light_sum light;
        float empty = 0; ///< the share of the ground, whose light is not in the sum
    };

    template <class Shader>
    void draw_by(Shader shader, const band_fragments& band, const l3d_background& background,
                 int height);
    void collect(const band_fragments& band, std::size_t pixel);
    void hide();
    std::uint64_t nearer_samples(const fragment& one, const fragment& other) const;
    bool is_hidden(const fragment& sliver) const;
    template <class Shader>
    bool mix(Shader& shader, const band_fragments& band, scan_point corner, bool closed,
             const ground& behind, mixture& sum);
    template <class Shader>
    bool add_rest(Shader& shader, const band_fragments& band, scan_point corner, bool closed,
                  float known, std::uint64_t seen, const ground& behind, mixture& sum);
    static ground ground_of(std::uint32_t word);
    template <class Shader>
    light_sum light_of(Shader& shader, const band_fragments& band, const fragment& of,
                       scan_point corner) const;

    bool has_color_ = false;
    const fragment_fog* fog_ = nullptr; ///< while it draws
    pair_measures measures_;
    std::vector<fragment> fragments_;
    std::vector<std::size_t> seen_; ///< the fragments with a sample where they are seen
    std::vector<std::uint32_t> words_;
    sampled_pixel sampler_;
    std::int64_t sampled_ = 0;
};

} // namespace l3d_detail

#endif
