// SPDX-License-Identifier: MIT
// l3d_polygon_report: a frame's cost and skipped work, for polygons.
#ifndef L3D_PIPELINE_POLYGONS_POLYGON_REPORT_H
#define L3D_PIPELINE_POLYGONS_POLYGON_REPORT_H

#include "base/public.h"
#include "pipeline/report_parts.h"
#include "scene/counts.h"

#include <cstdint>
#include <string>

/// The counts of a model's triangles in a frame.
struct L3D_PUBLIC l3d_polygon_counts : l3d_seen_counts {
    std::int64_t back = 0; ///< left out: seen from behind

    /// Adds the counts of other triangles.
    void add(const l3d_polygon_counts& other) {
        l3d_seen_counts::add(other);
        back += other.back;
    }
};

/// Counts of the work that a frame's order took.
struct L3D_PUBLIC l3d_painter_order_counts {
    std::int64_t triangles = 0; ///< triangles to be ordered
    std::int64_t pairs = 0;     ///< pairs of triangles compared as they may share pixels
    std::int64_t knots = 0;     ///< sets that no order of whole triangles paints right
    std::int64_t knotted = 0;   ///< triangles in the knots
    std::int64_t cuts = 0;      ///< triangles and pieces cut in two
};

/// Times of the stages of a frame of polygons. Units: milliseconds.
struct L3D_PUBLIC l3d_polygon_times : l3d_common_times {
    double place = 0; ///< vertices to the picture, faces culled and clipped
    double order = 0; ///< sorting, comparing, cutting; 0 with a depth buffer
};

/// The report of one frame of polygons.
struct L3D_PUBLIC l3d_polygon_report : l3d_common_report {
    l3d_polygon_times time_ms;      ///< times of the stages, in milliseconds
    std::int64_t faces = 0;         ///< faces of the model
    std::int64_t triangles = 0;     ///< triangles of its faces
    l3d_polygon_counts polygons;    ///< triangles drawn, and left out, by reason
    l3d_painter_order_counts order; ///< the work of ordering; zeros with a depth buffer

    /// One line of JSON, without the line's end.
    std::string json() const;

    /// The work that this frame did not need, and the test that proved it, a line each.
    std::string explanation() const;
};

#endif
