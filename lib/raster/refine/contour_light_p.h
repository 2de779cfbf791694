// SPDX-License-Identifier: MIT
// contour_light: the light of a surface beside its contour, as its own polygons have it.
#ifndef L3D_RASTER_REFINE_CONTOUR_LIGHT_P_H
#define L3D_RASTER_REFINE_CONTOUR_LIGHT_P_H

#include "raster/refine/contour_pixels_p.h"

#include <cstdint>

namespace l3d_detail {

/// A place in the picture. Units: pixels.
struct picture_place {
    float x = 0, y = 0;
};

/// What the nearest polygon of a surface shows at a place, in mode l3d_shade::levels.
struct surface_light {
    float level = 0; ///< of a grey: the ambient level and what is above it
    float inv_w = 0;
    bool turns_right = false;   ///< the polygon's corners do, seen in the picture
    std::uint32_t material = 0; ///< of its part
};

/// Looks for the nearest polygon at a place through the quads around those that a contour lies
/// beside: two on either side. Light is that of pixel_mixer.
/// Returns: false if none of them is there.
bool find_light(const contour_pixel& pixel, picture_place place, surface_light& found);

/// The middle of the part of a pixel on the right of its contour, which counts as straight.
/// If it is so bent that a straight one would leave no part there, that is place_on_right.
/// Expects: a simple pixel that one contour passes.
picture_place middle_on_right(const contour_pixel& pixel);

/// A place on the right of the contour, a sixteenth of a pixel beside it, where it is nearest to
/// the centre. Expects: as above.
picture_place place_on_right(const contour_pixel& pixel);

} // namespace l3d_detail

#endif
