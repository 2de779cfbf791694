// SPDX-License-Identifier: MIT
// l3d_normal_columns: converts Bernstein to power form for each column, and uses Horner's scheme
// for each row.
#include "dice/normal_columns.h"

#include <cmath>

namespace {

constexpr std::array<double, 6> binomial_5{1, 5, 10, 10, 5, 1};

/// A normal of at most this length may be rounding alone. The largest Bernstein coefficient is 1,
/// exact to 64 * 2^-53 (l3d_normal_net), and power coefficients are at most C(5, 3) 2^3 = 80. With
/// some 20 roundings in a row the error is 2^-53 (64 + 20 * 80), below 2^-42.
constexpr double rounding = 0x1p-42;

} // namespace

std::array<float, 3> l3d_unit_normal(const l3d_normal_net::vector& normal) {
    const double length = std::sqrt(l3d_dot(normal, normal));
    if (!(length > rounding))
        return {0, 0, 0};
    return {static_cast<float>(normal[0] / length), static_cast<float>(normal[1] / length),
            static_cast<float>(normal[2] / length)};
}

void l3d_normal_columns::resize(std::size_t columns) {
    columns_ = columns;
    for (auto& component : powers_)
        for (auto& power : component)
            if (power.size() < columns)
                power.resize(columns);
}

void l3d_normal_columns::set(std::size_t c, const l3d_normal_net& net, double u) {
    std::array<double, 6> weight;
    for (std::size_t i = 0; i < 6; ++i) {
        weight[i] = binomial_5[i];
        for (std::size_t k = 0; k < 5; ++k)
            weight[i] *= k < i ? u : 1 - u;
    }
    std::array<l3d_normal_net::vector, 6> b;
    for (int r = 0; r < 6; ++r) {
        b[static_cast<std::size_t>(r)] = net.at(r, 0) * weight[0];
        for (int i = 1; i < 6; ++i)
            b[static_cast<std::size_t>(r)] += net.at(r, i) * weight[static_cast<std::size_t>(i)];
    }
    // The k-th power coefficient is C(5, k) times the k-th difference of b at 0.
    for (std::size_t k = 0; k < 6; ++k) {
        for (std::size_t i = 0; i < 3; ++i)
            powers_[i][k][c] = b[0][static_cast<int>(i)] * binomial_5[k];
        for (std::size_t j = 0; j + k + 1 < 6; ++j)
            b[j] = b[j + 1] - b[j];
    }
}

void l3d_normal_columns::emit(double v, float* x, float* y, float* z) const {
    for (std::size_t c = 0; c < columns_; ++c) {
        l3d_normal_net::vector normal;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& a = powers_[i];
            normal[static_cast<int>(i)] =
                ((((a[5][c] * v + a[4][c]) * v + a[3][c]) * v + a[2][c]) * v + a[1][c]) * v +
                a[0][c];
        }
        const std::array<float, 3> unit = l3d_unit_normal(normal);
        x[c] = unit[0];
        y[c] = unit[1];
        z[c] = unit[2];
    }
}
