// SPDX-License-Identifier: MIT
// Paths, gradients and fonts.
#include "docs.h"
#include "types.h"

#include <l3d/placement_2d.h>

#include <fstream>

namespace python {

namespace {

// ---- paths --------------------------------------------------------------------------------------

reference make_path(arguments& a) {
    a.are("Path", "");
    return made(l3d_path());
}

reference move_to(l3d_path& self, arguments& a) {
    a.are("Path.move_to", "to |");
    self.move_to(a.point("to"));
    return a.self();
}
reference line_to(l3d_path& self, arguments& a) {
    a.are("Path.line_to", "to |");
    self.line_to(a.point("to"));
    return a.self();
}
reference quadratic_to(l3d_path& self, arguments& a) {
    a.are("Path.quadratic_to", "control to |");
    const l3d_point_2d control = a.point("control");
    self.quadratic_to(control, a.point("to"));
    return a.self();
}
reference cubic_to(l3d_path& self, arguments& a) {
    a.are("Path.cubic_to", "first second to |");
    const l3d_point_2d first = a.point("first"), second = a.point("second");
    self.cubic_to(first, second, a.point("to"));
    return a.self();
}
reference arc_to(l3d_path& self, arguments& a) {
    a.are("Path.arc_to", "center radii begin sweep turn |");
    const l3d_point_2d center = a.point("center"), radii = a.point("radii");
    const double begin = number_of(a.need("begin"), a.what("begin"), -most_degrees, most_degrees);
    const double sweep = number_of(a.need("sweep"), a.what("sweep"), -most_degrees, most_degrees);
    self.arc_to(center, radii, a.number("turn", 0, -most_degrees, most_degrees), begin, sweep);
    return a.self();
}
reference close(l3d_path& self, arguments& a) {
    a.are("Path.close", "");
    self.close();
    return a.self();
}
reference add_circle(l3d_path& self, arguments& a) {
    a.are("Path.add_circle", "center radius |");
    const l3d_point_2d center = a.point("center");
    self.add_circle(center, number_of(a.need("radius"), a.what("radius"), 0, farthest_pixel));
    return a.self();
}
reference add_box(l3d_path& self, arguments& a) {
    a.are("Path.add_box", "left top right bottom |");
    const auto side = [&](const char* name) {
        return static_cast<std::int32_t>(whole_of(a.need(name), a.what(name), -(1 << 30), 1 << 30));
    };
    self.add_box({side("left"), side("top"), side("right"), side("bottom")});
    return a.self();
}

std::vector<l3d_point_2d> points_of(const arguments& a) {
    const number_array array(a.need("points"), a.what("points"));
    array.expect({-1, 2});
    static_assert(sizeof(l3d_point_2d) == 2 * sizeof(double));
    std::vector<l3d_point_2d> result(array.shape()[0]);
    array.copy_to(reinterpret_cast<double*>(result.data()), farthest_pixel);
    return result;
}
reference add_polygon(l3d_path& self, arguments& a) {
    a.are("Path.add_polygon", "points |");
    self.add_polygon(points_of(a));
    return a.self();
}
reference add_lines(l3d_path& self, arguments& a) {
    a.are("Path.add_lines", "points |");
    bool is_first = true;
    for (const l3d_point_2d p : points_of(a))
        std::exchange(is_first, false) ? self.move_to(p) : self.line_to(p);
    return a.self();
}

/// A scale, a turn and a move, one after the other.
l3d_placement_2d placement_of(const arguments& a) {
    l3d_point_2d at{0, 0};
    a.read("at", at, point_of);
    const double scale = a.number("scale", 1, 1 / farthest_pixel, farthest_pixel);
    return l3d_placement_2d::scaled(scale, scale)
        .then(l3d_placement_2d::turned(a.number("turn", 0, -most_degrees, most_degrees)))
        .then(l3d_placement_2d::moved(at.x, at.y));
}
reference add(l3d_path& self, arguments& a) {
    a.are("Path.add", "path | at turn scale");
    const l3d_path other = a.object<l3d_path>("path"); // which may be this one
    self.add(other, placement_of(a));
    return a.self();
}

reference stroked(l3d_path& self, arguments& a) {
    a.are("Path.stroked", "width | cap join miter_limit dashes dash_begin");
    l3d_stroke pen;
    pen.width = a.number("width", pen.width, 0, farthest_pixel);
    read_choice(a, "cap", pen.cap, cap_names);
    read_choice(a, "join", pen.join, join_names);
    pen.miter_limit = a.number("miter_limit", pen.miter_limit, 0, farthest_pixel);
    if (PyObject* value = a.find("dashes")) {
        const number_array array(value, a.what("dashes"));
        array.expect({-1});
        pen.dashes = array.doubles(farthest_pixel);
        constexpr double least = 1e-3; // that l3d_stroked takes
        double sum = 0;
        for (const double length : pen.dashes) {
            if (length < 0)
                throw value_error(a.what("dashes") + ": a length is negative");
            sum += length;
        }
        if (sum < least && !pen.dashes.empty())
            throw value_error(a.what("dashes") + ": all together must be 1/1000 pixel or more");
    }
    pen.dash_begin = a.number("dash_begin", 0, -farthest_pixel, farthest_pixel);
    return made(l3d_stroked(self, pen));
}

reference copy(l3d_path& self, arguments& a) {
    a.are("Path.copy", "");
    return made(self);
}
reference is_empty(const l3d_path& self) {
    return flag(self.empty());
}

// ---- gradients ----------------------------------------------------------------------------------

std::vector<l3d_color_stop> stops_of(const arguments& a) {
    PyObject* given = a.need("stops");
    const std::string what = a.what("stops");
    if (PySequence_Check(given) == 0 || PyUnicode_Check(given))
        throw type_error(what + ": a list of tuples (at, color) is wanted, not " + shown(given));
    std::vector<l3d_color_stop> result;
    for (Py_ssize_t i = 0; i < PySequence_Size(given); ++i) {
        const reference stop = reference::taken(PySequence_GetItem(given, i));
        if (!PyTuple_Check(stop.get()) || PyTuple_Size(stop.get()) < 2 ||
            PyTuple_Size(stop.get()) > 3)
            throw type_error(what + ": a tuple (at, color) or (at, color, alpha) is wanted, not " +
                             shown(stop.get()));
        l3d_color_stop& to = result.emplace_back();
        to.at = number_of(PyTuple_GetItem(stop.get(), 0), what, 0, 1);
        to.color = color_of(PyTuple_GetItem(stop.get(), 1), what);
        if (PyTuple_Size(stop.get()) == 3)
            to.alpha = number_of(PyTuple_GetItem(stop.get(), 2), what, 0, 1);
        if (result.size() > 1 && to.at < result[result.size() - 2].at)
            throw value_error(what + ": they must be in the order of their places");
    }
    if (result.empty())
        throw value_error(what + ": there are none");
    return result;
}

reference linear(arguments& a) {
    a.are("Gradient.linear", "from_ to stops spread |");
    const l3d_point_2d from = a.point("from_"), to = a.point("to");
    if (from.x == to.x && from.y == to.y)
        throw value_error(a.what("to") + ": it must be another place than the first");
    l3d_spread spread = l3d_spread::pad;
    read_choice(a, "spread", spread, spread_names);
    return made(l3d_gradient::linear(from, to, stops_of(a), spread));
}

reference radial(arguments& a) {
    a.are("Gradient.radial", "center radius stops focus spread |");
    const l3d_point_2d center = a.point("center");
    const double radius =
        number_of(a.need("radius"), a.what("radius"), 1 / farthest_pixel, farthest_pixel);
    l3d_point_2d focus = center;
    a.read("focus", focus, point_of);
    l3d_spread spread = l3d_spread::pad;
    read_choice(a, "spread", spread, spread_names);
    return made(l3d_gradient::radial(center, radius, focus, stops_of(a), spread));
}

// ---- fonts --------------------------------------------------------------------------------------

reference make_font(arguments& a) {
    a.are("Font", "file |");
    if (!a.find("file"))
        return made(l3d_font());
    const std::string file = path_of(a.need("file"), a.what("file"));
    std::string why;
    const auto font = l3d_font::load(file, why);
    if (!font)
        throw file_failure{file, why, !std::ifstream(file).good()};
    return made(*font);
}

reference of_system(arguments& a) {
    a.are("Font.system", "");
    std::string why; // the built-in face is as good as none
    return made(l3d_font::of_system(why));
}

reference width(l3d_font& self, arguments& a) {
    a.are("Font.width", "text size |");
    return number(std::int64_t{self.width(text_of(a.need("text"), a.what("text")), letters_of(a))});
}
reference line(l3d_font& self, arguments& a) {
    a.are("Font.line", "size |");
    return number(std::int64_t{self.line(letters_of(a))});
}
reference outline(l3d_font& self, arguments& a) {
    a.are("Font.outline", "text size at |");
    constexpr double least = 1e-3;
    const double size = a.number("size", 14, least, farthest_pixel);
    l3d_point_2d base{0, 0};
    a.read("at", base, point_of);
    l3d_path result;
    self.outline(result, base, text_of(a.need("text"), a.what("text")), size);
    return made(std::move(result));
}
reference font_name(const l3d_font& self) {
    return text(self.name());
}

} // namespace

int letters_of(const arguments& a) {
    constexpr int largest = 4096, usual = 14; // pixels; a letter takes its square in bytes
    PyObject* value = a.find("size");
    return value ? static_cast<int>(whole_of(value, a.what("size"), 1, largest)) : usual;
}

PyTypeObject* add_path_type(PyObject* module) {
    using p = l3d_path;
    static PyMethodDef methods[] = {
        method<p, move_to>("move_to", doc("Path.move_to")),
        method<p, line_to>("line_to", doc("Path.line_to")),
        method<p, quadratic_to>("quadratic_to", doc("Path.quadratic_to")),
        method<p, cubic_to>("cubic_to", doc("Path.cubic_to")),
        method<p, arc_to>("arc_to", doc("Path.arc_to")),
        method<p, close>("close", doc("Path.close")),
        method<p, add_circle>("add_circle", doc("Path.add_circle")),
        method<p, add_box>("add_box", doc("Path.add_box")),
        method<p, add_polygon>("add_polygon", doc("Path.add_polygon")),
        method<p, add_lines>("add_lines", doc("Path.add_lines")),
        method<p, add>("add", doc("Path.add")),
        method<p, stroked>("stroked", doc("Path.stroked")),
        method<p, copy>("copy", doc("Path.copy")),
        {}};
    static PyGetSetDef attributes[] = {attribute<p, is_empty>("is_empty", doc("Path.is_empty")),
                                       {}};
    return new_type<p>(module, "l3d.Path", doc("Path"), methods, attributes,
                       {slot(Py_tp_new, construct<make_path>)});
}

PyTypeObject* add_gradient_type(PyObject* module) {
    static PyMethodDef methods[] = {function<linear>("linear", doc("Gradient.linear"), METH_STATIC),
                                    function<radial>("radial", doc("Gradient.radial"), METH_STATIC),
                                    {}};
    static PyGetSetDef attributes[] = {{}};
    return new_type<l3d_gradient>(module, "l3d.Gradient", doc("Gradient"), methods, attributes, {});
}

PyTypeObject* add_font_type(PyObject* module) {
    using f = l3d_font;
    static PyMethodDef methods[] = {function<of_system>("system", doc("Font.system"), METH_STATIC),
                                    method<f, width>("width", doc("Font.width")),
                                    method<f, line>("line", doc("Font.line")),
                                    method<f, outline>("outline", doc("Font.outline")),
                                    {}};
    static PyGetSetDef attributes[] = {attribute<f, font_name>("name", doc("Font.name")), {}};
    return new_type<f>(module, "l3d.Font", doc("Font"), methods, attributes,
                       {slot(Py_tp_new, construct<make_font>)});
}

} // namespace python
