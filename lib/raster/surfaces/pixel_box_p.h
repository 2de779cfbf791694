// SPDX-License-Identifier: MIT
// pixels_in, squares_in: find the pixels that polygons in a box may cover.
#ifndef L3D_RASTER_SURFACES_PIXEL_BOX_P_H
#define L3D_RASTER_SURFACES_PIXEL_BOX_P_H

#include "raster/shapes/scan_edge_p.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

namespace l3d_detail {

/// The pixels that a polygon in the box may cover. By the fill rule, a centre on the right or lower
/// side of the box belongs to no polygon in the box.
inline l3d_pixel_box pixels_in(const l3d_subpixel_box& box) {
    return {first_centre(box.left), first_centre(box.top), first_centre(box.right),
            first_centre(box.bottom)};
}

/// The pixels whose squares a polygon in the box may reach. The left and the upper side of a square
/// count for the pixel beyond this side, too, since contours are walked with a small shift to the
/// left and up.
inline l3d_pixel_box squares_in(const l3d_subpixel_box& box) {
    constexpr std::int32_t last = l3d_subpixel_one - 1;
    return {(box.left - 1) >> l3d_subpixel_bits, (box.top - 1) >> l3d_subpixel_bits,
            (box.right + last) >> l3d_subpixel_bits, (box.bottom + last) >> l3d_subpixel_bits};
}

} // namespace l3d_detail

#endif
