// SPDX-License-Identifier: MIT
// The parts of frame reports that patches and polygons share.
#ifndef L3D_PIPELINE_REPORT_PARTS_H
#define L3D_PIPELINE_REPORT_PARTS_H

#include "base/public.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <cstdint>
#include <string>

/// Times of the stages that every frame has, by the monotonic clock. Units: milliseconds.
struct L3D_PUBLIC l3d_common_times {
    double raster = 0;  ///< clearing, coverage, depth, shading, lines
    double overlay = 0; ///< control nets and text
    double total = 0;   ///< all stages but those below
    double show = 0;    ///< bringing the picture to the screen; not part of total
    double write = 0;   ///< writing picture files; not part of total
};

/// The entries that the reports of all frames share.
struct L3D_PUBLIC l3d_common_report {
    int frame = 0;              ///< its number, from 0; skipped frames count
    std::string method;         ///< the name of the method that filled surfaces
    std::string renderer;       ///< the GL that filled surfaces; empty if processors did
    std::string real;           ///< the number type of the library, l3d_real_name()
    std::string simd;           ///< vector instructions, as l3d_simd_target names them
    l3d_size size;              ///< size of the picture, in pixels
    int threads = 1;            ///< threads that drew
    l3d_surface_counts surface; ///< counts of the filling
    std::uint64_t hash = 0;     ///< l3d_hash of the picture
};

/// FNV-1a of the pixel words, row by row from the top, 64 bits.
/// Source: Fowler, Noll, Vo; constants from RFC 9923.
L3D_PUBLIC std::uint64_t l3d_hash(const l3d_pixels& pixels);

#endif
