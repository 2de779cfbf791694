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

/// A quad, or a triangle as half of a quad, as bilinear functions of s and t from 0 to 1.
///
/// Shape: each function has a number at (0, 0), and numbers along s, along t, and along s t. The
///        functions x and y are multiplied by w, which is 1 at (0, 0), and are 0 there.
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
    static constexpr std::size_t stride = 24; ///< numbers of a quad: 22, rounded up to 1.5 cache
                                              ///< lines
    std::array<float, stride> of;

    /// Sets all numbers except the light. Expects: a name of that part.
    void set(const painted_part& part, std::uint32_t name);
};

/// The quad that each pixel sees, and the pixel's place.
struct quad_pixels {
    /// index of the quad, times the stride
    alignas(64) std::array<std::int32_t, painted_pixels::room> first;
    alignas(64) painted_pixels::numbers x, y; ///< in pixels from the picture's top left corner
};

/// Finds the texture's place, its steps to neighbours, and the light of each pixel. Pixels beside a
/// quad get the values of its nearest side. The bits are the same on every processor.
/// Expects: the elements behind the last pixel have indices of quads, too.
void find_quad_places(const placed_quad* quads, const quad_pixels& from, painted_pixels& pixels);

} // namespace l3d_detail

#endif
