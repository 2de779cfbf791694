// SPDX-License-Identifier: MIT
// Finds silhouettes on borders and on lines, by two kinds of Newton's iteration.
#include "compare/plotters/silhouette.h"

#include <algorithm>
#include <cmath>

namespace {

double determinant(const l3d_image_point& a, const l3d_image_point& b, const l3d_image_point& c) {
    return l3d_dot(a, l3d_cross<double>(b, c));
}

bool is_inside(double u, double v) {
    return u >= 0 && u <= 1 && v >= 0 && v <= 1;
}

/// Improves u and v by one round of Newton's iteration for f = g = 0. False if the determinant
/// vanishes.
bool improve(double& u, double& v, const std::array<double, 3>& f, const std::array<double, 3>& g) {
    const double d = f[1] * g[2] - f[2] * g[1];
    if (!(d != 0))
        return false;
    // Steps that leave the piece by more than its own size lead nowhere, so they are clamped.
    u = std::clamp(u - (f[0] * g[2] - f[2] * g[0]) / d, -1.0, 2.0);
    v = std::clamp(v - (f[1] * g[0] - f[0] * g[1]) / d, -1.0, 2.0);
    return true;
}

} // namespace

l3d_scan_turn l3d_turn_at(const l3d_scan_piece& piece, double u, double v) {
    const auto s = piece.second_at(u, v);
    return {determinant(s.value, s.by_u, s.by_v),
            determinant(s.value, s.by_uu, s.by_v) + determinant(s.value, s.by_u, s.by_uv),
            determinant(s.value, s.by_uv, s.by_v) + determinant(s.value, s.by_u, s.by_vv)};
}

l3d_scan_root l3d_on_side(int side, double t) {
    return side < 2 ? l3d_scan_root{t, double(side), 0} : l3d_scan_root{double(side - 2), t, 0};
}

std::vector<l3d_border_turn> l3d_border_turns(const l3d_scan_piece& piece, int samples) {
    constexpr int halvings = 40;
    std::vector<l3d_border_turn> result;
    for (int side = 0; side < 4; ++side) {
        const auto value = [&](double t) {
            const l3d_scan_root at = l3d_on_side(side, t);
            return l3d_turn_at(piece, at.u, at.v).value;
        };
        double before = value(0);
        for (int i = 1; i <= samples; ++i) {
            double low = double(i - 1) / samples, high = double(i) / samples;
            const double after = value(high);
            if ((before < 0) != (after < 0)) {
                for (int round = 0; round < halvings; ++round) {
                    const double middle = (low + high) / 2;
                    ((value(middle) < 0) == (before < 0) ? low : high) = middle;
                }
                result.push_back({side, low, l3d_on_side(side, low)});
            }
            before = after;
        }
    }
    return result;
}

/// Finds a silhouette on a line. The iteration's last step measures its distance from the
/// silhouette, since the determinant has no unit.
std::optional<l3d_scan_root> l3d_silhouette_on_line(const l3d_scan_piece& piece, double y,
                                                    l3d_scan_root start, double accuracy,
                                                    int& rounds) {
    constexpr double step_at_rest = 1e-4; // in the parameters
    double u = start.u, v = start.v;
    for (int round = 0; round < l3d_scan_piece::most_rounds; ++round) {
        ++rounds;
        const auto s = piece.at(u, v);
        const l3d_scan_turn turn = l3d_turn_at(piece, u, v);
        const double before_u = u, before_v = v;
        if (!improve(
                u, v,
                {s.value[1] - y * s.value[2], s.by_u[1] - y * s.by_u[2], s.by_v[1] - y * s.by_v[2]},
                {turn.value, turn.by_u, turn.by_v}))
            return std::nullopt;
        const bool rests = std::max(std::abs(u - before_u), std::abs(v - before_v)) < step_at_rest;
        if (rests && std::abs(s.value[1] - y * s.value[2]) <= accuracy * s.value[2])
            return l3d_scan_root{u, v, piece.at(u, v).value[2]};
    }
    return std::nullopt;
}

/// Finds the points where y is level. With y = Y / W, they have Y_u W - Y W_u = 0, and the same for
/// v.
std::vector<l3d_scan_root> l3d_level_points(const l3d_scan_piece& piece, int& rounds) {
    constexpr int places = 5;
    constexpr double same = 1e-6, step_at_rest = 1e-9; // in the parameters
    std::vector<l3d_scan_root> found;
    for (int place = 0; place < places * places; ++place) {
        double u = (place % places + 0.5) / places, v = (place / places + 0.5) / places;
        bool rests = false;
        for (int round = 0; round < l3d_scan_piece::most_rounds && !rests; ++round) {
            ++rounds;
            const auto s = piece.second_at(u, v);
            const auto wronskian = [&](const l3d_image_point& a, const l3d_image_point& b) {
                return a[1] * b[2] - b[1] * a[2];
            };
            const double before_u = u, before_v = v;
            const double twisted = wronskian(s.by_uv, s.value);
            if (!improve(u, v,
                         {wronskian(s.by_u, s.value), wronskian(s.by_uu, s.value),
                          twisted + wronskian(s.by_u, s.by_v)},
                         {wronskian(s.by_v, s.value), twisted + wronskian(s.by_v, s.by_u),
                          wronskian(s.by_vv, s.value)}))
                break;
            rests = std::max(std::abs(u - before_u), std::abs(v - before_v)) < step_at_rest;
        }
        const bool is_known = std::any_of(found.begin(), found.end(), [&](const auto& other) {
            return std::max(std::abs(other.u - u), std::abs(other.v - v)) < same;
        });
        if (rests && is_inside(u, v) && !is_known)
            found.push_back({u, v, piece.at(u, v).value[2]});
    }
    return found;
}
