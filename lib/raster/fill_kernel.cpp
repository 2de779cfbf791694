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
#include <array>
#include <bit>
#include <cassert>

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

/// A vector from an array's element `at` on; unless it is all `inside`, zeros behind the end.
template <bool Inside, class D, class T>
HWY_INLINE hn::Vec<D> load_within(D d, const T* array, std::size_t at, std::size_t size) {
    if constexpr (Inside)
        return hn::LoadU(d, array + at);
    HWY_ALIGN T part[hn::MaxLanes(D())] = {};
    std::copy(array + std::min(at, size), array + std::min(at + hn::MaxLanes(D()), size), part);
    return hn::Load(d, part);
}

/// Whether a pixel centre in [begin, end) lies between the corners.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> meets(D d, const V (&v)[4], std::int32_t begin, std::int32_t end) {
    const V least = hn::Min(hn::Min(v[0], v[1]), hn::Min(v[2], v[3]));
    const V most = hn::Max(hn::Max(v[0], v[1]), hn::Max(v[2], v[3]));
    return hn::Lt(hn::Max(first_centre_of(d, least), hn::Set(d, begin)),
                  hn::Min(first_centre_of(d, most), hn::Set(d, end)));
}

/// Keeps those polygons that may cover a pixel, and fills them when there are enough.
class fill_stream {
public:
    HWY_INLINE explicit fill_stream(const fill_target& target)
        : target_(target), queue_(target.queue) {}

    /// Takes polygons [at, at + count) of arrays of corners. The first one's name is `name`, the
    /// others' follow by `step`.
    HWY_INLINE void take(const corner_arrays (&from)[4], const std::size_t (&at)[4],
                         std::size_t count, const void* source, std::int32_t name,
                         std::int32_t step) {
        using few = hn::CappedTag<std::int32_t, (lanes + 1) / 2>;
        if (count <= hn::MaxLanes(few()))
            return take_some(few(), from, at, 0, count, source, name, step);
        for (std::size_t i = 0; i < count; i += lanes)
            take_some(ints(), from, at, i, std::min(lanes, count - i), source,
                      name + static_cast<std::int32_t>(i) * step, step);
    }

    HWY_INLINE void finish() {
        fill_rest_of_queue();
        for (const auto& piece : queue_.pieces) {
            add(piece);
            if (queue_.count == lanes)
                fill_rest_of_queue();
        }
        queue_.pieces.clear();
        fill_rest_of_queue();
    }

private:
    template <class D>
    HWY_INLINE void take_some(D d, const corner_arrays (&from)[4], const std::size_t (&at)[4],
                              std::size_t i, std::size_t count, const void* source,
                              std::int32_t name, std::int32_t step) {
        bool inside = true;
        for (std::size_t k = 0; k < 4; ++k)
            inside = inside && at[k] + i + hn::MaxLanes(d) <= from[k].size;
        if (HWY_LIKELY(inside))
            take_vector<true>(d, from, at, i, count, source, name, step);
        else
            take_vector<false>(d, from, at, i, count, source, name, step);
    }

    template <bool Inside, class D>
    HWY_INLINE void take_vector(D d, const corner_arrays (&from)[4], const std::size_t (&at)[4],
                                std::size_t i, std::size_t count, const void* source,
                                std::int32_t name, std::int32_t step) {
        using vec = hn::Vec<D>;
        const hn::RebindToFloat<D> df;
        vec x[4], y[4];
        for (std::size_t k = 0; k < 4; ++k) {
            x[k] = load_within<Inside>(d, from[k].x, at[k] + i, from[k].size);
            y[k] = load_within<Inside>(d, from[k].y, at[k] + i, from[k].size);
        }
        const fill_band& band = target_.band;
        const auto live =
            hn::And(hn::FirstN(d, count),
                    hn::And(meets(d, x, 0, band.width), meets(d, y, band.top, band.bottom)));
        const std::size_t found = hn::CountTrue(d, live);
        if (found == 0)
            return;
        const std::size_t to = queue_.count;
        const bool all = found == count;
        const auto put = [&](vec v, std::int32_t* place) HWY_ATTR {
            if (!all)
                v = hn::Compress(v, live);
            hn::StoreU(v, d, place + to);
        };
        const auto number = [&](std::size_t k, const float* array) HWY_ATTR {
            return hn::BitCast(d, load_within<Inside>(df, array, at[k] + i, from[k].size));
        };
        for (std::size_t k = 0; k < 4; ++k) {
            put(x[k], queue_.corner[k][0]);
            put(y[k], queue_.corner[k][1]);
            put(number(k, from[k].inv_w), queue_.corner[k][2]);
            for (std::size_t c = 0; c < 3; ++c)
                put(number(k, from[k].normal[c]), queue_.corner[k][3 + c]);
        }
        put(hn::Add(hn::Mul(hn::Iota(d, 0), hn::Set(d, step)), hn::Set(d, name)), queue_.name);
        std::fill_n(queue_.source.begin() + static_cast<std::ptrdiff_t>(to), lanes, source);
        queue_.count += found;
        if (queue_.count >= fill_queue::enough)
            fill_enough();
    }

    /// Adds a piece. Expects: room.
    void add(const std::array<l3d_micro_vertex, 3>& triangle) {
        const std::size_t to = queue_.count++;
        for (std::size_t k = 0; k < 4; ++k) {
            const l3d_micro_vertex& v = triangle[std::min<std::size_t>(k, 2)];
            auto& corner = queue_.corner[k];
            corner[0][to] = v.x;
            corner[1][to] = v.y;
            corner[2][to] = std::bit_cast<std::int32_t>(v.inv_w);
            for (std::size_t c = 0; c < 3; ++c)
                corner[3 + c][to] = std::bit_cast<std::int32_t>(v.normal[c]);
        }
        queue_.name[to] = fill_queue::piece;
        queue_.source[to] = nullptr;
    }

    /// Fills as many as are enough, and moves the others, fewer than the widest vector, to the
    /// front.
    HWY_NOINLINE void fill_enough() {
        static_assert(fill_queue::enough % lanes == 0);
        for (std::size_t at = 0; at < fill_queue::enough; at += lanes)
            fill(at, lanes);
        const auto to_front = [](auto* array) {
            std::copy_n(array + fill_queue::enough, fill_queue::widest_vector, array);
        };
        for (auto& corner : queue_.corner)
            for (auto& component : corner)
                to_front(component);
        to_front(queue_.name);
        to_front(queue_.source.data());
        queue_.count -= fill_queue::enough;
    }

    void fill_rest_of_queue() {
        for (std::size_t at = 0; at < queue_.count; at += lanes)
            fill(at, std::min(lanes, queue_.count - at));
        queue_.count = 0;
    }

    HWY_NOINLINE void fill(std::size_t at, std::size_t count) {
        fill_group group;
        if (!group.set_up(target_, at, count, table_))
            return;
        target_.counts.written += fill_table_of(table_.shape);
    }

    HWY_INLINE std::int64_t fill_table_of(fill_shape shape) const {
        switch (shape) {
        case fill_shape::flat:
            return fill_pixels<fill_shape::flat>(target_.band, table_);
        case fill_shape::bent:
            return fill_pixels<fill_shape::bent>(target_.band, table_);
        case fill_shape::twisted:
            break;
        }
        return fill_pixels<fill_shape::twisted>(target_.band, table_);
    }

    const fill_target& target_;
    fill_queue& queue_;
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

void fill_quads(const fill_target& to, const l3d_micro_grid& grid, int row_begin, int row_end,
                int column_begin, int column_end) {
    const corner_arrays a = arrays_of(grid);
    const corner_arrays from[4] = {a, a, a, a};
    fill_stream stream(to);
    for (int row = row_begin; row < row_end; ++row) {
        const std::size_t p00 = grid.index(row, column_begin);
        const std::size_t p01 = grid.index(row + 1, column_begin);
        stream.take(from, {p00, p00 + 1, p01 + 1, p01},
                    static_cast<std::size_t>(column_end - column_begin), &grid,
                    static_cast<std::int32_t>(p00), 1);
    }
}

void fill_triangles(const fill_target& to, const l3d_micro_triangles& triangles, std::size_t first,
                    std::size_t last) {
    const auto& corners = triangles.corners;
    const corner_arrays c = arrays_of(corners[2]);
    const corner_arrays from[4] = {arrays_of(corners[0]), arrays_of(corners[1]), c, c};
    fill_stream(to).take(from, {first, first, first, first}, last - first, &triangles,
                         -1 - static_cast<std::int32_t>(first), -1);
}

void fill_finish(const fill_target& to) {
    fill_stream(to).finish();
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace l3d_detail {

L3D_SIMD_TABLE(fill_quads);
L3D_SIMD_TABLE(fill_triangles);
L3D_SIMD_TABLE(fill_finish);

void fill_quads(const fill_target& to, const l3d_micro_grid& grid, int row_begin, int row_end,
                int column_begin, int column_end) {
    assert(to.band.width >= fill_least_width);
    if (row_begin < row_end && column_begin < column_end)
        L3D_SIMD_CALL(fill_quads)
    (to, grid, row_begin, row_end, column_begin, column_end);
}

void fill_triangles(const fill_target& to, const l3d_micro_triangles& triangles, std::size_t first,
                    std::size_t last) {
    assert(to.band.width >= fill_least_width);
    L3D_SIMD_CALL(fill_triangles)(to, triangles, first, last);
}

void fill_finish(const fill_target& to) {
    L3D_SIMD_CALL(fill_finish)(to);
}

} // namespace l3d_detail

#endif
