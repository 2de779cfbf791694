// SPDX-License-Identifier: MIT
// l3d_seen_region: makes four sides that enclose all views with the same rounded eye and direction.
#include "scene/levels/seen_region.h"

#include "scene/sides/shared_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace {

using vector = l3d_seen_region::vector;

/// The steps of the grids to which eyes and directions are rounded, as a share of half of the
/// picture. Coarser grids keep the region for longer while the camera moves, but make the region
/// larger. With a sixteenth, the region is about twice as large as a picture of 4 by 3.
constexpr double grid_share = 1.0 / 16;

/// The largest power of two that is at most x.
double power_below(double x) {
    return std::exp2(std::floor(std::log2(x)));
}

vector rounded(const vector& v, double grid) {
    return {std::round(v[0] / grid) * grid, std::round(v[1] / grid) * grid,
            std::round(v[2] / grid) * grid};
}

double value_of(const std::array<double, 4>& sum, const l3d_vector<double, 4>& p) {
    return sum[0] * p[0] + sum[1] * p[1] + sum[2] * p[2] + sum[3] * p[3];
}

/// Some unit vector perpendicular to v.
vector across(const vector& v) {
    vector axis(0.0);
    int least = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(v[k]) < std::abs(v[least]))
            least = k;
    axis[least] = 1;
    return l3d_normalized(l3d_cross(v, axis));
}

} // namespace

/// Finds a and b so that |x| <= a + b z holds in the rounded axes for everything that the picture
/// shows.
///
/// Let the eye be off by at most e, and the direction by at most d. A place of the picture is eye +
/// z forward + s with |s| <= t z, where t is the tangent of half of the picture's diagonal. So in
/// the rounded axes |x| <= e + z (d + t), and depth is at least z (1 - d d / 2 - t d) - e. With c =
/// 1 - d d / 2 - t d, b = (d + t) / c and a = e (1 + b). A place with |x|, |y| <= a + b z is no
/// farther from the rounded eye than z + 2 (a + b z). So its depth is at least z - e - d (z + 2 (a
/// + b z)).
std::optional<l3d_seen_region> l3d_seen_region::of(const l3d_camera& camera, l3d_size size,
                                                   double least_depth, double reach) {
    // The margin for filters, for errors of a part of a pixel, and for strips beside hidden parts.
    constexpr double rim_px = 2 + l3d_longest_shared_chord;
    const double half_px = std::hypot(size.width, size.height) / 2 + rim_px;
    const double t = half_px / camera.focal_length(size);
    // Half of the picture at the nearest things, in the world's unit.
    const double half =
        camera.is_parallel() ? half_px / camera.scale_at_target(size) : t * least_depth;
    // In wide pictures, a turn moves depths at the rim by more than half of the picture's part.
    const double turn = camera.is_parallel() ? half / reach : t / (1 + t * t);
    const vector forward = camera.axes().forward;
    const double eye_grid = power_below(grid_share * half);
    const double turn_grid = power_below(std::min(grid_share * turn, grid_share));
    const vector eye = rounded(camera.is_parallel() ? camera.target : camera.eye, eye_grid);
    const vector z = l3d_normalized(rounded(forward, turn_grid));
    // Half of the diagonal of a cube of the grid; the length of a direction errs by as much.
    const double e = std::numbers::sqrt3 / 2 * eye_grid, d = std::numbers::sqrt3 * turn_grid;
    double a = half + e + d * reach, b = 0;
    std::array<double, 2> depth{0, 1}; // factors of z and of 1
    if (!camera.is_parallel()) {
        const double c = 1 - d * d / 2 - t * d;
        b = (d + t) / c;
        a = e * (1 + b);
        depth = {1 - d * (1 + 2 * b), -e - 2 * d * a};
    }
    if (!std::isfinite(a) || !(eye_grid > 0 && turn_grid > 0))
        return std::nullopt;
    const vector x = across(z), y = l3d_cross(z, x);
    l3d_seen_region result;
    std::size_t side = 0;
    for (const vector& axis : {x, -x, y, -y}) {
        const vector factors = z * b - axis;
        result.sides_[side++] = {factors[0], factors[1], factors[2], a - l3d_dot(factors, eye)};
    }
    result.depth_ = {z[0] * depth[0], z[1] * depth[0], z[2] * depth[0],
                     depth[1] - depth[0] * l3d_dot(z, eye)};
    return result;
}

l3d_seen_region l3d_seen_region::in(const l3d_matrix<double>& placement) const {
    const auto placed = [&](const sum& of) {
        sum result{};
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                result[static_cast<std::size_t>(column)] +=
                    of[static_cast<std::size_t>(row)] * placement(row, column);
        return result;
    };
    l3d_seen_region result;
    std::ranges::transform(sides_, result.sides_.begin(), placed);
    result.depth_ = placed(depth_);
    return result;
}

double l3d_seen_region::least_depth(std::span<const l3d_vector<double, 4>> points) const {
    double least = std::numeric_limits<double>::infinity();
    for (const l3d_vector<double, 4>& p : points)
        least = std::min(least, value_of(depth_, p) / p[3]);
    return least;
}

bool l3d_seen_region::hides(std::span<const l3d_vector<double, 4>> points) const {
    return std::ranges::any_of(sides_, [&](const sum& side) {
        return std::ranges::all_of(
            points, [&](const l3d_vector<double, 4>& p) { return value_of(side, p) < 0; });
    });
}

bool l3d_seen_region::holds(const vector& least, const vector& most) const {
    return std::ranges::all_of(sides_, [&](const sum& side) {
        l3d_vector<double, 4> nearest{0.0, 0.0, 0.0, 1.0};
        for (int k = 0; k < 3; ++k)
            nearest[k] = side[static_cast<std::size_t>(k)] > 0 ? least[k] : most[k];
        return value_of(side, nearest) >= 0;
    });
}
