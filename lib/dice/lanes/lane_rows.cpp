// SPDX-License-Identifier: MIT
// walk_in_lanes: walks columns by forward differences in SIMD lanes.
#include "dice/lanes/lane_rows_p.h"

#include "geom/bezier_patch.h"

#include <algorithm>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/lanes/lane_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using doubles = hn::CappedTag<double, lane_columns>;

/// The numbers with which the walk of a vector of columns starts. `point` has the first point of
/// each strip and the last strip's end: [strip][coordinate][column]. `at` has the four registers of
/// each coordinate, for the curve in each strip, balanced if the walk is: [strip][4 * coordinate +
/// difference][column].
template <class Number> struct column_starts {
    static constexpr std::size_t registers = 12;
    alignas(64) Number point[5][3][lane_columns];
    alignas(64) Number at[4][registers][lane_columns];
};

/// Stores numbers with which columns start in the type of the registers. Fixed-point registers hold
/// the numbers times `scale`.
HWY_ATTR HWY_INLINE void put(hn::Vec<doubles> value, double, float* out) {
    const hn::Rebind<float, doubles> d;
    hn::Store(hn::DemoteTo(d, value), d, out);
}
HWY_ATTR HWY_INLINE void put(hn::Vec<doubles> value, double, double* out) {
    hn::Store(value, doubles(), out);
}
HWY_ATTR HWY_INLINE void put(hn::Vec<doubles> value, double scale, std::int32_t* out) {
    const hn::Rebind<std::int32_t, doubles> d;
    const auto raw = hn::Round(hn::Mul(value, hn::Set(doubles(), scale)));
    hn::Store(hn::DemoteTo(d, raw), d, out);
}
HWY_ATTR HWY_INLINE void put(hn::Vec<doubles> value, double scale, std::int64_t* out) {
    const hn::Rebind<std::int64_t, doubles> d;
    const auto raw = hn::Round(hn::Mul(value, hn::Set(doubles(), scale)));
    hn::Store(hn::ConvertTo(d, raw), d, out);
}

/// Converts registers to floating point, for division.
template <class D> using float_tag = hn::RebindToFloat<D>;
template <class D, class V> HWY_ATTR HWY_INLINE auto as_float(D, V value) {
    if constexpr (hwy::IsFloat<hn::TFromD<D>>())
        return value;
    else
        return hn::ConvertTo(float_tag<D>(), value);
}

/// Rounds numbers of all lanes to the nearest integers of 32 bits.
template <class D> HWY_ATTR HWY_INLINE auto snapped(D, hn::Vec<D> value) {
    if constexpr (sizeof(hn::TFromD<D>) == 4)
        return hn::NearestInt(value);
    else
        return hn::DemoteTo(hn::Rebind<std::int32_t, D>(), hn::Round(value));
}
template <class D> HWY_ATTR HWY_INLINE auto as_single(D, hn::Vec<D> value) {
    if constexpr (sizeof(hn::TFromD<D>) == 4)
        return value;
    else
        return hn::DemoteTo(hn::Rebind<float, D>(), value);
}

/// A bicubic in powers of u and v: [component][power of v][power of u].
struct power_form {
    double at[3][4][4];
};

/// The power form of a net, with w_middle subtracted from w.
HWY_ATTR power_form powers_of(const centred_net& net, double w_middle) {
    power_form result;
    for (std::size_t k = 0; k < 3; ++k) {
        auto& p = result.at[k];
        for (std::size_t r = 0; r < 4; ++r)
            for (std::size_t c = 0; c < 4; ++c)
                p[r][c] = net.points[k][4 * r + c] - (k == 2 ? w_middle : 0);
        for (std::size_t c = 0; c < 4; ++c)
            l3d_to_powers(p[0][c], p[1][c], p[2][c], p[3][c]);
        for (std::size_t r = 0; r < 4; ++r)
            l3d_to_powers(p[r][0], p[r][1], p[r][2], p[r][3]);
    }
    return result;
}

/// The weights that make forward differences of f(t) = a0 + a1 t + a2 t^2 + a3 t^3 at t with step
/// h. The differences are f(t), d1 . (a1, a2, a3), d2 . (a2, a3) and d3 a3.
struct difference_weights {
    double t, d1[3], d2[2], d3;
    double moved; ///< the factor lane_parameters::moved of these columns

    difference_weights(double at, double h, double moved_by) : t(at), moved(moved_by) {
        const double h2 = h * h, h3 = h2 * h;
        d1[0] = h;
        d1[1] = 2 * t * h + h2;
        d1[2] = 3 * t * (t * h + h2) + h3;
        d2[0] = 2 * h2;
        d2[1] = 6 * (t * h2 + h3);
        d3 = 6 * h3;
    }
};

/// Finds the starts of the columns from `column` + i on, one vector of columns, for all strips.
template <class Number>
HWY_ATTR HWY_INLINE void start(const power_form& powers, const lane_walk& walk,
                               const difference_weights* weights, std::size_t column, std::size_t i,
                               column_starts<Number>& starts) {
    const doubles d;
    const auto t = hn::Load(d, walk.u.at + column + i);
    const auto moved = hn::Load(d, walk.u.moved + column + i);
    const auto six = hn::Set(d, 6.0), two = hn::Set(d, 2.0);
    for (std::size_t k = 0; k < 3; ++k) {
        // The column's curve in powers of v: the bicubic at u, balanced along u.
        const auto at_u = [&](std::size_t power) HWY_ATTR {
            const double* a = powers.at[k][power];
            const auto bend = hn::Set(d, a[2]), twist = hn::Mul(hn::Set(d, a[3]), t);
            auto sum = hn::Add(twist, bend);
            sum = hn::Add(hn::Mul(sum, t), hn::Set(d, a[1]));
            sum = hn::Add(hn::Mul(sum, t), hn::Set(d, a[0]));
            const auto second = hn::Add(hn::Mul(two, bend), hn::Mul(six, twist));
            return hn::Sub(sum, hn::Mul(moved, second));
        };
        const auto a0 = at_u(0), a1 = at_u(1), a2 = at_u(2), a3 = at_u(3);

        // The start of each strip, and the registers of its differences, balanced along v.
        const double scale = k < 2 ? walk.register_xy : walk.register_w;
        for (std::size_t b = 0; b < static_cast<std::size_t>(walk.strips); ++b) {
            const difference_weights& by = weights[b];
            const auto at = hn::Set(d, by.t), moved_v = hn::Set(d, by.moved);
            const auto twist = hn::Mul(a3, at);
            auto value = hn::Add(twist, a2);
            value = hn::Add(hn::Mul(value, at), a1);
            value = hn::Add(hn::Mul(value, at), a0);
            const auto bend = hn::Add(hn::Mul(two, a2), hn::Mul(six, twist));
            const auto slope = hn::Sub(a1, hn::Mul(moved_v, hn::Mul(six, a3)));
            const auto first = hn::Add(
                hn::Add(hn::Mul(slope, hn::Set(d, by.d1[0])), hn::Mul(a2, hn::Set(d, by.d1[1]))),
                hn::Mul(a3, hn::Set(d, by.d1[2])));
            const auto second =
                hn::Add(hn::Mul(a2, hn::Set(d, by.d2[0])), hn::Mul(a3, hn::Set(d, by.d2[1])));
            put(value, scale, starts.point[b][k] + i);
            auto* out = starts.at[b] + 4 * k;
            put(hn::Sub(value, hn::Mul(moved_v, bend)), scale, out[0] + i);
            put(first, scale, out[1] + i);
            put(second, scale, out[2] + i);
            put(hn::Mul(a3, hn::Set(d, by.d3)), scale, out[3] + i);
        }

        // The end of the last strip, where v = 1.
        put(hn::Add(hn::Add(a0, a1), hn::Add(a2, a3)), scale, starts.point[walk.strips][k] + i);
    }
}

/// Walks one vector of columns, from `column` + i on, down all strips.
template <class Number, bool Parallel>
HWY_ATTR HWY_INLINE void walk_down(const lane_walk& walk, const column_starts<Number>& starts,
                                   std::size_t column, std::size_t i, l3d_micro_grid& grid) {
    const hn::CappedTag<Number, lane_columns> d;
    const float_tag<decltype(d)> df;
    using real = hn::TFromD<float_tag<decltype(d)>>;
    const hn::Rebind<std::int32_t, decltype(df)> di;
    const hn::Rebind<float, decltype(df)> ds;
    const double divisor = Parallel ? walk.w_middle : 1 / walk.register_w;
    const auto to_pixels =
        hn::Set(df, static_cast<real>(l3d_subpixel_one / divisor / walk.register_xy));
    // There are two factors, since their product may not fit a float. Its product with 1 / w does.
    [[maybe_unused]] const auto to_units = hn::Set(ds, static_cast<float>(walk.register_w));
    [[maybe_unused]] const auto to_depth = hn::Set(ds, walk.depth_scale);
    const auto origin_x = hn::Set(di, walk.origin_x), origin_y = hn::Set(di, walk.origin_y);
    [[maybe_unused]] const auto one = hn::Set(df, real(1));
    [[maybe_unused]] const auto slope =
        hn::Set(ds, static_cast<float>(walk.depth_slope / walk.register_w));
    [[maybe_unused]] const auto middle_depth =
        hn::Set(ds, static_cast<float>(l3d_dice_view::middle_depth));

    // Projects, snaps and stores a row of vertices.
    std::size_t to = column + i;
    using number_vec = hn::Vec<decltype(d)>;
    using float_vec = hn::Vec<decltype(df)>;
    const auto put_places = [&](number_vec x, number_vec y, float_vec scaled) HWY_ATTR {
        const auto px = snapped(df, hn::Mul(as_float(d, x), scaled));
        const auto py = snapped(df, hn::Mul(as_float(d, y), scaled));
        hn::StoreU(hn::Add(px, origin_x), di, grid.x.data() + to);
        hn::StoreU(hn::Add(py, origin_y), di, grid.y.data() + to);
    };
    const auto emit = [&](number_vec x, number_vec y, number_vec w) HWY_ATTR {
        if constexpr (Parallel) {
            put_places(x, y, to_pixels);
            const auto change = hn::Mul(as_single(df, as_float(d, w)), slope);
            hn::StoreU(hn::Add(change, middle_depth), ds, grid.inv_w.data() + to);
        } else {
            const auto inverse = hn::Div(one, as_float(d, w));
            put_places(x, y, hn::Mul(inverse, to_pixels));
            const auto inv_w = hn::Mul(as_single(df, inverse), to_units);
            hn::StoreU(hn::Mul(inv_w, to_depth), ds, grid.inv_w.data() + to);
        }
        to += static_cast<std::size_t>(grid.pitch);
    };
    const auto emit_point = [&](int b) HWY_ATTR {
        const auto& point = starts.point[b];
        emit(hn::Load(d, point[0] + i), hn::Load(d, point[1] + i), hn::Load(d, point[2] + i));
    };

    // Each strip starts from exact values. From row to row, only differences are added.
    for (int b = 0; b < walk.strips; ++b) {
        emit_point(b);
        const auto* from = starts.at[b];
        auto x = hn::Load(d, from[0] + i), x1 = hn::Load(d, from[1] + i);
        auto y = hn::Load(d, from[4] + i), y1 = hn::Load(d, from[5] + i);
        auto w = hn::Load(d, from[8] + i), w1 = hn::Load(d, from[9] + i);
        auto x2 = hn::Load(d, from[2] + i), y2 = hn::Load(d, from[6] + i);
        auto w2 = hn::Load(d, from[10] + i);
        const auto x3 = hn::Load(d, from[3] + i), y3 = hn::Load(d, from[7] + i);
        const auto w3 = hn::Load(d, from[11] + i);
        for (int row = 1; row < walk.rows[static_cast<std::size_t>(b)]; ++row) {
            x = hn::Add(x, x1);
            y = hn::Add(y, y1);
            w = hn::Add(w, w1);
            x1 = hn::Add(x1, x2);
            y1 = hn::Add(y1, y2);
            w1 = hn::Add(w1, w2);
            x2 = hn::Add(x2, x3);
            y2 = hn::Add(y2, y3);
            w2 = hn::Add(w2, w3);
            emit(x, y, w);
        }
    }
    emit_point(walk.strips);
}

template <class Number, bool Parallel>
HWY_ATTR void walk_columns(const lane_walk& walk, l3d_micro_grid& grid) {
    const power_form powers = powers_of(walk.net, walk.w_middle);
    const auto weights_of = [&](int b) {
        const int n = walk.rows[static_cast<std::size_t>(b)];
        const double h = 1.0 / (walk.strips * n);
        return difference_weights(static_cast<double>(b) / walk.strips, h,
                                  walk.balanced && n > 1 ? l3d_balance * h * h : 0);
    };
    const difference_weights first = weights_of(0);
    difference_weights weights[4] = {first, first, first, first};
    for (int b = 1; b < walk.strips; ++b)
        weights[b] = weights_of(b);
    column_starts<Number> starts;
    constexpr hn::CappedTag<Number, lane_columns> d;
    for (std::size_t column = 0; column < walk.u.count; column += lane_columns) {
        // The end of the last whole vector of registers for these columns.
        const std::size_t left = std::min(walk.u.count - column, lane_columns);
        const std::size_t end = hwy::RoundUpTo(left, hn::Lanes(d));
        for (std::size_t i = 0; i < end; i += hn::Lanes(doubles()))
            start(powers, walk, weights, column, i, starts);
        for (std::size_t i = 0; i < end; i += hn::Lanes(d))
            walk_down<Number, Parallel>(walk, starts, column, i, grid);
    }
}

template <class Number> HWY_ATTR void walk_in(const lane_walk& walk, l3d_micro_grid& grid) {
    if (walk.w_middle > 0)
        walk_columns<Number, true>(walk, grid);
    else
        walk_columns<Number, false>(walk, grid);
}

HWY_ATTR void walk_float_32(const lane_walk& walk, l3d_micro_grid& grid) {
    walk_in<float>(walk, grid);
}
HWY_ATTR void walk_float_64(const lane_walk& walk, l3d_micro_grid& grid) {
    walk_in<double>(walk, grid);
}
HWY_ATTR void walk_fixed_32(const lane_walk& walk, l3d_micro_grid& grid) {
    walk_in<std::int32_t>(walk, grid);
}
HWY_ATTR void walk_fixed_64(const lane_walk& walk, l3d_micro_grid& grid) {
    walk_in<std::int64_t>(walk, grid);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(walk_float_32);
L3D_SIMD_TABLE(walk_float_64);
L3D_SIMD_TABLE(walk_fixed_32);
L3D_SIMD_TABLE(walk_fixed_64);

void lane_parameters::fill(int strips, const std::array<int, 4>& steps, bool balanced) {
    const double length = 1.0 / strips; // a power of two
    count = 0;
    for (int s = 0; s < strips; ++s) {
        const int n = steps[static_cast<std::size_t>(s)];
        const double h = length / n;
        for (int i = 0; i < n; ++i, ++count) {
            at[count] = (s + static_cast<double>(i) / n) * length;
            moved[count] = balanced && i > 0 ? l3d_balance * h * h : 0;
        }
    }
    const std::size_t last = count++;
    std::fill(at + last, at + padded(), 1.0);
    std::fill(moved + last, moved + padded(), 0.0);
}

void lane_parameters::place(double low, double high) {
    if (low == 0 && high == 1)
        return;
    for (std::size_t i = 0; i < padded(); ++i)
        at[i] = low + (high - low) * at[i];
}

void walk_in_lanes(const lane_walk& walk, lane_register kind, l3d_micro_grid& grid) {
    switch (kind) {
    case lane_register::float_32:
        return L3D_SIMD_CALL(walk_float_32)(walk, grid);
    case lane_register::float_64:
        return L3D_SIMD_CALL(walk_float_64)(walk, grid);
    case lane_register::fixed_32:
        return L3D_SIMD_CALL(walk_fixed_32)(walk, grid);
    case lane_register::fixed_64:
        return L3D_SIMD_CALL(walk_fixed_64)(walk, grid);
    }
}

} // namespace l3d_detail
#endif
