// SPDX-License-Identifier: MIT
// l3d_picture_plane: reciprocal depth over a triangle's plane.
#ifndef L3D_RASTER_SHAPES_PICTURE_PLANE_H
#define L3D_RASTER_SHAPES_PICTURE_PLANE_H

#include "raster/surface_part.h"

#include <array>
#include <cstdint>

/// The plane of a triangle: 1/w as a linear function of the place in the picture.
///
/// Units:   places in 1/256 pixel.
/// Expects: a triangle that covers some area.
/// Cost:    one division to make.
struct l3d_picture_plane {
    /// The first corner, near which rounding is least, and the corner's 1/w.
    double x0, y0, at_first;
    double along_x, along_y;

    explicit l3d_picture_plane(const std::array<l3d_micro_vertex, 3>& v)
        : x0(v[0].x), y0(v[0].y), at_first(v[0].inv_w) {
        const double x1 = double(v[1].x) - v[0].x, y1 = double(v[1].y) - v[0].y;
        const double x2 = double(v[2].x) - v[0].x, y2 = double(v[2].y) - v[0].y;
        const double d1 = double(v[1].inv_w) - v[0].inv_w, d2 = double(v[2].inv_w) - v[0].inv_w;
        const double scale = 1 / (x1 * y2 - y1 * x2);
        along_x = (d1 * y2 - d2 * y1) * scale;
        along_y = (d2 * x1 - d1 * x2) * scale;
    }

    double at(double x, double y) const {
        return at_first + along_x * (x - x0) + along_y * (y - y0);
    }
    double at_pixel(int column, int row) const {
        return at(l3d_subpixel_one * (column + 0.5), l3d_subpixel_one * (row + 0.5));
    }
};

#endif
