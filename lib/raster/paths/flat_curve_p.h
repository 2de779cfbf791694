// SPDX-License-Identifier: MIT
// visit_flat: turns a path into lines within a certified distance, by forward differences.
#ifndef L3D_RASTER_PATHS_FLAT_CURVE_P_H
#define L3D_RASTER_PATHS_FLAT_CURVE_P_H

#include "raster/paths/path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace l3d_detail {

/// The point of the plane that homogeneous coordinates stand for.
inline l3d_point_2d projected(const l3d_curve_2d::point& p) {
    // Weights of ends are mostly 1, and need no division.
    if (p[2] == 1)
        return {p[0], p[1]};
    return {p[0] / p[2], p[1] / p[2]};
}

/// The box in which a path is seen. Outside of the box, curves need no fine chords. Units: pixels.
struct seen_box {
    double left, top, right, bottom;

    /// Whether a curve lies wholly beyond one side of the box, by its convex hull.
    bool misses(const l3d_curve_2d& curve) const {
        const auto all = [&curve](auto beyond) {
            return std::ranges::all_of(curve.points, beyond);
        };
        // weights are above 0, so a comparison with p[2] replaces a division by it
        return all([this](const auto& p) { return p[0] < left * p[2]; }) ||
               all([this](const auto& p) { return p[0] > right * p[2]; }) ||
               all([this](const auto& p) { return p[1] < top * p[2]; }) ||
               all([this](const auto& p) { return p[1] > bottom * p[2]; });
    }
};

/// Whether a curve is not rational: all weights are 1, so that no division is needed.
inline bool is_plain(const l3d_curve_2d& curve) {
    return std::ranges::all_of(curve.points, [](const auto& p) { return p[2] == 1; });
}

/// The way in which a curve is divided into chords.
struct flat_plan {
    double steps; ///< number of chords, a whole number, perhaps too large for an integer
    bool halved;  ///< whether the curve is halved; then each half takes as many steps as it needs
};

/// Finds the number of chords that keep within a distance of the curve.
///
/// The chords' ends are moved off the curve, to the outer side of its bend, so that the chords'
/// errors are equally large on both sides of the curve. NUMERICS.md, section 20.
flat_plan flat_steps(const l3d_curve_2d& curve, double distance);

/// The length of the first and the last step, in units of the other steps' length. These two steps
/// differ from the others because the curve's own ends stay in place. The value is (1 + sqrt 2) /
/// sqrt 8.
inline constexpr double flat_step_at_ends = (1 + std::numbers::sqrt2) / (2 * std::numbers::sqrt2);

/// The length of a step in the curve's parameter, except for the first and the last step.
/// Expects: at least 2 steps.
constexpr double flat_step(std::size_t steps) {
    return 1 / (static_cast<double>(steps - 2) + 2 * flat_step_at_ends);
}

/// The limit of steps of a curve that is not halved.
inline constexpr std::size_t most_flat_steps = 64;

/// The number of points that are computed together.
inline constexpr std::size_t flat_points_at_once = 8;

/// Finds the points at which a curve's chords meet, one fewer than the `steps` chords.
/// Shape:   `points` has room for flat_points_at_once more points.
void find_flat_points(const l3d_curve_2d& curve, std::size_t steps, l3d_point_2d* points);

/// Memory for the points of a curve until they are taken. Callers that flatten many curves keep
/// this memory, as setting it up takes as long as flattening a short curve.
using flat_room = std::array<l3d_point_2d, most_flat_steps + flat_points_at_once>;

/// Divides a curve into chords, and calls lines(points) for the chords' ends, several at a time. A
/// part outside of the box `seen` becomes one chord.
template <class Lines>
void flatten(const l3d_curve_2d& curve, double distance, const seen_box& seen, flat_room& room,
             const Lines& lines) {
    std::size_t count = 1;
    const flat_plan plan = flat_steps(curve, distance);
    if (plan.steps > 1 && !seen.misses(curve)) {
        if (plan.halved) {
            const auto [first, second] = curve.split();
            flatten(first, distance, seen, room, lines);
            return flatten(second, distance, seen, room, lines);
        }
        count = static_cast<std::size_t>(plan.steps);
        find_flat_points(curve, count, room.data());
    }
    room[count - 1] = projected(curve.points[3]);
    lines(std::span<const l3d_point_2d>(room.data(), count));
}

/// Calls begin(point), lines(points) and end(closed) for each outline of a path, with curves as
/// chords.
template <class Begin, class Lines, class End>
void visit_flat(const l3d_path& path, double distance, const seen_box& seen, flat_room& room,
                const Begin& begin, const Lines& lines, const End& end) {
    struct {
        const double distance;
        const seen_box& seen;
        flat_room& room;
        const Begin& begin_outline;
        const Lines& add_lines;
        const End& end_outline;
        bool open = false;

        void move(l3d_point_2d to) {
            finish();
            begin_outline(to);
            open = true;
        }
        void lines(std::span<const l3d_point_2d> to) { add_lines(to); }
        void curve(const l3d_curve_2d& c) { flatten(c, distance, seen, room, add_lines); }
        void close() {
            end_outline(true);
            open = false;
        }
        void finish() {
            if (open)
                end_outline(false);
        }
    } visitor{distance, seen, room, begin, lines, end};
    path.visit(visitor);
    visitor.finish();
}

} // namespace l3d_detail

#endif
