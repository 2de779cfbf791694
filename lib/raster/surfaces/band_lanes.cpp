// SPDX-License-Identifier: MIT
// band_lanes: bounds vertices, for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/surfaces/band_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/surfaces/band_cells_p.h"
#include "raster/shapes/scan_edge_p.h"
#include "raster/parallel/lane_integers-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

struct lane_bounds {
    int_vec left, top, right, bottom;
    float_vec nearest;
};

HWY_INLINE lane_bounds nothing() {
    constexpr std::int32_t most = 0x7fffffff;
    return {set(most), set(most), set(-most), set(-most), hn::Zero(floats())};
}

/// Extends bounds by `count` vertices from `begin` on, and masks the lanes of other vertices. If a
/// vector from `begin` on would end after the last of `size` elements, the vector starts earlier.
/// Expects: size >= 16.
HWY_INLINE void take(lane_bounds& b, const std::int32_t* x, const std::int32_t* y,
                     const float* inv_w, std::size_t begin, std::size_t count, std::size_t size) {
    const int_vec first = set(static_cast<std::int32_t>(begin));
    const int_vec end = set(static_cast<std::int32_t>(begin + count));
    for (std::size_t i = begin; i < begin + count; i += lanes) {
        const std::size_t at = std::min(i, size - lanes);
        const int_vec place = hn::Add(hn::Iota(ints(), 0), set(static_cast<std::int32_t>(at)));
        const auto inside = hn::AndNot(hn::Lt(place, first), hn::Lt(place, end));
        const int_vec xs = hn::LoadU(ints(), x + at), ys = hn::LoadU(ints(), y + at);
        b.left = hn::IfThenElse(inside, hn::Min(b.left, xs), b.left);
        b.right = hn::IfThenElse(inside, hn::Max(b.right, xs), b.right);
        b.top = hn::IfThenElse(inside, hn::Min(b.top, ys), b.top);
        b.bottom = hn::IfThenElse(inside, hn::Max(b.bottom, ys), b.bottom);
        const float_vec depths = hn::LoadU(floats(), inv_w + at);
        b.nearest =
            hn::IfThenElse(hn::RebindMask(floats(), inside), hn::Max(b.nearest, depths), b.nearest);
    }
}

HWY_INLINE std::int32_t least(int_vec v) {
    return hn::GetLane(hn::MinOfLanes(ints(), v));
}
HWY_INLINE std::int32_t greatest(int_vec v) {
    return hn::GetLane(hn::MaxOfLanes(ints(), v));
}

HWY_INLINE polygon_bounds reduced(const lane_bounds& b) {
    return {{least(b.left), least(b.top), greatest(b.right), greatest(b.bottom)},
            hn::GetLane(hn::MaxOfLanes(floats(), b.nearest))};
}

polygon_bounds bounds_of_cells(const l3d_micro_grid& grid, const grid_cells& cells,
                               band_rows* rows) {
    const auto count = static_cast<std::size_t>(cells.column_end - cells.column_begin) + 1;
    lane_bounds all = nothing();
    band_rows above{};
    for (int row = cells.row_begin; row <= cells.row_end; ++row) {
        lane_bounds here = all;
        here.top = nothing().top;
        here.bottom = nothing().bottom;
        take(here, grid.x.data(), grid.y.data(), grid.inv_w.data(),
             grid.index(row, cells.column_begin), count, grid.x.size());
        const band_rows below{least(here.top), greatest(here.bottom)};
        if (row > cells.row_begin)
            *rows++ = {first_centre(std::min(above.top, below.top)),
                       first_centre(std::max(above.bottom, below.bottom))};
        above = below;
        here.top = hn::Min(here.top, all.top);
        here.bottom = hn::Max(here.bottom, all.bottom);
        all = here;
    }
    return reduced(all);
}

polygon_bounds bounds_of_triangles(const l3d_micro_triangles& triangles, std::size_t first,
                                   std::size_t last) {
    lane_bounds all = nothing();
    constexpr std::size_t in_block = l3d_micro_triangles::lanes;
    for (std::size_t i = first; i < last; i = (i / in_block + 1) * in_block)
        for (const l3d_micro_triangles::corner& c : triangles.blocks[i / in_block]) {
            const std::size_t at = i % in_block, count = std::min(last - i, in_block - at);
            take(all, c.x.data(), c.y.data(), c.inv_w.data(), at, count, in_block);
        }
    return reduced(all);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(bounds_of_cells);
L3D_SIMD_TABLE(bounds_of_triangles);

polygon_bounds bounds_of(const l3d_micro_grid& grid, const grid_cells& cells, band_rows* rows) {
    return L3D_SIMD_CALL(bounds_of_cells)(grid, cells, rows);
}

polygon_bounds bounds_of(const l3d_micro_triangles& triangles, std::size_t first,
                         std::size_t last) {
    return L3D_SIMD_CALL(bounds_of_triangles)(triangles, first, last);
}

} // namespace l3d_detail
#endif
