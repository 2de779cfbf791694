// SPDX-License-Identifier: MIT
// Ratios of the control points' differences.
#include "stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace stability {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using reference::vec3;
using line = std::array<vec3, 4>;

vec3 difference(const vec3& a, const vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

double length(const vec3& v) {
    return std::hypot(v.x, v.y, v.z);
}

/// 1 if both are 0.
double ratio(double larger, double smaller) {
    return larger == smaller ? 1 : smaller > 0 ? larger / smaller : infinity;
}

/// Adds a row or column to the ratios, and returns its length from point to point.
double add_line(stiffness& to, const line& p) {
    std::array<vec3, 3> first;
    std::array<double, 3> speeds{};
    for (std::size_t i = 0; i < 3; ++i) {
        first[i] = difference(p[i + 1], p[i]);
        speeds[i] = length(first[i]);
    }
    const auto [least, most] = std::minmax({speeds[0], speeds[1], speeds[2]});
    to.speed = std::max(to.speed, ratio(most, least));
    const vec3 third = difference(difference(first[2], first[1]), difference(first[1], first[0]));
    if (length(third) > 0)
        to.third = std::max(to.third, 1 + ratio(length(third), length(difference(p[3], p[0]))));
    return speeds[0] + speeds[1] + speeds[2];
}

void add_patch(stiffness& to, const reference::patch& patch, const reference::camera_frame& eye) {
    double along_u = 0, along_v = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& p = patch.points;
        along_u += add_line(to, {p[4 * i], p[4 * i + 1], p[4 * i + 2], p[4 * i + 3]});
        along_v += add_line(to, {p[i], p[4 + i], p[8 + i], p[12 + i]});
    }
    to.aspect = std::max({to.aspect, ratio(along_u, along_v), ratio(along_v, along_u)});
    double least = infinity, most = 0;
    for (const vec3& point : patch.points) {
        const long double world[3] = {point.x, point.y, point.z};
        const auto w = static_cast<double>(eye.project(world).w);
        least = std::min(least, w);
        most = std::max(most, w);
    }
    to.weights = std::max(to.weights, least > 0 ? most / least : infinity);
}

} // namespace

double stiffness::most() const {
    return std::max({speed, third, weights, aspect});
}

stiffness stiffness_of(const test_case& c) {
    stiffness result;
    const reference::camera_frame eye(c.eye, c.size);
    for (const reference::patch& patch : c.patches)
        add_patch(result, patch, eye);
    return result;
}

} // namespace stability
