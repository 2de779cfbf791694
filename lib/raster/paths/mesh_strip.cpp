// SPDX-License-Identifier: MIT
// mesh_strip: set up in lanes of double, filled by small_fill.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/paths/mesh_strip.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/micro_grid.h"
#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/paths/mesh_strip_p.h"
#include "raster/shapes/small_fill-inl.h"
#include "raster/shapes/small_triangle_p.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Most triangles of a mesh have three or four columns of pixels. Wider vectors would be idle, and
/// many processors do vectors of 64 bytes in two steps.
constexpr int narrow = 4;

constexpr std::size_t most_lanes = 8;
static_assert(mesh_row::room >= most_lanes);
using lane_integers = hn::Rebind<std::int32_t, eight_doubles>;
using lane_floats = hn::Rebind<float, eight_doubles>;
using condition = hn::Mask<eight_doubles>;

/// What becomes of a triangle.
enum : std::int32_t { left_to_others = 0, empty = 1, to_be_filled = 2 };

/// The most by which a channel may change from a lattice unit to the next: by 2^12 levels over
/// small_side. So sums are below 2^13, and a few roundings of theirs in float below 2^-9.
constexpr double most_change = 4096.0 / (small_side * l3d_subpixel_one);

/// Triangles that are set up, one in each element.
struct set_up_triangles {
    using integers_of_all = std::array<std::int32_t, most_lanes>;
    using floats_of_all = std::array<float, most_lanes>;

    alignas(64) integers_of_all state, left, top, columns, rows;
    alignas(64) std::array<integers_of_all, 3> first, per_column, per_row; ///< of edges
    alignas(64) std::array<floats_of_all, 3> start, across, down, low, high;

    HWY_INLINE small_box box(std::size_t i) const { return {left[i], top[i], columns[i], rows[i]}; }
    HWY_INLINE std::array<small_edge, 3> edges(std::size_t i) const {
        std::array<small_edge, 3> result;
        for (std::size_t k = 0; k < 3; ++k)
            result[k] = {first[k][i], per_column[k][i], per_row[k][i]};
        return result;
    }
};

/// The words of a triangle whose colours are linear. Each stays between the corners'.
template <class Lanes> class linear_colors {
public:
    HWY_INLINE linear_colors(const set_up_triangles& of, std::size_t triangle)
        : of_(of), triangle_(triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            down_[k] = hn::Set(floats, of.down[k][triangle]);
            low_[k] = hn::Set(floats, of.low[k][triangle]);
            high_[k] = hn::Set(floats, of.high[k][triangle]);
        }
    }

    HWY_INLINE void begin_block(std::int32_t column) {
        const auto i = hn::ConvertTo(floats, hn::Iota(Lanes::integers, column));
        for (std::size_t k = 0; k < 3; ++k)
            value_[k] = hn::Add(hn::Set(floats, of_.start[k][triangle_]),
                                hn::Mul(hn::Set(floats, of_.across[k][triangle_]), i));
    }

    HWY_INLINE typename Lanes::word_vec next_row() {
        typename Lanes::word_vec level[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto within = hn::Min(hn::Max(value_[k], low_[k]), high_[k]);
            value_[k] = hn::Add(value_[k], down_[k]);
            level[k] = hn::BitCast(Lanes::words, hn::Add(within, hn::Set(floats, whole_floats)));
        }
        return hn::Or(hn::Or(hn::ShiftLeft<16>(level[0]), hn::ShiftLeft<8>(level[1])),
                      hn::And(level[2], hn::Set(Lanes::words, 255)));
    }

private:
    /// Floats from here on are whole numbers: the sum with another is rounded to the nearest, and
    /// its lowest bits are that number. All others are in the highest byte.
    static constexpr float whole_floats = 0x1p23F;

    static constexpr auto floats = Lanes::floats;

    const set_up_triangles& of_;
    std::size_t triangle_;
    typename Lanes::float_vec value_[3], down_[3], low_[3], high_[3];
};

HWY_ATTR HWY_INLINE void put(number x, set_up_triangles::integers_of_all& to) {
    hn::StoreU(hn::DemoteTo(lane_integers(), x.v), lane_integers(), to.data());
}
HWY_ATTR HWY_INLINE void put(number x, set_up_triangles::floats_of_all& to) {
    hn::StoreU(hn::DemoteTo(lane_floats(), x.v), lane_floats(), to.data());
}
HWY_ATTR HWY_INLINE number least(number a, number b) {
    return {hn::Min(a.v, b.v)};
}
HWY_ATTR HWY_INLINE number chosen(condition which, number a, number b) {
    return {hn::IfThenElse(which, a.v, b.v)};
}
HWY_ATTR HWY_INLINE condition both(condition a, condition b) {
    return hn::And(a, b);
}

/// A corner of each triangle. Units: 1/256 pixel, whole ones.
struct lane_corner {
    number x, y;
    std::array<number, 3> color;
};

HWY_ATTR HWY_INLINE lane_corner corners_of(const mesh_row& row, std::size_t i) {
    const auto from = [i](const std::vector<double>& of)
                          HWY_ATTR { return number{hn::LoadU(eight_doubles(), of.data() + i)}; };
    const auto lattice = [&](const std::vector<double>& of) HWY_ATTR {
        return number{hn::Round((from(of) * same(l3d_subpixel_one)).v)};
    };
    return {lattice(row.x),
            lattice(row.y),
            {from(row.color[0]), from(row.color[1]), from(row.color[2])}};
}

/// Where three coordinates lie.
struct lane_range {
    number low, high;

    HWY_ATTR HWY_INLINE lane_range(number a, number b, number c)
        : low(least(least(a, b), c)), high(largest(largest(a, b), c)) {}

    /// False also if one is not a number.
    HWY_ATTR HWY_INLINE condition small_within(double end) const {
        return both(both(hn::Ge(low.v, hn::Zero(eight_doubles())),
                         hn::Le(high.v, same(end * l3d_subpixel_one).v)),
                    hn::Le((high - low).v, same(small_side * l3d_subpixel_one).v));
    }
};

/// The first pixel whose sample is not before a place.
HWY_ATTR HWY_INLINE number first_sample(number place) {
    constexpr double pixel = l3d_subpixel_one;
    return {hn::Floor(((place + same(pixel - 1)) * same(1 / pixel)).v)};
}

HWY_ATTR HWY_INLINE void put_edge(const lane_corner& from, const lane_corner& to, std::size_t k,
                                  set_up_triangles& out) {
    const number dx = to.x - from.x, dy = to.y - from.y, zero = same(0);
    const condition is_left_or_top =
        hn::Or(hn::Lt(dy.v, zero.v), both(hn::Eq(dy.v, zero.v), hn::Gt(dx.v, zero.v)));
    put(dy * from.x - dx * from.y - chosen(is_left_or_top, zero, same(1)), out.first[k]);
    put(zero - dy * same(l3d_subpixel_one), out.per_column[k]);
    put(dx * same(l3d_subpixel_one), out.per_row[k]);
}

/// Linear colours over triangles whose corners are relative to the first sample. Returns where they
/// do not change too fast.
HWY_ATTR HWY_INLINE condition put_colors(const lane_corner& p, const lane_corner& q,
                                         const lane_corner& r, number area, set_up_triangles& out) {
    const number qx = q.x - p.x, qy = q.y - p.y, rx = r.x - p.x, ry = r.y - p.y;
    const number scale = same(1) / area, unit = same(l3d_subpixel_one);
    const auto most = same(most_change).v;
    condition gentle = hn::Eq(area.v, area.v);
    for (std::size_t k = 0; k < 3; ++k) {
        const number a = p.color[k], b = q.color[k], c = r.color[k];
        const number dx = ((b - a) * ry - (c - a) * qy) * scale;
        const number dy = ((c - a) * qx - (b - a) * rx) * scale;
        gentle = both(gentle, both(hn::Lt(hn::Abs(dx.v), most), hn::Lt(hn::Abs(dy.v), most)));
        put(a - dx * p.x - dy * p.y, out.start[k]);
        put(dx * unit, out.across[k]);
        put(dy * unit, out.down[k]);
        put(least(least(a, b), c), out.low[k]);
        put(largest(largest(a, b), c), out.high[k]);
    }
    return gentle;
}

HWY_ATTR HWY_INLINE void set_up(lane_corner p, lane_corner q, lane_corner r,
                                const std::array<double, 2>& ends, set_up_triangles& out) {
    const lane_range x(p.x, q.x, r.x), y(p.y, q.y, r.y);
    const condition small = both(x.small_within(ends[0]), y.small_within(ends[1]));
    const number left = first_sample(x.low), top = first_sample(y.low);
    const number columns = first_sample(x.high) - left, rows = first_sample(y.high) - top;
    for (lane_corner* corner : {&p, &q, &r}) {
        corner->x = corner->x - left * same(l3d_subpixel_one);
        corner->y = corner->y - top * same(l3d_subpixel_one);
    }
    const number area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x), zero = same(0);
    const condition gentle = put_colors(p, q, r, area, out);
    const condition left_turn = hn::Lt(area.v, zero.v);
    const lane_corner second{chosen(left_turn, r.x, q.x), chosen(left_turn, r.y, q.y), {}};
    const lane_corner third{chosen(left_turn, q.x, r.x), chosen(left_turn, q.y, r.y), {}};
    put_edge(p, second, 0, out);
    put_edge(second, third, 1, out);
    put_edge(third, p, 2, out);
    put(left, out.left);
    put(top, out.top);
    put(columns, out.columns);
    put(rows, out.rows);
    const condition nothing =
        hn::Or(hn::Eq(area.v, zero.v), hn::Le(least(columns, rows).v, zero.v));
    const number if_small =
        chosen(nothing, same(empty), chosen(gentle, same(to_be_filled), same(left_to_others)));
    put(chosen(small, if_small, same(left_to_others)), out.state);
}

template <class Lanes>
HWY_INLINE void fill(const l3d_pixels& target, const set_up_triangles& of, std::size_t triangle) {
    linear_colors<Lanes> colors(of, triangle);
    fill_box<Lanes>(target, of.box(triangle), of.edges(triangle), colors);
}

std::size_t shade_strip_in_lanes(const l3d_pixels& target, const mesh_strip& strip,
                                 const std::array<double, 2>& ends, std::size_t first) {
    const std::size_t all = strip.triangles(), lanes = lanes_at_once();
    std::array<set_up_triangles, 2> halves;
    for (std::size_t step = first / 2; 2 * step < all; step += lanes) {
        const lane_corner a = corners_of(strip.above, step), b = corners_of(strip.above, step + 1),
                          c = corners_of(strip.below, step + 1), d = corners_of(strip.below, step);
        set_up(a, b, c, ends, halves[0]);
        set_up(a, c, d, ends, halves[1]);
        const std::size_t end = std::min(all, 2 * (step + lanes));
        for (std::size_t i = std::max(first, 2 * step); i < end; ++i) {
            const set_up_triangles& half = halves[i % 2];
            const std::size_t lane = i / 2 - step;
            if (half.state[lane] == left_to_others)
                return i;
            if (half.state[lane] == empty)
                continue;
            if (half.columns[lane] <= narrow)
                fill<pixel_lanes<narrow>>(target, half, lane);
            else
                fill<pixel_lanes<2 * narrow>>(target, half, lane);
        }
    }
    return all;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(shade_strip_in_lanes);

std::size_t shade_strip(const l3d_pixels& target, const mesh_strip& strip,
                        const std::array<double, 2>& ends, std::size_t first) {
    return L3D_SIMD_CALL(shade_strip_in_lanes)(target, strip, ends, first);
}

} // namespace l3d_detail
#endif
