// SPDX-License-Identifier: MIT
// curve_chords: halves curves until their control points are near chords.
#include "scene/drawing/curve_chords_p.h"

#include <algorithm>
#include <cmath>

namespace l3d_detail {

namespace {

bool goes_on(const surface_vertex& last, const surface_vertex& next) {
    constexpr double rounding = 1e-12;
    return std::abs(last.u - next.u) < rounding && std::abs(last.v - next.v) < rounding;
}

} // namespace

void curve_chords::add(const bernstein_net& curve,
                       const std::function<std::array<double, 2>(double)>& place, double from,
                       double to, int halvings) {
    constexpr int most_halvings = 24;
    const ahead_of_near where = side_of_near(curve, view_);
    if (where == ahead_of_near::none || is_beside(curve, view_))
        return;
    const bool is_ahead = where == ahead_of_near::all;
    if (is_ahead && (halvings == most_halvings || is_flat(curve))) {
        const surface_vertex a = vertex(curve.at(0, 0), place(from));
        if (lines_.empty() || !goes_on(lines_.back().back(), a))
            lines_.push_back({a});
        lines_.back().push_back(vertex(curve.at(0, curve.m), place(to)));
        return;
    }
    if (halvings == most_halvings)
        return;
    const auto [low, high] = bernstein_net::halves(curve, true);
    const double middle = (from + to) / 2;
    add(low, place, from, middle, halvings + 1);
    add(high, place, middle, to, halvings + 1);
}

/// Whether a chord may stand for a curve. Depths may be off four times as much as places, since
/// they only decide which line or surface is in front.
bool curve_chords::is_flat(const bernstein_net& curve) const {
    const auto place = [](const double* p) {
        return image_place{p[0] / p[2], p[1] / p[2], p[3] / p[2]};
    };
    const image_place a = place(curve.at(0, 0)), b = place(curve.at(0, curve.m));
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    for (int i = 1; i < curve.m; ++i) {
        const image_place c = place(curve.at(0, i));
        const double along = (c.x - a.x) * dx + (c.y - a.y) * dy;
        const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
        if (!(distance_from(c, a, b) <= tolerance_ &&
              std::abs(a.z + t * (b.z - a.z) - c.z) <= 4 * tolerance_))
            return false;
    }
    return true;
}

} // namespace l3d_detail
