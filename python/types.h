// SPDX-License-Identifier: MIT
// The types of the module, and what the values in their objects are.
#ifndef L3D_PYTHON_TYPES_H
#define L3D_PYTHON_TYPES_H

#include "arguments.h"
#include "arrays.h"
#include "object.h"

#include <l3d/any_model.h>
#include <l3d/camera.h>
#include <l3d/font.h>
#include <l3d/gradient.h>
#include <l3d/image.h>
#include <l3d/lighting.h>
#include <l3d/material.h>
#include <l3d/nurbs_surface.h>
#include <l3d/patch_scene.h>
#include <l3d/path.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace python {

/// A light beside the first light.
using light = std::variant<l3d_far_light, l3d_point_light>;

/// Reads red, green and blue of a light: numbers of at least 0, where 1 is white.
l3d_light_color light_color_of(PyObject* value, const std::string& what);

/// A scene, and the number of its changes. A view takes the scene anew when that number differs.
struct scene {
    l3d_patch_scene instances;
    std::uint64_t changes = 0;
};

/// Pixels that never change, with facts about them.
struct picture {
    std::shared_ptr<l3d_image> image;
    bool is_transparent = false; ///< whether the words' highest bytes count as transparency
    /// Makes a line of JSON, which takes longer than some frames. It is null for pictures that are
    /// no frames.
    std::function<std::string()> report{};
    std::shared_ptr<const std::vector<float>> depth{}, doubts{}; ///< null where there are none
    array_view rgb{}; ///< the array that the buffer protocol shows
};
/// Makes a picture of an image that nobody changes from then on.
picture picture_of(std::shared_ptr<l3d_image> image, bool is_transparent);

/// A view of the words of an image, from the first row on. The highest byte says how transparent a
/// pixel is.
array_view words_of(const std::shared_ptr<l3d_image>& image);
/// The bytes of a PNG file.
reference png_of(const l3d_pixels& pixels, bool is_transparent);
/// Writes the file that a path names. Errors: file_failure.
void save_picture(const l3d_pixels& pixels, bool is_transparent, const std::string& path);

/// A camera, and a pipeline that draws frames of a scene or of a model of polygons with it.
class view;
using view_owner = std::unique_ptr<view>;
/// The picture that a notebook shows for a scene, a model or a view.
picture shown_picture(const l3d_any_model& model);
picture shown_picture(const scene& of);

/// Reads the argument "size" of a text, in pixels.
int letters_of(const arguments& a);

/// Pixels, and the drawing of shapes and text on them.
class canvas;
using canvas_owner = std::unique_ptr<canvas>;

using python_types = std::tuple<array_view, l3d_material, l3d_camera, light, l3d_any_model,
                                l3d_nurbs_curve, l3d_nurbs_surface, scene, picture, view_owner,
                                l3d_path, l3d_gradient, l3d_font, canvas_owner>;

/// The module's own objects: the types in the order of python_types, and two exceptions.
struct module_state {
    std::array<PyTypeObject*, std::tuple_size_v<python_types>> types;
    PyObject *error, *file_error;
};
module_state& state();

template <class T, std::size_t I = 0> constexpr std::size_t type_index() {
    if constexpr (std::is_same_v<T, std::tuple_element_t<I, python_types>>)
        return I;
    else
        return type_index<T, I + 1>();
}
template <class T> PyTypeObject* type_of() {
    return state().types[type_index<T>()];
}

// Each of these adds a type, and functions that belong to it, to the module.
PyTypeObject* add_material_type(PyObject* module);
PyTypeObject* add_camera_type(PyObject* module);
PyTypeObject* add_light_type(PyObject* module);
PyTypeObject* add_model_type(PyObject* module);
PyTypeObject* add_curve_type(PyObject* module);
PyTypeObject* add_surface_type(PyObject* module);
PyTypeObject* add_scene_type(PyObject* module);
PyTypeObject* add_picture_type(PyObject* module);
PyTypeObject* add_view_type(PyObject* module);
PyTypeObject* add_path_type(PyObject* module);
PyTypeObject* add_gradient_type(PyObject* module);
PyTypeObject* add_font_type(PyObject* module);
PyTypeObject* add_canvas_type(PyObject* module);

/// l3d.draw.
reference draw(arguments& a);
/// The functions that make surfaces: from curves, or by a shape's name.
reference revolved(arguments& a);
reference extruded(arguments& a);
reference ruled(arguments& a);
reference pipe(arguments& a);
reference shape(arguments& a);

/// The index of the part that an argument names. Errors: value_error with all names.
std::size_t part_of(const l3d_parts& parts, const std::string& name, const std::string& what);

/// Adds functions to the module. Errors: error_is_set.
void add_functions(PyObject* module, PyMethodDef* rows);

/// Reads every item of a sequence as an object of type T.
template <class T> std::vector<T> list_of(PyObject* value, const std::string& what) {
    if (PySequence_Check(value) == 0 || PyUnicode_Check(value))
        throw type_error(what + ": a list is wanted, not " + shown(value));
    std::vector<T> result;
    const Py_ssize_t count = PySequence_Size(value);
    for (Py_ssize_t i = 0; i < count; ++i) {
        const reference item = reference::taken(PySequence_GetItem(value, i));
        result.push_back(object_of<T>(item.get(), what + "[" + std::to_string(i) + "]"));
    }
    return result;
}

// The names that Python has for values of enumerations, in their order.
inline constexpr std::array<std::string_view, 2> winding_names{"nonzero", "even_odd"};
inline constexpr std::array<std::string_view, 3> spread_names{"pad", "repeat", "reflect"};
inline constexpr std::array<std::string_view, 3> cap_names{"butt", "round", "square"};
inline constexpr std::array<std::string_view, 3> join_names{"miter", "round", "bevel"};
inline constexpr std::array<std::string_view, 3> filter_names{"nearest", "linear", "area"};
inline constexpr std::array<std::string_view, 2> blending_names{"coded", "linear"};
inline constexpr std::array<std::string_view, 3> style_names{"solid", "wireframe", "hidden_lines"};

/// Reads an argument that is one of some names as the value of an enumeration.
template <class Enum, std::size_t N>
void read_choice(const arguments& a, std::string_view name, Enum& into,
                 const std::array<std::string_view, N>& names) {
    if (PyObject* value = a.find(name))
        into = static_cast<Enum>(choice_of(value, a.what(name), names));
}

} // namespace python

#endif
