// SPDX-License-Identifier: MIT
// NURBS curves and surfaces, and the surfaces made of curves.
#include "docs.h"
#include "types.h"

#include <l3d/error.h>

#include <numeric>

namespace python {

namespace {

std::vector<vector_3d> points_of(const number_array& array) {
    std::vector<vector_3d> result(array.size() / 3);
    array.copy_to(reinterpret_cast<double*>(result.data()), farthest);
    return result;
}

/// The knots that arguments say: given ones, or those of clamped or closed curves.
l3d_bspline_direction direction_of(const arguments& a, PyObject* degree, const char* degree_name,
                                   const char* knots_name, std::size_t points, bool is_closed) {
    const int of_degree =
        degree ? static_cast<int>(whole_of(degree, a.what(degree_name), 1, l3d_bpt_largest_degree))
               : 3;
    const auto n = static_cast<std::size_t>(of_degree);
    if (PyObject* given = a.find(knots_name)) {
        const number_array array(given, a.what(knots_name));
        array.expect({-1});
        l3d_bspline_direction result{of_degree, array.doubles(farthest), 0, 0};
        if (result.knots.size() != points + n + 1)
            throw value_error(a.what(knots_name) + ": " + std::to_string(points + n + 1) +
                              " are wanted, as many as points, degree and 1 together, not " +
                              std::to_string(result.knots.size()));
        if (points <= n)
            throw value_error(a.what(degree_name) +
                              ": it must be less than the number of points, " +
                              std::to_string(points));
        result.from = result.knots[n];
        result.to = result.knots[points];
        return result;
    }
    const std::size_t least = is_closed ? 2 * n + 1 : n + 1;
    if (points < least)
        throw value_error(a.what(degree_name) + ": a degree of " + std::to_string(n) + " needs " +
                          std::to_string(least) + " points at least, and there are " +
                          std::to_string(points));
    return is_closed ? l3d_bspline_direction::periodic(of_degree, points)
                     : l3d_bspline_direction::clamped(of_degree, points);
}

reference make_curve(arguments& a) {
    a.are("Curve", "points degree | knots weights closed");
    const number_array array(a.need("points"), a.what("points"));
    array.expect({-1, 3});
    std::vector<vector_3d> points = points_of(array);
    const bool is_closed = a.flag("closed", false);
    PyObject* degree = a.find("degree");
    if (is_closed) { // as smooth where it closes as elsewhere: the first points come again
        const auto n = static_cast<std::size_t>(
            degree ? whole_of(degree, a.what("degree"), 1, l3d_bpt_largest_degree) : 3);
        if (points.size() <= n)
            throw value_error(a.what("points") + ": more than " + std::to_string(n) +
                              " are wanted for a closed curve of this degree");
        for (std::size_t i = 0; i < n; ++i)
            points.push_back(points[i]);
    }
    std::vector<double> weights;
    if (PyObject* given = a.find("weights")) {
        weights = numbers_of(given, a.what("weights"), array.shape()[0], farthest);
        for (std::size_t i = 0; weights.size() < points.size(); ++i)
            weights.push_back(weights[i]);
    }
    const auto along = direction_of(a, degree, "degree", "knots", points.size(), is_closed);
    return made(l3d_nurbs_curve(along, std::move(points), std::move(weights)));
}

reference circle(arguments& a) {
    a.are("Curve.circle", "radius |");
    constexpr double least = 1e-12;
    return made(
        l3d_nurbs_curve::circle(number_of(a.need("radius"), a.what("radius"), least, farthest)));
}

reference polyline(arguments& a) {
    a.are("Curve.polyline", "points |");
    const number_array array(a.need("points"), a.what("points"));
    array.expect({-1, 3});
    return made(l3d_nurbs_curve::polyline(points_of(array)));
}

double parameter(const arguments& a, const char* name, const l3d_bspline_direction& of) {
    return number_of(a.need(name), a.what(name), of.from, of.to);
}

reference evaluate_curve(l3d_nurbs_curve& self, arguments& a) {
    a.are("Curve.evaluate", "t |");
    return numbers(self.evaluate(parameter(a, "t", self.along())));
}

reference make_surface(arguments& a) {
    a.are("Surface", "points degree_u degree_v | knots_u knots_v weights");
    const number_array array(a.need("points"), a.what("points"));
    array.expect({-1, -1, 3});
    const std::size_t rows = array.shape()[0], columns = array.shape()[1];
    std::vector<double> weights;
    if (PyObject* given = a.find("weights")) {
        const number_array of(given, a.what("weights"));
        of.expect({static_cast<int>(rows), static_cast<int>(columns)});
        weights = of.doubles(farthest);
    }
    const auto u = direction_of(a, a.find("degree_u"), "degree_u", "knots_u", columns, false);
    const auto v = direction_of(a, a.find("degree_v"), "degree_v", "knots_v", rows, false);
    return made(l3d_nurbs_surface(u, v, points_of(array), std::move(weights)));
}

reference evaluate_surface(l3d_nurbs_surface& self, arguments& a) {
    a.are("Surface.evaluate", "u v |");
    return numbers(self.evaluate(parameter(a, "u", self.u()), parameter(a, "v", self.v())));
}

reference range_of(const l3d_bspline_direction& of) {
    return numbers(std::array{of.from, of.to});
}
reference curve_range(const l3d_nurbs_curve& self) {
    return range_of(self.along());
}
reference surface_range_u(const l3d_nurbs_surface& self) {
    return range_of(self.u());
}
reference surface_range_v(const l3d_nurbs_surface& self) {
    return range_of(self.v());
}

template <class T, class... Shape> reference points_as_array(const T& self, Shape... shape) {
    auto keeps = std::make_shared<T>(self);
    const auto* first = reinterpret_cast<const double*>(keeps->points().data());
    return memory_of(array_view::of(std::move(keeps), first, {shape...}));
}
reference curve_points(const l3d_nurbs_curve& self) {
    return points_as_array(self, self.points().size(), std::size_t{3});
}
reference surface_points(const l3d_nurbs_surface& self) {
    return points_as_array(self, self.v().points(), self.u().points(), std::size_t{3});
}

} // namespace

reference revolved(arguments& a) {
    a.are("revolved", "curve |");
    return made(l3d_revolved(a.object<l3d_nurbs_curve>("curve")));
}

reference extruded(arguments& a) {
    a.are("extruded", "curve by |");
    return made(
        l3d_extruded(a.object<l3d_nurbs_curve>("curve"), vector_of(a.need("by"), a.what("by"))));
}

reference ruled(arguments& a) {
    a.are("ruled", "first second |");
    return made(l3d_ruled(a.object<l3d_nurbs_curve>("first"), a.object<l3d_nurbs_curve>("second")));
}

reference pipe(arguments& a) {
    a.are("pipe", "curve radius tolerance |");
    constexpr double least = 1e-12;
    const double radius = number_of(a.need("radius"), a.what("radius"), least, farthest);
    const double tolerance = a.number("tolerance", radius / 1000, least, farthest);
    return made(l3d_pipe_along(a.object<l3d_nurbs_curve>("curve"), radius, tolerance).surface);
}

reference shape(arguments& a) {
    a.are("shape", "name |");
    const std::string name = text_of(a.need("name"), a.what("name"));
    const auto surfaces = l3d_exact_shape(name);
    if (!surfaces) {
        const auto names = l3d_exact_shape_names();
        choice_of(a.need("name"), a.what("name"), names);
    }
    reference result = reference::taken(PyList_New(0));
    for (const l3d_nurbs_surface& surface : *surfaces)
        if (PyList_Append(result.get(), made(surface).get()) != 0)
            throw error_is_set();
    return result;
}

PyTypeObject* add_curve_type(PyObject* module) {
    using c = l3d_nurbs_curve;
    static PyMethodDef methods[] = {
        function<circle>("circle", doc("Curve.circle"), METH_STATIC),
        function<polyline>("polyline", doc("Curve.polyline"), METH_STATIC),
        method<c, evaluate_curve>("evaluate", doc("Curve.evaluate")),
        {}};
    static PyGetSetDef attributes[] = {attribute<c, curve_range>("range", doc("Curve.range")),
                                       attribute<c, curve_points>("points", doc("Curve.points")),
                                       {}};
    return new_type<c>(module, "l3d.Curve", doc("Curve"), methods, attributes,
                       {slot(Py_tp_new, construct<make_curve>)});
}

PyTypeObject* add_surface_type(PyObject* module) {
    using s = l3d_nurbs_surface;
    static PyMethodDef methods[] = {
        method<s, evaluate_surface>("evaluate", doc("Surface.evaluate")), {}};
    static PyGetSetDef attributes[] = {
        attribute<s, surface_range_u>("range_u", doc("Surface.range_u")),
        attribute<s, surface_range_v>("range_v", doc("Surface.range_v")),
        attribute<s, surface_points>("points", doc("Surface.points")),
        {}};
    return new_type<s>(module, "l3d.Surface", doc("Surface"), methods, attributes,
                       {slot(Py_tp_new, construct<make_surface>)});
}

} // namespace python
