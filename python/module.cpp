// SPDX-License-Identifier: MIT
// The module l3d._l3d: its types, functions and exceptions.
#include "docs.h"
#include "types.h"

#include <l3d/error.h>
#include <l3d/version.h>
#include <l3d/workers.h>

#include <algorithm>
#include <cctype>

namespace python {

namespace {

PyModuleDef definition{};

/// Gives an exception of ours its attributes `file` and `line`, as far as they are known.
void set_error_at(PyObject* type, const std::string& what, const std::string& file,
                  std::int64_t line) {
    const reference error =
        reference::taken(PyObject_CallFunctionObjArgs(type, text(what).get(), nullptr));
    const auto set = [&](const char* name, const reference& value) {
        if (PyObject_SetAttrString(error.get(), name, value.get()) != 0)
            throw error_is_set();
    };
    if (!file.empty())
        set("file", text(file));
    if (line > 0)
        set("line", number(line));
    PyErr_SetObject(type, error.get());
}

/// The line that a message "file:line: what" names; 0 if it names none.
std::int64_t line_in(const std::string& what, const std::string& file) {
    if (!what.starts_with(file + ":"))
        return 0;
    std::int64_t line = 0;
    std::size_t at = file.size() + 1;
    constexpr std::size_t most_digits = 18; // those of 64 bits
    for (; at < what.size() && at < file.size() + most_digits && what[at] >= '0' && what[at] <= '9';
         ++at)
        line = 10 * line + (what[at] - '0');
    return at < what.size() && what[at] == ':' ? line : 0;
}

void translate() {
    try {
        throw;
    } catch (const error_is_set&) {
    } catch (const type_error& error) {
        PyErr_SetString(PyExc_TypeError, error.what());
    } catch (const value_error& error) {
        set_error_at(state().error, error.what(), "", 0);
    } catch (const file_failure& error) {
        set_error_at(error.is_of_system ? state().file_error : state().error, error.text,
                     error.file, line_in(error.text, error.file));
    } catch (const l3d_error& error) {
        set_error_at(state().error, error.what(), "", 0);
    } catch (const l3d_interrupted&) {
        if (!PyErr_Occurred())
            PyErr_SetNone(PyExc_KeyboardInterrupt);
    } catch (const std::bad_alloc&) {
        PyErr_NoMemory();
    } catch (const std::exception& error) {
        set_error_at(state().error, error.what(), "", 0);
    }
}

PyObject* new_error(PyObject* module, const char* name, const char* full_name, const char* doc,
                    PyObject* bases) {
    dictionary attributes;
    attributes.add("file", reference::none()).add("line", reference::none());
    const reference error =
        reference::taken(PyErr_NewExceptionWithDoc(full_name, doc, bases, attributes.get().get()));
    if (PyModule_AddObjectRef(module, name, error.get()) != 0)
        throw error_is_set();
    return error.get(); // the module keeps it
}

void fill(PyObject* module) {
    module_state& of = *static_cast<module_state*>(PyModule_GetState(module));
    of.error = new_error(module, "Error", "l3d.Error", doc("Error"), PyExc_ValueError);
    const reference bases = reference::taken(PyTuple_Pack(2, of.error, PyExc_OSError));
    of.file_error = new_error(module, "FileError", "l3d.FileError", doc("FileError"), bases.get());
    of.types = {add_array_type(module),   add_material_type(module), add_camera_type(module),
                add_light_type(module),   add_model_type(module),    add_curve_type(module),
                add_surface_type(module), add_scene_type(module),    add_picture_type(module),
                add_view_type(module),    add_path_type(module),     add_gradient_type(module),
                add_font_type(module),    add_canvas_type(module)};
    if (PyModule_AddStringConstant(module, "__version__", L3D_VERSION_TEXT) != 0)
        throw error_is_set();
}

} // namespace

module_state& state() {
    return *static_cast<module_state*>(PyModule_GetState(PyState_FindModule(&definition)));
}

void set_error() noexcept {
    try {
        translate();
    } catch (...) { // while an exception was made: Python has that one
        if (!PyErr_Occurred())
            PyErr_NoMemory();
    }
}

PyTypeObject* new_type(PyObject* module, const char* name, const char* doc, std::size_t size,
                       std::vector<PyType_Slot> slots) {
    const bool has_constructor =
        std::ranges::find(slots, Py_tp_new, &PyType_Slot::slot) != slots.end();
    slots.push_back({Py_tp_doc, const_cast<char*>(doc)});
    slots.push_back({0, nullptr});
    PyType_Spec spec{name, static_cast<int>(size), 0,
                     static_cast<unsigned>(Py_TPFLAGS_DEFAULT) |
                         (has_constructor ? 0u : unsigned{Py_TPFLAGS_DISALLOW_INSTANTIATION}),
                     slots.data()};
    const reference type = reference::taken(PyType_FromSpec(&spec));
    if (PyModule_AddType(module, reinterpret_cast<PyTypeObject*>(type.get())) != 0)
        throw error_is_set();
    return reinterpret_cast<PyTypeObject*>(type.get()); // the module keeps it
}

std::size_t part_of(const l3d_parts& parts, const std::string& name, const std::string& what) {
    if (const auto found = parts.find(name))
        return *found;
    throw value_error(what + ": " + parts.complaint(name));
}

} // namespace python

PyMODINIT_FUNC PyInit__l3d() {
    using namespace python;
    static PyMethodDef functions[] = {function<draw>("draw", doc("draw")),
                                      function<revolved>("revolved", doc("revolved")),
                                      function<extruded>("extruded", doc("extruded")),
                                      function<ruled>("ruled", doc("ruled")),
                                      function<pipe>("pipe", doc("pipe")),
                                      function<shape>("shape", doc("shape")),
                                      {}};
    definition.m_base = PyModuleDef_HEAD_INIT;
    definition.m_name = "l3d._l3d";
    definition.m_size = sizeof(module_state);
    definition.m_methods = functions;
    return answered([&] {
        reference module = reference::taken(PyModule_Create(&definition));
        fill(module.get());
        return module;
    });
}
