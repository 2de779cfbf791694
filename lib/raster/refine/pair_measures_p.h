// SPDX-License-Identifier: MIT
// pair_measures: what each polygon is in each pixel that it reaches.
#ifndef L3D_RASTER_REFINE_PAIR_MEASURES_P_H
#define L3D_RASTER_REFINE_PAIR_MEASURES_P_H

#include "raster/refine/band_fragments_p.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// What polygons are in pixels.
///
/// Units: places in parts of the pixel from its top left corner.
/// Shape: pair i in element i of each array; room for a vector from the last one on.
struct pair_measures {
    std::vector<float> area; ///< of the polygon inside the pixel; the pixel has 1
    std::vector<std::uint32_t> top,
        bottom;              ///< its samples: bit 8 row + column of rows 0 to 3, 4 to 7
    std::vector<float> x, y; ///< the mean of its corners, each brought into the pixel
    std::vector<float> inv_w, of_x, of_y; ///< the polygon's plane of depth: there; per pixel
    std::vector<float> level;             ///< in mode l3d_shade::levels: of the light there
    std::vector<float> spread;            ///< how far apart levels are in the pixel, nearly

    static constexpr std::size_t widest_vector = 16;
    void resize(std::size_t count);

    std::uint64_t samples(std::size_t i) const { return std::uint64_t{bottom[i]} << 32 | top[i]; }
};

/// The samples of these masks: 8 rows of 8, in the middle of equal cells.
inline constexpr int mask_side = 8;

/// The samples where at + of_x x + of_y y is positive.
std::uint64_t samples_above(float at, float of_x, float of_y);

/// Measures all pairs of a band. Expects: they are sorted.
void measure_pairs(const band_fragments& band, pair_measures& to);

} // namespace l3d_detail

#endif
