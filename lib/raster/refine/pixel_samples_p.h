// SPDX-License-Identifier: MIT
// pixel_samples: finds which samples of pixels polygons cover, and which of these are seen.
#ifndef L3D_RASTER_REFINE_PIXEL_SAMPLES_P_H
#define L3D_RASTER_REFINE_PIXEL_SAMPLES_P_H

#include "raster/surface_part.h"
#include "raster/refine/marked_pixels_p.h"
#include "raster/refine/sample_places_p.h"
#include "raster/surfaces/quad_cut_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A linear function of the place in the picture. The plane is given by its value in a polygon's
/// middle, and by its changes for a pixel to the right and a pixel down.
struct fragment_plane {
    float middle, right, down;
};

/// A convex polygon that may reach a marked pixel. In a triangle, the last corner comes twice.
struct fragment_polygon {
    std::int32_t x[5], y[5]; ///< the corners, and the first corner again; units: 1/256 pixel
    float inv_w[4];
    float light[3][4]; ///< the three numbers of l3d_micro_vertex::normal at each corner
    std::int32_t corners;
    /// The colour of the polygon's material, or in mode `error` the colour of its part. In frames
    /// that are lit or that see exact patches, this member is the material's index instead.
    std::uint32_t color;
    /// Twice the polygon's area, positive if its corners turn to the right; not 0.
    std::int64_t area2;

    float middle_x, middle_y; ///< the mean of the four corners; units: pixels
    fragment_plane depth;     ///< the plane of inv_w

    /// Sets the corners' numbers, the number of different corners, and twice the area.
    void set(const quad_corners& of, std::int32_t of_corners, std::int64_t twice_area) {
        for (std::size_t i = 0; i < of.size(); ++i) {
            x[i] = of[i].x;
            y[i] = of[i].y;
            inv_w[i] = of[i].inv_w;
            for (std::size_t k = 0; k < 3; ++k)
                light[k][i] = of[i].normal[k];
        }
        x[4] = of[0].x;
        y[4] = of[0].y;
        corners = of_corners;
        area2 = twice_area;
    }

    /// Computes the mean of the corners and the plane of depth. Expects: set() was called.
    void set_plane() {
        constexpr double unit = 0.25 / l3d_subpixel_one;
        middle_x = static_cast<float>(unit * (double(x[0]) + x[1] + x[2] + x[3]));
        middle_y = static_cast<float>(unit * (double(y[0]) + y[1] + y[2] + y[3]));
        depth = plane_of(inv_w);
    }

    /// Makes a plane from a number at each corner. In the corners' mean, it has the mean of these
    /// numbers, and along both diagonals it has the same differences as the corners.
    fragment_plane plane_of(const float (&numbers)[4]) const {
        const double per_area = l3d_subpixel_one / static_cast<double>(area2);
        const double a = per_area * (double{numbers[2]} - numbers[0]),
                     b = per_area * (double{numbers[3]} - numbers[1]);
        return {0.25f * ((numbers[0] + numbers[1]) + (numbers[2] + numbers[3])),
                static_cast<float>(a * (y[3] - y[1]) - b * (y[2] - y[0])),
                static_cast<float>(b * (x[2] - x[0]) - a * (x[3] - x[1]))};
    }

    /// The value of a plane of this polygon at a place of the picture. Units: pixels.
    float at(const fragment_plane& plane, float to_x, float to_y) const {
        return plane.middle + (plane.right * (to_x - middle_x) + plane.down * (to_y - middle_y));
    }

    l3d_micro_vertex corner(std::size_t i) const {
        return {x[i], y[i], inv_w[i], {light[0][i], light[1][i], light[2][i]}};
    }
};

/// A fragment: the samples that a polygon covers in a pixel. `before` is the index of the fragment
/// that the pixel got before this one.
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

/// The boxes of pixels around consecutive quads in a row of a grid. find() finds the boxes of
/// `count` quads, clipped to `inside`. find() also writes up to 15 elements without meaning after
/// these.
/// Expects: room for all of these elements.
struct quad_boxes {
    std::vector<std::int32_t> left, top, right, bottom;

    void find(const l3d_micro_grid& grid, std::size_t first, std::size_t count,
              const l3d_pixel_box& inside);
};

/// The fragments that are seen in a few pixels, in the order in which they were added. No two
/// fragments of a pixel share a sample.
struct seen_in_pixels {
    /// The largest number of pixels that see_samples() takes at once.
    static constexpr std::size_t most = 4;

    std::array<seen_fragment, most * sample_places::count> fragments;
    /// For each pixel, the index of its first fragment; then the index behind the last pixel's
    /// fragments.
    std::array<std::size_t, most + 1> begins;
};

/// Finds the polygon that is seen at each sample of at most seen_in_pixels::most pixels. At a
/// sample, the polygon whose plane of depth is the nearest is seen; among equally near polygons,
/// the one that was added first is seen.
void see_samples(std::span<const fragment_polygon> polygons, std::span<const fragment> fragments,
                 std::span<const marked_pixel> pixels, seen_in_pixels& to);

} // namespace l3d_detail

#endif
