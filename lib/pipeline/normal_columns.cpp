// SPDX-License-Identifier: MIT
// l3d_normal_columns: Bernstein to power form per column, Horner's scheme per row.
#include "pipeline/normal_columns.h"

namespace {

constexpr std::array<double, 6> binomial_5{1, 5, 10, 10, 5, 1};

} // namespace

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
            powers_[i][k][c] = static_cast<float>(b[0][static_cast<int>(i)] * binomial_5[k]);
        for (std::size_t j = 0; j + k + 1 < 6; ++j)
            b[j] = b[j + 1] - b[j];
    }
}

void l3d_normal_columns::emit(double v, float* x, float* y, float* z) const {
    const auto t = static_cast<float>(v);
    const std::array<float*, 3> out{x, y, z};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& a = powers_[i];
        for (std::size_t c = 0; c < columns_; ++c)
            out[i][c] =
                ((((a[5][c] * t + a[4][c]) * t + a[3][c]) * t + a[2][c]) * t + a[1][c]) * t +
                a[0][c];
    }
}
