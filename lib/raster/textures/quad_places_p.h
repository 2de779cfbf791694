// SPDX-License-Identifier: MIT
// quad_places: what pixels see of the quads of patches, as places in pictures.
#ifndef L3D_RASTER_TEXTURES_QUAD_PLACES_P_H
#define L3D_RASTER_TEXTURES_QUAD_PLACES_P_H

#include "raster/textures/painted_part_p.h"
#include "raster/textures/texture_lanes_p.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The pixels from `begin` on that show one part or nothing.
struct part_run {
    std::size_t end = 0;
    bool has_triangles = false; ///< some show a triangle, and have no place yet
};

/// Finds places and ways of the pixels of a run. Pixels beside a quad see its nearest side; of a
/// pixel that shows nothing the ways are 0. The same bits on every processor.
/// Expects: the pixel at `begin` shows the part; `parameters` of all parts.
part_run find_quad_places(const painted_part& part, const float* parameters,
                          const named_pixels& from, std::size_t begin, painted_pixels& pixels);

/// The same for a pixel that shows a triangle, as half of a quad. Units: pixels from the picture's
/// top left corner. Shape: `triangle` counts those of the part.
void find_triangle_place(const painted_part& part, std::size_t triangle, double x, double y,
                         std::size_t pixel, painted_pixels& pixels);

/// That triangle. Shape: x and y from the first corner, of which the pixel is `left` and `top`;
/// places of corners in the picture.
struct seen_triangle {
    float left, top;
    std::array<float, 3> x, y, inv_w;
    std::array<std::array<float, 2>, 3> places;
};

} // namespace l3d_detail

#endif
