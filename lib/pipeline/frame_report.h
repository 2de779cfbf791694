// SPDX-License-Identifier: MIT
// l3d_frame_report: what a frame cost, how exact it is, and what it left out.
#ifndef L3D_PIPELINE_FRAME_REPORT_H
#define L3D_PIPELINE_FRAME_REPORT_H

#include "dice/dice_counts.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <cstdint>
#include <string>

/// Times of a frame's stages, by the monotonic clock. Units: milliseconds.
struct l3d_stage_times {
    double transform = 0; ///< what may be seen, sorted front to back
    double dice = 0;      ///< control nets to the image, bounds, steps, forward differences
    double raster = 0;    ///< clearing, coverage, depth, shading
    double overlay = 0;   ///< control nets and text
    double total = 0;     ///< all of the above
    double show = 0;      ///< bringing the picture to the screen; not part of total
    double write = 0;     ///< writing picture files; not part of total
};

/// One frame.
struct l3d_frame_report {
    int frame = 0;
    std::string method;
    std::string real;
    std::string simd; ///< vector instructions, as l3d_simd_target names them
    l3d_size size;
    int threads = 1;
    double tolerance_px = 0;
    double near = 0; ///< nearest distance drawn: the camera's, unless rounding asks for more
    l3d_stage_times time_ms;
    std::int64_t patches = 0;
    l3d_dice_counts dice;
    l3d_surface_counts surface;
    std::uint64_t hash = 0; ///< l3d_hash of the picture

    /// One line of JSON, without the line's end.
    std::string json() const;

    /// What this frame did not need, and the test that proved it, a line each.
    std::string explanation() const;
};

/// FNV-1a of the pixel words, row by row from the top, 64 bits.
/// Source: Fowler, Noll, Vo; constants from RFC 9923.
std::uint64_t l3d_hash(const l3d_pixels& pixels);

#endif
