// SPDX-License-Identifier: MIT
// vertex_lanes: vertices side by side, and triangles whose corners are vectors.
#include "pipeline/polygons/vertex_lanes_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/polygons/vertex_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/chunks_p.h"
#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using some_floats = hn::Rebind<float, eight_doubles>;
using some_integers = hn::Rebind<std::int32_t, eight_doubles>;

/// One row of a matrix, a number of it in all lanes.
struct lane_row {
    number x, y, z;

    HWY_INLINE lane_row(const l3d_matrix<double>& m, int row)
        : x(same(m(row, 0))), y(same(m(row, 1))), z(same(m(row, 2))) {}
};

/// The sum in the order in which a column is added to a column.
HWY_INLINE number placed(const lane_row& row, number offset, const vector& v) {
    return offset + row.x * v.x + row.y * v.y + row.z * v.z;
}

HWY_INLINE number turned(const lane_row& row, const vector& v) {
    return row.x * v.x + row.y * v.y + row.z * v.z;
}

/// 1/256 pixel from a quotient of pixels: l3d_snap, in lanes.
HWY_INLINE number in_subpixels(number x, number reciprocal) {
    return x * reciprocal * same(l3d_subpixel_one);
}

/// To nearest, ties away from zero.
HWY_INLINE hn::Vec<some_integers> rounded_lanes(number x) {
    const hn::Vec<eight_doubles> half = hn::Set(eight_doubles(), 0.5);
    return hn::DemoteTo(some_integers(), hn::Add(x.v, hn::CopySign(half, x.v)));
}

/// A vector of vertices after the other.
class vertex_placer {
public:
    HWY_INLINE explicit vertex_placer(const vertex_placing& how)
        : x_(how.view.matrix(), 0), y_(how.view.matrix(), 1), d_(how.view.matrix(), 2),
          w_(how.view.matrix(), 3), turn_{{how.view.placement(), 0},
                                          {how.view.placement(), 1},
                                          {how.view.placement(), 2}},
          how_(how) {}

    HWY_INLINE void place(const double* from, std::int32_t* to) const {
        const eight_doubles d;
        const some_integers di;
        vector v;
        hn::LoadInterleaved3(d, from, v.x.v, v.y.v, v.z.v);
        const auto offset = [&](int row) HWY_ATTR { return same(how_.view.matrix()(row, 3)); };
        const number x = placed(x_, offset(0), v), y = placed(y_, offset(1), v);
        const number w = placed(w_, offset(3), v);
        const number reach = same(l3d_guard_band) * w;
        const auto drawable =
            hn::And(hn::And(hn::Gt(w.v, hn::Set(d, how_.window.near)),
                            hn::Lt(w.v, hn::Set(d, how_.window.far))),
                    hn::And(hn::Le(magnitude(x).v, reach.v), hn::Le(magnitude(y).v, reach.v)));
        const auto where = [&](number of)
                               HWY_ATTR { return number{hn::IfThenElseZero(drawable, of.v)}; };
        const number reciprocal = same(1.0) / w;
        number inv_w = reciprocal;
        if (how_.view.is_parallel())
            inv_w = same(how_.depth_base) + same(how_.depth_step) * placed(d_, offset(2), v);
        const auto column = hn::Add(rounded_lanes(where(in_subpixels(x, reciprocal))),
                                    hn::Set(di, how_.window.centre_x()));
        const auto row = hn::Add(rounded_lanes(where(in_subpixels(y, reciprocal))),
                                 hn::Set(di, how_.window.centre_y()));
        const auto depth = hn::BitCast(di, hn::DemoteTo(some_floats(), where(inv_w).v));
        hn::StoreInterleaved4(column, row, depth, hn::Zero(di), di, to);
    }

    HWY_INLINE void turn(const float* from, float* to) const {
        const some_floats df;
        hn::Vec<some_floats> x, y, z;
        hn::LoadInterleaved3(df, from, x, y, z);
        const auto wide = [](hn::Vec<some_floats> of)
                              HWY_ATTR { return number{hn::PromoteTo(eight_doubles(), of)}; };
        const vector v{wide(x), wide(y), wide(z)};
        const auto narrow = [](number of) HWY_ATTR { return hn::DemoteTo(some_floats(), of.v); };
        hn::StoreInterleaved4(narrow(turned(turn_[0], v)), narrow(turned(turn_[1], v)),
                              narrow(turned(turn_[2], v)), hn::Zero(df), df, to);
    }

private:
    lane_row x_, y_, d_, w_, turn_[3];
    const vertex_placing& how_;
};

/// The last few are copied to where a whole vector can be read and written.
void place_vertices(const vertex_placing& how, std::span<const l3d_polygon_model::vector> vertices,
                    std::span<const l3d_polygon_model::direction> normals, std::size_t begin,
                    std::size_t end, placed_vertices& to) {
    constexpr std::size_t lanes = hn::MaxLanes(eight_doubles());
    const vertex_placer placer(how);
    std::size_t i = begin;
    for (; i + lanes <= end; i += lanes) {
        placer.place(&vertices[i][0], to.places[i].data());
        if (!normals.empty())
            placer.turn(&normals[i][0], to.normals[i].data());
    }
    if (i == end)
        return;
    const std::size_t rest = end - i;
    std::array<l3d_polygon_model::vector, lanes> last{};
    std::array<placed_vertices::place, lanes> places;
    std::ranges::copy(vertices.subspan(i, rest), last.begin());
    placer.place(&last[0][0], places[0].data());
    std::copy_n(places.begin(), rest, to.places.begin() + static_cast<std::ptrdiff_t>(i));
    if (normals.empty())
        return;
    std::array<l3d_polygon_model::direction, lanes> last_normals{};
    std::array<placed_vertices::normal, lanes> turned_normals;
    std::ranges::copy(normals.subspan(i, rest), last_normals.begin());
    placer.turn(&last_normals[0][0], turned_normals[0].data());
    std::copy_n(turned_normals.begin(), rest, to.normals.begin() + static_cast<std::ptrdiff_t>(i));
}

/// Where the box of a triangle is, seen from the window.
enum class box_place { outside, subpixel, seen, clipped };

#if HWY_TARGET == HWY_SCALAR

class box_test {
public:
    HWY_INLINE box_test(l3d_size size, bool squares)
        : add_(squares ? 0 : l3d_subpixel_one / 2 - 1),
          end_(squares ? 1 : 0), window_{size.width, size.height} {}

    HWY_INLINE box_place of(const std::int32_t* a, const std::int32_t* b,
                            const std::int32_t* c) const {
        if (std::min({a[2], b[2], c[2]}) == 0)
            return box_place::clipped;
        bool empty = false;
        for (std::size_t i = 0; i < window_.size(); ++i) {
            const std::int32_t first = (std::min({a[i], b[i], c[i]}) + add_) >> l3d_subpixel_bits;
            const std::int32_t end =
                ((std::max({a[i], b[i], c[i]}) + add_) >> l3d_subpixel_bits) + end_;
            if (end <= 0 || first >= window_[i])
                return box_place::outside;
            empty = empty || first >= end;
        }
        return empty ? box_place::subpixel : box_place::seen;
    }

private:
    std::int32_t add_, end_;
    std::array<std::int32_t, 2> window_;
};

#else

using quad_integers = hn::FixedTag<std::int32_t, 4>;
using quad_lanes = hn::Vec<quad_integers>;

class box_test {
public:
    HWY_INLINE box_test(l3d_size size, bool squares)
        : add_(hn::Set(quad_integers(), squares ? 0 : l3d_subpixel_one / 2 - 1)),
          end_(hn::Set(quad_integers(), squares ? 1 : 0)) {
        alignas(16) const std::int32_t ends[4] = {size.width, size.height, 0, 0};
        window_ = hn::Load(quad_integers(), ends);
    }

    /// Two lanes are columns and rows. In the next, inv_w is ordered like its bits.
    HWY_INLINE box_place of(const std::int32_t* a, const std::int32_t* b,
                            const std::int32_t* c) const {
        const quad_integers d;
        const quad_lanes va = hn::LoadU(d, a), vb = hn::LoadU(d, b), vc = hn::LoadU(d, c);
        const quad_lanes least = hn::Min(hn::Min(va, vb), vc);
        if (HWY_UNLIKELY(hn::ExtractLane(least, 2) == 0))
            return box_place::clipped;
        const quad_lanes most = hn::Max(hn::Max(va, vb), vc);
        const quad_lanes first = hn::ShiftRight<l3d_subpixel_bits>(hn::Add(least, add_));
        const quad_lanes end =
            hn::Add(hn::ShiftRight<l3d_subpixel_bits>(hn::Add(most, add_)), end_);
        if (HWY_UNLIKELY(!both(hn::And(hn::Gt(end, hn::Zero(d)), hn::Lt(first, window_)))))
            return box_place::outside;
        return both(hn::Lt(first, end)) ? box_place::seen : box_place::subpixel;
    }

private:
    /// Whether the lanes of columns and rows are set.
    static HWY_INLINE bool both(hn::Mask<quad_integers> mask) {
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(quad_integers(), mask, bits);
        return (bits[0] & 3) == 3;
    }

    quad_lanes add_, end_, window_;
};

#endif

std::size_t choose_triangles(const triangle_choice& of, std::size_t begin, std::size_t end,
                             chosen_triangles& to, l3d_polygon_counts& counts) {
    const std::span<const l3d_model_triangle> all = of.model.triangles();
    const std::span<const l3d_polygon_model::direction> faces = of.model.face_normals();
    const std::span<const l3d_polygon_model::vector> vertices = of.model.mesh().vertices;
    const box_test box(of.view.size(), of.squares);
    std::size_t count = 0, t = begin;
    to.clipped = false;
    for (; t < end && count < to.room && !to.clipped; ++t) {
        const l3d_model_triangle& triangle = all[t];
        const auto& corners = triangle.corners;
        const bool from_behind = !(of.view.faces_eye(l3d_converted<double>(faces[triangle.face]),
                                                     vertices[corners[0]]) > 0);
        if (of.cull && from_behind) {
            ++counts.back;
            continue;
        }
        const auto seen = box.of(of.places[corners[0]].data(), of.places[corners[1]].data(),
                                 of.places[corners[2]].data());
        to.triangle[count] = static_cast<std::uint32_t>(t);
        to.sign[count] = from_behind ? std::uint32_t{1} << 31 : 0;
        count += seen == box_place::seen || seen == box_place::clipped;
        counts.offscreen += seen == box_place::outside;
        counts.subpixel += seen == box_place::subpixel;
        to.clipped = seen == box_place::clipped;
    }
    to.count = count;
    return t;
}

/// Triangles that are copied together.
constexpr std::size_t together = 4;

/// A corner of each of them, and how its normal is turned round.
struct corner_records {
    std::array<const placed_vertices::place*, together> places;
    std::array<const placed_vertices::normal*, together> normals;
    alignas(16) std::array<std::uint32_t, together> signs;
};

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void put_places(const corner_records& from, l3d_micro_triangles::corner& to,
                           std::size_t at) {
    for (std::size_t k = 0; k < together; ++k) {
        const placed_vertices::place& place = *from.places[k];
        to.x[at + k] = place[0];
        to.y[at + k] = place[1];
        to.inv_w[at + k] = std::bit_cast<float>(place[2]);
    }
}

HWY_INLINE void put_normals(const corner_records& from, l3d_micro_triangles::corner& to,
                            std::size_t at) {
    for (std::size_t k = 0; k < together; ++k)
        for (std::size_t c = 0; c < to.normal.size(); ++c) {
            const float component = (*from.normals[k])[c];
            to.normal[c][at + k] = from.signs[k] != 0 ? -component : component;
        }
}

#else

/// The first three components of four records, a vector of each.
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
    hn::StoreU(of.first, d, to.x.data() + at);
    hn::StoreU(of.second, d, to.y.data() + at);
    hn::StoreU(hn::BitCast(df, of.third), df, to.inv_w.data() + at);
}

HWY_INLINE void put_normals(const corner_records& from, l3d_micro_triangles::corner& to,
                            std::size_t at) {
    const hn::RebindToFloat<quad_integers> d;
    const auto record = [&](std::size_t k)
                            HWY_ATTR { return hn::LoadU(d, from.normals[k]->data()); };
    const transposed of(d, record(0), record(1), record(2), record(3));
    const auto sign =
        hn::BitCast(d, hn::Load(hn::RebindToUnsigned<quad_integers>(), from.signs.data()));
    hn::StoreU(hn::Xor(of.first, sign), d, to.normal[0].data() + at);
    hn::StoreU(hn::Xor(of.second, sign), d, to.normal[1].data() + at);
    hn::StoreU(hn::Xor(of.third, sign), d, to.normal[2].data() + at);
}

#endif

/// What is written after the last triangle is nothing, and will be overwritten.
void add_triangles(std::span<const l3d_model_triangle> triangles, const placed_vertices& vertices,
                   bool with_normals, const chosen_triangles& chosen, std::size_t count,
                   l3d_micro_triangles& to) {
    to.make_room(chunks_of(count, together) * together);
    for (std::size_t i = 0; i < count; i += together) {
        corner_records records;
        std::array<const l3d_model_triangle*, together> of;
        for (std::size_t k = 0; k < together; ++k) {
            const std::size_t at = std::min(i + k, count - 1);
            of[k] = &triangles[chosen.triangle[at]];
            records.signs[k] = chosen.sign[at];
        }
        for (std::size_t c = 0; c < to.corners.size(); ++c) {
            for (std::size_t k = 0; k < together; ++k)
                records.places[k] = vertices.places.data() + of[k]->corners[c];
            put_places(records, to.corners[c], to.count + i);
            if (!with_normals)
                continue;
            for (std::size_t k = 0; k < together; ++k)
                records.normals[k] = vertices.normals.data() + of[k]->corners[c];
            put_normals(records, to.corners[c], to.count + i);
        }
    }
    to.count += count;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(place_vertices);
L3D_SIMD_TABLE(choose_triangles);
L3D_SIMD_TABLE(add_triangles);

void place_vertices(const vertex_placing& how, std::span<const l3d_polygon_model::vector> vertices,
                    std::span<const l3d_polygon_model::direction> normals, std::size_t begin,
                    std::size_t end, placed_vertices& to) {
    L3D_SIMD_CALL(place_vertices)(how, vertices, normals, begin, end, to);
}

std::size_t choose_triangles(const triangle_choice& of, std::size_t begin, std::size_t end,
                             chosen_triangles& to, l3d_polygon_counts& counts) {
    return L3D_SIMD_CALL(choose_triangles)(of, begin, end, to, counts);
}

void add_triangles(std::span<const l3d_model_triangle> triangles, const placed_vertices& vertices,
                   bool with_normals, const chosen_triangles& chosen, std::size_t count,
                   l3d_micro_triangles& to) {
    L3D_SIMD_CALL(add_triangles)(triangles, vertices, with_normals, chosen, count, to);
}

} // namespace l3d_detail
#endif
