// SPDX-License-Identifier: MIT
// l3d_polygon_report: what a frame of polygons cost, and what it left out.
#ifndef L3D_PIPELINE_POLYGON_REPORT_H
#define L3D_PIPELINE_POLYGON_REPORT_H

#include "pipeline/painter_order.h"
#include "pipeline/polygon_frame.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <cstdint>
#include <string>

/// Times of a frame's stages, by the monotonic clock. Units: milliseconds.
struct l3d_polygon_times {
    double place = 0;   ///< vertices to the picture, faces culled and clipped
    double order = 0;   ///< sorting, comparing, cutting; 0 with a depth buffer
    double raster = 0;  ///< clearing, coverage, depth, shading, lines
    double overlay = 0; ///< text
    double total = 0;   ///< all of the above
    double show = 0;    ///< bringing the picture to the screen; not part of total
    double write = 0;   ///< writing picture files; not part of total
};

/// One frame.
struct l3d_polygon_report {
    int frame = 0;
    std::string method; ///< "zsort", "zbuffer" or "mesa"
    l3d_size size;
    int threads = 1;
    l3d_polygon_times time_ms;
    std::int64_t faces = 0;     ///< of the model
    std::int64_t triangles = 0; ///< that its faces are
    l3d_polygon_counts polygons;
    l3d_painter_order_counts order;
    l3d_surface_counts surface;
    std::uint64_t hash = 0; ///< l3d_hash of the picture

    /// One line of JSON, without the line's end.
    std::string json() const;
};

#endif
