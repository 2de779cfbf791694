// SPDX-License-Identifier: MIT
// vertex_lanes: places vertices side by side, and chooses triangles that may be seen.
#include "pipeline/polygons/vertex_lanes_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/polygons/vertex_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using some_floats = hn::Rebind<float, eight_doubles>;
using some_integers = hn::Rebind<std::int32_t, eight_doubles>;

/// One row of a matrix. Each number of the row fills all lanes of a vector.
struct lane_row {
    number x, y, z;

    HWY_INLINE lane_row(const l3d_matrix<double>& m, int row)
        : x(same(m(row, 0))), y(same(m(row, 1))), z(same(m(row, 2))) {}
};

/// The product of a matrix's row and places in lanes, added up in the order of the scalar code.
HWY_INLINE number placed(const lane_row& row, number offset, const vector& v) {
    return offset + row.x * v.x + row.y * v.y + row.z * v.z;
}

HWY_INLINE number turned(const lane_row& row, const vector& v) {
    return row.x * v.x + row.y * v.y + row.z * v.z;
}

/// Rounds a quotient of pixels to steps of 1/256 pixel: l3d_snap, in lanes.
HWY_INLINE number in_subpixels(number x, number reciprocal) {
    return x * reciprocal * same(l3d_subpixel_one);
}

/// Rounds to the nearest integer, and halves away from zero.
HWY_INLINE hn::Vec<some_integers> rounded_lanes(number x) {
    const hn::Vec<eight_doubles> half = hn::Set(eight_doubles(), 0.5);
    return hn::DemoteTo(some_integers(), hn::Add(x.v, hn::CopySign(half, x.v)));
}

/// Places vertices in the picture, as many at a time as a vector has lanes.
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
            inv_w = same(how_.depths.base) + same(how_.depths.step) * placed(d_, offset(2), v);
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

/// Places vertices by whole vectors. The last few vertices are copied to an array in which a whole
/// vector fits.
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

/// The position of a triangle's box relative to the window.
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

    /// Compares a triangle's box with the window. The first two lanes are columns and rows. The
    /// third lane is inv_w, which is ordered like its bits.
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
    /// Whether a mask is set both in the lane of columns and in the lane of rows.
    static HWY_INLINE bool both(hn::Mask<quad_integers> mask) {
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(quad_integers(), mask, bits);
        return (bits[0] & 3) == 3;
    }

    quad_lanes add_, end_, window_;
};

#endif

/// The side of some triangles that the eye sees.
enum class seen_side { front, back, either };

HWY_INLINE seen_side side_of(const l3d_facing_block& block, const l3d_polygon_view& view) {
    const auto all_face = [&](bool front) HWY_ATTR {
        return view.all_face(block.axis, block.spread, block.middle, block.reach, front);
    };
    return all_face(true)    ? seen_side::front
           : all_face(false) ? seen_side::back
                             : seen_side::either;
}

std::size_t choose_triangles(const triangle_choice& of, std::size_t begin, std::size_t end,
                             chosen_triangles& to, l3d_polygon_counts& counts) {
    const std::span<const l3d_model_triangle> all = of.model.triangles();
    const std::span<const l3d_polygon_model::direction> faces = of.model.face_normals();
    const std::span<const l3d_polygon_model::vector> vertices = of.model.mesh().vertices;
    constexpr std::size_t in_block = l3d_facing_block::triangles;
    const box_test box(of.view.size(), of.squares);
    std::size_t count = 0, t = begin, end_of_block = begin;
    seen_side side = seen_side::either;
    to.clipped = false;
    for (; t < end && count < to.room && !to.clipped; ++t) {
        if (t >= end_of_block) {
            side = side_of(of.model.facing_blocks()[t / in_block], of.view);
            end_of_block = std::min((t / in_block + 1) * in_block, end);
            if (of.cull && side == seen_side::back) {
                counts.back += static_cast<std::int64_t>(end_of_block - t);
                t = end_of_block - 1;
                continue;
            }
        }
        const l3d_model_triangle& triangle = all[t];
        const auto& corners = triangle.corners;
        const bool from_behind =
            side == seen_side::either
                ? !(of.view.faces_eye(l3d_converted<double>(faces[triangle.face]),
                                      vertices[corners[0]]) > 0)
                : side == seen_side::back;
        if (of.cull && from_behind) {
            ++counts.back;
            continue;
        }
        const auto seen = box.of(of.places[corners[0]].data(), of.places[corners[1]].data(),
                                 of.places[corners[2]].data());
        to.triangle[count] = static_cast<std::uint32_t>(t);
        to.sign[count] = from_behind ? chosen_triangles::from_behind : 0;
        count += seen == box_place::seen || seen == box_place::clipped;
        counts.offscreen += seen == box_place::outside;
        counts.subpixel += seen == box_place::subpixel;
        to.clipped = seen == box_place::clipped;
    }
    to.count = count;
    return t;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(place_vertices);
L3D_SIMD_TABLE(choose_triangles);

void place_vertices(const vertex_placing& how, std::span<const l3d_polygon_model::vector> vertices,
                    std::span<const l3d_polygon_model::direction> normals, std::size_t begin,
                    std::size_t end, placed_vertices& to) {
    L3D_SIMD_CALL(place_vertices)(how, vertices, normals, begin, end, to);
}

std::size_t choose_triangles(const triangle_choice& of, std::size_t begin, std::size_t end,
                             chosen_triangles& to, l3d_polygon_counts& counts) {
    return L3D_SIMD_CALL(choose_triangles)(of, begin, end, to, counts);
}

} // namespace l3d_detail
#endif
