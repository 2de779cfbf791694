// SPDX-License-Identifier: MIT
// l3d_facing_cones: makes cones of sixteen blocks once a model, and tests them in every frame.
#include "scene/culling/facing_cones.h"

#include "geom/patch_part.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace {

using vector = l3d_facing_cones::vector;

/// Normals' coefficients shorter than this have no direction, since they may be rounding alone
/// (l3d_normal_columns).
constexpr double no_direction = 0x1p-40;

/// Margin for the rounding of some thirty operations on doubles, relative to the distances in them.
/// It also covers an eye that was found by solving three equations.
constexpr double slack = 1e-9;

} // namespace

void l3d_facing_cones::ball_and_cone::hold_points(std::span<const vector> points) {
    vector least = points[0], most = points[0];
    for (const vector& p : points)
        for (int k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], p[k]);
            most[k] = std::max(most[k], p[k]);
        }
    centre = (least + most) * 0.5;
    for (const vector& p : points)
        radius = std::max(radius, l3d_length(p - centre));
}

/// Makes the cone that holds a net's normals from the net's coefficients. A cone narrower than a
/// half-space holds all positive combinations of the coefficients, so all normals.
void l3d_facing_cones::ball_and_cone::hold_normals(std::span<const vector> normals) {
    vector sum{0.0, 0.0, 0.0};
    for (const vector& n : normals)
        sum += n;
    const double length = l3d_length(sum);
    if (!(length > no_direction))
        return;
    axis = sum * (1 / length);
    double least_cosine = 1;
    for (const vector& n : normals)
        if (const double of_n = l3d_length(n); of_n > no_direction)
            least_cosine = std::min(least_cosine, l3d_dot(n, axis) / of_n);
    if (least_cosine > 0)
        sine = std::sqrt(std::max(0.0, 1 - least_cosine * least_cosine)) + slack;
}

l3d_facing_cones::l3d_facing_cones(const l3d_bezier_patch<double, 3>& patch,
                                   const l3d_normal_net& normals) {
    whole_.hold_points(patch.points);
    whole_.hold_normals(normals.polynomial().points);
    const auto points = l3d_blocks_of(patch);
    const auto directions = l3d_blocks_of(normals.polynomial());
    for (std::size_t block = 0; block < blocks; ++block) {
        ball_and_cone of;
        of.hold_points(points[block].points);
        of.hold_normals(directions[block].points);
        set(block, of);
    }
}

void l3d_facing_cones::set(std::size_t block, const ball_and_cone& of) {
    for (int k = 0; k < 3; ++k) {
        centre_[static_cast<std::size_t>(k)][block] = of.centre[k];
        axis_[static_cast<std::size_t>(k)][block] = of.axis[k];
    }
    radius_[block] = of.radius;
    sine_[block] = of.sine;
}

/// Tests the cone and the ball of the patch, then of each block. Every S of a ball is at most
/// distance + radius away, and (S - from) . axis is at least its value at the centre less the
/// radius. A vector is within a right angle of the whole cone if its cosine with the axis exceeds
/// the cone's sine.
unsigned l3d_facing_cones::away_from(const vector& from, double side) const {
    const double reach = slack * (std::abs(from[0]) + std::abs(from[1]) + std::abs(from[2]));
    // The test of the whole patch compares squares, since a root would be half of the work.
    const vector way = whole_.centre - from;
    const double along_whole = side * l3d_dot(way, whole_.axis), sine = whole_.sine + slack;
    const double clear = std::abs(along_whole) - whole_.radius * (1 + sine) - reach;
    if (clear > 0 && clear * clear > sine * sine * l3d_dot(way, way))
        return along_whole > 0 ? all : 0;
    std::array<std::uint8_t, blocks> is_away;
    for (std::size_t i = 0; i < blocks; ++i) {
        const double x = centre_[0][i] - from[0], y = centre_[1][i] - from[1],
                     z = centre_[2][i] - from[2];
        const double distance = std::sqrt(x * x + y * y + z * z) + radius_[i];
        const double along = side * (x * axis_[0][i] + y * axis_[1][i] + z * axis_[2][i]);
        is_away[i] = along - radius_[i] > sine_[i] * distance + slack * distance + reach;
    }
    unsigned bits = 0;
    for (std::size_t i = 0; i < blocks; ++i)
        bits |= static_cast<unsigned>(is_away[i]) << i;
    return bits;
}
