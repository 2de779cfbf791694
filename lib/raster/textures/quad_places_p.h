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
    /// Whether some pixels of the run show a triangle; these pixels have no place yet.
    bool has_triangles = false;
};

/// Finds the place in the texture's picture for each pixel of the run from `begin` on, and the
/// steps from this place to the places of the next pixels. A pixel beside a quad gets the nearest
/// place on the quad's sides; where nothing is shown, steps are 0. The bits are the same on every
/// processor.
/// Expects: the pixel at `begin` shows the part; `parameters` is painted_parts::parameters.
part_run find_quad_places(const painted_part& part, const float* parameters,
                          const named_pixels& from, std::size_t begin, painted_pixels& pixels);

/// Finds the place in the texture's picture, and the steps to the places of the next pixels, for
/// one pixel. The pixel shows triangle number `triangle` of the part. The triangle is taken as half
/// of a quad. `pixel` is the pixel's index in `pixels`.
/// Units: pixels from the picture's top left corner.
void find_triangle_place(const painted_part& part, std::size_t triangle, double x, double y,
                         std::size_t pixel, painted_pixels& pixels);

/// A triangle that a pixel shows. x, y, and the pixel's `left` and `top` are relative to the
/// triangle's first corner. `places` are the corners' places in the texture's picture.
struct seen_triangle {
    float left, top;
    std::array<float, 3> x, y, inv_w;
    std::array<std::array<float, 2>, 3> places;
};

} // namespace l3d_detail

#endif
