// SPDX-License-Identifier: MIT
// Projects homogeneous image points to sub-pixels, in each number type.
#ifndef L3D_DICE_SNAP_H
#define L3D_DICE_SNAP_H

#include "geom/real.h"
#include "raster/surface_part.h"

#include <concepts>
#include <cstdint>

/// A projected point: its place in 1/256 pixel from the picture's centre, and the reciprocal of its
/// scaled w.
struct l3d_snapped {
    std::int32_t x, y;
    float inv_w;
};

namespace l3d_detail {

/// Rounds to the nearest integer, ties away from zero. The cast is the one conversion from float to
/// integer that every processor has in vector form.
template <std::floating_point T> std::int32_t rounded(T value) {
    return static_cast<std::int32_t>(value < 0 ? value - T(0.5) : value + T(0.5));
}

} // namespace l3d_detail

/// Projects a homogeneous point to (x / w, y / w), rounded to 1/256 pixel.
///
/// Expects: w > 0, |x / w| and |y / w| at most l3d_guard_band.
/// Errors:  the reciprocal and the product are rounded: at most 2.01 u |x / w|, with the unit
///          roundoff u. Snapping adds half a sub-pixel in each coordinate.
template <std::floating_point T> l3d_snapped l3d_snap(T x, T y, T w) {
    const T reciprocal = T(1) / w;
    return {l3d_detail::rounded(x * reciprocal * T(l3d_subpixel_one)),
            l3d_detail::rounded(y * reciprocal * T(l3d_subpixel_one)),
            static_cast<float>(reciprocal)};
}

/// Projects a point in fixed point. Each coordinate is one exact quotient that is rounded once.
/// Expects: w > 0, |x / w| and |y / w| at most l3d_guard_band, and |x| and |y| below 2^(bits - 1 -
///          8) raw. The guard band and the image transform's scale ensure this limit.
template <class S, int F, l3d_overflow O>
l3d_snapped l3d_snap(l3d_fixed<S, F, O> x, l3d_fixed<S, F, O> y, l3d_fixed<S, F, O> w) {
    const auto divided = [&](l3d_fixed<S, F, O> value) {
        return static_cast<std::int32_t>(l3d_detail::divided_to_nearest(
            std::int64_t{value.raw()} * l3d_subpixel_one, std::int64_t{w.raw()}));
    };
    return {divided(x), divided(y), static_cast<float>(1 / l3d_to_double(w))};
}

/// Bounds the error that l3d_snap adds to a vertex whose coordinates in the picture are at most
/// `reach`. Units: pixels.
template <class T> double l3d_snap_error(double reach) {
    constexpr double root_two = 1.4142135623730951;
    return root_two * (2.01 * l3d_real_traits<T>::unit_roundoff * reach + 0.5 / l3d_subpixel_one);
}

#endif
