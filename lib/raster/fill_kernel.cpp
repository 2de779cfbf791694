// SPDX-License-Identifier: MIT
// fill_kernel: polygons are queued, set up a vector at a time, and filled one by one.
#include "raster/fill_kernel_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fill_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/simd_dispatch_p.h"

#include "raster/fill_group-inl.h"
#include "raster/fill_pixels-inl.h"

#include <algorithm>
#include <cassert>

namespace l3d_detail {
extern int dbg_stage;
}
HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Where one corner of a row of polygons lies in memory, side by side.
///
/// Shape: `size` elements in each array may be read.
struct corner_arrays {
    const std::int32_t* x;
    const std::int32_t* y;
    const float* inv_w;
    const float* normal[3];
    std::size_t size;
};

/// A vector from an array's element `at` on; zeros behind its end.
template <class D, class T>
HWY_INLINE hn::Vec<D> load_within(D d, const T* array, std::size_t at, std::size_t size) {
    if (HWY_LIKELY(at + lanes <= size))
        return hn::LoadU(d, array + at);
    HWY_ALIGN T part[lanes] = {};
    std::copy(array + at, array + size, part);
    return hn::Load(d, part);
}

/// Takes polygons, keeps those that may cover a pixel, and fills them when there are enough.
template <int Corners> class fill_stream {
public:
    HWY_INLINE explicit fill_stream(const fill_job& job) : job_(job) {}

    /// Takes polygons [at, at + count) of arrays of corners, the first one called `id`.
    HWY_INLINE void take(const corner_arrays (&from)[Corners], const std::size_t (&at)[Corners],
                         std::size_t count, std::int32_t id) {
        for (std::size_t i = 0; i < count; i += lanes)
            take_vector(from, at, i, std::min(lanes, count - i), id);
    }

    HWY_INLINE void finish() {
        std::size_t at = 0;
        for (; at < queue_.count; at += lanes)
            fill(at, std::min(lanes, queue_.count - at));
        queue_.count = 0;
    }

private:
    HWY_INLINE void take_vector(const corner_arrays (&from)[Corners],
                                const std::size_t (&at)[Corners], std::size_t i, std::size_t count,
                                std::int32_t id) {
        const ints d;
        const floats df;
        int_vec x[Corners], y[Corners];
        for (std::size_t k = 0; k < Corners; ++k) {
            x[k] = load_within(d, from[k].x, at[k] + i, from[k].size);
            y[k] = load_within(d, from[k].y, at[k] + i, from[k].size);
        }
        const int_mask live =
            hn::And(hn::FirstN(d, count), hn::And(meets(x, 0, job_.band.width),
                                                  meets(y, job_.band.top, job_.band.bottom)));
        const std::size_t found = hn::CountTrue(d, live);
        if (found == 0)
            return;
        const std::size_t to = queue_.count;
        for (std::size_t k = 0; k < Corners; ++k) {
            put(x[k], live, queue_.corner[k][0] + to);
            put(y[k], live, queue_.corner[k][1] + to);
            const auto number = [&](const float* array) HWY_ATTR {
                return hn::BitCast(d, load_within(df, array, at[k] + i, from[k].size));
            };
            put(number(from[k].inv_w), live, queue_.corner[k][2] + to);
            for (std::size_t c = 0; c < 3; ++c)
                put(number(from[k].normal[c]), live, queue_.corner[k][3 + c] + to);
        }
        put(hn::Iota(d, id + static_cast<std::int32_t>(i)), live, queue_.id + to);
        queue_.count += found;
        if (queue_.count > fill_queue::most - lanes)
            fill_whole();
    }

    static HWY_INLINE void put(int_vec v, int_mask live, std::int32_t* to) {
        hn::StoreU(hn::Compress(v, live), ints(), to);
    }

    /// Whether a pixel centre in [begin, end) lies between the corners.
    static HWY_INLINE int_mask meets(const int_vec (&v)[Corners], std::int32_t begin,
                                     std::int32_t end) {
        int_vec least = v[0], most = v[0];
        for (std::size_t k = 1; k < Corners; ++k) {
            least = hn::Min(least, v[k]);
            most = hn::Max(most, v[k]);
        }
        return hn::Lt(hn::Max(first_centre_of(least), set(begin)),
                      hn::Min(first_centre_of(most), set(end)));
    }

    /// Fills whole vectors and moves the others to the front.
    HWY_NOINLINE void fill_whole() {
        std::size_t at = 0;
        for (; at + lanes <= queue_.count; at += lanes)
            fill(at, lanes);
        const ints d;
        for (std::size_t k = 0; k < Corners; ++k)
            for (auto& component : queue_.corner[k])
                hn::Store(hn::LoadU(d, component + at), d, component);
        hn::Store(hn::LoadU(d, queue_.id + at), d, queue_.id);
        queue_.count -= at;
    }

    HWY_NOINLINE void fill(std::size_t at, std::size_t count) {
        if (dbg_stage == 1)
            return;
        fill_group<Corners> group;
        if (!group.set_up(job_, queue_, at, count, table_))
            return;
        if (dbg_stage == 2)
            return;
        if (table_.curved && dbg_stage != 3)
            job_.counts.written += fill_pixels<true>(job_.band, table_);
        else
            job_.counts.written += fill_pixels<false>(job_.band, table_);
    }

    fill_job job_;
    fill_queue queue_;
    fill_table table_;
};

corner_arrays arrays_of(const l3d_micro_grid& grid) {
    return {grid.x.data(),
            grid.y.data(),
            grid.inv_w.data(),
            {grid.normal[0].data(), grid.normal[1].data(), grid.normal[2].data()},
            grid.x.size()};
}

corner_arrays arrays_of(const l3d_micro_triangles::corner& corner) {
    return {corner.x.data(),
            corner.y.data(),
            corner.inv_w.data(),
            {corner.normal[0].data(), corner.normal[1].data(), corner.normal[2].data()},
            corner.x.size()};
}

void fill_quads(const fill_band& band, const fill_shading& shading, const l3d_micro_grid& grid,
                int row_begin, int row_end, int column_begin, int column_end, fill_counts& counts,
                fill_rest& rest) {
    if (column_begin >= column_end)
        return;
    const corner_arrays a = arrays_of(grid);
    const corner_arrays from[4] = {a, a, a, a};
    fill_stream<4> stream({band, shading, counts, rest.quads});
    for (int row = row_begin; row < row_end; ++row) {
        const std::size_t p00 = grid.index(row, column_begin);
        const std::size_t p01 = grid.index(row + 1, column_begin);
        stream.take(from, {p00, p00 + 1, p01 + 1, p01},
                    static_cast<std::size_t>(column_end - column_begin),
                    static_cast<std::int32_t>(p00));
    }
    stream.finish();
}

void fill_triangles(const fill_band& band, const fill_shading& shading,
                    const l3d_micro_triangles& triangles, std::size_t first, std::size_t last,
                    fill_counts& counts, fill_rest& rest) {
    const auto& corners = triangles.corners;
    const corner_arrays from[3] = {arrays_of(corners[0]), arrays_of(corners[1]),
                                   arrays_of(corners[2])};
    fill_stream<3> stream({band, shading, counts, rest.triangles});
    stream.take(from, {first, first, first}, last - first, static_cast<std::int32_t>(first));
    stream.finish();
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace l3d_detail {

int dbg_stage = 0;
L3D_SIMD_TABLE(fill_quads);
L3D_SIMD_TABLE(fill_triangles);

void fill_quads(const fill_band& band, const fill_shading& shading, const l3d_micro_grid& grid,
                int row_begin, int row_end, int column_begin, int column_end, fill_counts& counts,
                fill_rest& rest) {
    assert(band.width >= fill_least_width);
    L3D_SIMD_CALL(fill_quads)
    (band, shading, grid, row_begin, row_end, column_begin, column_end, counts, rest);
}

void fill_triangles(const fill_band& band, const fill_shading& shading,
                    const l3d_micro_triangles& triangles, std::size_t first, std::size_t last,
                    fill_counts& counts, fill_rest& rest) {
    assert(band.width >= fill_least_width);
    L3D_SIMD_CALL(fill_triangles)(band, shading, triangles, first, last, counts, rest);
}

} // namespace l3d_detail

#endif
