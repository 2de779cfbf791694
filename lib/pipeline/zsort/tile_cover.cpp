// SPDX-License-Identifier: MIT
// tile_cover: evaluates edge functions, one pixel in each lane.
#include "pipeline/zsort/tile_cover_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/zsort/tile_cover.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_integers-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

constexpr std::int32_t side = 8; // rows and columns of a tile
constexpr auto at_once = static_cast<std::int32_t>(lanes);

/// The function of a triangle's edge for all pixels: it is not negative where a pixel's centre is
/// inside of the edge.
///
/// Corners are at most 2^14 apart, and centres at most 2^14 + 2^11 from corners. So products are
/// below 2^29, and their differences below 2^30.
struct edge_function {
    std::int32_t first; ///< value of the function at the first pixel of the first tile
    std::int32_t per_column, per_row;
    int_vec pattern; ///< values at a vector's pixels, relative to the vector's first pixel

    HWY_INLINE void go_from(const l3d_micro_vertex& a, const l3d_micro_vertex& b, std::int32_t x,
                            std::int32_t y) {
        const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
        const bool is_left_or_top = dy < 0 || (dy == 0 && dx > 0);
        first = dx * (y - a.y) - dy * (x - a.x) - (is_left_or_top ? 0 : 1);
        per_column = -l3d_subpixel_one * dy;
        per_row = l3d_subpixel_one * dx;
        const int_vec place = hn::Iota(ints(), 0);
        pattern = hn::Add(hn::Mul(hn::And(place, set(side - 1)), set(per_column)),
                          hn::Mul(hn::ShiftRight<3>(place), set(per_row)));
    }
    HWY_INLINE int_vec at(std::int32_t column, std::int32_t row) const {
        return hn::Add(pattern, set(first + column * per_column + row * per_row));
    }
};

HWY_INLINE std::uint64_t cover_of(const edge_function (&edges)[3], std::int32_t left,
                                  std::int32_t top) {
    constexpr std::int32_t width = std::min(at_once, side), height = std::max(at_once / side, 1);
    std::uint64_t cover = 0;
    for (std::int32_t column = 0; column < side; column += width) {
        int_vec at[3], down[3];
        for (std::size_t i = 0; i < 3; ++i) {
            at[i] = edges[i].at(left + column, top);
            down[i] = set(height * edges[i].per_row);
        }
        for (std::int32_t row = 0; row < side; row += height) {
            const auto inside = hn::Gt(hn::Or(hn::Or(at[0], at[1]), at[2]), set(-1));
            cover |= bits_of(inside) << (side * row + column);
            for (std::size_t i = 0; i < 3; ++i)
                at[i] = hn::Add(at[i], down[i]);
        }
    }
    return cover;
}

void cover_tiles_of(const std::array<l3d_micro_vertex, 3>& v, const cover_tiles& tiles,
                    std::uint64_t* covers) {
    constexpr std::int32_t half = l3d_subpixel_one / 2;
    const std::int32_t x = l3d_subpixel_one * tiles.left + half;
    const std::int32_t y = l3d_subpixel_one * tiles.top + half;
    const std::int32_t area =
        (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x);
    edge_function edges[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const l3d_micro_vertex &a = v[i], &b = v[(i + 1) % 3];
        if (area > 0)
            edges[i].go_from(a, b, x, y);
        else
            edges[i].go_from(b, a, x, y);
    }
    for (std::int32_t row = 0; row < tiles.rows; ++row)
        for (std::int32_t column = 0; column < tiles.columns; ++column)
            *covers++ = area == 0 ? 0 : cover_of(edges, side * column, side * row);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(cover_tiles_of);

void tile_cover(const std::array<l3d_micro_vertex, 3>& v, const cover_tiles& tiles,
                std::uint64_t* covers) {
    L3D_SIMD_CALL(cover_tiles_of)(v, tiles, covers);
}

} // namespace l3d_detail
#endif
