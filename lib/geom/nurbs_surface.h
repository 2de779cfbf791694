// SPDX-License-Identifier: MIT
// l3d_nurbs_surface and l3d_nurbs_curve: non-uniform rational B-splines, B-spline surfaces, and the
// shapes made of them.
#ifndef L3D_GEOM_NURBS_SURFACE_H
#define L3D_GEOM_NURBS_SURFACE_H

#include "base/public.h"
#include "geom/vector.h"
#include "geom/files/patch_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The knots of a B-spline along a curve, or along u or v of a surface, and the range of the
/// parameter that is used.
///
/// Shape: the number of control points along this direction is points(). Knots do not decrease, and
///        knots[degree] <= from < to <= knots[points()].
struct L3D_PUBLIC l3d_bspline_direction {
    int degree = 0; ///< degree of the polynomials between knots; 3 for cubic ones
    /// Parameters where the polynomials meet; a knot of multiplicity m is listed m times.
    std::vector<double> knots;
    /// The range of the parameter: the curve or surface consists of the points within this range.
    double from = 0, to = 0;

    friend bool operator==(const l3d_bspline_direction&, const l3d_bspline_direction&) = default;

    /// The number of control points along this direction.
    std::size_t points() const { return knots.size() - static_cast<std::size_t>(degree) - 1; }

    /// The number of spans between different knots within [from, to]. Each span is a Bezier segment
    /// along this direction.
    std::size_t segments() const;

    /// The error message for an invalid direction; "" if it is valid. Degrees are from 1 to
    /// l3d_bpt_largest_degree. Knots are finite, of magnitude at most 1e12, and do not decrease. No
    /// knot between the ends is listed more than `degree` times, since the surface would be torn
    /// there. [from, to] lies within the knots that have enough control points.
    std::string complaint() const;

    /// Clamped, uniform knots for `points` control points: the curve begins at the first control
    /// point and ends at the last. The parameter runs from 0 to 1.
    /// Expects: points > degree >= 1.
    static l3d_bspline_direction clamped(int degree, std::size_t points);

    /// Periodic, uniform knots for a closed curve, which is as smooth at its seam as elsewhere. Its
    /// last `degree` control points must repeat its first ones; `points` counts both. The parameter
    /// runs from 0 to 1.
    /// Expects: points >= 2 degree + 1, degree >= 1.
    static l3d_bspline_direction periodic(int degree, std::size_t points);
};

/// Divides a B-spline surface into Bezier patches, in order along u first, then v. Up to rounding,
/// the patches together are the same surface.
///
/// Control points that are Bezier points already, as their knots have full multiplicity, keep their
/// bits. Neighbouring patches have the same points, bit for bit, on their boundary.
/// Shape:   points: u.points() * v.points(), u fastest; weights: as many, or none if all are 1.
///          Both directions have at least one segment.
/// Expects: positive weights, degrees from 1 to l3d_bpt_largest_degree, directions as
///          l3d_bspline_direction expects.
/// Cost:    the square of a degree per control point and patch.
/// Source:  Ramshaw, Blossoming: A Connect-the-Dots Approach to Splines, 1987. The Bezier point i
///          of the span [a, b] is the blossom of n - i arguments a and i arguments b. The same
///          points result if both knots are inserted to full multiplicity.
L3D_PUBLIC std::vector<l3d_patch_points>
l3d_bezier_patches(const l3d_bspline_direction& u, const l3d_bspline_direction& v,
                   const std::vector<std::array<double, 3>>& points,
                   std::span<const double> weights = {});

/// A place of a surface, with the surface's first and second derivatives by u and v.
struct L3D_PUBLIC l3d_surface_derivatives {
    /// A place or a direction.
    using vector = l3d_vector<double, 3>;
    vector place{0.0, 0.0, 0.0}, ///< the point of the surface
        by_u{0.0, 0.0, 0.0},     ///< the surface's derivative by u
        by_v{0.0, 0.0, 0.0},     ///< the surface's derivative by v
        by_uu{0.0, 0.0, 0.0},    ///< the surface's second derivative by u
        by_uv{0.0, 0.0, 0.0},    ///< the surface's derivative by u and v
        by_vv{0.0, 0.0, 0.0};    ///< the surface's second derivative by v
};

/// A non-uniform rational B-spline surface of degrees 1 to 15: clamped, unclamped or periodic in
/// each direction.
///
/// Shape:  u.points() * v.points() control points, u fastest; weights are from 1e-100 to
///         1e12. The outside is where dS/du x dS/dv points.
/// Source: Piegl and Tiller, The NURBS Book, chapters 3 to 5.
class L3D_PUBLIC l3d_nurbs_surface {
public:
    /// A place, or a control point.
    using vector = l3d_vector<double, 3>;

    /// A surface of these knots, control points and weights. All weights are 1 if none are given.
    /// Errors: throws l3d_error(bad_input) with the text of complaint().
    l3d_nurbs_surface(l3d_bspline_direction u, l3d_bspline_direction v, std::vector<vector> points,
                      std::vector<double> weights = {});

    /// A patch as a surface: one span along u and v, each parameter from 0 to 1. The surface's
    /// pieces() give the same patch, bit for bit.
    /// Errors: as the constructor.
    static l3d_nurbs_surface of_patch(const l3d_patch_points& patch);

    /// The error message for an invalid surface, naming the value at fault; "" if it is valid.
    static std::string complaint(const l3d_bspline_direction& u, const l3d_bspline_direction& v,
                                 const std::vector<vector>& points,
                                 const std::vector<double>& weights);

    /// The knots along u.
    const l3d_bspline_direction& u() const { return u_; }
    /// The knots along v.
    const l3d_bspline_direction& v() const { return v_; }
    /// The control points, u fastest.
    const std::vector<vector>& points() const { return points_; }
    /// The weights of the control points, in their order; empty if all are 1.
    const std::vector<double>& weights() const { return weights_; }

    /// The loops in (u, v) that trim the surface, as in l3d_patch_points. None if the surface is
    /// whole.
    const std::vector<l3d_trim_loop>& trims() const { return trims_; }
    /// The same surface, trimmed by these loops instead of its own. l3d_trim_loop_of makes a loop
    /// from curves.
    ///
    /// On a surface that closes on itself, loops may cross the seam where it closes. A curve may
    /// end at one side of the parameters where the next begins at the other, and curves may go on
    /// beyond the parameters. Loops that go around keep the part on their left, seen from outside.
    /// The result's trims() are closed loops in the plane of u and v.
    /// Errors: throws l3d_error(bad_input) with the text of l3d_trims_complaint(), and for loops
    ///         that go around twice, or both ways.
    l3d_nurbs_surface trimmed(std::span<const l3d_trim_loop> loops) const;

    /// Moves a control point, and sets its weight. Other points keep their weights. If the surface
    /// had no weights, the others get 1.
    ///
    /// Expects: an index of points(), finite coordinates of magnitude at most 1e12, and a weight
    ///          from 1e-100 to 1e12.
    void set_point(std::size_t index, const vector& place, double weight);

    /// The place at (u, v). Expects: u().from <= u <= u().to, and v alike.
    vector evaluate(double u, double v) const;
    /// The place at (u, v), and the derivatives there. At a knot, the derivatives are those of the
    /// span that begins at the knot.
    /// Expects: as evaluate.
    l3d_surface_derivatives derivatives(double u, double v) const;

    /// The same surface with one more knot u along u.
    /// Errors: throws l3d_error(bad_input) if the knot is outside of the range, or is listed
    ///         `degree` times already.
    l3d_nurbs_surface with_knot_u(double u) const;
    /// The same surface with one more knot v along v. Errors: as with_knot_u.
    l3d_nurbs_surface with_knot_v(double v) const;

    /// The surface as Bezier patches, the pieces that models are made of (l3d_bezier_patches).
    std::vector<l3d_patch_points> pieces() const;

private:
    l3d_vector<double, 4> homogeneous(std::size_t column, std::size_t row) const;
    l3d_vector<double, 4> derivative(double u, double v, int by_u, int by_v) const;
    void append(const l3d_vector<double, 4>& p);

    l3d_bspline_direction u_, v_;
    std::vector<vector> points_;
    std::vector<double> weights_;
    std::vector<l3d_trim_loop> trims_;
};

/// A point of a curve, with the curve's first and second derivatives by its parameter.
struct L3D_PUBLIC l3d_curve_jet {
    /// A place or a direction.
    using vector = l3d_vector<double, 3>;
    vector place{0.0, 0.0, 0.0}, ///< the point of the curve
        first{0.0, 0.0, 0.0},    ///< the curve's derivative
        second{0.0, 0.0, 0.0};   ///< the curve's second derivative
};

/// A non-uniform rational B-spline curve of degree 1 to 15: clamped, unclamped or periodic.
///
/// Shape:  one knot direction, which says how many control points there are; weights are from
///         1e-100 to 1e12.
/// Source: Piegl and Tiller, The NURBS Book, chapters 3 to 5.
class L3D_PUBLIC l3d_nurbs_curve {
public:
    /// A place, or a control point.
    using vector = l3d_vector<double, 3>;

    /// A curve of these knots, control points and weights. All weights are 1 if none are given.
    /// Errors: throws l3d_error(bad_input) with the text of complaint().
    l3d_nurbs_curve(l3d_bspline_direction along, std::vector<vector> points,
                    std::vector<double> weights = {});

    /// The curve of degree 1 that runs straight from point to point.
    /// Errors: as the constructor, for fewer than two points.
    static l3d_nurbs_curve polyline(std::vector<vector> points);

    /// A circle about the origin, exact: from the x axis towards the y axis, once around.
    /// Expects: radius > 0.
    static l3d_nurbs_curve circle(double radius);

    /// The error message for an invalid curve, naming the value at fault; "" if it is valid.
    static std::string complaint(const l3d_bspline_direction& along,
                                 const std::vector<vector>& points,
                                 const std::vector<double>& weights);

    /// The knots, and the range of the parameter.
    const l3d_bspline_direction& along() const { return along_; }
    /// The control points, along().points() of them.
    const std::vector<vector>& points() const { return points_; }
    /// The weights of the control points, in their order; empty if all are 1.
    const std::vector<double>& weights() const { return weights_; }

    /// The weight of a control point. Expects: index < points().size().
    double weight(std::size_t index) const { return weights_.empty() ? 1 : weights_[index]; }

    /// The place at t. Expects: along().from <= t <= along().to.
    vector evaluate(double t) const;
    /// The place at t, and the derivatives there. At a knot, the derivatives are those of the span
    /// that begins at the knot.
    /// Expects: as evaluate.
    l3d_curve_jet derivatives(double t) const;

    /// The same curve with one more knot t.
    /// Errors: throws l3d_error(bad_input) if t is outside of the range, or is listed `degree`
    ///         times already.
    l3d_nurbs_curve with_knot(double t) const;

    friend bool operator==(const l3d_nurbs_curve&, const l3d_nurbs_curve&) = default;

private:
    l3d_vector<double, 4> homogeneous(std::size_t index) const;

    l3d_bspline_direction along_;
    std::vector<vector> points_;
    std::vector<double> weights_;
};

/// The edge that a curve of a loop follows, and the edge's parameters at the curve's ends.
struct L3D_PUBLIC l3d_edge_use {
    std::uint32_t edge = l3d_no_edge; ///< the edge's index in the model; l3d_no_edge for none
    /// The parameters of the edge at along().from and along().to of the curve.
    double from = 0, to = 1;
};

/// Makes a loop of curves that follow each other. The curves' x and y are u and v; z is ignored.
/// Shape: `edges` has an entry for each curve, or is empty.
L3D_PUBLIC l3d_trim_loop l3d_trim_loop_of(std::span<const l3d_nurbs_curve> curves,
                                          std::span<const l3d_edge_use> edges = {});

/// The exact surface that a curve makes as it turns once around the y axis.
///
/// Shape: u runs around the axis, v along the curve. A curve beside the axis that runs upwards
///        makes a surface whose outside is away from the axis.
L3D_PUBLIC l3d_nurbs_surface l3d_revolved(const l3d_nurbs_curve& curve);

/// The exact surface that a curve sweeps as it moves straight along the vector `by`.
/// Shape: u runs along the curve, v along the vector.
/// Errors: throws l3d_error(bad_input) where a moved control point is beyond 1e12.
L3D_PUBLIC l3d_nurbs_surface l3d_extruded(const l3d_nurbs_curve& curve,
                                          const l3d_vector<double, 3>& by);

/// The exact surface of all lines that join points of two curves at the same parameter.
///
/// Shape:  u runs along the curves, v from the first to the second.
/// Errors: throws l3d_error(bad_input) for curves of different degrees or ranges of the parameter.
L3D_PUBLIC l3d_nurbs_surface l3d_ruled(l3d_nurbs_curve first, l3d_nurbs_curve second);

/// A surface that approximates a pipe along a curve, and its measured error.
struct L3D_PUBLIC l3d_pipe {
    l3d_nurbs_surface surface; ///< u runs around the curve, v along it
    /// The largest distance of the surface's points from the exact circles. This distance is
    /// measured at 9 places along each span and 8 around, not proven.
    double measured = 0;
};

/// Makes a pipe along a curve: circles around it, each perpendicular to the curve. An exact pipe is
/// not a NURBS surface. The result has exact circles at the ends of its spans; the circles' centres
/// and axes are cubic along the curve.
///
/// Expects: a curve whose first derivative vanishes nowhere; radius and tolerance > 0.
/// Errors:  throws l3d_error(bad_input) if 1024 spans do not keep the tolerance.
L3D_PUBLIC l3d_pipe l3d_pipe_along(const l3d_nurbs_curve& curve, double radius, double tolerance);

/// A sphere of radius 1 about the origin, poles on the y axis.
L3D_PUBLIC std::vector<l3d_nurbs_surface> l3d_sphere_surfaces();
/// A cylinder of radius 1 around the y axis, from y = -1 to 1, closed by discs.
L3D_PUBLIC std::vector<l3d_nurbs_surface> l3d_cylinder_surfaces();
/// A cone around the y axis, closed: radius 1 at y = -1, tip at y = 1.
L3D_PUBLIC std::vector<l3d_nurbs_surface> l3d_cone_surfaces();
/// A torus around the y axis: radius 1 to the middle of the tube, whose radius is 0.4.
L3D_PUBLIC std::vector<l3d_nurbs_surface> l3d_torus_surfaces();
/// A disc of radius 1 about the origin, whose front faces along the y axis.
L3D_PUBLIC std::vector<l3d_nurbs_surface> l3d_disc_surfaces();

/// The names of the five exact shapes above: cone, cylinder, disc, sphere, torus.
L3D_PUBLIC std::vector<std::string_view> l3d_exact_shape_names();
/// The exact shape of this name; nothing if there is none.
L3D_PUBLIC std::optional<std::vector<l3d_nurbs_surface>> l3d_exact_shape(std::string_view name);

#endif
