// SPDX-License-Identifier: MIT
// What a frame is drawn into, and the work space that goes with it.
#ifndef L3D_RASTER_SURFACE_TARGET_P_H
#define L3D_RASTER_SURFACE_TARGET_P_H

#include "raster/scan_polygon_p.h"
#include "raster/surface_rasterizer.h"

namespace l3d_detail {

/// Lives: borrows pixels and depth from begin to the end of the frame; owns the spans.
struct surface_target {
    l3d_pixels pixels;
    l3d_depth_buffer* depth = nullptr;
    l3d_shading shading;
    scan_polygon scan;
    l3d_surface_counts counts;
};

} // namespace l3d_detail

#endif
