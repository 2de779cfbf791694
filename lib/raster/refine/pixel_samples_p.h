// SPDX-License-Identifier: MIT
// pixel_samples: which samples of pixels polygons cover, and which of them are seen.
#ifndef L3D_RASTER_REFINE_PIXEL_SAMPLES_P_H
#define L3D_RASTER_REFINE_PIXEL_SAMPLES_P_H

#include "raster/surface_part.h"
#include "raster/refine/marked_pixels_p.h"
#include "raster/refine/sample_places_p.h"
#include "raster/shapes/scan_edge_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A linear function of the place in the picture: its value in a polygon's middle, and its change
/// for one pixel to the right and one down.
struct fragment_plane {
    float middle, right, down;
};

/// A convex polygon that may reach a marked pixel. A triangle has its last corner twice.
struct fragment_polygon {
    std::int32_t x[5], y[5]; ///< the corners, and the first one again; units: 1/256 pixel
    float inv_w[4];
    float light[3][4]; ///< the three numbers of l3d_micro_vertex::normal at each corner
    std::int32_t corners;
    /// The colour of its material, or in mode `error` that of its part. For a lit or inspected
    /// surface, it is the index of its material.
    std::uint32_t color;
    std::int64_t area2; ///< twice its area, positive if corners turn to the right; not 0

    float middle_x, middle_y; ///< the mean of the four corners; units: pixels
    fragment_plane depth;     ///< the plane of inv_w

    /// Computes the mean and the plane of depth. Expects: all other members are set.
    void set_plane();

    /// The plane of numbers at the corners. It passes through their mean, and is parallel to the
    /// differences along both diagonals.
    fragment_plane plane_of(const float (&numbers)[4]) const;

    /// The value of a plane at a place. Units: pixels.
    float at(const fragment_plane& plane, float to_x, float to_y) const {
        return plane.middle + (plane.right * (to_x - middle_x) + plane.down * (to_y - middle_y));
    }

    void set_corner(std::size_t i, std::int32_t to_x, std::int32_t to_y, float to_inv_w) {
        x[i] = to_x;
        y[i] = to_y;
        inv_w[i] = to_inv_w;
    }
    /// Sets the number of corners and the area, and closes the outline.
    /// Expects: all corners are set.
    void close(std::int32_t of_corners, std::int64_t twice_area) {
        x[4] = x[0];
        y[4] = y[0];
        corners = of_corners;
        area2 = twice_area;
    }
    /// Sets the places and the depths of three corners, and the area.
    void set_triangle(const std::array<l3d_micro_vertex, 3>& of);

    scan_point place(std::size_t i) const { return {x[i], y[i]}; }

    l3d_micro_vertex corner(std::size_t i) const {
        return {x[i], y[i], inv_w[i], {light[0][i], light[1][i], light[2][i]}};
    }
};

/// The samples that a polygon covers in a pixel. `before` is the index of the fragment that was
/// added to the pixel before this one.
struct fragment {
    std::uint64_t samples;
    std::uint32_t polygon, before;

    static constexpr std::uint32_t none = ~std::uint32_t{0};
};

/// The visible part of a polygon in a pixel: its samples, their number, and their middle in the
/// picture.
/// Units: pixels.
struct seen_fragment {
    std::uint64_t samples;
    std::uint32_t polygon;
    std::int32_t count;
    float x, y;
};

/// Adds the fragments of a polygon in the marked pixels of a box, except where everything drawn is
/// nearer. The polygon gets the number `name`; its light and plane need not be set. A sample
/// belongs to a polygon by the picture's fill rule, so it belongs to only one of two polygons that
/// share a side.
/// Returns: the number of fragments that were written to `to`.
/// Expects: a box in the band, not empty. `to` is the fragment with index `first`, and has room for
///          all pixels of the box.
std::size_t cover_samples(const fragment_polygon& of, std::uint32_t name, const l3d_pixel_box& box,
                          marked_pixels& pixels, fragment* to, std::uint32_t first);

/// The pixel boxes of `count` consecutive quads in a row of a grid, clipped to a box. Up to 15 more
/// elements are written, without a meaning.
/// Expects: room for all of them.
struct quad_boxes {
    std::vector<std::int32_t> left, top, right, bottom;

    void find(const l3d_micro_grid& grid, std::size_t first, std::size_t count,
              const l3d_pixel_box& inside);
};

/// The fragments that are seen in a few pixels. No two fragments of a pixel share a sample.
/// Fragments have the order in which they were added.
struct seen_in_pixels {
    static constexpr std::size_t most = 4; ///< pixels

    std::array<seen_fragment, most * sample_places::count> fragments;
    std::array<std::size_t, most + 1> begins; ///< the first fragment of each pixel, and the end
};

/// Finds the polygon that is seen at each sample of at most seen_in_pixels::most pixels: the one
/// whose plane of depth is the nearest. Among equals, it is the one that was added first.
void see_samples(std::span<const fragment_polygon> polygons, std::span<const fragment> fragments,
                 std::span<const marked_pixel> pixels, seen_in_pixels& to);

} // namespace l3d_detail

#endif
