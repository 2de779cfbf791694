// SPDX-License-Identifier: MIT
// visit_flat: a path as straight lines, by forward differences, within a certified distance.
#ifndef L3D_RASTER_PATHS_FLAT_CURVE_P_H
#define L3D_RASTER_PATHS_FLAT_CURVE_P_H

#include "geom/forward_difference.h"
#include "raster/paths/path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace l3d_detail {

/// The point that homogeneous coordinates stand for.
inline l3d_point_2d projected(const l3d_curve_2d::point& p) {
    return {p[0] / p[2], p[1] / p[2]};
}

/// Where points are seen. Units: pixels.
struct seen_box {
    double left, top, right, bottom;

    /// Whether all of a curve is beyond one side. It lies in the hull of its control points.
    bool misses(const l3d_curve_2d& curve) const {
        const auto all = [&curve](auto beyond) {
            return std::ranges::all_of(curve.points,
                                       [&](const auto& p) { return beyond(projected(p)); });
        };
        return all([this](l3d_point_2d p) { return p.x < left; }) ||
               all([this](l3d_point_2d p) { return p.x > right; }) ||
               all([this](l3d_point_2d p) { return p.y < top; }) ||
               all([this](l3d_point_2d p) { return p.y > bottom; });
    }
};

/// Whether all weights are 1, so that no division is needed.
inline bool is_plain(const l3d_curve_2d& curve) {
    return std::ranges::all_of(curve.points, [](const auto& p) { return p[2] == 1; });
}

/// How many equal steps of the parameter keep a curve within a distance of its chords; in double,
/// as it may be too many.
///
/// A homogeneous chord over a step h errs by at most h^2 / 8 times the second derivative, which is
/// at most 6 times the largest second difference. The place on the chord then errs by at most (dx +
/// r dw) / w: seen from the middle of the curve's ends, no place is farther away than r.
double flat_steps(const l3d_curve_2d& curve, double distance);

/// The steps that are walked by forward differences before a curve is begun exactly again. So few
/// keep rounding below 2^-40 of the coordinates.
inline constexpr int most_flat_steps = 16;

/// Calls line(point) for the end of each chord. What is not seen becomes one chord.
///
/// A half needs at most half the steps: about the same origin, its second differences are a
/// quarter. Where weights differ, a half may need far less: the bound has their smallest.
/// Expects: steps that keep the distance, a whole number but for being a double.
template <class Line>
void flatten_in(double steps, const l3d_curve_2d& curve, double distance, const seen_box& seen,
                const Line& line) {
    if (steps > 1 && !seen.misses(curve)) {
        const bool plain = is_plain(curve);
        if (steps > most_flat_steps) {
            const double half = std::ceil(steps / 2);
            const auto go = [&](const l3d_curve_2d& part) {
                flatten_in(plain ? half : std::min(half, flat_steps(part, distance)), part,
                           distance, seen, line);
            };
            const auto [first, second] = curve.split();
            go(first);
            return go(second);
        }
        const int count = static_cast<int>(steps);
        std::array<l3d_forward_difference<double, 3>, 3> walk;
        for (std::size_t k = 0; k < 3; ++k) {
            const int i = static_cast<int>(k);
            walk[k] = l3d_forward_difference<double, 3>::build(
                {curve.points[0][i], curve.points[1][i], curve.points[2][i], curve.points[3][i]},
                count);
        }
        for (int step = 1; step < count; ++step) {
            walk[0].step();
            walk[1].step();
            walk[2].step();
            if (plain)
                line(l3d_point_2d{walk[0].value(), walk[1].value()});
            else
                line(l3d_point_2d{walk[0].value() / walk[2].value(),
                                  walk[1].value() / walk[2].value()});
        }
    }
    line(projected(curve.points[3]));
}

/// The same for a whole curve.
template <class Line>
void flatten(const l3d_curve_2d& curve, double distance, const seen_box& seen, const Line& line) {
    flatten_in(flat_steps(curve, distance), curve, distance, seen, line);
}

/// Calls begin(point), line(point) and end(closed) for each outline of a path.
template <class Begin, class Line, class End>
void visit_flat(const l3d_path& path, double distance, const seen_box& seen, const Begin& begin,
                const Line& line, const End& end) {
    struct {
        const double distance;
        const seen_box& seen;
        const Begin& begin_outline;
        const Line& add_line;
        const End& end_outline;
        bool open = false;

        void move(l3d_point_2d to) {
            finish();
            begin_outline(to);
            open = true;
        }
        void line(l3d_point_2d to) { add_line(to); }
        void curve(const l3d_curve_2d& c) { flatten(c, distance, seen, add_line); }
        void close() {
            end_outline(true);
            open = false;
        }
        void finish() {
            if (open)
                end_outline(false);
        }
    } visitor{distance, seen, begin, line, end};
    path.visit(visitor);
    visitor.finish();
}

} // namespace l3d_detail

#endif
