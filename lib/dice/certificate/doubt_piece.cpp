// SPDX-License-Identifier: MIT
// l3d_doubt_piece: halves by de Casteljau's scheme.
#include "dice/certificate/doubt_piece.h"

#include <algorithm>
#include <cmath>
#include <tuple>

std::pair<l3d_doubt_piece, l3d_doubt_piece> l3d_doubt_piece::split(bool along_u) const {
    std::pair<l3d_doubt_piece, l3d_doubt_piece> halves;
    auto& [low, high] = halves;
    low.of = high.of = of;
    low.u0 = high.u0 = u0, low.u1 = high.u1 = u1, low.v0 = high.v0 = v0, low.v1 = high.v1 = v1;
    std::tie(low.net, high.net) = along_u ? net.split_u() : net.split_v();
    (along_u ? low.u1 : low.v1) = along_u ? (u0 + u1) / 2 : (v0 + v1) / 2;
    (along_u ? high.u0 : high.v0) = along_u ? (u0 + u1) / 2 : (v0 + v1) / 2;
    const std::size_t step = along_u ? 1 : order, across = along_u ? order : 1;
    for (std::size_t line = 0; line < order; ++line) {
        std::array<vector, order> b;
        for (std::size_t i = 0; i < order; ++i)
            b[i] = normals[line * across + i * step];
        for (std::size_t left = order; left > 0; --left) {
            low.normals[line * across + (order - left) * step] = b[0];
            high.normals[line * across + (left - 1) * step] = b[left - 1];
            for (std::size_t i = 0; i + 1 < left; ++i)
                b[i] = (b[i] + b[i + 1]) * 0.5;
        }
    }
    return halves;
}

bool l3d_doubt_piece::is_longer_along_u() const {
    double in_u = 0, in_v = 0;
    for (int line = 0; line < 4; ++line)
        for (int i = 0; i < 3; ++i) {
            const auto length = [](const l3d_image_point& a, const l3d_image_point& b) {
                return std::max(std::abs(a[0] / a[2] - b[0] / b[2]),
                                std::abs(a[1] / a[2] - b[1] / b[2]));
            };
            in_u = std::max(in_u, length(net.at(line, i), net.at(line, i + 1)));
            in_v = std::max(in_v, length(net.at(i, line), net.at(i + 1, line)));
        }
    return in_u >= in_v;
}
