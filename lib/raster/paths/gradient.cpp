// SPDX-License-Identifier: MIT
// l3d_gradient: places and colours; l3d_mesh_patch: inner points.
#include "raster/paths/gradient.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

l3d_gradient l3d_gradient::linear(l3d_point_2d from, l3d_point_2d to,
                                  std::span<const l3d_color_stop> stops) {
    const double dx = to.x - from.x, dy = to.y - from.y, length = dx * dx + dy * dy;
    assert(!stops.empty() && length > 0);
    l3d_gradient result;
    result.begin_ = from;
    result.across_ = dx / length;
    result.down_ = dy / length;
    result.stops_.assign(stops.begin(), stops.end());
    return result;
}

l3d_gradient l3d_gradient::radial(l3d_point_2d center, double radius,
                                  std::span<const l3d_color_stop> stops) {
    assert(!stops.empty() && radius > 0);
    l3d_gradient result;
    result.radial_ = true;
    result.begin_ = center;
    result.across_ = result.down_ = 1 / radius;
    result.stops_.assign(stops.begin(), stops.end());
    return result;
}

void l3d_gradient::colors(int x, int y, std::span<std::uint32_t> result) const {
    const double down = (y - begin_.y) * down_;
    double column = x - begin_.x;
    for (std::uint32_t& color : result) {
        const double across = column++ * across_;
        color = color_at(radial_ ? std::sqrt(across * across + down * down) : across + down);
    }
}

std::uint32_t l3d_gradient::color_at(double place) const {
    const auto after = std::ranges::upper_bound(stops_, place, {}, &l3d_color_stop::at);
    if (after == stops_.begin())
        return stops_.front().color & 0x00ffffff;
    const l3d_color_stop& from = *std::prev(after);
    if (after == stops_.end())
        return from.color & 0x00ffffff;
    const double share = (place - from.at) / (after->at - from.at);
    std::uint32_t result = 0;
    for (const int shift : {0, 8, 16}) {
        const double a = from.color >> shift & 255, b = after->color >> shift & 255;
        result |= static_cast<std::uint32_t>(a + (b - a) * share + 0.5) << shift;
    }
    return result;
}

l3d_mesh_patch l3d_mesh_patch::coons(const std::array<l3d_point_2d, 12>& around,
                                     const std::array<std::uint32_t, 4>& colors) {
    l3d_mesh_patch result;
    result.colors = colors;
    auto& p = result.points;
    for (std::size_t i = 0; i < 3; ++i) {
        p[0][i] = around[i];
        p[i][3] = around[3 + i];
        p[3][3 - i] = around[6 + i];
        p[3 - i][0] = around[9 + i];
    }
    // An inner point by the corner next to it: a, the neighbours of a on the borders, the corners
    // beside a, what is opposite of the neighbours, the corner opposite of a.
    const auto inner = [&p](std::size_t row, std::size_t column) {
        const std::size_t r = row == 1 ? 0 : 3, c = column == 1 ? 0 : 3;
        const std::size_t far_r = 3 - r, far_c = 3 - c;
        const auto sum = [&](double l3d_point_2d::*k) {
            return (-4 * p[r][c].*k + 6 * (p[r][column].*k + p[row][c].*k) -
                    2 * (p[r][far_c].*k + p[far_r][c].*k) +
                    3 * (p[far_r][column].*k + p[row][far_c].*k) - p[far_r][far_c].*k) /
                   9;
        };
        return l3d_point_2d{sum(&l3d_point_2d::x), sum(&l3d_point_2d::y)};
    };
    for (std::size_t row = 1; row < 3; ++row)
        for (std::size_t column = 1; column < 3; ++column)
            p[row][column] = inner(row, column);
    return result;
}
