// SPDX-License-Identifier: MIT
// smooth_line: sets up and clips a line, by arithmetic alone.
#include "raster/lines/smooth_line_p.h"

#include "raster/shapes/polygon_corners_p.h"

#include <cstdlib>
#include <utility>

l3d_detail::smooth_line::smooth_line(l3d_point_2d from, l3d_point_2d to, l3d_size size) {
    constexpr std::int64_t half_pixel = l3d_subpixel_one / 2;
    far_point a = lattice_point(from), b = lattice_point(to);
    x_major_ = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    if (!x_major_) {
        std::swap(a.x, a.y);
        std::swap(b.x, b.y);
        std::swap(size.width, size.height);
    }
    if (a.x > b.x)
        std::swap(a, b);
    // Converts from the lattice of polygons to that of samples.
    first_major_ = a.x - half_pixel;
    last_major_ = b.x - half_pixel;
    const std::int64_t minor = a.y - half_pixel;
    const std::int64_t length = std::max<std::int64_t>(b.x - a.x, 1); // a dot has no slope
    minor_size_ = size.height;
    slope_ = wide_integer{l3d_subpixel_one} * (b.y - a.y);
    start_ = wide_integer{minor} * length - wide_integer{b.y - a.y} * first_major_;
    denominator_ = l3d_subpixel_one * length;
    const wide_integer first = floor_quotient(first_major_, l3d_subpixel_one);
    const wide_integer last = ceil_quotient(last_major_, l3d_subpixel_one);
    // A column has two pixels, at floor and floor + 1. One of them is in the picture while
    // -1 <= floor < minor_size.
    seen_ = where_within(
        {std::max<wide_integer>(first, 0), std::min<wide_integer>(last, size.width - 1)}, slope_,
        -wide_integer{denominator_} - start_,
        minor_size_ * wide_integer{denominator_} - 1 - start_);
}
