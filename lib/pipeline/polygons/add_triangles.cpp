// SPDX-License-Identifier: MIT
// add_triangles: copies corners of chosen triangles, transposed, to a rasterizer's lanes.
#include "pipeline/polygons/vertex_lanes_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/polygons/add_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// The number of triangles that are copied together, to lanes at which a vector begins.
constexpr std::size_t together = 4;
static_assert(l3d_micro_triangles::lanes % together == 0);

/// For the triangles that are copied together: the records of one corner of each triangle, and the
/// bit that reverses its normals.
struct corner_records {
    std::array<const placed_vertices::place*, together> places;
    std::array<const placed_vertices::normal*, together> normals;
    alignas(16) std::array<std::uint32_t, together> signs;
};

HWY_INLINE void put_place(const placed_vertices::place& place, l3d_micro_triangles::corner& to,
                          std::size_t at) {
    to.x[at] = place[0];
    to.y[at] = place[1];
    to.inv_w[at] = std::bit_cast<float>(place[2]);
}

HWY_INLINE void put_normal(const placed_vertices::normal& normal, std::uint32_t sign,
                           l3d_micro_triangles::corner& to, std::size_t at) {
    for (std::size_t c = 0; c < to.normal.size(); ++c)
        to.normal[c][at] = sign != 0 ? -normal[c] : normal[c];
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void put_places(const corner_records& from, l3d_micro_triangles::corner& to,
                           std::size_t at) {
    for (std::size_t k = 0; k < together; ++k)
        put_place(*from.places[k], to, at + k);
}

HWY_INLINE void put_normals(const corner_records& from, l3d_micro_triangles::corner& to,
                            std::size_t at) {
    for (std::size_t k = 0; k < together; ++k)
        put_normal(*from.normals[k], from.signs[k], to, at + k);
}

#else

using quad_integers = hn::FixedTag<std::int32_t, 4>;

/// The first three components of four records, each a vector.
template <class D> struct transposed {
    hn::Vec<D> first, second, third;

    HWY_INLINE transposed(D d, hn::Vec<D> v0, hn::Vec<D> v1, hn::Vec<D> v2, hn::Vec<D> v3) {
        const auto low02 = hn::InterleaveLower(d, v0, v2), low13 = hn::InterleaveLower(d, v1, v3);
        const auto high02 = hn::InterleaveUpper(d, v0, v2);
        const auto high13 = hn::InterleaveUpper(d, v1, v3);
        first = hn::InterleaveLower(d, low02, low13);
        second = hn::InterleaveUpper(d, low02, low13);
        third = hn::InterleaveLower(d, high02, high13);
    }
};

HWY_INLINE void put_places(const corner_records& from, l3d_micro_triangles::corner& to,
                           std::size_t at) {
    const quad_integers d;
    const hn::RebindToFloat<quad_integers> df;
    const auto record = [&](std::size_t k)
                            HWY_ATTR { return hn::LoadU(d, from.places[k]->data()); };
    const transposed of(d, record(0), record(1), record(2), record(3));
    hn::Store(of.first, d, to.x.data() + at);
    hn::Store(of.second, d, to.y.data() + at);
    hn::Store(hn::BitCast(df, of.third), df, to.inv_w.data() + at);
}

HWY_INLINE void put_normals(const corner_records& from, l3d_micro_triangles::corner& to,
                            std::size_t at) {
    const hn::RebindToFloat<quad_integers> d;
    const auto record = [&](std::size_t k)
                            HWY_ATTR { return hn::LoadU(d, from.normals[k]->data()); };
    const transposed of(d, record(0), record(1), record(2), record(3));
    const auto sign =
        hn::BitCast(d, hn::Load(hn::RebindToUnsigned<quad_integers>(), from.signs.data()));
    hn::Store(hn::Xor(of.first, sign), d, to.normal[0].data() + at);
    hn::Store(hn::Xor(of.second, sign), d, to.normal[1].data() + at);
    hn::Store(hn::Xor(of.third, sign), d, to.normal[2].data() + at);
}

#endif

/// Adds chosen triangles to lanes: single triangles up to the first lane of a vector, then whole
/// vectors of triangles.
class triangle_adder {
public:
    HWY_INLINE triangle_adder(std::span<const l3d_model_triangle> triangles,
                              const placed_vertices& vertices, bool with_normals,
                              const chosen_triangles& chosen, std::size_t count,
                              l3d_micro_triangles& to)
        : triangles_(triangles), vertices_(vertices), with_normals_(with_normals), chosen_(chosen),
          count_(count), to_(to) {}

    HWY_INLINE void add_one(std::size_t i) {
        const std::size_t place = to_.count + i, at = place % l3d_micro_triangles::lanes;
        const auto& corners = triangles_[chosen_.triangle[i]].corners;
        for (std::size_t c = 0; c < corners.size(); ++c) {
            put_place(vertices_.places[corners[c]], to_.corners(place, c), at);
            if (with_normals_)
                put_normal(vertices_.normals[corners[c]], chosen_.sign[i], to_.corners(place, c),
                           at);
        }
    }

    /// Adds `together` triangles from number `i` on. Lanes after the last triangle get meaningless
    /// values, which later calls overwrite.
    HWY_INLINE void add_some(std::size_t i) {
        const std::size_t place = to_.count + i, at = place % l3d_micro_triangles::lanes;
        corner_records records;
        std::array<const l3d_model_triangle*, together> of;
        for (std::size_t k = 0; k < together; ++k) {
            const std::size_t next = std::min(i + k, count_ - 1);
            of[k] = &triangles_[chosen_.triangle[next]];
            records.signs[k] = chosen_.sign[next];
        }
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < together; ++k)
                records.places[k] = vertices_.places.data() + of[k]->corners[c];
            put_places(records, to_.corners(place, c), at);
            if (!with_normals_)
                continue;
            for (std::size_t k = 0; k < together; ++k)
                records.normals[k] = vertices_.normals.data() + of[k]->corners[c];
            put_normals(records, to_.corners(place, c), at);
        }
    }

private:
    std::span<const l3d_model_triangle> triangles_;
    const placed_vertices& vertices_;
    bool with_normals_;
    const chosen_triangles& chosen_;
    std::size_t count_;
    l3d_micro_triangles& to_;
};

void add_triangles(std::span<const l3d_model_triangle> triangles, const placed_vertices& vertices,
                   bool with_normals, const chosen_triangles& chosen, std::size_t count,
                   l3d_micro_triangles& to) {
    to.make_room(count);
    triangle_adder adder(triangles, vertices, with_normals, chosen, count, to);
    std::size_t i = 0;
    for (; i < count && (to.count + i) % together != 0; ++i)
        adder.add_one(i);
    for (; i < count; i += together)
        adder.add_some(i);
    to.count += count;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(add_triangles);

void add_triangles(std::span<const l3d_model_triangle> triangles, const placed_vertices& vertices,
                   bool with_normals, const chosen_triangles& chosen, std::size_t count,
                   l3d_micro_triangles& to) {
    L3D_SIMD_CALL(add_triangles)(triangles, vertices, with_normals, chosen, count, to);
}

} // namespace l3d_detail
#endif
