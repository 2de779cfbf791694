// SPDX-License-Identifier: MIT
// l3d_gradient, l3d_mesh_patch: colours that change from place to place.
#ifndef L3D_RASTER_PATHS_GRADIENT_H
#define L3D_RASTER_PATHS_GRADIENT_H

#include "base/color.h"
#include "base/public.h"
#include "raster/placement_2d.h"
#include "raster/rasterizer_2d.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// A colour at a place along a gradient.
struct L3D_PUBLIC l3d_color_stop {
    double at = 0;       ///< from 0, the beginning, to 1, the end
    l3d_color color = 0; ///< 0x00RRGGBB
    double alpha = 1;    ///< from 0, nothing, to 1, opaque
};

/// The colours before a gradient's beginning and behind its end.
enum class L3D_PUBLIC l3d_spread {
    pad,    ///< the first and the last stop's colour
    repeat, ///< the same again, from 0 to 1
    reflect ///< the same, forwards and backwards by turns
};

/// Colours along a line, or around a place.
///
/// Red, green, blue and alpha are each linear between two stops, in the coded values of pixel
/// words. A pixel gets the mean over its square, in which colours count by their alpha: also where
/// stops jump or a gradient repeats within a pixel. A linear gradient is exact. A radial one counts
/// as linear in each of up to 32 x 32 parts of the square. That moves a place where stops jump by
/// less than 1/512 pixel, beyond 1/8 pixel of the focus. Pixels store the nearest whole number.
/// Units:   pixels, as in l3d_rasterizer_2d.
/// Cost:    with stops that are not within a pixel, a square root and some products; else some
///          products more for each of them and each part.
class L3D_PUBLIC l3d_gradient {
public:
    /// Makes a gradient from one place to another, constant across.
    /// Expects: stops in order, one at least; two different places.
    static l3d_gradient linear(l3d_point_2d from, l3d_point_2d to,
                               std::span<const l3d_color_stop> stops,
                               l3d_spread spread = l3d_spread::pad);
    /// Makes a gradient from a place outwards to the circle around it.
    /// Expects: stops in order, one at least; a radius above 0.
    static l3d_gradient radial(l3d_point_2d center, double radius,
                               std::span<const l3d_color_stop> stops,
                               l3d_spread spread = l3d_spread::pad) {
        return radial(center, radius, center, stops, spread);
    }
    /// Makes a gradient from a focus to a circle: along each ray, places go from 0 at the focus to
    /// 1 on the circle. A focus that is not inside is moved there, to 1 - 2^-10 of the radius.
    /// Expects: stops in order, one at least; a radius above 0.
    static l3d_gradient radial(l3d_point_2d center, double radius, l3d_point_2d focus,
                               std::span<const l3d_color_stop> stops,
                               l3d_spread spread = l3d_spread::pad);

    /// The gradient after its plane was turned, stretched or moved.
    /// Expects: a placement that leaves areas.
    l3d_gradient placed(const l3d_placement_2d& place) const;

    /// The words of pixels in a row, from (x, y) on. The highest byte says how transparent the
    /// pixel is, 0 for not at all, as in l3d_pixels.
    void colors(int x, int y, std::span<std::uint32_t> result) const;

private:
    /// Red, green, blue and alpha.
    using numbers = std::array<double, 4>;

    /// Between two stops: linear from one end to the other.
    struct piece {
        double from, to; ///< places along the gradient; infinite at the ends of a padded one
        numbers begin, end;

        numbers at(double place) const;
    };

    /// The change of the place in the gradient over a square of the picture.
    struct slope {
        double place;
        double right, down; ///< change over the square's width, and over its height
    };

    l3d_gradient(std::span<const l3d_color_stop> stops, l3d_spread spread);

    const piece& piece_at(double place, double& in_period) const;
    void add(double from, double to, double weight_from, double weight_to, numbers& sum) const;
    void add_in_period(double from, double to, double weight_from, double weight_to,
                       numbers& sum) const;
    bool is_one_piece(double from, double to) const;
    numbers mean(const slope& of) const;
    slope slope_at(l3d_point_2d at) const;
    double parts_at(l3d_point_2d at) const;
    std::uint32_t word_at(l3d_point_2d at) const;

    bool radial_ = false;
    bool is_opaque_ = true;
    double steepest_ = 0;        ///< levels per place between two stops
    l3d_placement_2d to_unit_{}; ///< a linear gradient goes along x to 1, a circle has radius 1
    double narrowest_ = 1, widest_ = 1; ///< the least and the largest scale of to_unit_
    l3d_point_2d focus_{};              ///< focus, in to_unit_'s coordinates
    double period_ = 0;                 ///< 0 for a padded gradient
    std::vector<piece> pieces_;         ///< pieces of a period, without gaps
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
