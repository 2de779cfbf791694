// SPDX-License-Identifier: MIT
// sampled_pixel: the mean light of a pixel's square, by 256 samples.
#ifndef L3D_RASTER_REFINE_SAMPLED_PIXEL_P_H
#define L3D_RASTER_REFINE_SAMPLED_PIXEL_P_H

#include "raster/refine/coverage_p.h"
#include "raster/refine/fragment_light_p.h"

#include <cstddef>
#include <span>
#include <vector>

namespace l3d_detail {

/// Finds which of a pixel's samples show which polygon. It is the slow twin of pixel_mixer, and
/// draws the pixels that are not simple enough for it.
///
/// A polygon's light is that in the middle of its samples that are seen.
/// Lives: kept for its memory.
class sampled_pixel {
public:
    /// Starts a pixel. Units: 1/256 pixel; its top left corner.
    void begin(scan_point corner) {
        corner_ = corner;
        fragments_.clear();
    }

    /// Of polygons that are equally near, the one that was added first is seen.
    void add(const fragment_polygon& polygon);

    /// `has_color`: polygons have the colours of materials. `closed`: samples that no polygon
    /// covers show what the others do. Of others, `empty` gets the share.
    template <class Shader>
    light_sum light(Shader& shader, const fragment_fog& fog, bool has_color, bool closed,
                    float& empty);

private:
    struct fragment {
        const fragment_polygon* polygon = nullptr;
        coverage seen; ///< once what is in front is known
    };

    void hide();
    light_sum light_of_levels(const fragment& of, bool has_color) const;

    scan_point corner_;
    std::vector<fragment> fragments_; ///< nearest corner first
};

template <class Shader>
light_sum sampled_pixel::light(Shader& shader, const fragment_fog& fog, bool has_color, bool closed,
                               float& empty) {
    hide();
    light_sum sum;
    float covered = 0;
    for (const fragment& f : fragments_) {
        const coverage_moments m = moments_of(f.seen);
        if (m.count == 0)
            continue;
        const float share = static_cast<float>(m.count) / sample_pattern::count;
        covered += share;
        const double half_each = 0.5 / m.count;
        const double x = corner_.x + half_each * m.x, y = corner_.y + half_each * m.y;
        light_sum light;
        if constexpr (has_bends<Shader>)
            light = light_of_levels(f, has_color);
        else
            light = light_at(shader, *f.polygon, has_color, x, y);
        sum.add(fog.over(light, *f.polygon, x, y), share);
    }
    empty = closed && covered > 0 ? 0.0f : 1 - covered;
    if (empty > 0 || covered <= 0)
        return sum;
    light_sum all;
    all.add(sum, 1 / covered);
    return all;
}

} // namespace l3d_detail

#endif
