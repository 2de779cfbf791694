// SPDX-License-Identifier: MIT
// mesh_strip: fills the triangles between two rows of a diced mesh, in SIMD lanes.
#ifndef L3D_RASTER_PATHS_MESH_STRIP_P_H
#define L3D_RASTER_PATHS_MESH_STRIP_P_H

#include "raster/paths/mesh_dicer_p.h"
#include "raster/shapes/shaded_triangle_p.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <span>

namespace l3d_detail {

/// Shades the triangles of a strip in their order, from the triangle with index `first` on. A
/// colour is the nearest one to its cell's bilinear colour, within 2^-8.
///
/// Triangles are set up together, one in each lane, and then filled one by one. The function stops
/// at a triangle that is large, not wholly in the picture, or changes colour too fast. Returns the
/// index of this triangle, or the number of all triangles if it stops at none.
/// Expects: `ends` = {width, height} of the picture, or less, and at most 2^15.
std::size_t shade_strip(const l3d_pixels& target, const mesh_strip& strip,
                        const std::array<double, 2>& ends, std::size_t first);

/// Shades spans of a triangle of a cell. A colour is the nearest one to the cell's bilinear colour,
/// within 2^-8.
/// Shape:   the first two colours of the spans are the place in the cell, from 0 to 1.
/// Expects: the spans are in the picture.
void shade_bilinear(const l3d_pixels& target, const mesh_cell& cell,
                    std::span<const shaded_span> spans);

} // namespace l3d_detail

#endif
