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

/// Maps a parameter of the kernel to the parameter of the rational B-spline for the same curve.
///
/// Both are equal, except for conics. The kernel's parameter of a circle is the angle, that of a
/// hyperbola its hyperbolic angle. A rational arc of the angles from -h to h has the parameter
/// h tan(angle / 2) / tan(h / 2), or tanh for a hyperbola. Both agree at the arcs' ends.
class parameter_map {
public:
    enum class kind { same, circular, hyperbolic };

    parameter_map() = default;
    /// `ends`: the ends of the arcs, in order; all arcs have the same length.
    parameter_map(kind of, std::vector<double> ends) : kind_(of), ends_(std::move(ends)) {}

    /// The B-spline's parameter.
    double operator()(double s) const;
    /// The kernel's parameter.
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

/// A direction of a clamped B-spline.
struct direction {
    int degree = 1;
    std::vector<double> knots;
    parameter_map map;

    double from() const { return knots.front(); }
    double to() const { return knots.back(); }
};

/// A control point: x, y, z and the weight. The coordinates are not multiplied by the weight.
using point = std::array<double, 4>;

struct rational_curve {
    direction along;
    std::vector<point> points;
    bool is_approximate = false; ///< to within curve_tolerance

    /// The same curve in reverse.
    rational_curve reversed() const;
};

struct rational_surface {
    direction u, v;
    std::vector<point> points; ///< u fastest
    bool is_approximate = false;

    /// The same surface with u and v exchanged, so its outside is the other side.
    rational_surface exchanged() const;
};

/// A rectangle of the kernel's parameters.
struct rectangle {
    double u0, u1, v0, v1;
};

/// The curve between two parameters. Curves that are not rational, such as offsets, are
/// approximated to 1e-6 mm: a tenth of the error that files commonly allow.
/// Errors: throws Standard_Failure.
rational_curve rational_of(const Handle(Geom_Curve) & curve, double from, double to);

/// The surface over a rectangle. Parameters of periodic surfaces may begin anywhere.
/// Errors: as rational_of of a curve.
rational_surface rational_of(const Handle(Geom_Surface) & surface, const rectangle& bounds);

} // namespace cad

#endif
