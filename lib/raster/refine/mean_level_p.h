// SPDX-License-Identifier: MIT
// mean_level: the level whose light is the mean light of a polygon in a pixel.
#ifndef L3D_RASTER_REFINE_MEAN_LEVEL_P_H
#define L3D_RASTER_REFINE_MEAN_LEVEL_P_H

#include "raster/refine/band_fragments_p.h"

#include <cstdint>

namespace l3d_detail {

/// The level above the ambient one that has the mean light of a polygon at some samples. Light does
/// not grow as levels do: where these change fast, the light of a middle place is not the mean.
///
/// Mode l3d_shade::levels. Samples are those of pair_measures, `corner` is the pixel's top left
/// one. Units: 1/256 pixel. Expects: a sample; a polygon that has an area.
float mean_level(const fragment_polygon& polygon, scan_point corner, std::uint64_t samples);

} // namespace l3d_detail

#endif
