// SPDX-License-Identifier: MIT
// mesh_strip: sets up triangles in lanes of double, which small_fill fills.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/paths/mesh_strip.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/surface_part.h"
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

constexpr std::size_t most_lanes = 8;
static_assert(mesh_row::room >= most_lanes);
using lane_integers = hn::Rebind<std::int32_t, eight_doubles>;
using lane_floats = hn::Rebind<float, eight_doubles>;
using condition = hn::Mask<eight_doubles>;

/// The state of a triangle after its set-up.
enum : std::int32_t { left_to_others = 0, empty = 1, to_be_filled = 2 };

/// The largest change of a channel from a lattice unit to the next: 2^12 levels over small_side. So
/// sums are below 2^13, and the error of a few roundings in float is below 2^-9.
constexpr double most_change = 4096.0 / (small_side * l3d_subpixel_one);
/// The largest difference of a bilinear colour from the linear one, anywhere in a triangle's box.
constexpr double most_bend = 4096;

/// Triangles after their set-up. Element i of each innermost array belongs to triangle i.
struct set_up_triangles {
    using integers_of_all = std::array<std::int32_t, most_lanes>;
    using floats_of_all = std::array<float, most_lanes>;

    alignas(64) integers_of_all state, left, top, columns, rows;
    /// The edge functions of a triangle's three sides, as in small_edge.
    alignas(64) std::array<integers_of_all, 3> first, per_column, per_row;
    /// The linear functions that give red, green and blue.
    alignas(64) std::array<floats_of_all, 3> start, across, down;
    /// The twist of a bilinear colour. At each place, the bilinear colour exceeds the linear colour
    /// by `twist` times the product of two shares. These are the barycentric coordinates of the two
    /// corners on the diagonal.
    alignas(64) std::array<floats_of_all, 3> twist;
    struct share {
        floats_of_all start, across, down;
    };
    alignas(64) std::array<share, 2> shares;

    HWY_INLINE small_box box(std::size_t i) const { return {left[i], top[i], columns[i], rows[i]}; }
    HWY_INLINE std::array<small_edge, 3> edges(std::size_t i) const {
        std::array<small_edge, 3> result;
        for (std::size_t k = 0; k < 3; ++k)
            result[k] = {first[k][i], per_column[k][i], per_row[k][i]};
        return result;
    }
};

/// Makes the pixel words of a triangle with bilinear colours, which are quadratic functions down
/// each column.
template <class Lanes> class bilinear_colors {
public:
    HWY_INLINE bilinear_colors(const set_up_triangles& of, std::size_t triangle)
        : of_(of), triangle_(triangle) {
        const float both_down = of.shares[0].down[triangle] * of.shares[1].down[triangle];
        for (std::size_t k = 0; k < 3; ++k)
            bend_[k] = hn::Set(floats, 2 * both_down * of.twist[k][triangle]);
    }

    HWY_INLINE void begin_block(std::int32_t column) {
        const auto i = hn::ConvertTo(floats, hn::Iota(Lanes::integers, column));
        const auto set = [this](const floats_of_all& of) { return hn::Set(floats, of[triangle_]); };
        const auto linear = [&](const floats_of_all& start, const floats_of_all& across) {
            return hn::Add(set(start), hn::Mul(set(across), i));
        };
        const auto &one = of_.shares[0], &other = of_.shares[1];
        const auto e = linear(one.start, one.across), f = linear(other.start, other.across);
        const auto e_down = set(one.down), f_down = set(other.down);
        const auto product = hn::Mul(e, f);
        const auto product_down =
            hn::Add(hn::Add(hn::Mul(e, f_down), hn::Mul(f, e_down)), hn::Mul(e_down, f_down));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto twist = set(of_.twist[k]);
            value_[k] = hn::Add(linear(of_.start[k], of_.across[k]), hn::Mul(twist, product));
            down_[k] = hn::Add(set(of_.down[k]), hn::Mul(twist, product_down));
        }
    }

    HWY_INLINE typename Lanes::word_vec next_row() {
        typename Lanes::word_vec level[3];
        for (std::size_t k = 0; k < 3; ++k) {
            level[k] = hn::BitCast(Lanes::words, hn::Add(value_[k], hn::Set(floats, whole_floats)));
            value_[k] = hn::Add(value_[k], down_[k]);
            down_[k] = hn::Add(down_[k], bend_[k]);
        }
        return hn::Or(hn::Or(hn::ShiftLeft<16>(level[0]), hn::ShiftLeft<8>(level[1])),
                      hn::And(level[2], hn::Set(Lanes::words, 255)));
    }

private:
    using floats_of_all = set_up_triangles::floats_of_all;

    /// From this number on, floats are whole numbers. So adding this number to a level rounds the
    /// level to the nearest, and leaves it in the lowest bits. All other bits are in the highest
    /// byte.
    static constexpr float whole_floats = 0x1p23F;

    static constexpr auto floats = Lanes::floats;

    const set_up_triangles& of_;
    std::size_t triangle_;
    typename Lanes::float_vec value_[3], down_[3], bend_[3];
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

/// A corner of the triangle in each lane. Units: 1/256 pixel, whole numbers.
struct lane_corner {
    number x, y;
    std::array<number, 3> color;
};

HWY_ATTR HWY_INLINE lane_corner chosen(condition which, const lane_corner& a,
                                       const lane_corner& b) {
    lane_corner result{chosen(which, a.x, b.x), chosen(which, a.y, b.y), {}};
    for (std::size_t k = 0; k < 3; ++k)
        result.color[k] = chosen(which, a.color[k], b.color[k]);
    return result;
}

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

/// The range of the three corners' coordinates along one axis.
struct lane_range {
    number low, high;

    HWY_ATTR HWY_INLINE lane_range(number a, number b, number c)
        : low(least(least(a, b), c)), high(largest(largest(a, b), c)) {}

    /// Whether the range is small and ends before `end`; false if a coordinate is not a number.
    HWY_ATTR HWY_INLINE condition small_within(double end) const {
        return both(both(hn::Ge(low.v, hn::Zero(eight_doubles())),
                         hn::Le(high.v, same(end * l3d_subpixel_one).v)),
                    hn::Le((high - low).v, same(small_side * l3d_subpixel_one).v));
    }
};

/// The first pixel whose sample is not before a place, along one axis.
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

/// A linear function over the triangle in each lane, whose corners are relative to the first
/// sample.
struct lane_plane {
    number start, across, down; ///< the value at the first sample, and the changes per lattice unit
};

/// The numbers that all planes of a triangle have in common, for making lane_planes of its corners'
/// values.
struct lane_planes {
    number px, py, qx, qy, rx, ry, scale;

    HWY_ATTR HWY_INLINE lane_planes(const lane_corner& p, const lane_corner& q,
                                    const lane_corner& r, number area)
        : px(p.x), py(p.y), qx(q.x - p.x), qy(q.y - p.y), rx(r.x - p.x), ry(r.y - p.y),
          scale(same(1) / area) {}

    HWY_ATTR HWY_INLINE lane_plane through(number a, number b, number c) const {
        const number across = ((b - a) * ry - (c - a) * qy) * scale;
        const number down = ((c - a) * qx - (b - a) * rx) * scale;
        return {a - across * px - down * py, across, down};
    }
};

HWY_ATTR HWY_INLINE void put(const lane_plane& plane, set_up_triangles::floats_of_all& start,
                             set_up_triangles::floats_of_all& across,
                             set_up_triangles::floats_of_all& down) {
    const number unit = same(l3d_subpixel_one);
    put(plane.start, start);
    put(plane.across * unit, across);
    put(plane.down * unit, down);
}

/// Sets up the colours of triangles whose first and last corners are on the diagonal. Returns the
/// lanes whose colours do not change too fast.
HWY_ATTR HWY_INLINE condition put_colors(const lane_corner& p, const lane_corner& q,
                                         const lane_corner& r, const std::array<number, 3>& twist,
                                         number area, number width, number height,
                                         set_up_triangles& out) {
    const lane_planes planes(p, q, r, area);
    const auto most = same(most_change).v;
    condition gentle = hn::Eq(area.v, area.v);
    number most_twist = same(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const lane_plane plane = planes.through(p.color[k], q.color[k], r.color[k]);
        gentle = both(gentle, both(hn::Lt(magnitude(plane.across).v, most),
                                   hn::Lt(magnitude(plane.down).v, most)));
        put(plane, out.start[k], out.across[k], out.down[k]);
        put(twist[k], out.twist[k]);
        most_twist = largest(most_twist, magnitude(twist[k]));
    }
    const number zero = same(0), one = same(1);
    const lane_plane of_p = planes.through(one, zero, zero), of_r = planes.through(zero, zero, one);
    put(of_p, out.shares[0].start, out.shares[0].across, out.shares[0].down);
    put(of_r, out.shares[1].start, out.shares[1].across, out.shares[1].down);
    const auto change = [&](const lane_plane& of) HWY_ATTR {
        return magnitude(of.across) * width + magnitude(of.down) * height;
    };
    const number share = one + largest(change(of_p), change(of_r));
    return both(gentle, hn::Lt((most_twist * share * share).v, same(most_bend).v));
}

HWY_ATTR HWY_INLINE void set_up(lane_corner p, lane_corner q, lane_corner r,
                                const std::array<number, 3>& twist,
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
    const condition gentle = put_colors(p, q, r, twist, area, x.high - x.low, y.high - y.low, out);
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
    bilinear_colors<Lanes> colors(of, triangle);
    fill_box<Lanes>(target, of.box(triangle), of.edges(triangle), colors);
}

std::size_t shade_strip_in_lanes(const l3d_pixels& target, const mesh_strip& strip,
                                 const std::array<double, 2>& ends, std::size_t first) {
    const std::size_t all = 2 * strip.cells(), lanes = lanes_at_once();
    std::array<set_up_triangles, 2> halves;
    for (std::size_t step = first / 2; 2 * step < all; step += lanes) {
        const lane_corner a = corners_of(strip.above, step), b = corners_of(strip.above, step + 1),
                          c = corners_of(strip.below, step + 1), d = corners_of(strip.below, step);
        const condition rises = hn::Ne(hn::LoadU(eight_doubles(), strip.rises.data() + step),
                                       hn::Zero(eight_doubles()));
        std::array<number, 3> twist;
        for (std::size_t k = 0; k < 3; ++k) {
            const number value = a.color[k] - b.color[k] + c.color[k] - d.color[k];
            twist[k] = chosen(rises, value, same(0) - value);
        }
        set_up(chosen(rises, d, a), chosen(rises, a, b), chosen(rises, b, c), twist, ends,
               halves[0]);
        set_up(chosen(rises, b, c), chosen(rises, c, d), chosen(rises, d, a), twist, ends,
               halves[1]);
        const std::size_t end = std::min(all, 2 * (step + lanes));
        for (std::size_t i = std::max(first, 2 * step); i < end; ++i) {
            const set_up_triangles& half = halves[i % 2];
            const std::size_t lane = i / 2 - step;
            if (half.state[lane] == left_to_others)
                return i;
            if (half.state[lane] == empty)
                continue;
            // Narrower vectors for narrower triangles would cost more in mispredicted branches.
            if (half.columns[lane] <= 8)
                fill<pixel_lanes<8>>(target, half, lane);
            else
                fill<pixel_lanes<16>>(target, half, lane);
        }
    }
    return all;
}

/// The bilinear colours of a cell, a + u across + v (down + u twist) for each channel.
struct cell_colors {
    std::array<float, 3> start, across, down, twist;

    explicit cell_colors(const mesh_cell& cell) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = [&](std::size_t i) { return cell.corners[i].color[k]; };
            start[k] = static_cast<float>(at(0));
            across[k] = static_cast<float>(at(1) - at(0));
            down[k] = static_cast<float>(at(2) - at(0));
            twist[k] = static_cast<float>(at(0) - at(1) - at(2) + at(3));
        }
    }
};

constexpr pixel_lanes<16> wide;

HWY_INLINE decltype(wide)::word_vec words_at(const shaded_span& span, const cell_colors& colors,
                                             std::int32_t column) {
    constexpr auto floats = wide.floats;
    const auto set = [](float x) { return hn::Set(wide.floats, x); };
    const auto i = hn::ConvertTo(floats, hn::Iota(wide.integers, column - span.anchor));
    const auto u = hn::Add(set(span.start[0]), hn::Mul(set(span.step[0]), i));
    const auto v = hn::Add(set(span.start[1]), hn::Mul(set(span.step[1]), i));
    decltype(wide)::word_vec level[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const auto down = hn::Add(set(colors.down[k]), hn::Mul(u, set(colors.twist[k])));
        const auto above = hn::Add(set(colors.start[k]), hn::Mul(u, set(colors.across[k])));
        const auto value = hn::Add(hn::Add(above, hn::Mul(v, down)), set(0.5F));
        level[k] = hn::BitCast(wide.words, hn::ConvertTo(wide.integers, value));
    }
    return hn::Or(hn::Or(hn::ShiftLeft<16>(level[0]), hn::ShiftLeft<8>(level[1])), level[2]);
}

void shade_bilinear_in_lanes(const l3d_pixels& target, const mesh_cell& cell,
                             std::span<const shaded_span> spans) {
    const cell_colors colors(cell);
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(wide.words));
    for (const shaded_span& s : spans) {
        std::uint32_t* row = target.words + s.row * target.stride;
        for (std::int32_t x = s.first; x < s.last; x += lanes) {
            const auto count = static_cast<std::size_t>(std::min(lanes, s.last - x));
            hn::BlendedStore(words_at(s, colors, x), hn::FirstN(wide.words, count), wide.words,
                             row + x);
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(shade_strip_in_lanes);
L3D_SIMD_TABLE(shade_bilinear_in_lanes);

std::size_t shade_strip(const l3d_pixels& target, const mesh_strip& strip,
                        const std::array<double, 2>& ends, std::size_t first) {
    return L3D_SIMD_CALL(shade_strip_in_lanes)(target, strip, ends, first);
}

void shade_bilinear(const l3d_pixels& target, const mesh_cell& cell,
                    std::span<const shaded_span> spans) {
    L3D_SIMD_CALL(shade_bilinear_in_lanes)(target, cell, spans);
}

} // namespace l3d_detail
#endif
