// SPDX-License-Identifier: MIT
// l3d_clip_region: a box that lines are cut off at, and its border.
#ifndef L3D_RASTER_SHAPES_CLIP_REGION_H
#define L3D_RASTER_SHAPES_CLIP_REGION_H

#include "base/public.h"
#include "raster/rasterizer_2d.h"

#include <cstdint>

/// Cuts lines off at the sides of a box, in doubles; they are rounded when they are drawn.
/// Units:   pixels, y down.
/// Source:  Cohen, Sutherland; in Newman, Sproull: Principles of Interactive Computer Graphics.
struct L3D_PUBLIC l3d_clip_region {
    /// The box's corners, top left and bottom right; both belong to it.
    l3d_point_2d least{}, most{};

    /// The bits of outcode(), one for each side of the box.
    static constexpr unsigned left = 1, right = 2, below = 4, above = 8;

    /// The sides that a point is beyond, as a sum of bits; 0 if it is inside.
    unsigned outcode(l3d_point_2d p) const {
        return (p.x < least.x ? left : 0) | (p.x > most.x ? right : 0) |
               (p.y > most.y ? below : 0) | (p.y < least.y ? above : 0);
    }

    /// Moves the ends of a line to the sides. Returns false if no part of it is inside.
    /// Expects: finite numbers.
    bool clip(l3d_point_2d& from, l3d_point_2d& to) const;

    /// Draws a line's part inside, between the pixels nearest to its ends.
    void draw_line(l3d_rasterizer_2d& rasterizer, l3d_point_2d from, l3d_point_2d to,
                   std::uint32_t color) const;

    /// Draws the four sides.
    void draw_border(l3d_rasterizer_2d& rasterizer, std::uint32_t color) const;
};

#endif
