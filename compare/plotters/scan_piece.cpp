// SPDX-License-Identifier: MIT
// l3d_scan_piece: solves for a pixel by Newton's iteration in two variables.
#include "compare/plotters/scan_piece.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

using cubic = std::array<l3d_image_point, 4>;

cubic powers_of(const l3d_image_point& a, const l3d_image_point& b, const l3d_image_point& c,
                const l3d_image_point& d) {
    const l3d_image_point d1 = b - a, d2 = (c - b) - d1;
    return {a, d1 * 3.0, d2 * 3.0, ((d - c) - (c - b)) - d2};
}

/// The distance outside of the piece within which a root still counts. Its neighbour may miss the
/// root by rounding.
constexpr double rim = 1e-9;

/// A difference of the net as seen from the box's middle, and the most by which it differs as seen
/// from other places of the box.
struct direction {
    double x, y, blur;
};

} // namespace

l3d_scan_piece::l3d_scan_piece(const l3d_image_patch& net) {
    std::array<cubic, 4> rows;
    for (int r = 0; r < 4; ++r)
        rows[static_cast<std::size_t>(r)] =
            powers_of(net.at(r, 0), net.at(r, 1), net.at(r, 2), net.at(r, 3));
    for (std::size_t i = 0; i < 4; ++i) {
        const cubic column = powers_of(rows[0][i], rows[1][i], rows[2][i], rows[3][i]);
        for (std::size_t j = 0; j < 4; ++j)
            powers_[j][i] = column[j];
    }
}

l3d_scan_piece::jet l3d_scan_piece::at(double u, double v) const {
    cubic along_u, slope;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto &a = powers_[0][i], &b = powers_[1][i], &c = powers_[2][i], &d = powers_[3][i];
        along_u[i] = ((d * v + c) * v + b) * v + a;
        slope[i] = (d * (3 * v) + c * 2.0) * v + b;
    }
    return {((along_u[3] * u + along_u[2]) * u + along_u[1]) * u + along_u[0],
            (along_u[3] * (3 * u) + along_u[2] * 2.0) * u + along_u[1],
            ((slope[3] * u + slope[2]) * u + slope[1]) * u + slope[0]};
}

l3d_scan_piece::second_jet l3d_scan_piece::second_at(double u, double v) const {
    cubic bend, twist;
    second_jet result{at(u, v), {}, {}, {}};
    cubic along_u;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto &a = powers_[0][i], &b = powers_[1][i], &c = powers_[2][i], &d = powers_[3][i];
        along_u[i] = ((d * v + c) * v + b) * v + a;
        twist[i] = (d * (3 * v) + c * 2.0) * v + b;
        bend[i] = d * (6 * v) + c * 2.0;
    }
    result.by_uu = along_u[3] * (6 * u) + along_u[2] * 2.0;
    result.by_uv = (twist[3] * (3 * u) + twist[2] * 2.0) * u + twist[1];
    result.by_vv = ((bend[3] * u + bend[2]) * u + bend[1]) * u + bend[0];
    return result;
}

std::optional<l3d_scan_root> l3d_scan_piece::find(double x, double y, l3d_scan_root start,
                                                  double accuracy, int& rounds) const {
    double u = start.u, v = start.v;
    for (int round = 0; round < most_rounds; ++round) {
        ++rounds;
        const jet s = at(u, v);
        const double fx = s.value[0] - x * s.value[2], fy = s.value[1] - y * s.value[2];
        const double ux = s.by_u[0] - x * s.by_u[2], uy = s.by_u[1] - y * s.by_u[2];
        const double vx = s.by_v[0] - x * s.by_v[2], vy = s.by_v[1] - y * s.by_v[2];
        const bool rests = std::max(std::abs(fx), std::abs(fy)) <= accuracy * s.value[2];
        if (rests && u >= -rim && u <= 1 + rim && v >= -rim && v <= 1 + rim)
            return l3d_scan_root{u, v, s.value[2]};
        const double determinant = ux * vy - uy * vx;
        if (!(determinant != 0))
            return std::nullopt;
        // Steps that leave the piece by more than its own size lead nowhere, so they are clamped.
        u = std::clamp(u - (fx * vy - fy * vx) / determinant, -1.0, 2.0);
        v = std::clamp(v - (ux * fy - uy * fx) / determinant, -1.0, 2.0);
        if (rests && round > 0 && (u < -rim || u > 1 + rim || v < -rim || v > 1 + rim))
            return std::nullopt;
    }
    return std::nullopt;
}

bool l3d_is_one_to_one(const l3d_image_patch& net, const l3d_image_box& hull) {
    const double x = (hull.left + hull.right) / 2, y = (hull.top + hull.bottom) / 2;
    const double r = std::hypot(hull.width(), hull.height()) / 2;
    const auto seen = [&](const l3d_image_point& d) {
        return direction{d[0] - x * d[2], d[1] - y * d[2], r * std::abs(d[2])};
    };
    std::array<direction, 12> along_u, along_v;
    std::size_t n = 0;
    for (int line = 0; line < 4; ++line)
        for (int i = 0; i < 3; ++i, ++n) {
            along_u[n] = seen(net.at(line, i + 1) - net.at(line, i));
            along_v[n] = seen(net.at(i + 1, line) - net.at(i, line));
        }
    const auto length = [](const direction& d) { return std::hypot(d.x, d.y); };
    const auto within_right_angle = [&](const std::array<direction, 12>& all) {
        direction mean{0, 0, 0};
        for (const direction& d : all) {
            mean.x += d.x;
            mean.y += d.y;
        }
        const double size = length(mean);
        // If all are within 45 degrees of the mean, any two are within a right angle.
        return std::all_of(all.begin(), all.end(), [&](const direction& d) {
            return d.x * mean.x + d.y * mean.y > (0.7072 * length(d) + 1.71 * d.blur) * size;
        });
    };
    if (!within_right_angle(along_u) || !within_right_angle(along_v))
        return false;
    bool left = true, right = true;
    for (const direction& a : along_u)
        for (const direction& b : along_v) {
            const double turn = a.x * b.y - a.y * b.x;
            const double blur = a.blur * (length(b) + b.blur) + b.blur * length(a);
            left = left && turn > blur;
            right = right && turn < -blur;
        }
    return left || right;
}
