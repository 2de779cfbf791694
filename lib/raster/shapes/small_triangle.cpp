// SPDX-License-Identifier: MIT
// small_triangle: sets up edges in lanes, for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shapes/small_triangle.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"
#include "raster/shapes/scan_edge_p.h"
#include "raster/shapes/small_fill-inl.h"
#include "raster/shapes/small_triangle_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The pixel words of a triangle that has a single colour, for fill_box.
template <class Lanes> struct one_color {
    std::uint32_t color;

    HWY_INLINE void begin_block(std::int32_t) {}
    HWY_INLINE auto next_row() { return hn::Set(Lanes::words, color); }
};

/// A position in whole units of 1/256 pixel. Expects: |position| <= 2^15 pixels.
HWY_INLINE std::int32_t units(double position) {
    return static_cast<std::int32_t>(std::lrint(position * l3d_subpixel_one));
}

/// The range of the three corners' coordinates along one axis, in pixels.
struct bounds {
    double low, high;

    HWY_INLINE bounds(double a, double b, double c)
        : low(std::min(std::min(a, b), c)), high(std::max(std::max(a, b), c)) {}

    HWY_INLINE bool small_within(double end) const {
        return low >= 0 && high <= end && high - low <= small_side;
    }
    /// first() is the first pixel whose sample is not before the low end. last() is the same for
    /// the high end.
    HWY_INLINE std::int32_t first() const { return first_sample(low); }
    HWY_INLINE std::int32_t last() const { return first_sample(high); }

private:
    HWY_INLINE static std::int32_t first_sample(double position) {
        return (units(position) + l3d_subpixel_one - 1) >> l3d_subpixel_bits;
    }
};

/// The edge function between two corners, relative to the first sample.
HWY_INLINE small_edge edge_between(scan_point from, scan_point to) {
    const std::int32_t dx = to.x - from.x, dy = to.y - from.y;
    // a left or top edge has dy < 0, or dy = 0 and dx > 0: then this is negative, for |dx| < 2^14
    const std::int32_t order = dy * (1 << 14) - dx;
    return {dy * from.x - dx * from.y - 1 - (order >> 31), -l3d_subpixel_one * dy,
            l3d_subpixel_one * dx};
}

template <class Lanes>
HWY_INLINE void fill(const l3d_pixels& target, const small_box& box,
                     const std::array<small_edge, 3>& edges, std::uint32_t color) {
    one_color<Lanes> word{color};
    fill_box<Lanes>(target, box, edges, word);
}

bool fill_small_triangle_in_lanes(const l3d_pixels& target,
                                  std::span<const l3d_point_2d, 3> corners,
                                  const std::array<double, 2>& ends, std::uint32_t color) {
    const l3d_point_2d &a = corners[0], &b = corners[1], &c = corners[2];
    if (std::isnan(a.x + b.x + c.x + a.y + b.y + c.y))
        return false; // comparisons may lose a NaN, but a sum does not
    const bounds x(a.x, b.x, c.x), y(a.y, b.y, c.y);
    if (!x.small_within(ends[0]) || !y.small_within(ends[1]))
        return false;
    const small_box box{x.first(), y.first(), x.last() - x.first(), y.last() - y.first()};
    const auto seen = [=](const l3d_point_2d& at) {
        return scan_point{units(at.x) - l3d_subpixel_one * box.left,
                          units(at.y) - l3d_subpixel_one * box.top};
    };
    const scan_point p = seen(a);
    scan_point q = seen(b), r = seen(c);
    const std::int32_t area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (area == 0)
        return true;
    if (area < 0)
        std::swap(q, r);
    const std::array<small_edge, 3> edges{edge_between(p, q), edge_between(q, r),
                                          edge_between(r, p)};
    constexpr int narrow = 8; // many processors handle vectors of 64 bytes in two steps
    if (box.columns <= narrow)
        fill<pixel_lanes<narrow>>(target, box, edges, color);
    else
        fill<pixel_lanes<2 * narrow>>(target, box, edges, color);
    return true;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(fill_small_triangle_in_lanes);

bool fill_small_triangle(const l3d_pixels& target, std::span<const l3d_point_2d, 3> corners,
                         const std::array<double, 2>& ends, std::uint32_t color) {
    return L3D_SIMD_CALL(fill_small_triangle_in_lanes)(target, corners, ends, color);
}

} // namespace l3d_detail
#endif
