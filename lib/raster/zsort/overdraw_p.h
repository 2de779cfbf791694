// SPDX-License-Identifier: MIT
// overdraw: how often a pixel would be painted on average.
#ifndef L3D_RASTER_ZSORT_OVERDRAW_P_H
#define L3D_RASTER_ZSORT_OVERDRAW_P_H

#include "raster/zsort/painter.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Whether the areas of all triangles add up to more than the box around all, so that many of their
/// pixels are hidden. Then painting from front to back pays: what it leaves out costs more than the
/// bits that tell it. Triangles beyond the picture count as they are. They may lead to the slower
/// of both ways, but not to another picture.
///
/// Cost: looks at some thousand pieces at most, evenly among all.
inline bool has_overdraw(std::span<const l3d_painter_triangle> triangles,
                         std::span<const l3d_painter_piece> pieces) {
    constexpr std::size_t most_looked_at = 1024;
    const std::size_t step = pieces.size() / most_looked_at + 1;
    double area = 0;
    std::int32_t left = INT32_MAX, top = INT32_MAX, right = INT32_MIN, bottom = INT32_MIN;
    for (std::size_t i = 0; i < pieces.size(); i += step) {
        const auto& v = triangles[pieces[i].triangle].v;
        const double along1_x = double(v[1].x) - v[0].x, along1_y = double(v[1].y) - v[0].y;
        const double along2_x = double(v[2].x) - v[0].x, along2_y = double(v[2].y) - v[0].y;
        const double area2 = along1_x * along2_y - along1_y * along2_x;
        area += 0.5 * static_cast<double>(step) * (area2 < 0 ? -area2 : area2);
        for (const l3d_micro_vertex& corner : v) {
            left = std::min(left, corner.x);
            top = std::min(top, corner.y);
            right = std::max(right, corner.x);
            bottom = std::max(bottom, corner.y);
        }
    }
    return area > (double(right) - left) * (double(bottom) - top);
}

} // namespace l3d_detail

#endif
