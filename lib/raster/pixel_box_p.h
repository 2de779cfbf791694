// SPDX-License-Identifier: MIT
// pixel_box: a rectangle of whole pixels.
#ifndef L3D_RASTER_PIXEL_BOX_P_H
#define L3D_RASTER_PIXEL_BOX_P_H

#include "raster/scan_edge_p.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cstdint>

namespace l3d_detail {

/// Columns [left, right) of rows [top, bottom).
struct pixel_box {
    std::int32_t left = 0, top = 0, right = 0, bottom = 0;

    bool empty() const { return left >= right || top >= bottom; }

    pixel_box intersected(const pixel_box& other) const {
        return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
                std::min(bottom, other.bottom)};
    }
};

inline pixel_box whole(l3d_size size) {
    return {0, 0, size.width, size.height};
}

/// The pixels that a polygon in the box may cover: by the fill rule, a centre on its right or lower
/// end belongs to no polygon in it.
inline pixel_box pixels_in(const l3d_subpixel_box& box) {
    return {first_centre(box.left), first_centre(box.top), first_centre(box.right),
            first_centre(box.bottom)};
}

} // namespace l3d_detail

#endif
