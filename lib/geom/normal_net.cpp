// SPDX-License-Identifier: MIT
// l3d_normal_net: multiplies the derivative nets, and removes vanishing factors.
#include "geom/normal_net.h"

#include "geom/nurbs/bernstein_products_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

using l3d_detail::binomial;
using vector = l3d_normal_net::vector;

constexpr int degree = 5;
constexpr int order = degree + 1;

/// An edge row counts as vanishing if its coefficients are below this share of the largest
/// coefficient. The product sums 36 terms of double precision, so cancellation leaves at most some
/// 100 * 2^-53 = 1e-14.
constexpr double vanishing = 1e-12;

double largest(const vector& v) {
    return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

/// Bound on the rounding error of a cross product that is zero, as a share of its factors' sizes.
/// The weighted sum of 12 products has some 20 roundings of 2^-53 in a row; 64 leaves room for
/// more.
constexpr double rounding = 64 * 0x1p-53;

/// Divides a degree-5 Bernstein polynomial that vanishes at t = 0 by t, and raises the quartic
/// quotient back to degree 5. Uses t B4_j(t) = (j + 1)/5 B5_(j+1)(t).
std::array<vector, order> divided_by_t(const std::array<vector, order>& b) {
    std::array<vector, degree> quotient;
    for (std::size_t j = 0; j < degree; ++j)
        quotient[j] = b[j + 1] * (double(degree) / double(j + 1));
    std::array<vector, order> raised;
    for (std::size_t j = 0; j < order; ++j) {
        const double s = double(j) / degree;
        const vector low = j > 0 ? quotient[j - 1] : vector(0.0);
        const vector high = j < degree ? quotient[j] : vector(0.0);
        raised[j] = low * s + high * (1 - s);
    }
    return raised;
}

} // namespace

/// Halves the polynomial by de Casteljau's algorithm at the middle.
std::pair<l3d_normal_polynomial, l3d_normal_polynomial>
l3d_normal_polynomial::split(std::size_t along, std::size_t across) const {
    std::pair<l3d_normal_polynomial, l3d_normal_polynomial> halves{{}, *this};
    for (std::size_t line = 0; line < order; ++line) {
        vector* const low = &halves.first.points[line * across];
        vector* const high = &halves.second.points[line * across];
        for (std::size_t level = 0; level < order; ++level) {
            low[level * along] = high[0];
            for (std::size_t i = 0; i + 1 < order - level; ++i)
                high[i * along] = (high[i * along] + high[(i + 1) * along]) * 0.5;
        }
    }
    return halves;
}

l3d_normal_net::l3d_normal_net(const l3d_bezier_patch<double, 3>& patch) {
    double size = 0;
    for (const vector& p : patch.points)
        size = std::max(size, largest(p));
    // Control points carry rounding errors themselves: 2^-53 of `size`.
    std::array<double, 36> noise{};
    for (int ru = 0; ru < 4; ++ru)
        for (int cu = 0; cu < 3; ++cu) {
            const vector du = patch.at(ru, cu + 1) - patch.at(ru, cu);
            for (int rv = 0; rv < 3; ++rv)
                for (int cv = 0; cv < 4; ++cv) {
                    const vector dv = patch.at(rv + 1, cv) - patch.at(rv, cv);
                    const double weight = binomial(3, ru) * binomial(2, rv) /
                                          binomial(degree, ru + rv) * binomial(2, cu) *
                                          binomial(3, cv) / binomial(degree, cu + cv);
                    const std::size_t target = index(ru + rv, cu + cv);
                    net_.points[target] = net_.points[target] + l3d_cross(du, dv) * weight;
                    const double a = largest(du), b = largest(dv);
                    noise[target] += rounding * weight * (a * b + size * (a + b));
                }
        }
    bool is_noise = true;
    for (std::size_t i = 0; i < net_.points.size(); ++i)
        is_noise = is_noise && largest(net_.points[i]) <= noise[i];
    if (is_noise)
        net_ = {};
    finish();
}

l3d_normal_net::l3d_normal_net(const l3d_normal_polynomial& normals) : net_(normals) {
    finish();
}

void l3d_normal_net::finish() {
    scale_to_one();
    // A polynomial of degree 5 by 5 has at most 5 factors of each of u, 1 - u, v, 1 - v.
    for (int factors = 0; factors < 4 * degree && divide_by_vanishing_factor(); ++factors)
        scale_to_one();
    fill_floats();
}

void l3d_normal_net::fill_floats() {
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t r = 0; r < order; ++r)
            for (std::size_t c = 0; c < order; ++c)
                in_floats_[k][r][c] =
                    static_cast<float>(net_.points[order * r + c][static_cast<int>(k)]);
}

void l3d_normal_net::scale_to_one() {
    double most = 0;
    for (const vector& v : net_.points)
        most = std::max(most, largest(v));
    if (most > 0)
        for (vector& v : net_.points)
            v = v * (1 / most);
}

/// Divides the net by the factor of its first vanishing edge. False if no edge vanishes or the net
/// is zero.
bool l3d_normal_net::divide_by_vanishing_factor() {
    if (std::all_of(net_.points.begin(), net_.points.end(),
                    [](const vector& v) { return largest(v) == 0; }))
        return false;
    for (const bool along_u : {true, false})
        for (const bool at_end : {false, true}) {
            const auto coefficient = [&](int step, int line) -> vector& {
                const int inward = at_end ? degree - step : step;
                return net_.points[along_u ? index(line, inward) : index(inward, line)];
            };
            bool vanishes = true;
            for (int line = 0; line < order; ++line)
                vanishes = vanishes && largest(coefficient(0, line)) < vanishing;
            if (!vanishes)
                continue;
            for (int line = 0; line < order; ++line) {
                std::array<vector, order> b;
                for (int step = 0; step < order; ++step)
                    b[static_cast<std::size_t>(step)] = coefficient(step, line);
                b = divided_by_t(b);
                for (int step = 0; step < order; ++step)
                    coefficient(step, line) = b[static_cast<std::size_t>(step)];
            }
            return true;
        }
    return false;
}

l3d_normal_net::vector l3d_normal_net::evaluate(double u, double v) const {
    const auto collapse = [](std::array<vector, order> b, double t) {
        for (int level = degree; level > 0; --level)
            for (std::size_t i = 0; i < static_cast<std::size_t>(level); ++i)
                b[i] = b[i] + (b[i + 1] - b[i]) * t;
        return b[0];
    };
    std::array<vector, order> in_v;
    for (int r = 0; r < order; ++r) {
        std::array<vector, order> in_u;
        for (int c = 0; c < order; ++c)
            in_u[static_cast<std::size_t>(c)] = at(r, c);
        in_v[static_cast<std::size_t>(r)] = collapse(in_u, u);
    }
    return collapse(in_v, v);
}
