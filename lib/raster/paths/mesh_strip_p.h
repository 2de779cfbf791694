// SPDX-License-Identifier: MIT
// mesh_strip: the triangles between two rows of a diced mesh, in SIMD lanes.
#ifndef L3D_RASTER_PATHS_MESH_STRIP_P_H
#define L3D_RASTER_PATHS_MESH_STRIP_P_H

#include "raster/paths/mesh_dicer_p.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>

namespace l3d_detail {

/// Shades the triangles of a strip from `first` on, in their order. A colour is the nearest to the
/// linear one, within 2^-8.
///
/// Triangles are set up together, a lane each, and then filled one by one. Returns the first that
/// it does not take, or the number of all triangles. It takes what is small, lies wholly in the
/// picture, and does not change its colour too fast.
/// Expects: `ends` = {width, height} of the picture, or less, and at most 2^15.
std::size_t shade_strip(const l3d_pixels& target, const mesh_strip& strip,
                        const std::array<double, 2>& ends, std::size_t first);

} // namespace l3d_detail

#endif
