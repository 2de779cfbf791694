// SPDX-License-Identifier: MIT
// triangle_runs: lines of sides in double, a row a lane.
#include "raster/shapes/triangle_runs_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shapes/triangle_runs.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/lane_places-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/shapes/attribute_plane_p.h"

#include <algorithm>
#include <utility>

#ifndef L3D_RASTER_SHAPES_TRIANGLE_RUNS_ONCE
#define L3D_RASTER_SHAPES_TRIANGLE_RUNS_ONCE
namespace l3d_detail {

/// Rows side by side, and the lines that limit them.
struct rows_between {
    const std::array<scan_edge::line, 3>& lines;
    bool is_long_left;
    std::int32_t stepped; ///< rows from where the lines begin to the first row
    std::int32_t row, width;
};

} // namespace l3d_detail
#endif

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

using integers = hn::Rebind<std::int32_t, eight_doubles>;
using columns_of_rows = hn::Vec<integers>;

HWY_INLINE columns_of_rows set(std::int32_t value) {
    return hn::Set(integers(), value);
}

/// scan_edge::column of each row. Where a line is far outside of the triangle, it is held at
/// columns that no corner can be in.
HWY_INLINE columns_of_rows column_of(const scan_edge::line& line, number row) {
    const number place = (same(line.first) + same(line.per_row) * row) * same(line.inverse);
    const auto inside = hn::Min(hn::Max(place.v, same(0).v), same(2.0 * scan_edge::offset).v);
    return hn::Sub(hn::DemoteTo(integers(), inside), set(scan_edge::offset));
}

template <bool IsLongLeft> HWY_INLINE void find(const rows_between& of, wide_runs& runs) {
    for (std::size_t i = 0; i < runs.count; i += lanes_at_once()) {
        const auto place = places_from(integers(), static_cast<std::int32_t>(i));
        const number row{hn::PromoteTo(eight_doubles(), hn::Add(place, set(of.stepped)))};
        const auto along = column_of(of.lines[0], row);
        const auto upper = column_of(of.lines[1], row), lower = column_of(of.lines[2], row);
        const auto start = IsLongLeft ? along : hn::Max(upper, lower);
        const auto end = IsLongLeft ? hn::Min(upper, lower) : along;
        hn::Store(hn::Add(place, set(of.row)), integers(), runs.row.data() + i);
        hn::Store(start, integers(), runs.start.data() + i);
        hn::Store(hn::Max(start, set(0)), integers(), runs.begin.data() + i);
        hn::Store(hn::Min(end, set(of.width)), integers(), runs.end.data() + i);
    }
}

void find_runs(const rows_between& of, wide_runs& runs) {
    if (of.is_long_left)
        find<true>(of, runs);
    else
        find<false>(of, runs);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(find_runs);

namespace {

/// The line from a corner to one that is not above it; of a level side one that limits nothing, on
/// the left or on the right of all columns.
scan_edge::line line_between(scan_point upper, scan_point lower, std::int32_t row, bool is_left) {
    if (upper.y == lower.y)
        return {is_left ? 0.0 : 2.0 * scan_edge::offset, 0, 1};
    return scan_edge(upper, lower, row).from_there();
}

} // namespace

triangle_runs::triangle_runs(const std::array<scan_point, 3>& corners, scan_rows kept) {
    auto [a, b, c] = corners;
    const auto put_in_order = [](scan_point& upper, scan_point& lower) {
        if (lower.y < upper.y)
            std::swap(upper, lower);
    };
    put_in_order(a, b);
    put_in_order(b, c);
    put_in_order(a, b);
    const std::int64_t turn = cross(c - a, b - a); // below 0 if b is on the right of the long side
    rows_ = {std::max(first_centre(a.y), kept.top), std::min(first_centre(c.y), kept.bottom)};
    if (turn == 0 || rows_.top >= rows_.bottom) {
        rows_ = {};
        return;
    }
    is_long_left_ = turn < 0;
    lines_ = {line_between(a, c, rows_.top, is_long_left_),
              line_between(a, b, rows_.top, !is_long_left_),
              line_between(b, c, rows_.top, !is_long_left_)};
}

bool triangle_runs::next(std::int32_t width, wide_runs& runs) {
    constexpr auto most = static_cast<std::int32_t>(wide_runs::room);
    const std::int32_t count = std::min(rows_.bottom - rows_.top, most);
    runs.count = static_cast<std::size_t>(count);
    if (count == 0)
        return false;
    L3D_SIMD_CALL(find_runs)({lines_, is_long_left_, found_, rows_.top, width}, runs);
    found_ += count;
    rows_.top += count;
    return true;
}

} // namespace l3d_detail
#endif
