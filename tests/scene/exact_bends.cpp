// SPDX-License-Identifier: MIT
// Exact bends: polynomials' derivatives by weights, those of the unit normal by Leibniz' rule.
#include "exact_bends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace dice_tests {
namespace {

using real = long double;

struct vec {
    real x = 0, y = 0, z = 0;

    friend vec operator+(vec a, vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend vec operator*(vec a, real s) { return {a.x * s, a.y * s, a.z * s}; }
};
real dot(vec a, vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
real size(vec a) {
    return std::sqrt(dot(a, a));
}

/// Derivatives of one function: [by u][by v].
template <class T> using derivatives = std::array<std::array<T, 4>, 4>;

constexpr real choose[4][4]{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};

/// De Casteljau's scheme on the hodograph of this order, by a parameter four times as fast.
template <std::size_t Order> std::array<real, Order> weights(std::size_t derivative, real t) {
    std::array<real, Order> result{};
    for (std::size_t from = 0; from < Order; ++from) {
        std::array<real, Order> p{};
        p[from] = 1;
        std::size_t left = Order;
        for (std::size_t k = 0; k < derivative; ++k, --left)
            for (std::size_t i = 0; i + 1 < left; ++i)
                p[i] = (p[i + 1] - p[i]) * static_cast<real>(left - 1) / 4;
        for (; left > 1; --left)
            for (std::size_t i = 0; i + 1 < left; ++i)
                p[i] = (1 - t) * p[i] + t * p[i + 1];
        result[from] = p[0];
    }
    return result;
}

/// Both nets, and their derivatives at points of a lattice.
template <std::size_t Order> struct surface {
    std::array<vec, Order * Order> net;

    using at_t = std::array<std::array<real, Order>, 4>;
    static at_t weights_at(real t) {
        at_t result;
        for (std::size_t k = 0; k < 4; ++k)
            result[k] = weights<Order>(k, t);
        return result;
    }

    /// For one v: the curves of the derivatives by v.
    std::array<std::array<vec, Order>, 4> row(const at_t& v) const {
        std::array<std::array<vec, Order>, 4> result{};
        for (std::size_t l = 0; l < 4; ++l)
            for (std::size_t r = 0; r < Order; ++r)
                for (std::size_t c = 0; c < Order; ++c)
                    result[l][c] = result[l][c] + net[Order * r + c] * v[l][r];
        return result;
    }

    static derivatives<vec> at(const std::array<std::array<vec, Order>, 4>& row, const at_t& u) {
        derivatives<vec> result{};
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t l = 0; l < 4; ++l)
                for (std::size_t c = 0; c < Order; ++c)
                    result[k][l] = result[k][l] + row[l][c] * u[k][c];
        return result;
    }
};

derivatives<vec> of_unit_normal(const derivatives<vec>& m) {
    derivatives<vec> n{};
    derivatives<real> r{};
    for (std::size_t order = 0; order < 4; ++order)
        for (std::size_t k = 0; k <= order; ++k) {
            const std::size_t l = order - k;
            real square = 0; // of M . M, less what r has of lower order
            vec rest = m[k][l];
            for (std::size_t a = 0; a <= k; ++a)
                for (std::size_t b = 0; b <= l; ++b) {
                    const real times = choose[k][a] * choose[l][b];
                    square += times * dot(m[a][b], m[k - a][l - b]);
                    if (a + b > 0 && a + b < order)
                        square -= times * r[a][b] * r[k - a][l - b];
                }
            r[k][l] = order == 0 ? std::sqrt(square) : square / (2 * r[0][0]);
            for (std::size_t a = 0; a <= k; ++a)
                for (std::size_t b = 0; b <= l; ++b)
                    if (a + b > 0)
                        rest = rest + n[k - a][l - b] * (-choose[k][a] * choose[l][b] * r[a][b]);
            n[k][l] = rest * (1 / r[0][0]);
        }
    return n;
}

bend_numbers of_point(const derivatives<vec>& s, const derivatives<vec>& m) {
    bend_numbers result{};
    result.uuvv = static_cast<double>(size(s[2][2]));
    if (size(m[0][0]) == 0)
        return result;
    const derivatives<vec> n = of_unit_normal(m);
    const auto along = [&](std::size_t k, std::size_t l) {
        return static_cast<double>(std::abs(dot(n[0][0], s[k][l])));
    };
    const auto turn = [&](std::size_t k, std::size_t l) {
        return static_cast<double>(size(n[k][l]));
    };
    return {along(2, 0), along(1, 1), along(0, 2), along(3, 0), along(2, 1), along(1, 2),
            along(0, 3), result.uuvv, turn(1, 0),  turn(0, 1),  turn(2, 0),  turn(1, 1),
            turn(0, 2),  turn(3, 0),  turn(2, 1),  turn(1, 2),  turn(0, 3)};
}

template <class T> bend_numbers numbers(const l3d_bend_numbers<T>& of, const auto& get) {
    return {get(of.uu),   get(of.uv),    get(of.vv),     get(of.uuu),    get(of.uuv),  get(of.uvv),
            get(of.vvv),  get(of.uuvv),  get(of.turn_u), get(of.turn_v), get(of.n_uu), get(of.n_uv),
            get(of.n_vv), get(of.n_uuu), get(of.n_uuv),  get(of.n_uvv),  get(of.n_vvv)};
}

} // namespace

const std::array<named_bend, 17> all_bends{{
    {"uu", 2, &bend_numbers::uu},
    {"uv", 2, &bend_numbers::uv},
    {"vv", 2, &bend_numbers::vv},
    {"uuu", 3, &bend_numbers::uuu},
    {"uuv", 3, &bend_numbers::uuv},
    {"uvv", 3, &bend_numbers::uvv},
    {"vvv", 3, &bend_numbers::vvv},
    {"uuvv", 4, &bend_numbers::uuvv},
    {"turn_u", 1, &bend_numbers::turn_u},
    {"turn_v", 1, &bend_numbers::turn_v},
    {"n_uu", 2, &bend_numbers::n_uu},
    {"n_uv", 2, &bend_numbers::n_uv},
    {"n_vv", 2, &bend_numbers::n_vv},
    {"n_uuu", 3, &bend_numbers::n_uuu},
    {"n_uuv", 3, &bend_numbers::n_uuv},
    {"n_uvv", 3, &bend_numbers::n_uvv},
    {"n_vvv", 3, &bend_numbers::n_vvv},
}};

bend_numbers bends_of_block(const l3d_surface_bends& bends, std::size_t block) {
    return numbers(bends.of_blocks(), [&](const auto& of) { return double{of[block]}; });
}

bend_numbers bends_of_whole(const l3d_surface_bends& bends) {
    return numbers(bends.of_whole(), [&](float of) { return double{of}; });
}

exact_bends::exact_bends(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals,
                         int points)
    : of_blocks{}, of_whole{} {
    surface<4> s;
    surface<6> m;
    for (std::size_t i = 0; i < s.net.size(); ++i)
        s.net[i] = {patch.points[i][0], patch.points[i][1], patch.points[i][2]};
    for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c)
            m.net[l3d_normal_net::index(r, c)] = {normals.at(r, c)[0], normals.at(r, c)[1],
                                                  normals.at(r, c)[2]};
    const auto parameter = [&](std::size_t block, int i) {
        return (static_cast<real>(block) + static_cast<real>(i) / (points - 1)) / 4;
    };
    for (std::size_t block_v = 0; block_v < 4; ++block_v)
        for (int j = 0; j < points; ++j) {
            const real v = parameter(block_v, j);
            const auto s_row = s.row(surface<4>::weights_at(v));
            const auto m_row = m.row(surface<6>::weights_at(v));
            for (std::size_t block_u = 0; block_u < 4; ++block_u)
                for (int i = 0; i < points; ++i) {
                    const real u = parameter(block_u, i);
                    const bend_numbers here =
                        of_point(surface<4>::at(s_row, surface<4>::weights_at(u)),
                                 surface<6>::at(m_row, surface<6>::weights_at(u)));
                    bend_numbers& most = of_blocks[4 * block_v + block_u];
                    for (const named_bend& b : all_bends)
                        most.*b.of = std::max(most.*b.of, here.*b.of);
                }
        }
    for (const named_bend& b : all_bends) {
        for (const bend_numbers& of : of_blocks)
            of_whole.*b.of = std::max(of_whole.*b.of, of.*b.of);
        of_whole.*b.of = std::ldexp(of_whole.*b.of, 2 * b.order);
    }
}

} // namespace dice_tests
