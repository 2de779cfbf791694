// SPDX-License-Identifier: MIT
// pixel_centroid: the middle of what a polygon has of a pixel.
#ifndef L3D_RASTER_REFINE_PIXEL_CENTROID_P_H
#define L3D_RASTER_REFINE_PIXEL_CENTROID_P_H

#include "raster/refine/band_fragments_p.h"

namespace l3d_detail {

/// A place of the picture. Units: 1/256 pixel.
struct pixel_place {
    double x, y;
};

/// The centroid of the part of a convex polygon that lies in a pixel's square, whose top left
/// corner is given. It lies in the polygon, so no number of the corners is extrapolated there.
/// If nothing lies in the square: the place of the square that is nearest to the mean of corners.
pixel_place centroid_in_pixel(const fragment_polygon& polygon, scan_point corner);

} // namespace l3d_detail

#endif
