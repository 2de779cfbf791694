// SPDX-License-Identifier: MIT
// Sizes of all derivatives over the parts of a patch, from coefficients: coarse, but cheap.
#if defined(L3D_DICE_BEND_SIZES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_DICE_BEND_SIZES_INL_H
#undef L3D_DICE_BEND_SIZES_INL_H
#else
#define L3D_DICE_BEND_SIZES_INL_H
#endif

#include "dice/bend_weights_p.h"
#include "dice/lane_doubles-inl.h"
#include "dice/surface_bends_p.h"

#include <cmath>
#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// A net's columns of parts: [component][row of the net][column of the part][part].
template <int Degree> struct part_columns {
    alignas(64) double at[3][Degree + 1][Degree + 1][bend_parts];

    /// Shape: net[component][row][column].
    HWY_ATTR explicit part_columns(const double (&net)[3][Degree + 1][Degree + 1]) {
        constexpr auto& weights = weights_of_bends<Degree>.parts;
        for (std::size_t i = 0; i < bend_parts; i += lanes_at_once())
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t row = 0; row <= Degree; ++row)
                    for (std::size_t to = 0; to <= Degree; ++to) {
                        number sum = same(net[c][row][0]) * loaded(weights[to][0] + i);
                        for (std::size_t from = 1; from <= Degree; ++from)
                            sum = sum + same(net[c][row][from]) * loaded(weights[to][from] + i);
                        store(sum, at[c][row][to] + i);
                    }
    }
};

/// The nets of parts i on of a row of parts.
template <int Degree> struct part_net {
    vector at[Degree + 1][Degree + 1]; ///< [row][column]

    HWY_ATTR part_net(const part_columns<Degree>& of, std::size_t part, std::size_t i) {
        constexpr auto& weights = weights_of_bends<Degree>.parts;
        for (std::size_t column = 0; column <= Degree; ++column)
            for (std::size_t to = 0; to <= Degree; ++to) {
                vector sum{same(0), same(0), same(0)};
                for (std::size_t from = 0; from <= Degree; ++from)
                    sum = sum + vector{loaded(of.at[0][from][column] + i),
                                       loaded(of.at[1][from][column] + i),
                                       loaded(of.at[2][from][column] + i)} *
                                    same(weights[to][from][part]);
                at[to][column] = sum;
            }
    }

    /// The coefficients of the derivative by u or v, but for the factor of the degree; `rows` and
    /// `columns` are those that there are.
    HWY_ATTR HWY_INLINE void difference(bool along_u, std::size_t rows, std::size_t columns) {
        for (std::size_t r = 0; r + !along_u < rows; ++r)
            for (std::size_t c = 0; c + along_u < columns; ++c)
                at[r][c] = at[r + !along_u][c + along_u] - at[r][c];
    }
};

/// Calls see(k, l, net, factor) with each derivative of orders k by u and l by v, k + l <= most,
/// whose coefficients are factor times those of the net, in its first rows and columns.
template <int Degree, class See>
HWY_ATTR HWY_INLINE void for_each_derivative(part_net<Degree> net, std::size_t most,
                                             const See& see) {
    for (std::size_t k = 0; k <= Degree && k <= most; ++k) {
        part_net<Degree> of = net;
        for (std::size_t l = 0; l <= Degree && k + l <= most; ++l) {
            see(k, l, of,
                falling(Degree, static_cast<int>(k)) * falling(Degree, static_cast<int>(l)));
            of.difference(false, Degree + 1 - l, Degree + 1 - k);
        }
        net.difference(true, Degree + 1, Degree + 1 - k);
    }
}

/// How far a difference of order k may be off for coefficients that are off by 1.
constexpr double amplified(std::size_t k, std::size_t l) {
    return static_cast<double>(std::size_t{1} << (k + l));
}

/// Coefficients of normals are at most 1 and made by two weighted means of six: 14 roundings of
/// 2^-53 in each component, the frame's own 6, 5 of differences; 1.74 times that in all.
constexpr double normal_noise = 64 * 0x1p-53;

/// Normals shorter than this part of the patch's longest have no direction: what noise makes of
/// them, normal_noise over this, is then less than 2^-10.
constexpr double no_length = 0x1p-36;

/// The same of points from the first one, whose difference is rounded: 1 and twice 5 roundings, 3
/// of differences; 1.74 times that in all, in units of the largest number.
constexpr double point_noise = 32 * 0x1p-53;

/// More than the relative rounding of what is summed up here, all of it positive: some 200
/// operations of 2^-53.
constexpr double relative = 1 + 0x1p-44;

constexpr double choose(std::size_t n, std::size_t k) {
    return k == 0 ? 1 : choose(n - 1, k - 1) * static_cast<double>(n) / static_cast<double>(k);
}

/// Upper bounds of the sizes of a part's normals and of their derivatives: [by u][by v].
///
/// In the part's frame M = (xy, z), and N = (q, 1) s with q = xy / z and s = (1 + t)^(-1/2), t =
/// q . q. From z q = xy, (1 + t) s' = - s t' / 2 and the products' derivatives, sizes follow from
/// sizes. q and the derivatives of z are small about the middle; that is why so little is lost.
class normal_sizes {
public:
    static constexpr std::size_t orders = 6;
    using table = number[orders][orders];

    HWY_ATTR normal_sizes(const part_columns<5>& columns, std::size_t part, std::size_t i,
                          const vector& axis);

    HWY_ATTR HWY_INLINE number at(std::size_t k, std::size_t l) const { return n_[k][l]; }

    /// The largest slope of N in the frame: N . d is at most |d . axis| + slope |d|.
    HWY_ATTR HWY_INLINE number slope() const { return q_[0][0]; }

    /// Whether there is a normal: also false where the axis, hence the length, is none.
    HWY_ATTR HWY_INLINE auto known() const {
        return hn::And(hn::Gt(length_.v, same(no_length).v), hn::Lt(length_.v, same(2).v));
    }

    /// What rounding may add to the direction of N on the lattice: coefficients' own, over the
    /// length, and four operations' more.
    HWY_ATTR HWY_INLINE number noise() const {
        return same(normal_noise) / length_ + same(0x1p-50);
    }

    /// Makes exact values on the lattice into bounds, and takes them for sizes where less.
    HWY_ATTR void add_what_lies_between(number (&bound)[bend_numbers]);

private:
    HWY_ATTR static void frame(const vector& z, vector& x, vector& y);
    HWY_ATTR void measure(const part_net<5>& net, table& z);
    HWY_ATTR void divide(const table& z);
    HWY_ATTR void normalize();

    table q_, n_;
    number length_, slack_[4];
};

/// Two unit vectors at right angles to z and to each other.
/// Source: Duff and others, Building an orthonormal basis, revisited, JCGT 6(1), 2017.
HWY_ATTR void normal_sizes::frame(const vector& z, vector& x, vector& y) {
    const number sign{hn::CopySign(same(1).v, z.z.v)};
    const number a = same(-1) / (sign + z.z), b = z.x * z.y * a;
    x = {same(1) + sign * z.x * z.x * a, sign * b, {hn::Neg((sign * z.x).v)}};
    y = {b, sign + z.y * z.y * a, {hn::Neg(z.y.v)}};
}

HWY_ATTR normal_sizes::normal_sizes(const part_columns<5>& columns, std::size_t part, std::size_t i,
                                    const vector& axis) {
    part_net<5> net(columns, part, i);
    vector x, y;
    frame(axis, x, y);
    for (auto& row : net.at)
        for (vector& m : row)
            m = {dot(m, x), dot(m, y), dot(m, axis)};
    table z;
    measure(net, z);
    divide(z);
    normalize();
}

/// Into q_ for now, what lies in the plane.
HWY_ATTR void normal_sizes::measure(const part_net<5>& net, table& z) {
    length_ = net.at[0][0].z;
    for (const auto& row : net.at)
        for (const vector& m : row)
            length_ = least(length_, m.z);
    length_ = length_ - same(normal_noise);
    for_each_derivative<5>(
        net, 5, [&](std::size_t k, std::size_t l, const part_net<5>& of, double factor) HWY_ATTR {
            number plane = same(0), height = plane;
            for (std::size_t row = 0; row + l < orders; ++row)
                for (std::size_t column = 0; column + k < orders; ++column) {
                    const vector& m = of.at[row][column];
                    plane = largest(plane, m.x * m.x + m.y * m.y);
                    height = largest(height, magnitude(m.z));
                }
            const number noise = same(normal_noise * amplified(k, l) * factor);
            q_[k][l] = root(plane) * same(factor) + noise;
            z[k][l] = height * same(factor) + noise;
        });
    number most = same(0);
    for (std::size_t order = 1; order < 4; ++order)
        for (std::size_t k = 0; k <= order; ++k)
            most = largest(most, q_[k][order - k] + z[k][order - k]);
    // See docs/NUMERICS.md: noise times 2^12 times the power of derivatives' relative size.
    const number base = same(1) + most / length_;
    slack_[0] = same(0x1p12) * noise();
    for (std::size_t order = 1; order < 4; ++order)
        slack_[order] = slack_[order - 1] * base;
}

HWY_ATTR void normal_sizes::divide(const table& z) {
    const number inverse = same(relative) / length_;
    for (std::size_t order = 0; order < orders; ++order)
        for (std::size_t k = 0; k <= order; ++k) {
            const std::size_t l = order - k;
            number sum = q_[k][l];
            for (std::size_t a = 0; a <= k; ++a)
                for (std::size_t b = 0; b <= l; ++b)
                    if (a + b > 0)
                        sum = sum + same(choose(k, a) * choose(l, b)) * z[a][b] * q_[k - a][l - b];
            q_[k][l] = sum * inverse;
        }
}

HWY_ATTR void normal_sizes::normalize() {
    table t, s;
    for (std::size_t order = 0; order < orders; ++order)
        for (std::size_t k = 0; k <= order; ++k) {
            const std::size_t l = order - k;
            number sum = same(0);
            for (std::size_t a = 0; a <= k; ++a)
                for (std::size_t b = 0; b <= l; ++b)
                    sum = sum + same(choose(k, a) * choose(l, b)) * q_[a][b] * q_[k - a][l - b];
            t[k][l] = sum;
            // Of s, one derivative is that of the equation, and there are these more.
            const std::size_t u = k > 0, v = k > 0 ? 0 : l > 0, ku = k - u, lv = l - v;
            number of_t = same(0), of_s = same(0);
            for (std::size_t a = 0; a <= ku && order > 0; ++a)
                for (std::size_t b = 0; b <= lv; ++b) {
                    const number times = same(choose(ku, a) * choose(lv, b));
                    of_t = of_t + times * t[a + u][b + v] * s[ku - a][lv - b];
                    if (a + b > 0)
                        of_s = of_s + times * t[a][b] * s[ku - a + u][lv - b + v];
                }
            s[k][l] = order == 0 ? same(1) : of_t * same(0.5) + of_s;
            number plane = same(0);
            for (std::size_t a = 0; a <= k; ++a)
                for (std::size_t b = 0; b <= l; ++b)
                    plane = plane + same(choose(k, a) * choose(l, b)) * q_[a][b] * s[k - a][l - b];
            n_[k][l] = root(plane * plane + s[k][l] * s[k][l]) * same(relative);
        }
}

HWY_ATTR void normal_sizes::add_what_lies_between(number (&bound)[bend_numbers]) {
    constexpr struct {
        bend_number number;
        std::size_t k, l;
    } all[]{{turn_uuu, 3, 0}, {turn_uuv, 2, 1}, {turn_uvv, 1, 2}, {turn_vvv, 0, 3}, {turn_uu, 2, 0},
            {turn_uv, 1, 1},  {turn_vv, 0, 2},  {turn_u, 1, 0},   {turn_v, 0, 1}};
    for (const auto& [which, k, l] : all) {
        number& n = n_[k][l];
        n = least(n, bound[which] + (n_[k + 2][l] + n_[k][l + 2]) * same(1.0 / 32) + slack_[k + l]);
        bound[which] = n;
    }
}

/// The same of points' derivatives of second order and more: sizes, and heights along the axis.
class point_sizes {
public:
    HWY_ATTR point_sizes(const part_columns<3>& columns, std::size_t part, std::size_t i,
                         const vector& axis, double size) {
        const part_net<3> net(columns, part, i);
        noise_ = size * point_noise;
        for (auto& row : size_)
            for (number& s : row)
                s = same(0);
        for (auto& row : height_)
            for (number& h : row)
                h = same(0);
        for_each_derivative<3>(
            net, 6,
            [&](std::size_t k, std::size_t l, const part_net<3>& of, double factor) HWY_ATTR {
                if (k + l < 2)
                    return;
                number squared = same(0), height = squared;
                for (std::size_t row = 0; row + l < 4; ++row)
                    for (std::size_t column = 0; column + k < 4; ++column) {
                        const vector& p = of.at[row][column];
                        squared = largest(squared, dot(p, p));
                        height = largest(height, magnitude(dot(p, axis)));
                    }
                const number noise = same(noise_ * amplified(k, l) * factor);
                size_[k][l] = (root(squared) * same(factor) + noise) * same(relative);
                height_[k][l] = height * same(factor) + noise;
            });
    }

    /// Of N . S_b for a derivative b, the second ones by u are at most those of products; n is
    /// done.
    HWY_ATTR void add_what_lies_between(const normal_sizes& n,
                                        number (&bound)[bend_numbers]) const {
        constexpr struct {
            bend_number number;
            std::size_t k, l;
        } all[]{{bend_uu, 2, 0},  {bend_uv, 1, 1},  {bend_vv, 0, 2}, {bend_uuu, 3, 0},
                {bend_uuv, 2, 1}, {bend_uvv, 1, 2}, {bend_vvv, 0, 3}};
        for (const auto& [which, k, l] : all) {
            const number size = size_[k][l];
            const number by_u = n.at(2, 0) * size + same(2) * n.at(1, 0) * size_[k + 1][l] +
                                along_normal(n, k + 2, l);
            const number by_v = n.at(0, 2) * size + same(2) * n.at(0, 1) * size_[k][l + 1] +
                                along_normal(n, k, l + 2);
            const number fine = bound[which] + (by_u + by_v) * same(1.0 / 32) +
                                n.noise() * size * same(4) + same(noise_);
            bound[which] = least(fine, along_normal(n, k, l)) * same(relative);
        }
        bound[bend_uuvv] = size_[2][2];
    }

private:
    HWY_ATTR HWY_INLINE number along_normal(const normal_sizes& n, std::size_t k,
                                            std::size_t l) const {
        return height_[k][l] + n.slope() * size_[k][l];
    }

    number size_[6][6], height_[6][6];
    double noise_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
