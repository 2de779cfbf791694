// SPDX-License-Identifier: MIT
// l3d_placed_image: an image with its place in a picture.
#ifndef L3D_RASTER_IMAGES_PLACED_IMAGE_H
#define L3D_RASTER_IMAGES_PLACED_IMAGE_H

#include "base/public.h"
#include "raster/placement_2d.h"
#include "tool_2d/pixels.h"

/// The way in which a pixel gets its colour from an image.
enum class L3D_PUBLIC l3d_image_filter {
    /// The colour of the image's pixel whose square holds the sample: hard edges, no new colours. A
    /// sample on a side belongs to the pixel to its right or below.
    nearest,
    /// Interpolated between the image's four pixels around the sample: smooth where an image is
    /// enlarged. Where it shrinks, pixels in between are lost.
    linear,
    /// The exact mean over the pixel's square, where each pixel of the image is a square of one
    /// colour. It loses nothing where an image shrinks, and enlarges to squares with smooth edges.
    area
};

/// An image and its place. Its pixel (i, j) is a square around (i, j), as in l3d_rasterizer_2d, so
/// a placement that moves nothing draws it into the picture's top left corner.
struct L3D_PUBLIC l3d_placed_image {
    l3d_pixels pixels;                                ///< the image; borrowed while drawing
    l3d_placement_2d place{};                         ///< place of the image in the picture
    l3d_image_filter filter = l3d_image_filter::area; ///< the way to a pixel's colour
    bool transparent = false; ///< the words' highest byte says how transparent they are
};

#endif
