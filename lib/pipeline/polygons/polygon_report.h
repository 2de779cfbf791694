// SPDX-License-Identifier: MIT
// l3d_polygon_report: what a frame of polygons cost, and what it left out.
#ifndef L3D_PIPELINE_POLYGONS_POLYGON_REPORT_H
#define L3D_PIPELINE_POLYGONS_POLYGON_REPORT_H

#include "pipeline/polygons/painter_order.h"
#include "pipeline/polygons/polygon_frame.h"
#include "pipeline/report_parts.h"

#include <cstdint>
#include <string>

/// Times of the stages of a frame of polygons. Units: milliseconds.
struct l3d_polygon_times : l3d_common_times {
    double place = 0; ///< vertices to the picture, faces culled and clipped
    double order = 0; ///< sorting, comparing, cutting; 0 with a depth buffer
};

/// One frame.
struct l3d_polygon_report : l3d_common_report {
    l3d_polygon_times time_ms;
    std::int64_t faces = 0;     ///< of the model
    std::int64_t triangles = 0; ///< that its faces are
    l3d_polygon_counts polygons;
    l3d_painter_order_counts order;

    /// One line of JSON, without the line's end.
    std::string json() const;

    /// What this frame did not need, and the test that proved it, a line each.
    std::string explanation() const;
};

#endif
