// SPDX-License-Identifier: MIT
// l3d_placement_2d: a map that moves, turns, stretches or slants the plane; and an image placed by
// it.
#ifndef L3D_RASTER_PLACEMENT_2D_H
#define L3D_RASTER_PLACEMENT_2D_H

#include "base/public.h"
#include "geom/transform.h"
#include "raster/rasterizer_2d.h"
#include "tool_2d/pixels.h"

/// An affine map of the plane: the point (x, y) goes to origin + x across + y down.
/// Units:   pixels, y down, as in l3d_rasterizer_2d.
struct L3D_PUBLIC l3d_placement_2d {
    l3d_point_2d origin{};     ///< the point to which (0, 0) goes
    l3d_point_2d across{1, 0}; ///< the step into which a step of 1 to the right is turned
    l3d_point_2d down{0, 1};   ///< the step into which a step of 1 downwards is turned

    /// A placement that only moves, by x to the right and y down.
    static l3d_placement_2d moved(double x, double y) { return {{x, y}, {1, 0}, {0, 1}}; }

    /// A placement that stretches along both axes and leaves (0, 0) where it is.
    static l3d_placement_2d scaled(double x, double y) { return {{0, 0}, {x, 0}, {0, y}}; }

    /// A placement that turns around a point, clockwise as y points down. Units: degrees.
    static l3d_placement_2d turned(double degrees, l3d_point_2d around = {}) {
        const auto [c, s] = l3d_turn_by(degrees);
        return {{around.x - c * around.x + s * around.y, around.y - s * around.x - c * around.y},
                {c, s},
                {-s, c}};
    }

    /// The placement that fits a window onto a viewport. Each is a box, given by two opposite
    /// corners. The picture is mirrored along an axis where the order of these corners differs
    /// between the two boxes.
    /// Expects: a window whose corners differ in x and in y.
    static l3d_placement_2d window_to_viewport(l3d_point_2d window_from, l3d_point_2d window_to,
                                               l3d_point_2d viewport_from,
                                               l3d_point_2d viewport_to) {
        const double x = (viewport_to.x - viewport_from.x) / (window_to.x - window_from.x);
        const double y = (viewport_to.y - viewport_from.y) / (window_to.y - window_from.y);
        return {{viewport_from.x - window_from.x * x, viewport_from.y - window_from.y * y},
                {x, 0},
                {0, y}};
    }

    /// The placement that fits an image of this size onto a box of the picture, given by its left,
    /// top, width and height in pixels. The sides of the outermost pixels lie on the box's sides.
    /// Expects: a size above 0.
    static l3d_placement_2d image_in_box(l3d_size image, double left, double top, double width,
                                         double height) {
        const double x = width / image.width, y = height / image.height;
        return {{left + (x - 1) / 2, top + (y - 1) / 2}, {x, 0}, {0, y}};
    }

    /// The point to which this placement moves p.
    l3d_point_2d at(l3d_point_2d p) const {
        return {origin.x + (p.x * across.x + p.y * down.x),
                origin.y + (p.x * across.y + p.y * down.y)};
    }

    /// The inverse map. Expects: a placement that maps no area to 0.
    l3d_placement_2d inverted() const {
        const double area = across.x * down.y - across.y * down.x;
        const l3d_point_2d a{down.y / area, -across.y / area}, d{-down.x / area, across.x / area};
        return {{-(origin.x * a.x + origin.y * d.x), -(origin.x * a.y + origin.y * d.y)}, a, d};
    }

    /// The map that applies this placement first, and `next` after it.
    l3d_placement_2d then(const l3d_placement_2d& next) const {
        const auto turned_only = [&next](l3d_point_2d p) {
            return l3d_point_2d{p.x * next.across.x + p.y * next.down.x,
                                p.x * next.across.y + p.y * next.down.y};
        };
        return {next.at(origin), turned_only(across), turned_only(down)};
    }
};

/// The way in which a pixel gets its colour from an image.
enum class L3D_PUBLIC l3d_image_filter {
    /// The colour of the image's pixel whose square contains the sample. Edges stay hard, and no
    /// new colours appear. A sample on a side belongs to the pixel to its right or below.
    nearest,
    /// Bilinear interpolation between the image's four pixels around the sample. An enlarged image
    /// becomes smooth; when an image shrinks, some of its pixels are skipped.
    linear,
    /// The exact mean over the pixel's square, where each pixel of the image is a square of one
    /// colour. Nothing is lost when an image shrinks; an enlarged image shows squares with smooth
    /// edges.
    area
};

/// An image and its place in the picture. The image's pixel (i, j) is a square around (i, j), as in
/// l3d_rasterizer_2d. So the default placement draws the image into the picture's top left corner.
struct L3D_PUBLIC l3d_placed_image {
    l3d_pixels pixels;        ///< the image; borrowed while drawing
    l3d_placement_2d place{}; ///< place of the image in the picture
    /// The way in which a pixel gets its colour from the image.
    l3d_image_filter filter = l3d_image_filter::area;
    /// Whether the highest byte of the image's words tells how transparent its pixels are.
    bool transparent = false;
};

#endif
