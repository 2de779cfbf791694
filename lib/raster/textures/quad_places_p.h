// SPDX-License-Identifier: MIT
// quad_places: the places in pictures that pixels of patches' quads show.
#ifndef L3D_RASTER_TEXTURES_QUAD_PLACES_P_H
#define L3D_RASTER_TEXTURES_QUAD_PLACES_P_H

#include "raster/textures/painted_part_p.h"
#include "raster/textures/texture_lanes_p.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// A run of pixels that show one part or nothing, as find_quad_places finds it.
struct part_run {
    std::size_t end = 0;
    bool has_triangles = false; ///< whether some pixels show a triangle, and have no place yet
};

/// Finds the place in the picture for each pixel of the run from `begin` on, and the steps to the
/// next pixels. A pixel beside a quad gets the place of the nearest side; where nothing is shown,
/// steps are 0. The bits are the same on every processor.
/// Expects: the pixel at `begin` shows the part; `parameters` of all parts.
part_run find_quad_places(const painted_part& part, const float* parameters,
                          const named_pixels& from, std::size_t begin, painted_pixels& pixels);

/// The same for a pixel that shows triangle number `triangle` of the part, taken as half of a quad.
/// Units: pixels from the picture's top left corner.
void find_triangle_place(const painted_part& part, std::size_t triangle, double x, double y,
                         std::size_t pixel, painted_pixels& pixels);

/// A triangle that a pixel shows. x, y, and the pixel's `left` and `top` are relative to the first
/// corner. `places` are the corners' places in the texture's picture.
struct seen_triangle {
    float left, top;
    std::array<float, 3> x, y, inv_w;
    std::array<std::array<float, 2>, 3> places;
};

} // namespace l3d_detail

#endif
