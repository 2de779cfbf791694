// SPDX-License-Identifier: MIT
// Points of circles and quadratic curves at a resolution, to be joined by lines.
#ifndef L3D_RASTER_PATHS_SAMPLED_CURVE_H
#define L3D_RASTER_PATHS_SAMPLED_CURVE_H

#include "base/public.h"
#include "raster/rasterizer_2d.h"

#include <cmath>
#include <numbers>
#include <vector>

/// Points of a circle, evenly spaced: the corners of a regular polygon with `resolution` sides,
/// from the right on towards larger y. The first one is not repeated at the end.
/// Expects: resolution >= 1.
inline std::vector<l3d_point_2d> l3d_sampled_circle(l3d_point_2d center, double radius,
                                                    int resolution) {
    std::vector<l3d_point_2d> result;
    for (int i = 0; i < resolution; ++i) {
        const double angle = 2 * std::numbers::pi * i / resolution;
        result.push_back(
            {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
    }
    return result;
}

/// Points of a quadratic Bezier curve at t = 0, 1 / (n - 1), ..., 1, where n is `resolution`.
/// Expects: resolution >= 2.
inline std::vector<l3d_point_2d> l3d_sampled_quadratic(l3d_point_2d from, l3d_point_2d control,
                                                       l3d_point_2d to, int resolution) {
    std::vector<l3d_point_2d> result;
    for (int i = 0; i < resolution; ++i) {
        const double t = static_cast<double>(i) / (resolution - 1), s = 1 - t;
        result.push_back({s * s * from.x + 2 * s * t * control.x + t * t * to.x,
                          s * s * from.y + 2 * s * t * control.y + t * t * to.y});
    }
    return result;
}

#endif
