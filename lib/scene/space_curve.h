// SPDX-License-Identifier: MIT
// l3d_space_curve: a curve or a polyline in space, to be drawn as a line of some width.
#ifndef L3D_SCENE_SPACE_CURVE_H
#define L3D_SCENE_SPACE_CURVE_H

#include "base/color.h"
#include "base/public.h"
#include "geom/matrix.h"
#include "geom/nurbs_surface.h"
#include "geom/vector.h"

#include <cstdint>
#include <vector>

/// A NURBS curve in space, to be drawn as a line of some colour and width at some place.
/// l3d_pipeline_afd::curves() draws such curves.
///
/// For straight lines from point to point, give it an l3d_nurbs_curve::polyline. A Bezier curve of
/// n + 1 points has the knots l3d_bspline_direction::clamped(n, n + 1).
class L3D_PUBLIC l3d_space_curve {
public:
    /// The widest line, in pixels.
    static constexpr double most_width = 1000;

    /// A line along this curve, at the curve's own place.
    /// Units:  `color` is a pixel word, 0x00RRGGBB; `width` is in pixels, whatever the distance.
    /// Errors: throws l3d_error(bad_input) if the width is not above 0 and at most most_width.
    explicit l3d_space_curve(const l3d_nurbs_curve& curve, l3d_color color = 0x00ffffff,
                             double width = 1);

    /// A line like this one at another place. The placement takes the curve's points to the world.
    /// Errors: throws l3d_error(bad_input) if a number of the placement is not finite, or if its
    ///         last row is not 0, 0, 0, 1.
    l3d_space_curve placed(const l3d_matrix<double>& placement) const;

    /// The colour, 0x00RRGGBB.
    l3d_color color() const { return color_; }
    /// The width in pixels.
    double width() const { return width_; }
    /// The matrix from the curve's space to the world.
    const l3d_matrix<double>& placement() const { return placement_; }

    /// The homogeneous control points of a Bezier curve: x w, y w, z w and the weight w.
    using bezier = std::vector<l3d_vector<double, 4>>;
    /// The curve as Bezier curves from knot to knot, in its own space.
    const std::vector<bezier>& spans() const { return spans_; }

private:
    std::vector<bezier> spans_;
    std::uint32_t color_;
    double width_;
    l3d_matrix<double> placement_ = l3d_identity<double>();
};

#endif
