// SPDX-License-Identifier: MIT
// The target of surface_fill, and the work space that goes with it.
#ifndef L3D_RASTER_SURFACES_SURFACE_TARGET_P_H
#define L3D_RASTER_SURFACES_SURFACE_TARGET_P_H

#include "raster/shapes/plane_cut_p.h"
#include "raster/surfaces/fill_kernel_p.h"
#include "raster/shapes/scan_polygon_p.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// The band that a shader draws into, with the settings for its words.
/// Lives: borrows the band's pixels and depth; owns the spans of the scan.
struct surface_target {
    fill_band band{};
    scan_polygon scan;
    fill_counts counts;
    fill_words coding{};
    std::uint32_t material = 0; ///< the polygons' material, as fill_words::of_material has it
    /// Cuts that limit the polygons; only pixels that all cuts keep are filled.
    std::span<const plane_cut> cuts;
    /// Whether rows are filled in lanes if the shader can do so. The bits are the same either way.
    bool by_lanes = false;

    /// The word that is stored in a pixel for the word that a shader gives.
    std::uint32_t word_of(std::uint32_t shaded) const {
        return coding.has_materials ? (shaded & 0xff) | material : shaded;
    }

    /// The word at column 0 of a row of the picture. Expects: band.top <= row < band.bottom.
    std::uint32_t* words(std::int32_t row) const {
        return band.words + (row - band.top) * band.word_pitch;
    }
    /// The normal at column 0 of a row of the picture. Expects: band.top <= row < band.bottom.
    std::uint32_t* normals(std::int32_t row) const {
        return band.normals + (row - band.top) * band.depth_pitch;
    }
    float* depths(std::int32_t row) const {
        return band.depths + (row - band.top) * band.depth_pitch;
    }
};

} // namespace l3d_detail

#endif
