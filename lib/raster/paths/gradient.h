// SPDX-License-Identifier: MIT
// l3d_gradient, l3d_mesh_patch: colours that change from place to place.
#ifndef L3D_RASTER_PATHS_GRADIENT_H
#define L3D_RASTER_PATHS_GRADIENT_H

#include "base/public.h"
#include "raster/rasterizer_2d.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// Where along a gradient a colour is.
struct L3D_PUBLIC l3d_color_stop {
    double at = 0;           ///< from 0, the beginning, to 1, the end
    std::uint32_t color = 0; ///< 0x00RRGGBB
};

/// Colours along a line, or around a place. Before the first and behind the last stop they go on
/// as they are there.
///
/// Red, green and blue are linear between two stops, in the coded values of pixel words. What is
/// stored is the nearest whole number, of a sum in double.
/// Units:   pixels, as in l3d_rasterizer_2d.
class L3D_PUBLIC l3d_gradient {
public:
    /// From one place to another, constant across.
    /// Expects: stops in order, one at least; two different places.
    static l3d_gradient linear(l3d_point_2d from, l3d_point_2d to,
                               std::span<const l3d_color_stop> stops);
    /// From a place outwards.
    /// Expects: stops in order, one at least; a radius above 0.
    static l3d_gradient radial(l3d_point_2d center, double radius,
                               std::span<const l3d_color_stop> stops);

    /// The colours of pixels in a row, from (x, y) on.
    void colors(int x, int y, std::span<std::uint32_t> result) const;

private:
    l3d_gradient() = default;
    std::uint32_t color_at(double place) const;

    bool radial_ = false;
    l3d_point_2d begin_{};
    double across_ = 0, down_ = 0; ///< what a pixel to the right, or downwards, adds
    std::vector<l3d_color_stop> stops_;
};

/// A tensor product patch with a colour at each corner, as in PDF shadings of type 7.
///
/// Shape:   points[row][column]: rows along v, columns along u; colours at (u, v) = (0, 0), (1, 0),
///          (0, 1), (1, 1), bilinear between.
struct L3D_PUBLIC l3d_mesh_patch {
    std::array<std::array<l3d_point_2d, 4>, 4> points; ///< control points, in pixels
    std::array<std::uint32_t, 4> colors{};             ///< 0x00RRGGBB

    /// A Coons patch, of type 6: its inner points follow from the borders.
    /// Shape:   the control points around, from (0, 0) along v = 0 to (1, 0), then to (1, 1), (0,
    ///          1) and back.
    /// Source:  Coons 1967; as a tensor product patch: PDF Reference 1.7, section 4.6.3.
    static l3d_mesh_patch coons(const std::array<l3d_point_2d, 12>& around,
                                const std::array<std::uint32_t, 4>& colors);
};

#endif
