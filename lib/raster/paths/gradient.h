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
    double at = 0;       ///< place: from 0, the beginning, to 1, the end
    l3d_color color = 0; ///< the colour, 0x00RRGGBB
    double alpha = 1;    ///< opacity: from 0, invisible, to 1, opaque
};

/// The continuation of a gradient before its beginning and behind its end.
enum class L3D_PUBLIC l3d_spread {
    pad,    ///< beyond both ends, the colour of the nearest stop
    repeat, ///< beyond both ends, the gradient again and again, from 0 to 1
    reflect ///< beyond both ends, the gradient backwards and forwards by turns
};

/// Colours that change along a line, or from a place outwards.
///
/// Red, green, blue and alpha are each linear between two stops, in the coded values of pixel
/// words. A pixel gets the mean over its square, in which colours are weighted by their alpha. The
/// pixel gets this mean also where stops jump or a gradient repeats within it.
///
/// A linear gradient is exact. A radial gradient is taken as linear in each of up to 32 x 32 parts
/// of the square. So a place where stops jump moves by less than 1/512 pixel, if it is more than
/// 1/8 pixel away from the focus. Pixels store the nearest whole level.
/// Units:   pixels, as in l3d_rasterizer_2d.
/// Cost:    a square root and some products for each pixel. Stops within the pixel add some
///          products for each stop and each part of the square.
class L3D_PUBLIC l3d_gradient {
public:
    /// Makes a gradient from one place to another. Colours are constant across this direction.
    /// Expects: stops in order, at least one; two different places.
    static l3d_gradient linear(l3d_point_2d from, l3d_point_2d to,
                               std::span<const l3d_color_stop> stops,
                               l3d_spread spread = l3d_spread::pad);
    /// Makes a gradient from a centre outwards to a circle around it.
    /// Expects: stops in order, at least one; a radius above 0.
    static l3d_gradient radial(l3d_point_2d center, double radius,
                               std::span<const l3d_color_stop> stops,
                               l3d_spread spread = l3d_spread::pad) {
        return radial(center, radius, center, stops, spread);
    }
    /// Makes a gradient from a focus to a circle: along each ray, the gradient goes from 0 at the
    /// focus to 1 on the circle. A focus that is not inside of the circle is moved into it: its
    /// distance from the centre becomes 1 - 2^-10 of the radius.
    /// Expects: stops in order, at least one; a radius above 0.
    static l3d_gradient radial(l3d_point_2d center, double radius, l3d_point_2d focus,
                               std::span<const l3d_color_stop> stops,
                               l3d_spread spread = l3d_spread::pad);

    /// The gradient that results if `place` maps every point of this gradient.
    /// Expects: a placement that maps no area to 0.
    l3d_gradient placed(const l3d_placement_2d& place) const;

    /// Computes the pixel words of a part of a row, from (x, y) to the right. The highest byte
    /// tells how transparent the pixel is, from 0, opaque, as in l3d_pixels.
    void colors(int x, int y, std::span<std::uint32_t> result) const;

private:
    /// Red, green, blue and alpha.
    using numbers = std::array<double, 4>;

    /// The colours between two neighbouring stops: linear from one end to the other.
    struct piece {
        double from, to; ///< places along the gradient; infinite at the ends of a padded gradient
        numbers begin, end;

        numbers at(double place) const;
    };

    /// How the place in the gradient changes over a square of the picture.
    struct slope {
        double place;
        double right, down; ///< change of the place over the square's width, and over its height
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
    /// The steepest change of a channel, in levels per unit of the gradient's place.
    double steepest_ = 0;
    l3d_placement_2d to_unit_{}; ///< maps a linear gradient to x from 0 to 1, a circle to radius 1
    double narrowest_ = 1, widest_ = 1; ///< the least and the largest scale of to_unit_
    l3d_point_2d focus_{};              ///< the focus, mapped by to_unit_
    double period_ = 0;                 ///< length after which the gradient repeats; 0 if padded
    std::vector<piece> pieces_;         ///< the pieces of one period, without gaps
};

/// A tensor product patch with a colour at each corner, as in PDF shadings of type 7.
///
/// Shape:   points[row][column]: rows along v, columns along u. The member `colors` has the colours
///          at (u, v) = (0, 0), (1, 0), (0, 1), (1, 1). Between these corners, colours are
///          bilinear.
struct L3D_PUBLIC l3d_mesh_patch {
    std::array<std::array<l3d_point_2d, 4>, 4> points; ///< control points, in pixels
    std::array<std::uint32_t, 4> colors{};             ///< the colours at the corners, 0x00RRGGBB

    /// Makes a Coons patch, as in PDF shadings of type 6. Its inner control points follow from its
    /// borders.
    /// Shape:   control points around the patch, from (0, 0) along v = 0 to (1, 0), then to (1, 1),
    ///          (0, 1) and back.
    /// Source:  Coons 1967; as a tensor product patch: PDF Reference 1.7, section 4.6.3.
    static l3d_mesh_patch coons(const std::array<l3d_point_2d, 12>& around,
                                const std::array<std::uint32_t, 4>& colors);
};

#endif
