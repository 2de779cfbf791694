// SPDX-License-Identifier: MIT
// l3d_nurbs_surface: a non-uniform rational B-spline surface.
#ifndef L3D_GEOM_NURBS_SURFACE_H
#define L3D_GEOM_NURBS_SURFACE_H

#include "base/public.h"
#include "geom/bspline_surface.h"
#include "geom/vector.h"

#include <cstddef>
#include <string>
#include <vector>

/// A place of a surface, with its derivatives by u and v up to the second.
struct L3D_PUBLIC l3d_surface_derivatives {
    /// A place or a direction.
    using vector = l3d_vector<double, 3>;
    vector place{0.0, 0.0, 0.0}, ///< the point of the surface
        by_u{0.0, 0.0, 0.0},     ///< its derivative by u
        by_v{0.0, 0.0, 0.0},     ///< its derivative by v
        by_uu{0.0, 0.0, 0.0},    ///< its second derivative by u
        by_uv{0.0, 0.0, 0.0},    ///< its derivative by u and v
        by_vv{0.0, 0.0, 0.0};    ///< its second derivative by v
};

/// A non-uniform rational B-spline surface of degrees 1 to 15: clamped, unclamped or periodic in
/// each direction.
///
/// Shape:  u.points() * v.points() control points, u fastest; weights are positive. The outside is
///         where dS/du x dS/dv points.
/// Source: Piegl and Tiller, The NURBS Book, chapters 3 to 5.
class L3D_PUBLIC l3d_nurbs_surface {
public:
    /// A place, or a control point.
    using vector = l3d_vector<double, 3>;

    /// A surface of these knots, control points and weights, which are all 1 if none are given.
    /// Errors: throws l3d_error(bad_input) with what complaint() says.
    l3d_nurbs_surface(l3d_bspline_direction u, l3d_bspline_direction v, std::vector<vector> points,
                      std::vector<double> weights = {});

    /// Why these make no surface, naming the value at fault; "" if they do.
    static std::string complaint(const l3d_bspline_direction& u, const l3d_bspline_direction& v,
                                 const std::vector<vector>& points,
                                 const std::vector<double>& weights);

    /// The knots along u.
    const l3d_bspline_direction& u() const { return u_; }
    /// The knots along v.
    const l3d_bspline_direction& v() const { return v_; }
    /// The control points, u fastest.
    const std::vector<vector>& points() const { return points_; }
    /// Their weights, as many; none if all are 1.
    const std::vector<double>& weights() const { return weights_; }

    /// The place at (u, v). Expects: u().from <= u <= u().to, and v alike.
    vector evaluate(double u, double v) const;
    /// The place at (u, v) with its derivatives; at a knot, those of the span that begins there.
    /// Expects: as evaluate.
    l3d_surface_derivatives derivatives(double u, double v) const;

    /// The same surface with a knot along u once more.
    /// Errors: throws l3d_error(bad_input) if it is outside of the range, or there as often as the
    ///         degree says.
    l3d_nurbs_surface with_knot_u(double u) const;
    /// The same surface with a knot along v once more. Errors: as with_knot_u.
    l3d_nurbs_surface with_knot_v(double v) const;

    /// The surface as Bezier patches (l3d_bezier_patches): what models are made of.
    std::vector<l3d_patch_points> pieces() const;

private:
    l3d_vector<double, 4> homogeneous(std::size_t column, std::size_t row) const;
    l3d_vector<double, 4> derivative(double u, double v, int by_u, int by_v) const;
    void append(const l3d_vector<double, 4>& p);

    l3d_bspline_direction u_, v_;
    std::vector<vector> points_;
    std::vector<double> weights_;
};

#endif
