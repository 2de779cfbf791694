// SPDX-License-Identifier: MIT
// normal_error: how far normals over a polygon are from those of the same parameters.
#ifndef L3D_RASTER_SURFACES_NORMAL_ERROR_P_H
#define L3D_RASTER_SURFACES_NORMAL_ERROR_P_H

#include "raster/surface_part.h"
#include "raster/shapes/attribute_plane_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The share of a polygon's shape and of its change of w in the error of a plane through its
/// corners' normals. The slow twin of normal_lanes. NUMERICS, section 24.
///
/// Shape:   area2 is the cross product of both diagonals, or of a triangle's first two sides.
/// Expects: area2 != 0, inv_w > 0.
template <std::size_t Corners>
float normal_error(const std::array<l3d_micro_vertex, Corners>& v,
                   const std::array<scan_point, Corners>& p, std::int64_t area2) {
    constexpr std::size_t last = Corners - 1;
    double part1 = 0, part2 = 0;
    if constexpr (Corners == 4) {
        // From the middle of the first diagonal to that of the second, in parts of both, halved.
        const scan_point along1 = p[2] - p[0], along2 = p[3] - p[1];
        const scan_point apart{p[1].x + p[3].x - p[0].x - p[2].x,
                               p[1].y + p[3].y - p[0].y - p[2].y};
        const double quarter = 0.25 / static_cast<double>(area2);
        part1 = quarter * static_cast<double>(cross(apart, along2));
        part2 = quarter * static_cast<double>(cross(along1, apart));
    }
    double square1 = 0, square2 = 0, twist = 0, beside = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto n = [&](std::size_t i) { return double{v[i].normal[k]}; };
        const double d1 = n(2) - n(0), d2 = n(last) - n(1), t = n(0) - n(1) + n(2) - n(last);
        const double off = part1 * d1 + part2 * d2;
        square1 += d1 * d1;
        square2 += d2 * d2;
        twist += t * t;
        beside += off * off;
    }
    float farthest = v[0].inv_w, nearest = farthest;
    for (const l3d_micro_vertex& corner : v) {
        farthest = std::min(farthest, corner.inv_w);
        nearest = std::max(nearest, corner.inv_w);
    }
    const double range = std::sqrt(std::max(square1, square2)) + std::sqrt(twist) / 2;
    const double more = double{nearest} / double{farthest} - 1;
    return static_cast<float>(std::sqrt(beside) + more / 4 * range);
}

} // namespace l3d_detail

#endif
