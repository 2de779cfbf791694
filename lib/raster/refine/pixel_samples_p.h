// SPDX-License-Identifier: MIT
// pixel_samples: which samples of pixels polygons cover, and which of them are seen.
#ifndef L3D_RASTER_REFINE_PIXEL_SAMPLES_P_H
#define L3D_RASTER_REFINE_PIXEL_SAMPLES_P_H

#include "raster/surface_part.h"
#include "raster/refine/marked_pixels_p.h"
#include "raster/shapes/scan_edge_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A number that is linear in the picture: in a polygon's middle, and what a pixel to the right and
/// one down add.
struct fragment_plane {
    float middle, right, down;
};

/// A convex polygon that may reach a marked pixel. A triangle's last corner is there twice.
struct fragment_polygon {
    std::int32_t x[5], y[5]; ///< the first is the last, too; units: 1/256 pixel
    float inv_w[4];
    float light[3][4]; ///< the corners' three numbers of l3d_micro_vertex::normal
    std::int32_t corners;
    /// The colour of its material, or in mode `error` of the part. A lit or inspected surface has
    /// its material's place here.
    std::uint32_t color;
    std::int64_t area2; ///< twice its area, positive if its corners turn to the right; not 0

    float middle_x, middle_y; ///< the mean of four corners; units: pixels
    fragment_plane depth;     ///< the plane of inv_w

    /// Sets the mean and the plane of depth. Expects: area2 is set, as all else.
    void set_plane();

    /// The plane of numbers of the corners, through their mean and parallel to both diagonals'
    /// differences.
    fragment_plane plane_of(const float (&numbers)[4]) const;

    /// A number of a plane at a place. Units: pixels.
    float at(const fragment_plane& plane, float to_x, float to_y) const {
        return plane.middle + (plane.right * (to_x - middle_x) + plane.down * (to_y - middle_y));
    }

    void set_corner(std::size_t i, std::int32_t to_x, std::int32_t to_y, float to_inv_w) {
        x[i] = to_x;
        y[i] = to_y;
        inv_w[i] = to_inv_w;
    }
    /// Sets the rest of what its sides need. Expects: all corners are set.
    void close(std::int32_t of_corners, std::int64_t twice_area) {
        x[4] = x[0];
        y[4] = y[0];
        corners = of_corners;
        area2 = twice_area;
    }
    /// Sets places and depths of three corners, and the area.
    void set_triangle(const std::array<l3d_micro_vertex, 3>& of);

    scan_point place(std::size_t i) const { return {x[i], y[i]}; }

    l3d_micro_vertex corner(std::size_t i) const {
        return {x[i], y[i], inv_w[i], {light[0][i], light[1][i], light[2][i]}};
    }
};

/// The samples that a polygon has in a pixel, and the place of the fragment that came to the pixel
/// before it.
struct fragment {
    std::uint64_t samples;
    std::uint32_t polygon, before;

    static constexpr std::uint32_t none = ~std::uint32_t{0};
};

/// The part of a polygon seen in a pixel: samples, their number, and their middle in the picture.
/// Units: pixels.
struct seen_fragment {
    std::uint64_t samples;
    std::uint32_t polygon;
    std::int32_t count;
    float x, y;
};

/// Adds what a polygon covers in marked pixels of a box, unless all that is there is nearer. It has
/// the number `name`; light and plane need not be set. A sample belongs to a polygon by the
/// picture's fill rule. So it belongs to exactly one of two that share a side.
/// Returns: the number of fragments, from `to` on.
/// Expects: a box in the band, not empty; `to`, whose place is `first`, has room for all its
/// pixels.
std::size_t cover_samples(const fragment_polygon& of, std::uint32_t name, const l3d_pixel_box& box,
                          marked_pixels& pixels, fragment* to, std::uint32_t first);

/// The boxes of some quads that are next to each other in a row of a grid, so far as they are in a
/// box. Those from `count` on mean nothing; there are up to 15.
/// Expects: room for them.
struct quad_boxes {
    std::vector<std::int32_t> left, top, right, bottom;

    void find(const l3d_micro_grid& grid, std::size_t first, std::size_t count,
              const l3d_pixel_box& inside);
};

/// Finds what is seen in pixel after pixel: at each sample the polygon whose plane of depth is the
/// nearest, of equals the one that came first. Those of a pixel are in the order in which they
/// came. Those of pixel i go from begins[i] to begins[i + 1].
void see_samples(std::span<const fragment_polygon> polygons, std::span<const fragment> fragments,
                 std::span<const marked_pixel> pixels, std::vector<seen_fragment>& seen,
                 std::vector<std::uint32_t>& begins);

} // namespace l3d_detail

#endif
