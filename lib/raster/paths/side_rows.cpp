// SPDX-License-Identifier: MIT
// side_rows: a row a lane, for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/paths/side_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/paths/side_rows_p.h"

#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

using lane_integers = hn::Rebind<std::int32_t, eight_doubles>;
using integers = hn::Vec<lane_integers>;

HWY_ATTR HWY_INLINE number between(number x, number low, number high) {
    return {hn::Min(hn::Max(x.v, low.v), high.v)};
}
HWY_ATTR HWY_INLINE integers truncated(number x) {
    return hn::DemoteTo(lane_integers(), x.v);
}

/// Where a side is at heights.
HWY_ATTR HWY_INLINE number x_at(const straight_side& side, number y) {
    return between(same(side.x0) + (y - same(side.y0)) * same(side.slope), same(side.least),
                   same(side.most));
}

/// The byte of a word of four that is the i-th in memory.
constexpr int shift_of(int i) {
    return std::endian::native == std::endian::little ? 8 * i : 24 - 8 * i;
}

/// G(x) is the area right of an edge from l to r and left of x. It is 0 up to l, and (x - l)^2 /
/// 2 (r - l) up to r. From there on it grows by one a pixel. A pixel has the difference of its
/// ends.
HWY_ATTR HWY_INLINE void find_lanes(const straight_side& side, double row, double full,
                                    side_row* rows) {
    const eight_doubles d;
    const number y = {hn::Add(hn::Iota(d, 0), hn::Set(d, row))}, zero = same(0), one = same(1);
    const number top = x_at(side, y), bottom = x_at(side, y + one);
    const number left = {hn::Min(top.v, bottom.v)}, right = largest(top, bottom);
    const number wide = right - left, least = same(std::numeric_limits<double>::min());
    const number half_inverse = same(0.5) / largest(wide, least);
    number at = {hn::Floor(left.v)};
    const integers first = truncated(at);
    number before = zero;
    integers values = hn::Zero(lane_integers());
    const auto column = [&](auto i) HWY_ATTR {
        at = at + one;
        const number in = between(at - left, zero, wide);
        const number area = in * in * half_inverse + largest(at - right, zero);
        const number right_of = between(area - before, zero, one);
        before = area;
        const number covered = side.is_left ? right_of : one - right_of;
        values = hn::Or(values,
                        hn::ShiftLeft<shift_of(i())>(truncated(covered * same(full) + same(0.5))));
    };
    column(std::integral_constant<int, 0>());
    column(std::integral_constant<int, 1>());
    column(std::integral_constant<int, 2>());
    column(std::integral_constant<int, 3>());
    HWY_ALIGN std::int32_t firsts[hn::MaxLanes(d)], words[hn::MaxLanes(d)];
    hn::Store(first, lane_integers(), firsts);
    hn::Store(values, lane_integers(), words);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i)
        rows[i] = {firsts[i], std::bit_cast<std::array<std::uint8_t, 4>>(words[i])};
}

void find_side_rows_in_lanes(const straight_side& side, std::int32_t row, std::size_t count,
                             double full, side_row* rows) {
    static_assert(hn::MaxLanes(eight_doubles()) <= side_row::at_once);
    for (std::size_t i = 0; i < count; i += lanes_at_once())
        find_lanes(side, row + static_cast<double>(i), full, rows + i);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(find_side_rows_in_lanes);

void find_side_rows(const straight_side& side, std::int32_t row, std::size_t count, double full,
                    side_row* rows) {
    L3D_SIMD_CALL(find_side_rows_in_lanes)(side, row, count, full, rows);
}

} // namespace l3d_detail
#endif
