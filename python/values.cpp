// SPDX-License-Identifier: MIT
// Materials, cameras and lights.
#include "docs.h"
#include "types.h"

#include <cmath>

namespace python {

namespace {

// ---- materials ----------------------------------------------------------------------------------

reference make_material(arguments& a) {
    a.are("Material", "color highlight sharpness opacity |");
    l3d_material result;
    a.read("color", result.color, color_of);
    a.read("highlight", result.highlight, color_of);
    if (PyObject* value = a.find("sharpness"))
        result.sharpness =
            static_cast<int>(whole_of(value, a.what("sharpness"), 1, l3d_material::most_sharpness));
    result.opacity = static_cast<float>(a.number("opacity", 1, 0, 1));
    return made(result);
}

template <auto Member> reference whole_member(const l3d_material& self) {
    return number(std::int64_t{self.*Member});
}

reference material_text(const l3d_material& self) {
    return text("l3d.Material(color=" + std::to_string(self.color) + ", highlight=" +
                std::to_string(self.highlight) + ", sharpness=" + std::to_string(self.sharpness) +
                ", opacity=" + shown(number(double{self.opacity}).get()) + ")");
}

// ---- cameras ------------------------------------------------------------------------------------

constexpr double widest = 180; // degrees

/// Numbers that are no camera together are refused when something is drawn: a program may change
/// one after the other.
reference make_camera(arguments& a) {
    a.are("Camera", "eye target up fov near_z far_z parallel |");
    l3d_camera result;
    a.read("eye", result.eye, vector_of, l3d_farthest_eye);
    a.read("target", result.target, vector_of, farthest);
    a.read("up", result.up, vector_of, farthest);
    result.fov = a.number("fov", result.fov, 0, widest);
    result.near_z = a.number("near_z", result.near_z, 0, std::numeric_limits<double>::max());
    result.far_z = a.number("far_z", result.far_z, 0, std::numeric_limits<double>::max());
    if (a.flag("parallel", false))
        result.projection = l3d_projection::parallel;
    if (const std::string why = result.complaint(); !why.empty())
        throw value_error("Camera: " + why);
    return made(result);
}

template <auto Member> reference vector_member(const l3d_camera& self) {
    return numbers(self.*Member);
}
template <auto Member> void set_vector(l3d_camera& self, PyObject* value) {
    self.*Member = vector_of(value, "Camera", l3d_farthest_eye);
}
template <auto Member> reference number_member(const l3d_camera& self) {
    return number(self.*Member);
}
template <auto Member> void set_number(l3d_camera& self, PyObject* value) {
    self.*Member = number_of(value, "Camera", 0);
}
reference is_parallel(const l3d_camera& self) {
    return flag(self.is_parallel());
}
void set_parallel(l3d_camera& self, PyObject* value) {
    self.projection =
        flag_of(value, "Camera: parallel") ? l3d_projection::parallel : l3d_projection::perspective;
}

reference orbit(l3d_camera& self, arguments& a) {
    a.are("Camera.orbit", "around_up around_right |");
    constexpr double most = 1e6; // degrees: beyond, a double tells no small angles apart
    const double up = number_of(a.need("around_up"), a.what("around_up"), -most, most);
    self.orbit(up, a.number("around_right", 0, -most, most));
    return reference::none();
}
reference approach(l3d_camera& self, arguments& a) {
    a.are("Camera.approach", "factor |");
    constexpr double most = 1e30;
    self.approach(number_of(a.need("factor"), a.what("factor"), 1 / most, most));
    return reference::none();
}
reference move(l3d_camera& self, arguments& a) {
    a.are("Camera.move", "by |");
    self.move(vector_of(a.need("by"), a.what("by")));
    return reference::none();
}
reference copy_camera(l3d_camera& self, arguments& a) {
    a.are("Camera.copy", "");
    return made(self);
}

reference camera_text(const l3d_camera& self) {
    const auto v = [](const vector_3d& of) { return shown(numbers(of).get()); };
    return text("l3d.Camera(eye=" + v(self.eye) + ", target=" + v(self.target) +
                ", up=" + v(self.up) + ", fov=" + shown(number(self.fov).get()) + ")");
}

// ---- lights -------------------------------------------------------------------------------------

reference make_light(arguments& a) {
    a.are("Light", "| direction position color reach");
    l3d_light_color color{1, 1, 1};
    a.read("color", color, light_color_of);
    if ((a.find("direction") != nullptr) == (a.find("position") != nullptr))
        throw type_error("Light needs either a direction or a position");
    if (PyObject* value = a.find("position")) {
        const vector_3d place = vector_of(value, a.what("position"));
        const double reach = a.number("reach", 0, 0, farthest);
        return made(light(l3d_point_light{place, static_cast<float>(reach), color}));
    }
    if (a.find("reach"))
        throw type_error("Light: reach: only a light with a position has one");
    const vector_3d to = vector_of(a.need("direction"), a.what("direction"));
    if (!(l3d_length(to) > 0))
        throw value_error("Light: direction: zero is no direction");
    l3d_lighting one;
    one.add(to, color);
    return made(light(one.lights[0]));
}

template <float l3d_material::*Member> reference share_member(const l3d_material& self) {
    return number(double{self.*Member});
}

} // namespace

PyTypeObject* add_material_type(PyObject* module) {
    using m = l3d_material;
    static PyMethodDef methods[] = {{}};
    static PyGetSetDef attributes[] = {
        attribute<m, whole_member<&m::color>>("color", doc("Material.color")),
        attribute<m, whole_member<&m::highlight>>("highlight", doc("Material.highlight")),
        attribute<m, whole_member<&m::sharpness>>("sharpness", doc("Material.sharpness")),
        attribute<m, share_member<&m::opacity>>("opacity", doc("Material.opacity")),
        {}};
    return new_type<m>(
        module, "l3d.Material", doc("Material"), methods, attributes,
        {slot(Py_tp_new, construct<make_material>), slot(Py_tp_repr, call_text<m, material_text>)});
}

PyTypeObject* add_camera_type(PyObject* module) {
    using c = l3d_camera;
    static PyMethodDef methods[] = {method<c, orbit>("orbit", doc("Camera.orbit")),
                                    method<c, approach>("approach", doc("Camera.approach")),
                                    method<c, move>("move", doc("Camera.move")),
                                    method<c, copy_camera>("copy", doc("Camera.copy")),
                                    {}};
    static PyGetSetDef attributes[] = {
        attribute<c, vector_member<&c::eye>, set_vector<&c::eye>>("eye", doc("Camera.eye")),
        attribute<c, vector_member<&c::target>, set_vector<&c::target>>("target",
                                                                        doc("Camera.target")),
        attribute<c, vector_member<&c::up>, set_vector<&c::up>>("up", doc("Camera.up")),
        attribute<c, number_member<&c::fov>, set_number<&c::fov>>("fov", doc("Camera.fov")),
        attribute<c, number_member<&c::near_z>, set_number<&c::near_z>>("near_z",
                                                                        doc("Camera.near_z")),
        attribute<c, number_member<&c::far_z>, set_number<&c::far_z>>("far_z", doc("Camera.far_z")),
        attribute<c, is_parallel, set_parallel>("parallel", doc("Camera.parallel")),
        {}};
    return new_type<c>(
        module, "l3d.Camera", doc("Camera"), methods, attributes,
        {slot(Py_tp_new, construct<make_camera>), slot(Py_tp_repr, call_text<c, camera_text>)});
}

PyTypeObject* add_light_type(PyObject* module) {
    static PyMethodDef methods[] = {{}};
    static PyGetSetDef attributes[] = {{}};
    return new_type<light>(module, "l3d.Light", doc("Light"), methods, attributes,
                           {slot(Py_tp_new, construct<make_light>)});
}

} // namespace python
