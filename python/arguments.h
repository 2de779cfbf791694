// SPDX-License-Identifier: MIT
// The arguments of a call from Python, and what they mean in C++.
#ifndef L3D_PYTHON_ARGUMENTS_H
#define L3D_PYTHON_ARGUMENTS_H

#include "object.h"

#include <l3d/matrix.h>
#include <l3d/pixels.h>
#include <l3d/rasterizer_2d.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace python {

using vector_3d = l3d_vector<double, 3>;

/// The largest magnitude of coordinates of models and of cameras' targets
/// (l3d_bpt_largest_coordinate).
inline constexpr double farthest = 1e12;
/// The farthest place of a picture that the rasterizers can tell from others: 2^30 pixels.
inline constexpr double farthest_pixel = 0x1p30;

/// The largest angle that l3d_path::arc_to takes, in degrees.
inline constexpr double most_degrees = 60000;

/// Each of the functions below reads one value. `what` begins the sentence of a type_error or
/// value_error.
double number_of(PyObject* value, const std::string& what,
                 double least = -std::numeric_limits<double>::max(),
                 double most = std::numeric_limits<double>::max());
std::int64_t whole_of(PyObject* value, const std::string& what, std::int64_t least,
                      std::int64_t most);
bool flag_of(PyObject* value, const std::string& what);
std::string text_of(PyObject* value, const std::string& what);
/// The path of a file: text, or an object that has one (os.PathLike).
std::string path_of(PyObject* value, const std::string& what);
/// A colour as 0x00RRGGBB, as "#rrggbb", or as three numbers from 0 to 255.
std::uint32_t color_of(PyObject* value, const std::string& what);
/// Reads exactly `count` finite numbers, none with a magnitude beyond `most`.
std::vector<double> numbers_of(PyObject* value, const std::string& what, std::size_t count,
                               double most = std::numeric_limits<double>::max());
vector_3d vector_of(PyObject* value, const std::string& what, double most = farthest);
l3d_point_2d point_of(PyObject* value, const std::string& what);
/// Reads four rows of four numbers.
l3d_matrix<double> matrix_of(PyObject* value, const std::string& what);
l3d_size size_of(PyObject* value, const std::string& what);

/// The index of a text among names.
std::size_t choice_of(PyObject* value, const std::string& what,
                      std::span<const std::string_view> names);

/// "a Material", with the name that Python has for such objects.
std::string name_of_type(PyTypeObject* type);

/// A value's type and its text, shortened, for messages.
std::string shown(PyObject* value);

template <class T> T& object_of(PyObject* value, const std::string& what) {
    if (!is_a<T>(value))
        throw type_error(what + ": " + name_of_type(type_of<T>()) + " is wanted, not " +
                         shown(value));
    return value_of<T>(value);
}

/// The arguments of one call, each by its name. None stands for an argument that is not given.
class arguments {
public:
    arguments(PyObject* self, PyObject* positional, PyObject* named)
        : self_(self), positional_(positional), named_(named) {}

    /// Declares which arguments there are: "model placement | material opacity". Arguments before
    /// the bar may also be given by position.
    /// Errors:  type_error for unknown arguments, or for an argument given twice.
    void are(std::string function, std::string_view names);

    /// The object whose method is called, to be returned as the call's result.
    reference self() const { return reference::shared(self_); }

    /// The argument, even if it is None; null if it is not given.
    PyObject* given(std::string_view name) const;
    /// The argument, or null if it is None or not given.
    PyObject* find(std::string_view name) const {
        PyObject* value = given(name);
        return value == Py_None ? nullptr : value;
    }
    /// The argument. Errors: type_error if it is None or not given.
    PyObject* need(std::string_view name) const;
    /// "function: name", the text that messages begin with.
    std::string what(std::string_view name) const { return function_ + ": " + std::string(name); }

    /// Reads an argument by one of the functions above, if it is given. Otherwise `into` keeps the
    /// default that it holds.
    template <class T, class Read, class... More>
    void read(std::string_view name, T& into, Read&& read, const More&... more) const {
        if (PyObject* value = find(name))
            into = read(value, what(name), more...);
    }

    template <class T> T& object(std::string_view name) const {
        return object_of<T>(need(name), what(name));
    }
    double number(std::string_view name, double otherwise, double least, double most) const {
        read(name, otherwise, number_of, least, most);
        return otherwise;
    }
    bool flag(std::string_view name, bool otherwise) const {
        read(name, otherwise, flag_of);
        return otherwise;
    }
    std::uint32_t color(std::string_view name, std::uint32_t otherwise) const {
        read(name, otherwise, color_of);
        return otherwise;
    }
    l3d_point_2d point(std::string_view name) const { return point_of(need(name), what(name)); }

private:
    void bind(std::string_view name, PyObject* value);

    PyObject *self_, *positional_, *named_;
    std::string function_;
    std::vector<std::pair<std::string, PyObject*>> values_;
};

/// Runs a call that returns a reference. The result is null after an exception.
template <class Call> PyObject* answered(Call&& call) noexcept {
    return guarded([&] { return call().release(); }, static_cast<PyObject*>(nullptr));
}

template <function_call Call>
PyObject* call_function(PyObject* self, PyObject* positional, PyObject* named) noexcept {
    return answered([&] {
        arguments a(self, positional, named);
        return Call(a);
    });
}

template <class T, method_call<T> Call>
PyObject* call_method(PyObject* self, PyObject* positional, PyObject* named) noexcept {
    return answered([&] {
        arguments a(self, positional, named);
        return Call(value_of<T>(self), a);
    });
}

template <function_call Call>
PyObject* construct(PyTypeObject*, PyObject* positional, PyObject* named) noexcept {
    return call_function<Call>(nullptr, positional, named);
}

template <class T, getter_call<T> Call> PyObject* call_getter(PyObject* self, void*) noexcept {
    return answered([&] { return Call(value_of<T>(self)); });
}

template <class T, getter_call<T> Call> PyObject* call_text(PyObject* self) noexcept {
    return call_getter<T, Call>(self, nullptr);
}

template <class T, setter_call<T> Call>
int call_setter(PyObject* self, PyObject* value, void*) noexcept {
    return guarded(
        [&] {
            if (!value)
                throw type_error("an attribute of l3d's objects cannot be deleted");
            Call(value_of<T>(self), value);
            return 0;
        },
        -1);
}

// The functions below make rows of the tables of functions, methods and attributes.

/// A function of the module or, with METH_STATIC in `flags`, of a class.
template <function_call Call>
PyMethodDef function(const char* name, const char* doc, int flags = 0) {
    return {name, reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(call_function<Call>)),
            METH_VARARGS | METH_KEYWORDS | flags, doc};
}
template <class T, method_call<T> Call> PyMethodDef method(const char* name, const char* doc) {
    return {name, reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(call_method<T, Call>)),
            METH_VARARGS | METH_KEYWORDS, doc};
}
template <class T, getter_call<T> Get> PyGetSetDef attribute(const char* name, const char* doc) {
    return {name, call_getter<T, Get>, nullptr, doc, nullptr};
}
template <class T, getter_call<T> Get, setter_call<T> Set>
PyGetSetDef attribute(const char* name, const char* doc) {
    return {name, call_getter<T, Get>, call_setter<T, Set>, doc, nullptr};
}

// The functions below turn values of C++ into objects of Python.

reference number(double value);
reference number(std::int64_t value);
reference flag(bool value);
reference text(std::string_view value);
reference sides(l3d_size size);
reference numbers(std::span<const double> values);
inline reference numbers(const vector_3d& v) {
    return numbers(std::array{v[0], v[1], v[2]});
}

/// A dictionary that is being filled.
class dictionary {
public:
    dictionary() : dict_(reference::taken(PyDict_New())) {}
    dictionary& add(const char* key, const reference& value) {
        if (PyDict_SetItemString(dict_.get(), key, value.get()) != 0)
            throw error_is_set();
        return *this;
    }
    reference get() const { return dict_; }

private:
    reference dict_;
};

} // namespace python

#endif
