// SPDX-License-Identifier: MIT
// Polynomials of two parameters in Bernstein form, of any degree, and their products.
#ifndef L3D_GEOM_BERNSTEIN_PRODUCTS_P_H
#define L3D_GEOM_BERNSTEIN_PRODUCTS_P_H

#include "geom/files/patch_file.h"
#include "geom/normal_net.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace l3d_detail {

/// Bernstein coefficients of a polynomial of degree m along u and n along v.
template <class V> struct net {
    int m, n;
    std::vector<V> c; // u runs fastest

    net(int of_m, int of_n)
        : m(of_m), n(of_n), c(static_cast<std::size_t>((of_m + 1) * (of_n + 1)), V(0.0)) {}
    V& at(int row, int column) { return c[static_cast<std::size_t>(row * (m + 1) + column)]; }
    const V& at(int row, int column) const {
        return c[static_cast<std::size_t>(row * (m + 1) + column)];
    }

    net by_u() const {
        net result(m - 1, n);
        for (int r = 0; r <= n; ++r)
            for (int k = 0; k < m; ++k)
                result.at(r, k) = (at(r, k + 1) - at(r, k)) * double(m);
        return result;
    }
    net by_v() const {
        net result(m, n - 1);
        for (int r = 0; r < n; ++r)
            for (int k = 0; k <= m; ++k)
                result.at(r, k) = (at(r + 1, k) - at(r, k)) * double(n);
        return result;
    }
    /// The polynomial over the lower and over the upper half of u, or of v. Source: de Casteljau.
    std::array<net, 2> halves(bool along_u) const {
        std::array<net, 2> result{*this, *this};
        const int degree = along_u ? m : n, lines = along_u ? n : m;
        for (int line = 0; line <= lines; ++line) {
            const auto in = [&](net& half, int i) -> V& {
                return along_u ? half.at(line, i) : half.at(i, line);
            };
            for (int level = 0; level <= degree; ++level) {
                in(result[0], level) = in(result[1], 0);
                for (int i = 0; i < degree - level; ++i)
                    in(result[1], i) = (in(result[1], i) + in(result[1], i + 1)) * 0.5;
            }
        }
        return result;
    }
    /// The quotient by v of a polynomial that is 0 at v = 0. The division uses v B^(n-1)_j = (j +
    /// 1) / n B^n_(j+1).
    net over_v() const {
        net result(m, n - 1);
        for (int r = 0; r < n; ++r)
            for (int k = 0; k <= m; ++k)
                result.at(r, k) = at(r + 1, k) * (double(n) / (r + 1));
        return result;
    }
};

/// The largest degree of a product. A piece's normals have at most three times the piece's degree.
/// These normals are multiplied by the quintic that approximates them.
inline constexpr int most_product = 3 * l3d_bpt_largest_degree + l3d_normal_polynomial::order;
/// Binomial coefficients n over k, which are exact in a double.
inline constexpr auto binomials = [] {
    std::array<std::array<double, most_product + 1>, most_product + 1> result{};
    for (std::size_t n = 0; n <= most_product; ++n)
        for (std::size_t k = 0; k <= n; ++k)
            result[n][k] = k == 0 ? 1 : result[n - 1][k - 1] + result[n - 1][k];
    return result;
}();

inline double binomial(int n, int k) {
    return binomials[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

/// One coordinate of a polynomial: its Bernstein coefficients times binomials. In this form, the
/// coefficients of a product are plain sums of products. Source: Farouki and Rajan 1988, Algorithms
/// for polynomials in Bernstein form.
class scaled_net {
public:
    int m, n;

    /// The polynomial 0, of degree of_m along u and of_n along v.
    scaled_net(int of_m, int of_n)
        : m(of_m), n(of_n), c_(static_cast<std::size_t>((of_n + 1) * stride() + taps - 1)) {}
    /// One coordinate of a net's polynomial: of(coefficient) selects the coordinate.
    template <class V, class Coordinate>
    scaled_net(const net<V>& whole, const Coordinate& of) : scaled_net(whole.m, whole.n) {
        for (int r = 0; r <= n; ++r)
            for (int k = 0; k <= m; ++k)
                row(r)[k] = of(whole.at(r, k)) * (binomial(n, r) * binomial(m, k));
    }

    /// The Bernstein coefficient in row r (along v) and column k (along u), without binomials.
    double at(int r, int k) const { return row(r)[k] / (binomial(n, r) * binomial(m, k)); }

    /// The least Bernstein coefficient, a lower bound of all values by the convex hull.
    double least() const {
        double result = at(0, 0);
        for (int r = 0; r <= n; ++r)
            for (int k = 0; k <= m; ++k)
                result = std::min(result, at(r, k));
        return result;
    }

    /// Adds the product of a and b, multiplied by `times`. Expects: the degrees of a and b add up
    /// to those of this net.
    void add(const scaled_net& a, const scaled_net& b, double times = 1) {
        // b's rows lie as far apart as those of the product. So one loop multiplies a coefficient
        // of a, or four neighbours in a row of a, with all of b.
        const auto length = b.n * stride() + b.m + taps;
        std::vector<double> rows(static_cast<std::size_t>(taps - 1 + length));
        double* const first = rows.data() + (taps - 1);
        for (int r = 0; r <= b.n; ++r)
            std::copy_n(b.row(r), b.m + 1, first + r * stride());
        for (int r = 0; r <= a.n; ++r)
            for (int k = 0; k <= a.m; k += taps) {
                double by[taps]{};
                for (int i = 0; i < taps && k + i <= a.m; ++i)
                    by[i] = times * a.row(r)[k + i];
                double* const to = row(r) + k;
                for (int j = 0; j < length; ++j)
                    to[j] += (by[0] * first[j] + by[1] * first[j - 1]) +
                             (by[2] * first[j - 2] + by[3] * first[j - 3]);
            }
    }

private:
    static constexpr int taps = 4;

    std::vector<double> c_; // rows, and zeros behind the last one

    int stride() const { return m + 1; }
    double* row(int r) { return c_.data() + r * stride(); }
    const double* row(int r) const { return c_.data() + r * stride(); }
};

using scaled_vectors = std::array<scaled_net, 3>;

inline scaled_net scaled(const net<double>& of) {
    return {of, [](double value) { return value; }};
}

template <class V> scaled_vectors scaled(const net<V>& of) {
    return {scaled_net(of, [](const V& v) { return v[0]; }),
            scaled_net(of, [](const V& v) { return v[1]; }),
            scaled_net(of, [](const V& v) { return v[2]; })};
}

inline scaled_vectors zeros(int m, int n) {
    return {scaled_net(m, n), scaled_net(m, n), scaled_net(m, n)};
}

/// The constant polynomial 1, written with these degrees.
inline scaled_net one(int m, int n) {
    net<double> result(m, n);
    std::ranges::fill(result.c, 1.0);
    return scaled(result);
}

inline scaled_vectors cross(const scaled_vectors& a, const scaled_vectors& b) {
    scaled_vectors result = zeros(a[0].m + b[0].m, a[0].n + b[0].n);
    for (std::size_t k = 0; k < 3; ++k) {
        result[k].add(a[(k + 1) % 3], b[(k + 2) % 3]);
        result[k].add(a[(k + 2) % 3], b[(k + 1) % 3], -1);
    }
    return result;
}

/// Adds the product of a and b, multiplied by `times`.
inline void add(scaled_vectors& to, const scaled_net& a, const scaled_vectors& b,
                double times = 1) {
    for (std::size_t k = 0; k < 3; ++k)
        to[k].add(a, b[k], times);
}

inline net<l3d_vector<double, 3>> net_of(const scaled_vectors& of) {
    net<l3d_vector<double, 3>> result(of[0].m, of[0].n);
    for (int r = 0; r <= result.n; ++r)
        for (int k = 0; k <= result.m; ++k)
            result.at(r, k) = {of[0].at(r, k), of[1].at(r, k), of[2].at(r, k)};
    return result;
}

} // namespace l3d_detail

#endif
