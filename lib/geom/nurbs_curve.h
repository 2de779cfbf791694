// SPDX-License-Identifier: MIT
// l3d_nurbs_curve: a non-uniform rational B-spline curve.
#ifndef L3D_GEOM_NURBS_CURVE_H
#define L3D_GEOM_NURBS_CURVE_H

#include "base/public.h"
#include "geom/bspline_surface.h"
#include "geom/vector.h"

#include <cstddef>
#include <string>
#include <vector>

/// A place of a curve, with the first and second derivative by its parameter.
struct L3D_PUBLIC l3d_curve_jet {
    /// A place or a direction.
    using vector = l3d_vector<double, 3>;
    vector place{0.0, 0.0, 0.0}, ///< the point of the curve
        first{0.0, 0.0, 0.0},    ///< its derivative
        second{0.0, 0.0, 0.0};   ///< the derivative of that
};

/// A non-uniform rational B-spline curve of degree 1 to 15: clamped, unclamped or periodic.
///
/// Shape:  one knot direction, which says how many control points there are; weights are positive.
/// Source: Piegl and Tiller, The NURBS Book, chapters 3 to 5.
class L3D_PUBLIC l3d_nurbs_curve {
public:
    /// A place, or a control point.
    using vector = l3d_vector<double, 3>;

    /// A curve of these knots, control points and weights, which are all 1 if none are given.
    /// Errors: throws l3d_error(bad_input) with what complaint() says.
    l3d_nurbs_curve(l3d_bspline_direction along, std::vector<vector> points,
                    std::vector<double> weights = {});

    /// Straight lines from point to point. Errors: as the constructor: for fewer than two.
    static l3d_nurbs_curve polyline(std::vector<vector> points);

    /// A circle about the origin, exact: from the x axis towards the y axis, once around.
    /// Expects: radius > 0.
    static l3d_nurbs_curve circle(double radius);

    /// Why these make no curve, naming the value at fault; "" if they do.
    static std::string complaint(const l3d_bspline_direction& along,
                                 const std::vector<vector>& points,
                                 const std::vector<double>& weights);

    /// The knots.
    const l3d_bspline_direction& along() const { return along_; }
    /// The control points, along().points() of them.
    const std::vector<vector>& points() const { return points_; }
    /// Their weights, as many; none if all are 1.
    const std::vector<double>& weights() const { return weights_; }

    /// The weight of a control point. Expects: index < points().size().
    double weight(std::size_t index) const { return weights_.empty() ? 1 : weights_[index]; }

    /// The place at t. Expects: along().from <= t <= along().to.
    vector evaluate(double t) const;
    /// The place at t with its derivatives; at a knot, those of the span that begins there.
    /// Expects: as evaluate.
    l3d_curve_jet derivatives(double t) const;

    /// The same curve with the knot t once more.
    /// Errors: throws l3d_error(bad_input) if t is outside of the range, or there as often as the
    ///         degree says.
    l3d_nurbs_curve with_knot(double t) const;

private:
    l3d_vector<double, 4> homogeneous(std::size_t index) const;

    l3d_bspline_direction along_;
    std::vector<vector> points_;
    std::vector<double> weights_;
};

#endif
