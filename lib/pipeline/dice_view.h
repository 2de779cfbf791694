// SPDX-License-Identifier: MIT
// l3d_dice_view: what dicing has to know of the picture.
#ifndef L3D_PIPELINE_DICE_VIEW_H
#define L3D_PIPELINE_DICE_VIEW_H

#include "geom/step_bound.h"
#include "raster/micro_grid.h"
#include "tool_2d/pixels.h"

#include <limits>

/// The picture and the accuracy asked for; constant for a frame.
///
/// Units: pixels from the picture's centre; near, far and depths in the image transform's scaled w.
struct l3d_dice_view {
    l3d_size size;
    double near = 0;
    double tolerance = 0.25;
    double depth_scale = 1; ///< scaled w / distance along the view axis
    double error_xy = 0;    ///< of a transformed control point
    double error_w = 0;
    bool keep_all = false; ///< leave nothing out that could be left out
    double far = std::numeric_limits<double>::infinity();

    l3d_image_box window() const {
        return {-size.width / 2.0, -size.height / 2.0, size.width / 2.0, size.height / 2.0};
    }

    /// The window and a pixel around it: what is outside this touches no pixel centre, whatever
    /// the snapping to sub-pixels.
    l3d_image_box margin() const { return window().grown(1); }

    /// Position of the picture's centre in 1/256 pixel; a half pixel is 128, so this is exact.
    std::int32_t centre_x() const { return size.width * (l3d_subpixel_one / 2); }
    std::int32_t centre_y() const { return size.height * (l3d_subpixel_one / 2); }
};

/// Farthest a vertex may lie from the picture's centre. Beyond, surfaces are clipped.
/// 2^14 pixels are 2^22 sub-pixels: exact in a float, and half the rasterizer's range, so that
/// the picture's centre (at most 2^13 pixels from its corner) still fits.
inline constexpr double l3d_guard_band = 16384;

#endif
