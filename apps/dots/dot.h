// SPDX-License-Identifier: MIT
// draw_dot: a dot that one can see in a picture of any size.
#ifndef L3D_APPS_DOTS_DOT_H
#define L3D_APPS_DOTS_DOT_H

#include <l3d/pixels.h>
#include <l3d/rasterizer_2d.h>

#include <algorithm>
#include <array>
#include <cstdint>

/// The side of a dot that one can see in a picture of this size: one pixel in the book's 320 x 200,
/// and more in larger pictures. Units: pixels.
inline int dot_side(l3d_size picture) {
    return std::max(1, std::min(picture.width / 320, picture.height / 200));
}

/// The side of a dot with smooth edges: at least two pixels. A smooth dot of one pixel would be
/// spread over four pixels, and be too dim to see. Units: pixels.
inline double smooth_dot_side(l3d_size picture) {
    return 2 * dot_side(picture);
}

/// Draws a dot: a square whose top left corner is (x, y). Units: pixels.
inline void draw_dot(l3d_rasterizer_2d& rasterizer, double x, double y, double side,
                     std::uint32_t color) {
    const std::array<l3d_point_2d, 4> corners{
        {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}};
    rasterizer.draw_polygon_flatshaded(corners, color);
}

#endif
