// SPDX-License-Identifier: MIT
// l3d_pixel_centres: the pixels whose centres lie between two places, along one axis.
#ifndef L3D_RASTER_PIXEL_CENTRES_H
#define L3D_RASTER_PIXEL_CENTRES_H

#include "raster/surface_part.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace l3d_detail {

/// The index of the first pixel whose centre is at or after a position: ceil((position - 128) /
/// 256).
/// Units: 1/256 pixel.
constexpr std::int32_t first_centre(std::int32_t position) {
    return (position + l3d_subpixel_one / 2 - 1) >> l3d_subpixel_bits;
}
constexpr std::int32_t first_centre(std::int64_t position) {
    return static_cast<std::int32_t>((position + l3d_subpixel_one / 2 - 1) >> l3d_subpixel_bits);
}

} // namespace l3d_detail

/// A range of pixels, from first to last, along x or along y.
///
/// Shape:   Number is std::int32_t, or double where a place may be beyond all integers.
template <class Number> struct l3d_pixel_centres {
    Number first, last;

    bool none() const { return last < first; }
    bool only_one() const { return last == first; }

    /// The pixels of the range that are in [begin, end).
    l3d_pixel_centres within(Number begin, Number end) const {
        return {std::max(first, begin), std::min(last, end - 1)};
    }
};

/// The pixels whose centres lie in [low, high], both ends included. Units: 1/256 pixel.
constexpr l3d_pixel_centres<std::int32_t> l3d_centres_in(std::int32_t low, std::int32_t high) {
    return {l3d_detail::first_centre(low), l3d_detail::first_centre(high + 1) - 1};
}

/// The pixels whose centres lie in [low, high). By the fill rule, these pixels belong to a polygon
/// from low to high.
/// Units: 1/256 pixel.
constexpr l3d_pixel_centres<std::int32_t> l3d_centres_filled(std::int32_t low, std::int32_t high) {
    return {l3d_detail::first_centre(low), l3d_detail::first_centre(high) - 1};
}

/// The pixels whose centres may lie between two places, if snapping moves each place by up to one
/// sub-pixel.
/// Units: pixels; `corner` is the place where pixel 0 begins.
inline l3d_pixel_centres<double> l3d_centres_near(double low, double high, double corner) {
    constexpr double slack = 1.0 / l3d_subpixel_one;
    return {std::ceil(low - corner - slack - 0.5), std::floor(high - corner + slack - 0.5)};
}

#endif
