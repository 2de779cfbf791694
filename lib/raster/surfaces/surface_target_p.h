// SPDX-License-Identifier: MIT
// What surface_fill draws into, and the work space that goes with it.
#ifndef L3D_RASTER_SURFACES_SURFACE_TARGET_P_H
#define L3D_RASTER_SURFACES_SURFACE_TARGET_P_H

#include "raster/surfaces/fill_kernel_p.h"
#include "raster/shapes/scan_polygon_p.h"

#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// Lives: borrows the band's pixels and depth; owns the spans.
struct surface_target {
    fill_band band{};
    scan_polygon scan;
    fill_counts counts;

    /// Column 0 of a row of the picture. Expects: band.top <= row < band.bottom.
    std::uint32_t* words(std::int32_t row) const {
        return band.words + (row - band.top) * band.word_pitch;
    }
    float* depths(std::int32_t row) const {
        return band.depths + (row - band.top) * band.depth_pitch;
    }
};

} // namespace l3d_detail

#endif
