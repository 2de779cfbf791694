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

/// A quad, or a triangle as half of one, as functions that are bilinear in s and t from 0 to 1.
///
/// Shape: each function has its numbers at (0, 0), along s, along t, and along s t. x and y are
///        multiplied by w, which is 1 at (0, 0), where x and y are 0.
struct placed_quad {
    enum number {
        left,
        top,
        x_s,
        x_t,
        x_st,
        y_s,
        y_t,
        y_st,
        w_s,
        w_t,
        w_st,
        u,
        u_s,
        u_t,
        u_st,
        v,
        v_s,
        v_t,
        v_st,
        red,
        green,
        blue
    };
    static constexpr std::size_t stride = 24; ///< numbers of a quad: 22, and whole cache lines of 3
    std::array<float, stride> of;

    /// Sets all but the light. Expects: a name of that part.
    void set(const painted_part& part, std::uint32_t name);
};

/// For each of the pixels, the quad that it sees, and where the pixel is.
struct quad_pixels {
    alignas(64) std::array<std::int32_t, painted_pixels::room> first; ///< quad, times the stride
    alignas(64) painted_pixels::numbers x, y; ///< in pixels from the picture's top left corner
};

/// Finds places, ways and light of pixels. Pixels beside a quad see its nearest side.
/// The same bits on every processor.
/// Expects: indices of quads also in the elements behind the last pixel.
void find_quad_places(const placed_quad* quads, const quad_pixels& from, painted_pixels& pixels);

} // namespace l3d_detail

#endif
