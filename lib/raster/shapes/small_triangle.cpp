// SPDX-License-Identifier: MIT
// small_triangle: edge functions in lanes, for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shapes/small_triangle.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"
#include "raster/shapes/scan_edge_p.h"
#include "raster/shapes/small_triangle_p.h"
#include "raster/parallel/store_where-inl.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<std::uint32_t, 16> words;
constexpr hn::RebindToSigned<decltype(words)> integers;
constexpr hn::RebindToFloat<decltype(words)> floats;
using word_lanes = hn::Vec<decltype(words)>;
using integer_lanes = hn::Vec<decltype(integers)>;

/// To whole units of 1/256 pixel. Expects: |position| <= 2^15.
HWY_INLINE std::int32_t units(double position) {
    return static_cast<std::int32_t>(std::lrint(position * l3d_subpixel_one));
}

/// Where three coordinates lie, in pixels.
struct bounds {
    double low, high;

    HWY_INLINE bounds(double a, double b, double c)
        : low(std::min(std::min(a, b), c)), high(std::max(std::max(a, b), c)) {}

    HWY_INLINE bool small_within(double end) const {
        return low >= 0 && high <= end && high - low <= small_side;
    }
    /// The pixels whose samples are not before the low or the high end.
    HWY_INLINE std::int32_t first() const { return first_sample(low); }
    HWY_INLINE std::int32_t last() const { return first_sample(high); }

private:
    HWY_INLINE static std::int32_t first_sample(double position) {
        return (units(position) + l3d_subpixel_one - 1) >> l3d_subpixel_bits;
    }
};

/// An edge function in a row of samples, and what it gains from row to row: not below 0 where
/// the sample is inside. On an edge that is neither left nor top it is -1.
struct edge_lanes {
    integer_lanes value, per_row;
    std::int32_t per_column;

    /// Corners as seen from the first sample.
    HWY_INLINE edge_lanes(scan_point from, scan_point to) {
        const std::int32_t dx = to.x - from.x, dy = to.y - from.y;
        // negative on a left or top edge, where dy < 0, or dy = 0 and dx > 0; for |dx| < 2^14
        const std::int32_t order = dy * (1 << 14) - dx;
        const std::int32_t first = dy * from.x - dx * from.y - 1 - (order >> 31);
        per_column = -l3d_subpixel_one * dy;
        value = hn::Add(hn::Set(integers, first),
                        hn::Mul(hn::Iota(integers, 0), hn::Set(integers, per_column)));
        per_row = hn::Set(integers, l3d_subpixel_one * dx);
    }

    /// To the next vector of columns.
    HWY_INLINE void step_right() {
        const auto lanes = static_cast<std::int32_t>(hn::Lanes(words));
        value = hn::Add(value, hn::Set(integers, lanes * per_column));
    }
};

/// The words of a triangle of one colour.
struct one_color {
    std::uint32_t color;

    HWY_INLINE bool begin(std::array<scan_point, 3>, std::int32_t) { return true; }
    HWY_INLINE void begin_block(std::int32_t) {}
    HWY_INLINE word_lanes next_row() { return hn::Set(words, color); }
};

/// The words of a triangle whose colours are linear. Each stays between the corners'.
struct linear_colors {
    const std::array<std::array<double, 3>, 3>& colors;
    std::array<float, 3> start{}, across{}, down{}, low{}, high{};
    hn::Vec<decltype(floats)> red{}, green{}, blue{};

    /// False if a channel changes by more than 2^12 over small_side: float would not do. So sums
    /// are below 2^13, and a few roundings of theirs below 2^-9.
    HWY_INLINE bool begin(std::array<scan_point, 3> p, std::int32_t area) {
        const double qx = p[1].x - p[0].x, qy = p[1].y - p[0].y;
        const double rx = p[2].x - p[0].x, ry = p[2].y - p[0].y;
        const double scale = 1.0 / area;
        constexpr double most = 4096.0 / (small_side * l3d_subpixel_one);
        for (std::size_t k = 0; k < 3; ++k) {
            const double a = colors[0][k], b = colors[1][k], c = colors[2][k];
            const double dx = ((b - a) * ry - (c - a) * qy) * scale;
            const double dy = ((c - a) * qx - (b - a) * rx) * scale;
            if (!(std::abs(dx) < most && std::abs(dy) < most))
                return false;
            start[k] = static_cast<float>(a - dx * p[0].x - dy * p[0].y);
            across[k] = static_cast<float>(dx * l3d_subpixel_one);
            down[k] = static_cast<float>(dy * l3d_subpixel_one);
            low[k] = static_cast<float>(std::min({a, b, c}));
            high[k] = static_cast<float>(std::max({a, b, c}));
        }
        return true;
    }

    HWY_INLINE void begin_block(std::int32_t column) {
        const auto i = hn::ConvertTo(floats, hn::Iota(integers, column));
        const auto value = [&](std::size_t k) {
            return hn::Add(hn::Set(floats, start[k]), hn::Mul(hn::Set(floats, across[k]), i));
        };
        red = value(0);
        green = value(1);
        blue = value(2);
    }

    HWY_INLINE word_lanes next_row() {
        const auto level = [&](hn::Vec<decltype(floats)>& value, std::size_t k) {
            const auto within =
                hn::Min(hn::Max(value, hn::Set(floats, low[k])), hn::Set(floats, high[k]));
            value = hn::Add(value, hn::Set(floats, down[k]));
            return hn::BitCast(words,
                               hn::ConvertTo(integers, hn::Add(within, hn::Set(floats, 0.5f))));
        };
        return hn::Or(hn::Or(hn::ShiftLeft<16>(level(red, 0)), hn::ShiftLeft<8>(level(green, 1))),
                      level(blue, 2));
    }
};

template <class Colors>
bool fill_small(const l3d_pixels& target, std::span<const l3d_point_2d, 3> corners,
                const std::array<double, 2>& ends, Colors colors) {
    const l3d_point_2d &a = corners[0], &b = corners[1], &c = corners[2];
    if (std::isnan(a.x + b.x + c.x + a.y + b.y + c.y))
        return false; // comparisons may lose a NaN, a sum does not
    const bounds x(a.x, b.x, c.x), y(a.y, b.y, c.y);
    if (!x.small_within(ends[0]) || !y.small_within(ends[1]))
        return false;
    const std::int32_t left = x.first(), right = x.last(), top = y.first(), bottom = y.last();
    const auto seen = [=](const l3d_point_2d& at) {
        return scan_point{units(at.x) - l3d_subpixel_one * left,
                          units(at.y) - l3d_subpixel_one * top};
    };
    const scan_point p = seen(a);
    scan_point q = seen(b), r = seen(c);
    const std::int32_t area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (area == 0)
        return true;
    if (!colors.begin({p, q, r}, area))
        return false;
    if (area < 0)
        std::swap(q, r);
    edge_lanes pq(p, q), qr(q, r), rp(r, p);
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(words));
    const std::ptrdiff_t stride = target.stride;
    std::uint32_t* block = target.words + top * stride + left;
    std::int32_t room = target.width - left;
    for (std::int32_t columns = right - left; columns > 0; columns -= lanes, block += lanes) {
        integer_lanes u = pq.value, v = qr.value, w = rp.value;
        std::uint32_t* at = block;
        colors.begin_block(right - left - columns);
        for (std::int32_t rows = bottom - top; rows > 0; --rows, at += stride) {
            const word_lanes word = colors.next_row();
            const auto inside = hn::Gt(hn::Or(hn::Or(u, v), w), hn::Set(integers, -1));
            if (HWY_LIKELY(room >= lanes))
                store_where(hn::RebindMask(floats, inside), word, words, at);
            else
                hn::BlendedStore(word, hn::RebindMask(words, inside), words, at);
            u = hn::Add(u, pq.per_row);
            v = hn::Add(v, qr.per_row);
            w = hn::Add(w, rp.per_row);
        }
        room -= lanes;
        if (columns > lanes) {
            pq.step_right();
            qr.step_right();
            rp.step_right();
        }
    }
    return true;
}

bool fill_small_triangle_in_lanes(const l3d_pixels& target,
                                  std::span<const l3d_point_2d, 3> corners,
                                  const std::array<double, 2>& ends, std::uint32_t color) {
    return fill_small(target, corners, ends, one_color{color});
}

bool shade_small_triangle_in_lanes(const l3d_pixels& target,
                                   std::span<const l3d_point_2d, 3> corners,
                                   const std::array<double, 2>& ends,
                                   const std::array<std::array<double, 3>, 3>& colors) {
    return fill_small(target, corners, ends, linear_colors{colors});
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(fill_small_triangle_in_lanes);
L3D_SIMD_TABLE(shade_small_triangle_in_lanes);

bool fill_small_triangle(const l3d_pixels& target, std::span<const l3d_point_2d, 3> corners,
                         const std::array<double, 2>& ends, std::uint32_t color) {
    return L3D_SIMD_CALL(fill_small_triangle_in_lanes)(target, corners, ends, color);
}

bool shade_small_triangle(const l3d_pixels& target, std::span<const l3d_point_2d, 3> corners,
                          const std::array<double, 2>& ends,
                          const std::array<std::array<double, 3>, 3>& colors) {
    return L3D_SIMD_CALL(shade_small_triangle_in_lanes)(target, corners, ends, colors);
}

} // namespace l3d_detail
#endif
