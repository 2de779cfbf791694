// SPDX-License-Identifier: MIT
// Exact rational B-splines of the kernel's curves and surfaces, and the change of parameters.
#ifndef L3D_PLUGINS_CAD_RATIONAL_H
#define L3D_PLUGINS_CAD_RATIONAL_H

#include <array>
#include <cstddef>
#include <vector>

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

namespace cad {

/// The largest degree of curves and surfaces in l3d.
inline constexpr int most_degree = 15;

/// Maps a parameter of the CAD kernel's curve to the parameter of the rational B-spline that is the
/// same curve.
///
/// The two parameters are equal, except for conics. The kernel's parameter of a circle is the
/// angle, that of a hyperbola the hyperbolic angle. A rational arc of the angles from -h to h has
/// the parameter h tan(angle / 2) / tan(h / 2); a hyperbola has tanh in place of tan. The two
/// parameters agree at the ends of arcs.
class parameter_map {
public:
    enum class kind { same, circular, hyperbolic };

    parameter_map() = default;
    /// Makes the map for a conic of several arcs. `ends` are the parameters at the arcs' ends, in
    /// order; all arcs have the same length.
    parameter_map(kind of, std::vector<double> ends) : kind_(of), ends_(std::move(ends)) {}

    /// The B-spline's parameter for the kernel's parameter s.
    double operator()(double s) const;
    /// The kernel's parameter for the B-spline's parameter t.
    double inverse(double t) const;
    /// The parameters where the map is not smooth.
    const std::vector<double>& ends() const { return ends_; }
    bool is_same() const { return kind_ == kind::same; }

    friend bool operator==(const parameter_map&, const parameter_map&) = default;

private:
    std::array<double, 2> arc(double at) const;

    kind kind_ = kind::same;
    std::vector<double> ends_;
};

/// The degree and knots along one direction of a clamped B-spline. Parameters run from the first
/// knot to the last. `map` turns the kernel's parameters into these parameters.
struct direction {
    int degree = 1;
    std::vector<double> knots;
    parameter_map map;

    double from() const { return knots.front(); }
    double to() const { return knots.back(); }
};

/// A control point: x, y, z and the weight. Coordinates are not multiplied by the weight.
using point = std::array<double, 4>;

struct rational_curve {
    direction along;
    std::vector<point> points;
    bool is_approximate = false; ///< whether the curve is approximated, to 1e-6 mm

    /// The same curve in the opposite direction.
    rational_curve reversed() const;
};

struct rational_surface {
    direction u, v;
    std::vector<point> points; ///< control points; the index along u changes fastest
    bool is_approximate = false;

    /// The same surface with u and v exchanged, so that its outside becomes its inside.
    rational_surface exchanged() const;
};

/// A rectangle in the plane of a surface's parameters u and v, as the kernel has them.
struct rectangle {
    double u0, u1, v0, v1;
};

/// The part of the kernel's curve between two parameters, as a rational B-spline. Curves that are
/// not rational, such as offsets, are approximated to 1e-6 mm: a tenth of the error that files
/// commonly allow.
/// Errors: throws Standard_Failure.
rational_curve rational_of(const Handle(Geom_Curve) & curve, double from, double to);

/// The part of the kernel's surface over a rectangle of its parameters, as a rational B-spline.
/// Parameters of periodic surfaces may begin anywhere.
/// Errors: as rational_of for a curve.
rational_surface rational_of(const Handle(Geom_Surface) & surface, const rectangle& bounds);

} // namespace cad

#endif
