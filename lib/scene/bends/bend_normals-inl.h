// SPDX-License-Identifier: MIT
// Bounds the derivatives of a unit normal over parts of a patch, and bends along the normal.
#if defined(L3D_SCENE_BENDS_BEND_NORMALS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_SCENE_BENDS_BEND_NORMALS_INL_H
#undef L3D_SCENE_BENDS_BEND_NORMALS_INL_H
#else
#define L3D_SCENE_BENDS_BEND_NORMALS_INL_H
#endif

#include "scene/bends/bend_series-inl.h"
#include "scene/bends/surface_bends_p.h"

#include <cmath>
#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The Taylor coefficients of a vector polynomial about the middles of parts of a patch, one part a
/// lane: [power of u][power of v]. Parameters run from -1 to 1 across a part.
template <std::size_t Degree> struct taylor_net { vector at[Degree + 1][Degree + 1]; };

constexpr double factorial(std::size_t n) {
    return n == 0 ? 1 : static_cast<double>(n) * factorial(n - 1);
}

/// The factor that turns the Taylor coefficient of u^k v^l into a derivative by parameters from 0
/// to 1 across the part. The coefficients' own parameters run twice as far, from -1 to 1.
constexpr double as_derivative(std::size_t k, std::size_t l) {
    return factorial(k) * factorial(l) * static_cast<double>(std::size_t{1} << (k + l));
}

/// Finds the largest of |a + b s + c t| for s and t from -1 to 1. The largest value is in a corner,
/// since the function is convex.
HWY_ATTR HWY_INLINE number largest_size(const vector& a, const vector& b, const vector& c) {
    const vector low = a - b, high = a + b;
    const number one = largest(squared(low - c), squared(low + c));
    return root(largest(one, largest(squared(high - c), squared(high + c))));
}

/// Bound of the error that rounding adds to normals, for normals whose longest coefficient is 1
/// (docs/NUMERICS.md, section 11).
constexpr double normal_noise = 0x1p-39;

/// A normal shorter than this is mostly noise, if the longest coefficient is 1.
constexpr double no_length = 0x1p-32;

/// Bound of the error that rounding adds to a second or third derivative of points, relative to the
/// largest of the points' coordinates.
constexpr double point_noise = 0x1p-44;

/// A factor that makes up for rounding in the sums of positive numbers below.
constexpr double relative = 1 + 0x1p-40;

// Functions that have series of their own are not inlined, so the stack holds only the series in
// use. A series takes 3 KB with the longest lanes.

/// The unit normals N of parts, one part a lane. The class computes their Taylor coefficients about
/// the parts' middles up to series_order, and bounds of derivatives over whole parts.
///
/// M is the polynomial of normals, and m is M over its length in the middle. Let p be the series of
/// (m . m)^(-1/2), cut off. Then p m points like m, and has the coefficients of N up to
/// series_order. (p m) . (p m) is 1 - w, where the first coefficients of w are 0. So N = p m (1 -
/// w)^(-1/2).
///
/// The same expression is taken with absolute values of all coefficients. The coefficients of the
/// result bound the absolute values of N's coefficients. Signs are lost only beyond the order. A
/// series of absolute values is largest in the corner (1, 1), where all coefficients add up, and so
/// are its derivatives. These values are bounds everywhere.
/// Source: Cauchy's method of majorants.
class part_normals {
public:
    HWY_ATTR explicit part_normals(taylor_net<5> m);

    HWY_ATTR HWY_INLINE const vector& at(std::size_t k, std::size_t l) const { return n_[k][l]; }

    HWY_ATTR HWY_INLINE number size(std::size_t k, std::size_t l) const { return sizes_[k][l]; }

    /// The value of a series in the corner. Its coefficients are the absolute values of N's
    /// coefficients.
    HWY_ATTR HWY_INLINE number sum_of_sizes() const { return most_[0][0]; }
    HWY_ATTR HWY_INLINE number noise() const { return noise_; }

    /// The mask of lanes in which the bounds hold. The bounds do not hold where a part may lack a
    /// normal.
    HWY_ATTR HWY_INLINE auto known() const { return known_; }

    HWY_ATTR HWY_INLINE number in_middle(std::size_t k, std::size_t l) const {
        return sizes_[k][l] * same(as_derivative(k, l));
    }

    /// The bound of the derivative of N, k times by u and l times by v. The bound's terms of order
    /// 0 and 1 are exact; all other terms are sums of absolute values.
    HWY_ATTR HWY_INLINE number bound(std::size_t k, std::size_t l) const {
        const number u = same(static_cast<double>(k + 1)), v = same(static_cast<double>(l + 1));
        const number exact = largest_size(n_[k][l], n_[k + 1][l] * u, n_[k][l + 1] * v);
        const number others =
            most_[k][l] - (sizes_[k][l] + sizes_[k + 1][l] * u + sizes_[k][l + 1] * v);
        return (exact + others + noise_) * same(as_derivative(k, l) * relative);
    }

private:
    HWY_NOINLINE HWY_ATTR void bound_products(const taylor_net<5>& m, const series& p);

    vector n_[series_order][series_order];
    series sizes_, most_;
    number noise_;
    hn::Mask<eight_doubles> known_;
};

HWY_ATTR part_normals::part_normals(taylor_net<5> m) {
    const number length = root(squared(m.at[0][0])), inverse = same(1) / length;
    known_ = hn::Gt(length.v, same(no_length).v);
    noise_ = same(normal_noise) * inverse;
    for (auto& column : m.at)
        for (vector& c : column)
            c = c * inverse;
    series square, p;
    for_powers(series_order - 1, [&](std::size_t k, std::size_t l) HWY_ATTR {
        number sum = same(0);
        for (std::size_t i = k > 5 ? k - 5 : 0; i <= k && i <= 5; ++i)
            for (std::size_t j = l > 5 ? l - 5 : 0; j <= l && j <= 5; ++j)
                sum = sum + dot(m.at[i][j], m.at[k - i][l - j]);
        square[k][l] = sum;
    });
    inverse_root(square, series_order - 1, p);
    for_powers(series_order - 1, [&](std::size_t k, std::size_t l) HWY_ATTR {
        vector sum{same(0), same(0), same(0)};
        for (std::size_t i = 0; i <= k && i <= 5; ++i)
            for (std::size_t j = 0; j <= l && j <= 5; ++j)
                sum = sum + m.at[i][j] * p[k - i][l - j];
        n_[k][l] = sum;
        sizes_[k][l] = root(squared(sum));
    });
    bound_products(m, p);
}

/// The product of two series of absolute values, in the corner. `all` has the product's value and
/// its derivatives. `beyond` has their part that comes from coefficients beyond the order: `all`
/// less the part of the first coefficients.
struct product_in_corner {
    series all, beyond;

    HWY_NOINLINE HWY_ATTR product_in_corner(const series& p, const series& p_in_corner,
                                            number (&m)[6][6]) {
        series first, low;
        for_powers(series_order - 1, [&](std::size_t k, std::size_t l) HWY_ATTR {
            first[k][l] = k < 6 && l < 6 ? m[k][l] : same(0);
        });
        multiply(p, first, series_order - 1, low);
        move_to_corner(low);
        move_to_corner(m, [](std::size_t) { return std::size_t{6}; });
        for_powers(wanted_order,
                   [&](std::size_t k, std::size_t l) HWY_ATTR { first[k][l] = m[k][l]; });
        multiply(p_in_corner, first, wanted_order, all);
        for_powers(wanted_order, [&](std::size_t k, std::size_t l) HWY_ATTR {
            beyond[k][l] = largest(all[k][l] - low[k][l], same(0));
        });
    }
};

/// Finds the bounds `most_`.
///
/// Let a be the normal in the middle, and p m = f + z a + x. f is exact; z and x are the rest
/// beyond the order, along a and across it. Dividing p m by 1 + z changes no direction, and gives f
/// + (x - z (f - a)) / (1 + z). So for a plane nothing is left beyond the order, and elsewhere less
/// is left than without this division.
HWY_ATTR void part_normals::bound_products(const taylor_net<5>& m, const series& p) {
    const vector a = m.at[0][0];
    number sizes_along[6][6], sizes_across[6][6];
    for (std::size_t k = 0; k < 6; ++k)
        for (std::size_t l = 0; l < 6; ++l) {
            const number along = dot(m.at[k][l], a);
            sizes_along[k][l] = magnitude(along);
            sizes_across[k][l] = root(squared(m.at[k][l] - a * along));
        }
    series of_p, p_in_corner;
    for_powers(series_order - 1, [&](std::size_t k, std::size_t l) HWY_ATTR {
        p_in_corner[k][l] = of_p[k][l] = magnitude(p[k][l]);
    });
    move_to_corner(p_in_corner);
    const product_in_corner along(of_p, p_in_corner, sizes_along);
    const product_in_corner across(of_p, p_in_corner, sizes_across);
    number most = same(0);
    for_powers(wanted_order, [&](std::size_t k, std::size_t l) HWY_ATTR {
        most = largest(most, along.all[k][l] + across.all[k][l]);
    });
    noise_ = noise_ * most * most;
    series first, first_squared;
    for_powers(series_order - 1,
               [&](std::size_t k, std::size_t l) HWY_ATTR { first[k][l] = sizes_[k][l]; });
    multiply(first, first, series_order - 1, first_squared);
    move_to_corner(first_squared);
    move_to_corner(first);
    series turned, one_less_z, by_z, beyond, pm, square, w, g;
    for_powers(wanted_order, [&](std::size_t k, std::size_t l) HWY_ATTR {
        const number one = same(k + l == 0 ? 1 : 0);
        turned[k][l] = largest(first[k][l] - one, same(0));
        one_less_z[k][l] = one - along.beyond[k][l];
    });
    multiply(along.beyond, turned, wanted_order, w);
    for_powers(wanted_order, [&](std::size_t k, std::size_t l)
                                 HWY_ATTR { w[k][l] = w[k][l] + across.beyond[k][l]; });
    invert(one_less_z, wanted_order, by_z);
    multiply(w, by_z, wanted_order, beyond);
    for_powers(wanted_order, [&](std::size_t k, std::size_t l)
                                 HWY_ATTR { pm[k][l] = first[k][l] + beyond[k][l] + noise_; });
    multiply(pm, pm, wanted_order, square);
    for_powers(wanted_order, [&](std::size_t k, std::size_t l) HWY_ATTR {
        const number more = largest(square[k][l] - first_squared[k][l], same(0)) + noise_;
        w[k][l] = same(k + l == 0 ? 1 : 0) - more;
    });
    const auto small = same(0x1p-20).v;
    known_ = hn::And(known_, hn::And(hn::Gt(one_less_z[0][0].v, small), hn::Gt(w[0][0].v, small)));
    inverse_root(w, wanted_order, g);
    multiply(pm, g, wanted_order, most_);
}

/// Bounds |N . S_b| over parts, for the derivatives S_b of second and third order of points.
///
/// The product is a series. Its coefficients are exact, except for the part that comes from terms
/// of N beyond series_order. So signs are lost only when terms are added up. Terms of even powers
/// keep their signs.
class part_points {
public:
    HWY_ATTR part_points(const taylor_net<3>& s, const part_normals& n, double size)
        : s_(s), n_(n), noise_(same(size * point_noise)) {
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t l = 0; l < 4; ++l)
                sizes_[k][l] = root(squared(s.at[k][l]));
        rest_ = n.sum_of_sizes();
        for_powers(exact_order - 1,
                   [&](std::size_t k, std::size_t l) HWY_ATTR { rest_ = rest_ - n.size(k, l); });
        rest_ = largest(rest_, same(0));
    }

    HWY_NOINLINE HWY_ATTR number bound(std::size_t k, std::size_t l) const {
        number product[room][room];
        for (auto& column : product)
            for (number& c : column)
                c = same(0);
        number all = same(0);
        for (std::size_t i = 0; i + k < 4; ++i)
            for (std::size_t j = 0; j + l < 4; ++j) {
                const number times = same(taken_out(k, i) * taken_out(l, j));
                const vector d = s_.at[k + i][l + j] * times;
                all = all + sizes_[k + i][l + j] * times;
                for (std::size_t a = 0; a < exact_order; ++a)
                    for (std::size_t b = 0; a + b < exact_order; ++b)
                        product[i + a][j + b] = product[i + a][j + b] + dot(n_.at(a, b), d);
            }
        // The sum of the terms of even powers lies between `low` and `high`.
        number low = product[0][0], high = low, others = same(0);
        product[0][0] = same(0);
        for (std::size_t a = 0; a < room; ++a)
            for (std::size_t b = 0; b < room; ++b) {
                const number above = largest(product[a][b], same(0));
                const number below = product[a][b] - above;
                if ((a | b) % 2 == 0) {
                    high = high + above;
                    low = low + below;
                } else {
                    others = others + (above - below);
                }
            }
        return (largest(magnitude(low), magnitude(high)) + others + (rest_ + n_.noise()) * all +
                noise_) *
               same(static_cast<double>(std::size_t{1} << (k + l)) * relative);
    }

    HWY_ATTR HWY_INLINE number in_middle(std::size_t k, std::size_t l) const {
        return magnitude(dot(n_.at(0, 0), s_.at[k][l])) * same(as_derivative(k, l));
    }

    /// The bound of |S_uuvv| over the part. S_uuvv is bilinear, so it is longest in a corner.
    HWY_ATTR HWY_INLINE number bound_uuvv() const {
        const vector a = s_.at[2][2] * same(4), u = s_.at[3][2] * same(12);
        const vector v = s_.at[2][3] * same(12), uv = s_.at[3][3] * same(36);
        const number at_end = largest_size(a + u, v + uv, {same(0), same(0), same(0)});
        const number at_start = largest_size(a - u, v - uv, {same(0), same(0), same(0)});
        return (largest(at_end, at_start) + noise_) * same(16 * relative);
    }

private:
    /// The factor that k derivatives by a parameter bring to the parameter's power k + rest.
    static constexpr double taken_out(std::size_t k, std::size_t rest) {
        return factorial(k + rest) / factorial(rest);
    }

    /// The order below which products with coefficients of N keep their signs, and the number of
    /// powers in such a product. With order 4, the teapot has 0.2 % more quads. With order 7, it
    /// has 1 % fewer, and bounds take a third more instructions.
    static constexpr std::size_t exact_order = 5, room = exact_order + 3;

    const taylor_net<3>& s_;
    const part_normals& n_;
    number noise_, rest_, sizes_[4][4];
};

/// Computes all bounds of parts from their Taylor coefficients, and stores them in the result's
/// lanes from i on.
HWY_ATTR void take_bounds(const taylor_net<5>& normals, const taylor_net<3>& points, double size,
                          group_bounds& result, std::size_t i) {
    constexpr struct {
        bend_number number;
        std::size_t k, l;
    } turns[]{{turn_u, 1, 0},   {turn_v, 0, 1},   {turn_uu, 2, 0},
              {turn_uv, 1, 1},  {turn_vv, 0, 2},  {turn_uuu, 3, 0},
              {turn_uuv, 2, 1}, {turn_uvv, 1, 2}, {turn_vvv, 0, 3}},
        bends[]{{bend_uu, 2, 0},  {bend_uv, 1, 1},  {bend_vv, 0, 2}, {bend_uuu, 3, 0},
                {bend_uuv, 2, 1}, {bend_uvv, 1, 2}, {bend_vvv, 0, 3}};
    const part_normals n(normals);
    const part_points s(points, n, size);
    const auto put = [&](const auto& all, const auto& of) HWY_ATTR {
        for (const auto& [which, k, l] : all) {
            const auto bound = of.bound(k, l).v, infinite = same(HUGE_VAL).v;
            const auto known = hn::And(n.known(), hn::Lt(bound, infinite)); // and not a NaN
            store({hn::IfThenElse(known, bound, infinite)}, result.most[which] + i);
            store(of.in_middle(k, l), result.middle[which] + i);
        }
    };
    put(turns, n);
    put(bends, s);
    store(s.bound_uuvv(), result.most[bend_uuvv] + i);
    store(same(0), result.middle[bend_uuvv] + i);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
