// SPDX-License-Identifier: MIT
// fill_kernel: queues polygons, sets them up a vector at a time, and fills them one by one.
#include "raster/surfaces/fill_kernel_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/surfaces/fill_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

#include "raster/surfaces/fill_group-inl.h"
#include "raster/surfaces/fill_hidden-inl.h"
#include "raster/surfaces/fill_lights-inl.h"

#include <algorithm>
#include <array>
#include <cassert>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Whether a pixel centre in [begin, end) lies between the least and the greatest of four
/// coordinates: l3d_centres_filled, in lanes.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> meets(D d, const V (&v)[4], std::int32_t begin, std::int32_t end) {
    const V least = hn::Min(hn::Min(v[0], v[1]), hn::Min(v[2], v[3]));
    const V most = hn::Max(hn::Max(v[0], v[1]), hn::Max(v[2], v[3]));
    return hn::Lt(hn::Max(first_centre_of(d, least), hn::Set(d, begin)),
                  hn::Min(first_centre_of(d, most), hn::Set(d, end)));
}

/// For each mask of up to eight lanes, the indices of its lanes in their order, four bits each.
struct lane_lists {
    std::uint32_t of[256] = {};

    constexpr lane_lists() {
        for (std::uint32_t mask = 0; mask < 256; ++mask)
            for (std::uint32_t lane = 0, found = 0; lane < 8; ++lane)
                if (mask >> lane & 1)
                    of[mask] |= lane << 4 * found++;
    }
};
constexpr lane_lists lists_of_lanes;

/// Indices of lanes that bring the lanes of a mask to a vector's front, in their order. Several
/// vectors use the same indices. Using the indices costs less than compressing each vector, above
/// all where the instruction set cannot compress.
template <class D> HWY_INLINE hn::Vec<D> lanes_kept(D d, hn::Mask<D> mask) {
    constexpr std::size_t listed = 8;
    if constexpr (hn::MaxLanes(D()) > listed) {
        return hn::Compress(hn::Iota(d, 0), mask);
    } else {
        const hn::RebindToUnsigned<D> du;
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, mask, bits);
        const auto list = hn::Set(du, lists_of_lanes.of[bits[0]]);
        const auto lanes_of = hn::Shr(list, hn::ShiftLeft<2>(hn::Iota(du, 0)));
        return hn::BitCast(d, hn::And(lanes_of, hn::Set(du, hn::MaxLanes(D()) - 1)));
    }
}

/// Queues the polygons that may cover a pixel, and fills them once there are enough.
///
/// Shape: `Light` is the class that makes the polygons' greys or normals, as in fill_group.
template <class Light> class fill_stream {
public:
    HWY_INLINE explicit fill_stream(const fill_target& target)
        : target_(target), queue_(target.queue) {}

    /// Neighbouring polygons, from arrays of their corners. `name` is the name of the first
    /// polygon; names rise by `step`.
    struct row {
        const corner_arrays& corners;
        corner_places at;
        light_arrays<Light::numbers> light;
        std::size_t count;
        const void* source;
        std::int32_t name, step;
        bool shows_both;        ///< see l3d_micro_grid::shows_both
        std::uint32_t material; ///< the material of all polygons, unless each has its own
        const std::uint32_t* materials = nullptr; ///< see l3d_micro_triangles::materials
        bool names_quads = false;                 ///< see l3d_surface_part::names_quads
    };

    HWY_INLINE void take(const row& from) {
        using few = hn::CappedTag<std::int32_t, (lanes + 1) / 2>;
        if (from.count <= hn::MaxLanes(few()))
            return take_some(few(), from, 0, from.count);
        for (std::size_t i = 0; i < from.count; i += lanes)
            take_some(ints(), from, i, std::min(lanes, from.count - i));
    }

    HWY_INLINE void finish() {
        fill_rest_of_queue();
        for (const auto& piece : queue_.pieces) {
            add(piece);
            if (queue_.count == fill_queue::widest_vector)
                fill_rest_of_queue();
        }
        queue_.pieces.clear();
        fill_rest_of_queue();
    }

private:
    template <class D>
    HWY_INLINE void take_some(D d, const row& from, std::size_t i, std::size_t count) {
        bool inside = true;
        for (std::size_t k = 0; k < 4; ++k)
            inside = inside && from.at[k] + i + hn::MaxLanes(d) <= from.corners[k].size;
        if (HWY_LIKELY(inside))
            take_vector<true>(d, from, i, count);
        else
            take_last(d, from, i, count);
    }

    /// Takes polygons at an array's end, where vectors would reach beyond it. Such polygons are
    /// few, so one copy of this function serves all rows.
    template <class D>
    HWY_NOINLINE void take_last(D d, const row& from, std::size_t i, std::size_t count) {
        take_vector<false>(d, from, i, count);
    }

    template <bool Inside, class D>
    HWY_INLINE void take_vector(D d, const row& from, std::size_t i, std::size_t count) {
        using vec = hn::Vec<D>;
        const hn::RebindToFloat<D> df;
        vec x[4], y[4];
        for (std::size_t k = 0; k < 4; ++k) {
            const vertex_arrays& corner = from.corners[k];
            x[k] = load_within<Inside>(d, corner.x, from.at[k] + i, corner.size);
            y[k] = load_within<Inside>(d, corner.y, from.at[k] + i, corner.size);
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
        const auto kept = hn::IndicesFromVec(d, lanes_kept(d, live));
        const auto put = [&](vec v, std::int32_t* place) HWY_ATTR {
            if (!all)
                v = hn::TableLookupLanes(v, kept);
            hn::StoreU(v, d, place + to);
        };
        vec other_side = hn::Zero(d); // flips the sign of normals
        if (Light::numbers > 1 && HWY_UNLIKELY(from.shows_both))
            other_side = hn::ShiftLeft<31>(hn::VecFromMask(d, turns_right(d, x, y)));
        for (std::size_t k = 0; k < 4; ++k) {
            const vertex_arrays& corner = from.corners[k];
            const std::size_t left = corner.size - from.at[k], at = from.light.at[k];
            put(x[k], queue_.corner[k][0]);
            put(y[k], queue_.corner[k][1]);
            const auto inv_w = load_within<Inside>(df, corner.inv_w, from.at[k] + i, corner.size);
            put(hn::BitCast(d, inv_w), queue_.corner[k][2]);
            for (std::size_t c = 0; c < Light::numbers; ++c) {
                const auto light = load_within<Inside>(df, from.light.of[k][c], at + i, at + left);
                put(hn::Xor(hn::BitCast(d, light), other_side), queue_.corner[k][3 + c]);
            }
        }
        const auto name = from.name + static_cast<std::int32_t>(i) * from.step;
        put(hn::Add(hn::Mul(hn::Iota(d, 0), hn::Set(d, from.step)), hn::Set(d, name)), queue_.name);
        std::fill_n(queue_.source.begin() + static_cast<std::ptrdiff_t>(to), lanes, from.source);
        if (target_.words.has_materials)
            put_materials(d, from, i, live);
        queue_.count += found;
        if (queue_.count >= fill_queue::enough)
            fill_enough();
    }

    /// Queues the materials of the row's polygons from `i` on. It takes the polygons whose lanes
    /// are set in `live`.
    template <class D>
    HWY_NOINLINE void put_materials(D d, const row& from, std::size_t i, hn::Mask<D> live) {
        std::uint32_t* const to = queue_.material + queue_.count;
        if (from.materials == nullptr && !from.names_quads) {
            std::fill_n(to, lanes, from.material);
            return;
        }
        const auto first = static_cast<std::uint32_t>(from.name) + static_cast<std::uint32_t>(i);
        const auto material_of = [&](std::size_t lane) {
            return from.names_quads ? from.material + target_.words.next_material() *
                                                          (first + static_cast<std::uint32_t>(lane))
                                    : target_.words.of_material(from.materials[i + lane]);
        };
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, live, bits);
        for (std::size_t lane = 0, found = 0; lane < hn::MaxLanes(d); ++lane)
            if (bits[lane / 8] >> (lane % 8) & 1)
                to[found++] = material_of(lane);
    }

    /// Adds a piece. Expects: room in the queue.
    void add(const fill_piece& triangle) {
        const std::size_t to = queue_.count++;
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t c = 0; c < components; ++c)
                queue_.corner[k][c][to] = triangle.corners[std::min<std::size_t>(k, 2)][c];
        queue_.name[to] = fill_queue::piece;
        queue_.source[to] = nullptr;
        queue_.material[to] = triangle.material;
    }

    /// Fills the first `enough` polygons of the queue, and moves the remaining polygons to the
    /// queue's front. There are fewer remaining polygons than lanes in the widest vector.
    HWY_NOINLINE void fill_enough() {
        static_assert(fill_queue::enough % lanes == 0);
        find_seen(fill_queue::enough);
        for (std::size_t at = 0; at < fill_queue::enough; at += lanes)
            fill(at, lanes);
        const auto to_front = [](auto* array) {
            std::copy_n(array + fill_queue::enough, fill_queue::widest_vector, array);
        };
        for (auto& corner : queue_.corner)
            for (std::size_t c = 0; c < components; ++c)
                to_front(corner[c]);
        to_front(queue_.name);
        to_front(queue_.source.data());
        if (target_.words.has_materials)
            to_front(queue_.material);
        queue_.count -= fill_queue::enough;
    }

    void fill_rest_of_queue() {
        find_seen(queue_.count);
        for (std::size_t at = 0; at < queue_.count; at += lanes)
            fill(at, std::min(lanes, queue_.count - at));
        queue_.count = 0;
    }

    HWY_INLINE void find_seen(std::size_t count) {
        std::fill_n(queue_.seen, count, 1);
        if (target_.leaves_out_hidden)
            clear_hidden(target_.band, queue_, count);
    }

    HWY_NOINLINE void fill(std::size_t at, std::size_t count) {
        fill_group<Light> group;
        if (group.set_up(target_, at, count, table_))
            target_.counts.written += group.fill(target_.band, table_);
    }

    static constexpr std::size_t components = 3 + Light::numbers;
    const fill_target& target_;
    fill_queue& queue_;
    fill_table table_;
};

template <class Lights>
HWY_INLINE void quads_by(const fill_target& to, const fill_grid& of, int row_begin, int row_end,
                         int column, std::size_t count) {
    using stream = fill_stream<typename Lights::lanes_type>;
    stream out(to);
    const l3d_micro_grid& grid = of.vertices;
    const Lights lights(to, of.levels);
    const vertex_arrays vertices(grid);
    const corner_arrays corners{vertices, vertices, vertices, vertices};
    for (int row = row_begin; row < row_end; ++row) {
        std::size_t p00 = grid.index(row, column);
        const std::size_t end = p00 + count;
        for (auto cut = std::ranges::lower_bound(grid.cut, p00); p00 < end; ++cut) {
            const std::size_t stop = cut == grid.cut.end() ? end : std::min<std::size_t>(*cut, end);
            const std::size_t p01 = p00 + static_cast<std::size_t>(grid.pitch);
            const corner_places at{p00, p00 + 1, p01 + 1, p01};
            if (p00 < stop)
                out.take({corners, at, lights.quads(corners, at, stop - p00, grid.shows_both),
                          stop - p00, &grid, static_cast<std::int32_t>(p00), 1, grid.shows_both,
                          of.material, nullptr, of.names_quads});
            p00 = stop + 1;
            if (stop == end)
                break;
        }
    }
}

template <class Lights>
HWY_INLINE void triangles_by(const fill_target& to, const l3d_micro_triangles& triangles,
                             std::uint32_t material, std::size_t first, std::size_t count) {
    const std::size_t at = first % l3d_micro_triangles::lanes;
    const auto arrays = [&](std::size_t k)
                            HWY_ATTR { return vertex_arrays(triangles.corners(first, k)); };
    const corner_arrays corners{arrays(0), arrays(1), arrays(2), arrays(2)};
    const Lights lights(to, nullptr);
    fill_stream<typename Lights::lanes_type>(to).take(
        {corners,
         {at, at, at, at},
         lights.triangles(corners, at, count),
         count,
         &triangles,
         -1 - static_cast<std::int32_t>(first),
         -1,
         false,
         material,
         triangles.materials.empty() ? nullptr : triangles.materials.data() + first});
}

void light_vertices(const l3d_shading& shading, const l3d_micro_grid& grid, float* levels) {
    const vertex_arrays vertices(grid);
    for (int row = 0; row < grid.rows; ++row) {
        const std::size_t at = grid.index(row, 0);
        make_levels(shading, vertices, at, static_cast<std::size_t>(grid.columns), levels + at);
    }
}

/// Fills quads in runs of columns, since there is room for the greys of only one run.
void fill_quads(const fill_target& to, const fill_grid& grid, int row_begin, int row_end,
                int column_begin, int column_end) {
    constexpr int run_of_quads = fill_queue::run;
    for (int column = column_begin; column < column_end; column += run_of_quads) {
        const auto count = static_cast<std::size_t>(std::min(column_end - column, run_of_quads));
        if (to.words.has_normals)
            quads_by<later_lights>(to, grid, row_begin, row_end, column, count);
        else if (to.shading.mode == l3d_shade::gouraud)
            quads_by<vertex_lights>(to, grid, row_begin, row_end, column, count);
        else if (to.shading.mode == l3d_shade::flat)
            quads_by<polygon_lights>(to, grid, row_begin, row_end, column, count);
        else if (to.shading.mode == l3d_shade::levels)
            quads_by<level_lights>(to, grid, row_begin, row_end, column, count);
        else
            quads_by<normal_lights>(to, grid, row_begin, row_end, column, count);
    }
}

void fill_triangles(const fill_target& to, const l3d_micro_triangles& triangles,
                    std::uint32_t material, std::size_t first, std::size_t last) {
    constexpr std::size_t in_block = l3d_micro_triangles::lanes;
    static_assert(in_block <= fill_queue::run);
    std::size_t count = 0;
    for (std::size_t i = first; i < last; i += count) {
        count = std::min(last - i, in_block - i % in_block);
        if (to.words.has_normals)
            triangles_by<later_lights>(to, triangles, material, i, count);
        else if (to.shading.mode == l3d_shade::gouraud)
            triangles_by<vertex_lights>(to, triangles, material, i, count);
        else if (to.shading.mode == l3d_shade::flat)
            triangles_by<polygon_lights>(to, triangles, material, i, count);
        else if (to.shading.mode == l3d_shade::levels)
            triangles_by<level_lights>(to, triangles, material, i, count);
        else
            triangles_by<normal_lights>(to, triangles, material, i, count);
    }
}

void fill_finish(const fill_target& to) {
    if (to.words.has_normals)
        fill_stream<normal_lanes>(to).finish();
    else if (to.shading.mode == l3d_shade::lambert)
        fill_stream<lambert_lanes>(to).finish();
    else if (to.shading.mode == l3d_shade::levels)
        fill_stream<level_lanes>(to).finish();
    else
        fill_stream<grey_lanes>(to).finish();
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace l3d_detail {

L3D_SIMD_TABLE(light_vertices);
L3D_SIMD_TABLE(fill_quads);
L3D_SIMD_TABLE(fill_triangles);
L3D_SIMD_TABLE(fill_finish);

void light_vertices(const l3d_shading& shading, const l3d_micro_grid& grid, float* levels) {
    L3D_SIMD_CALL(light_vertices)(shading, grid, levels);
}

void fill_quads(const fill_target& to, const fill_grid& grid, int row_begin, int row_end,
                int column_begin, int column_end) {
    assert(to.band.width >= fill_least_width);
    if (row_begin < row_end && column_begin < column_end)
        L3D_SIMD_CALL(fill_quads)
    (to, grid, row_begin, row_end, column_begin, column_end);
}

void fill_triangles(const fill_target& to, const l3d_micro_triangles& triangles,
                    std::uint32_t material, std::size_t first, std::size_t last) {
    assert(to.band.width >= fill_least_width);
    L3D_SIMD_CALL(fill_triangles)(to, triangles, material, first, last);
}

void fill_finish(const fill_target& to) {
    L3D_SIMD_CALL(fill_finish)(to);
}

} // namespace l3d_detail

#endif
