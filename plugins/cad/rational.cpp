// SPDX-License-Identifier: MIT
// Turns conics into rational arcs, surfaces into turned or moved profiles, and keeps splines.
#include "rational.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <GeomAbs_Shape.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomConvert.hxx>
#include <GeomConvert_ApproxCurve.hxx>
#include <GeomConvert_ApproxSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_NumericError.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Elips.hxx>
#include <gp_Hypr.hxx>
#include <gp_Parab.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

namespace cad {

namespace {

constexpr double pi = std::numbers::pi;
/// The error of approximated curves, in millimetres: a tenth of the error that files commonly
/// allow. It is ten times the distance within which the CAD kernel considers points equal.
constexpr double approximation = 1e-6;
/// Knots that are nearer to each other than this share of the knots' range count as one knot.
constexpr double same_share = 1e-12;

/// The longest arc of a circle that becomes one rational piece, in radians. With this length,
/// weights are at least cos(45 degrees).
constexpr double longest_arc = pi / 2;
/// The longest arc of a hyperbola that becomes one rational piece, as a hyperbolic angle. With this
/// length, the middle weight is at most cosh(1).
constexpr double longest_hyperbolic_arc = 2;

std::vector<double> arc_ends(double from, double to, double longest) {
    // Rounding must not turn a range of four arcs into five.
    const int count = std::max(1, static_cast<int>(std::ceil((to - from) / longest - 1e-9)));
    std::vector<double> ends;
    ends.reserve(static_cast<std::size_t>(count) + 1);
    for (int i = 0; i < count; ++i)
        ends.push_back(from + (to - from) * i / count);
    ends.push_back(to);
    return ends;
}

/// The knots of a B-spline of quadratic arcs with these ends.
std::vector<double> arc_knots(const std::vector<double>& ends) {
    std::vector<double> knots{ends.front()};
    for (const double end : ends)
        knots.insert(knots.end(), 2, end);
    knots.push_back(ends.back());
    return knots;
}

point weighted(const gp_XYZ& p, double w) {
    return {p.X(), p.Y(), p.Z(), w};
}

gp_XYZ place(const point& p) {
    return {p[0], p[1], p[2]};
}

/// The conic centre + x cos s + y sin s, for s from `from` to `to`; a hyperbola has cosh and sinh
/// instead.
rational_curve conic(bool is_hyperbola, const gp_XYZ& centre, const gp_XYZ& x, const gp_XYZ& y,
                     double from, double to) {
    rational_curve result;
    const auto at = [&](double s, double middle) {
        const double c = is_hyperbola ? std::cosh(s) : std::cos(s),
                     d = is_hyperbola ? std::sinh(s) : std::sin(s);
        return centre + (x * c + y * d) / middle;
    };
    const auto ends = arc_ends(from, to, is_hyperbola ? longest_hyperbolic_arc : longest_arc);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double half = (ends[i + 1] - ends[i]) / 2;
        const double middle = is_hyperbola ? std::cosh(half) : std::cos(half);
        result.points.push_back(weighted(at(ends[i], 1), 1));
        result.points.push_back(weighted(at(ends[i] + half, middle), middle));
    }
    // A whole circle ends where it begins.
    const bool is_closed = !is_hyperbola && to - from == 2 * pi;
    result.points.push_back(weighted(at(is_closed ? from : to, 1), 1));
    result.along = {
        2,
        arc_knots(ends),
        {is_hyperbola ? parameter_map::kind::hyperbolic : parameter_map::kind::circular, ends}};
    return result;
}

rational_curve segment(const gp_XYZ& from, const gp_XYZ& to, double first, double last) {
    return {{1, {first, first, last, last}, {}}, {weighted(from, 1), weighted(to, 1)}};
}

std::vector<double> values(const TColStd_Array1OfReal& of) {
    return {of.begin(), of.end()};
}

rational_curve taken(Handle(Geom_BSplineCurve) spline, double from, double to) {
    spline = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
    if (!spline->IsPeriodic()) {
        from = std::max(from, spline->FirstParameter());
        to = std::min(to, spline->LastParameter());
    }
    const double near = same_share * (to - from);
    if (spline->IsPeriodic() || std::abs(spline->FirstParameter() - from) > near ||
        std::abs(spline->LastParameter() - to) > near)
        spline->Segment(from, to);
    if (spline->IsPeriodic())
        spline->SetNotPeriodic();
    rational_curve result;
    result.along = {spline->Degree(), values(spline->KnotSequence()), {}};
    for (int i = 1; i <= spline->NbPoles(); ++i)
        result.points.push_back(weighted(spline->Pole(i).XYZ(), spline->Weight(i)));
    // A periodic curve counts parameters from its own origin.
    const double shift = from - result.along.from();
    if (std::abs(shift) > near)
        for (double& knot : result.along.knots)
            knot += shift;
    return result;
}

rational_surface taken(Handle(Geom_BSplineSurface) spline, const rectangle& at) {
    spline = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    spline->Bounds(u0, u1, v0, v1);
    const auto is_all = [](double a, double b, double c, double d) {
        return std::abs(a - c) <= same_share * (d - c) && std::abs(b - d) <= same_share * (d - c);
    };
    if (spline->IsUPeriodic() || spline->IsVPeriodic() || !is_all(u0, u1, at.u0, at.u1) ||
        !is_all(v0, v1, at.v0, at.v1))
        spline->Segment(at.u0, at.u1, at.v0, at.v1);
    if (spline->IsUPeriodic())
        spline->SetUNotPeriodic();
    if (spline->IsVPeriodic())
        spline->SetVNotPeriodic();
    rational_surface result;
    result.u = {spline->UDegree(), values(spline->UKnotSequence()), {}};
    result.v = {spline->VDegree(), values(spline->VKnotSequence()), {}};
    for (int j = 1; j <= spline->NbVPoles(); ++j)
        for (int i = 1; i <= spline->NbUPoles(); ++i)
            result.points.push_back(weighted(spline->Pole(i, j).XYZ(), spline->Weight(i, j)));
    const auto shift = [](direction& d, double from, double to) {
        const double by = from - d.from();
        if (std::abs(by) > same_share * (to - from))
            for (double& knot : d.knots)
                knot += by;
    };
    shift(result.u, at.u0, at.u1);
    shift(result.v, at.v0, at.v1);
    return result;
}

/// The surface that a profile makes by turning about an axis. u is the angle, from u0 to u1.
rational_surface turned(rational_curve profile, const gp_XYZ& origin, const gp_XYZ& axis, double u0,
                        double u1) {
    const auto ends = arc_ends(u0, u1, longest_arc);
    rational_surface result;
    result.u = {2, arc_knots(ends), {parameter_map::kind::circular, ends}};
    result.v = std::move(profile.along);
    result.is_approximate = profile.is_approximate;
    for (const point& p : profile.points) {
        const gp_XYZ arm = place(p) - origin;
        const gp_XYZ foot = origin + axis * arm.Dot(axis);
        const gp_XYZ x = place(p) - foot, y = axis ^ x;
        for (const point& q : conic(false, foot, x, y, u0, u1).points)
            result.points.push_back({q[0], q[1], q[2], q[3] * p[3]});
    }
    return result;
}

/// The surface that a profile makes by moving along a vector `by`, from v0 times to v1 times the
/// vector.
rational_surface moved(const rational_curve& profile, const gp_XYZ& by, double v0, double v1) {
    rational_surface result{profile.along, {1, {v0, v0, v1, v1}, {}}, {}, profile.is_approximate};
    for (const double v : {v0, v1})
        for (const point& p : profile.points)
            result.points.push_back(weighted(place(p) + by * v, p[3]));
    return result;
}

/// A surface that turns about the axis of `position`. `profile` makes its profile in the plane of
/// the axis and x.
rational_surface around(const gp_Ax3& position, const rectangle& at,
                        rational_curve (*profile)(const GeomAdaptor_Surface&, const rectangle&),
                        const GeomAdaptor_Surface& surface) {
    // Left-handed systems turn in the opposite direction.
    const gp_XYZ axis = position.XDirection().XYZ() ^ position.YDirection().XYZ();
    return turned(profile(surface, at), position.Location().XYZ(), axis, at.u0, at.u1);
}

gp_XYZ meridian(const gp_Ax3& position, double from_axis, double along_axis) {
    return position.Location().XYZ() + position.XDirection().XYZ() * from_axis +
           position.Direction().XYZ() * along_axis;
}

rational_curve profile_of_cylinder(const GeomAdaptor_Surface& s, const rectangle& at) {
    const gp_Cylinder c = s.Cylinder();
    return segment(meridian(c.Position(), c.Radius(), at.v0),
                   meridian(c.Position(), c.Radius(), at.v1), at.v0, at.v1);
}

rational_curve profile_of_cone(const GeomAdaptor_Surface& s, const rectangle& at) {
    const gp_Cone c = s.Cone();
    const double sine = std::sin(c.SemiAngle()), cosine = std::cos(c.SemiAngle());
    const auto end = [&](double v) {
        return meridian(c.Position(), c.RefRadius() + v * sine, v * cosine);
    };
    return segment(end(at.v0), end(at.v1), at.v0, at.v1);
}

rational_curve meridian_circle(const gp_Ax3& position, double from_axis, double radius,
                               const rectangle& at) {
    return conic(false, meridian(position, from_axis, 0), position.XDirection().XYZ() * radius,
                 position.Direction().XYZ() * radius, at.v0, at.v1);
}

rational_curve profile_of_sphere(const GeomAdaptor_Surface& s, const rectangle& at) {
    return meridian_circle(s.Sphere().Position(), 0, s.Sphere().Radius(), at);
}

rational_curve profile_of_torus(const GeomAdaptor_Surface& s, const rectangle& at) {
    const gp_Torus t = s.Torus();
    return meridian_circle(t.Position(), t.MajorRadius(), t.MinorRadius(), at);
}

rational_surface plane(const gp_Pln& of, const rectangle& at) {
    const gp_XYZ o = of.Location().XYZ(), x = of.Position().XDirection().XYZ(),
                 y = of.Position().YDirection().XYZ();
    return moved(segment(o + x * at.u0, o + x * at.u1, at.u0, at.u1), y, at.v0, at.v1);
}

rational_surface approximated(const Handle(Geom_Surface) & surface, const rectangle& at) {
    const Handle(Geom_Surface) part =
        new Geom_RectangularTrimmedSurface(surface, at.u0, at.u1, at.v0, at.v1);
    constexpr int most_pieces = 200, passes = 1, degree = 8;
    const GeomConvert_ApproxSurface close(part, approximation, GeomAbs_C1, GeomAbs_C1, degree,
                                          degree, most_pieces, passes);
    if (!close.HasResult())
        throw Standard_NumericError("a surface has no B-spline near it");
    rational_surface result = taken(close.Surface(), at);
    result.is_approximate = true;
    return result;
}

std::vector<double> mirrored(const std::vector<double>& knots) {
    std::vector<double> result;
    for (auto knot = knots.rbegin(); knot != knots.rend(); ++knot)
        result.push_back(knots.front() + (knots.back() - *knot));
    return result;
}

} // namespace

std::array<double, 2> parameter_map::arc(double at) const {
    const auto above = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, at);
    return {*(above - 1), *above};
}

double parameter_map::operator()(double s) const {
    if (is_same())
        return s;
    const auto [a, b] = arc(s);
    const double half = (b - a) / 2, middle = a + half, x = (s - middle) / 2;
    return middle + half * (kind_ == kind::circular ? std::tan(x) / std::tan(half / 2)
                                                    : std::tanh(x) / std::tanh(half / 2));
}

double parameter_map::inverse(double t) const {
    if (is_same())
        return t;
    const auto [a, b] = arc(t);
    const double half = (b - a) / 2, middle = a + half, x = (t - middle) / half;
    return middle + 2 * (kind_ == kind::circular ? std::atan(x * std::tan(half / 2))
                                                 : std::atanh(x * std::tanh(half / 2)));
}

rational_curve rational_curve::reversed() const {
    rational_curve result = *this;
    std::ranges::reverse(result.points);
    result.along.knots = mirrored(along.knots);
    result.along.map = {};
    return result;
}

rational_surface rational_surface::exchanged() const {
    rational_surface result{v, u, {}, is_approximate};
    const std::size_t columns = u.knots.size() - static_cast<std::size_t>(u.degree) - 1;
    for (std::size_t i = 0; i < columns; ++i)
        for (std::size_t j = i; j < points.size(); j += columns)
            result.points.push_back(points[j]);
    return result;
}

rational_curve rational_of(const Handle(Geom_Curve) & curve, double from, double to) {
    const GeomAdaptor_Curve known(curve);
    switch (known.GetType()) {
    case GeomAbs_Line:
        return segment(known.Value(from).XYZ(), known.Value(to).XYZ(), from, to);
    case GeomAbs_Circle: {
        const gp_Ax2 p = known.Circle().Position();
        const double r = known.Circle().Radius();
        return conic(false, p.Location().XYZ(), p.XDirection().XYZ() * r, p.YDirection().XYZ() * r,
                     from, to);
    }
    case GeomAbs_Ellipse: {
        const gp_Elips e = known.Ellipse();
        return conic(false, e.Location().XYZ(), e.Position().XDirection().XYZ() * e.MajorRadius(),
                     e.Position().YDirection().XYZ() * e.MinorRadius(), from, to);
    }
    case GeomAbs_Hyperbola: {
        const gp_Hypr h = known.Hyperbola();
        return conic(true, h.Location().XYZ(), h.Position().XDirection().XYZ() * h.MajorRadius(),
                     h.Position().YDirection().XYZ() * h.MinorRadius(), from, to);
    }
    case GeomAbs_Parabola: {
        const gp_Parab p = known.Parabola();
        // The polar form of O + s^2 x / (4 f) + s y between the ends is the middle control point.
        const gp_XYZ middle = p.Location().XYZ() +
                              p.Position().XDirection().XYZ() * (from * to / (4 * p.Focal())) +
                              p.Position().YDirection().XYZ() * ((from + to) / 2);
        return {{2, {from, from, from, to, to, to}, {}},
                {weighted(known.Value(from).XYZ(), 1), weighted(middle, 1),
                 weighted(known.Value(to).XYZ(), 1)}};
    }
    case GeomAbs_BSplineCurve:
    case GeomAbs_BezierCurve: {
        const Handle(Geom_BSplineCurve) spline = known.GetType() == GeomAbs_BSplineCurve
                                                     ? known.BSpline()
                                                     : GeomConvert::CurveToBSplineCurve(curve);
        if (spline->Degree() <= most_degree)
            return taken(spline, from, to);
        break;
    }
    default:
        break;
    }
    constexpr int most_pieces = 200, degree = 9;
    const GeomConvert_ApproxCurve close(new Geom_TrimmedCurve(curve, from, to), approximation,
                                        GeomAbs_C1, most_pieces, degree);
    if (!close.HasResult())
        throw Standard_NumericError("a curve has no B-spline near it");
    rational_curve result = taken(close.Curve(), from, to);
    result.is_approximate = true;
    return result;
}

rational_surface rational_of(const Handle(Geom_Surface) & whole, const rectangle& at) {
    Handle(Geom_Surface) surface = whole;
    while (surface->IsKind(STANDARD_TYPE(Geom_RectangularTrimmedSurface)))
        surface = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)->BasisSurface();
    const GeomAdaptor_Surface known(surface);
    switch (known.GetType()) {
    case GeomAbs_Plane:
        return plane(known.Plane(), at);
    case GeomAbs_Cylinder:
        return around(known.Cylinder().Position(), at, profile_of_cylinder, known);
    case GeomAbs_Cone:
        return around(known.Cone().Position(), at, profile_of_cone, known);
    case GeomAbs_Sphere:
        return around(known.Sphere().Position(), at, profile_of_sphere, known);
    case GeomAbs_Torus:
        return around(known.Torus().Position(), at, profile_of_torus, known);
    case GeomAbs_SurfaceOfRevolution: {
        const auto of = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
        if (!of.IsNull())
            return turned(rational_of(of->BasisCurve(), at.v0, at.v1), of->Location().XYZ(),
                          of->Direction().XYZ(), at.u0, at.u1);
        break;
    }
    case GeomAbs_SurfaceOfExtrusion: {
        const auto of = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface);
        if (!of.IsNull())
            return moved(rational_of(of->BasisCurve(), at.u0, at.u1), of->Direction().XYZ(), at.v0,
                         at.v1);
        break;
    }
    case GeomAbs_BSplineSurface:
    case GeomAbs_BezierSurface: {
        const Handle(Geom_BSplineSurface) spline =
            known.GetType() == GeomAbs_BSplineSurface
                ? known.BSpline()
                : GeomConvert::SurfaceToBSplineSurface(known.Bezier());
        if (spline->UDegree() <= most_degree && spline->VDegree() <= most_degree)
            return taken(spline, at);
        break;
    }
    default:
        break;
    }
    return approximated(surface, at);
}

} // namespace cad
