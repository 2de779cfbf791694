// SPDX-License-Identifier: MIT
// projective_centre: the point round which a folded quad is filled.
#ifndef L3D_RASTER_PROJECTIVE_CENTRE_P_H
#define L3D_RASTER_PROJECTIVE_CENTRE_P_H

#include "raster/micro_grid.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The mean of the corners, taken before projection: its w is the mean w, its place in the picture
/// and its normal are means weighted by w.
inline l3d_micro_vertex projective_centre(const std::array<l3d_micro_vertex, 4>& corners) {
    double sum = 0, x = 0, y = 0;
    std::array<double, 3> normal{};
    for (const l3d_micro_vertex& corner : corners) {
        const double w = 1 / double(corner.inv_w);
        sum += w;
        x += w * corner.x;
        y += w * corner.y;
        for (std::size_t axis = 0; axis < normal.size(); ++axis)
            normal[axis] += w * double(corner.normal[axis]);
    }
    const auto mean = [sum](double total) { return static_cast<float>(total / sum); };
    return {static_cast<std::int32_t>(std::lrint(x / sum)),
            static_cast<std::int32_t>(std::lrint(y / sum)),
            static_cast<float>(4 / sum),
            {mean(normal[0]), mean(normal[1]), mean(normal[2])}};
}

} // namespace l3d_detail

#endif
