// SPDX-License-Identifier: MIT
// Python objects that hold C++ values: references, types, methods, and exceptions on their way
// from one language to the other.
#ifndef L3D_PYTHON_OBJECT_H
#define L3D_PYTHON_OBJECT_H

#define PY_SSIZE_T_CLEAN
#define Py_LIMITED_API 0x030b0000 // Python 3.11 and all later ones
#include <Python.h>

#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace python {

/// Thrown when Python already knows of the exception.
struct error_is_set {};

/// Becomes a TypeError: an argument has the wrong type, or is missing.
struct type_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Becomes an l3d.Error: an argument has the right type, and a value that makes no sense.
struct value_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Becomes an l3d.Error with a file, or an l3d.FileError if the system refused something.
struct file_failure {
    std::string file, text;
    bool is_of_system;
};

/// Owns a reference to a Python object.
class reference {
public:
    reference() = default;
    reference(reference&& other) noexcept : object_(other.release()) {}
    reference(const reference& other) : object_(other.object_) { Py_XINCREF(object_); }
    reference& operator=(reference other) noexcept {
        std::swap(object_, other.object_);
        return *this;
    }
    ~reference() { Py_XDECREF(object_); }

    /// Takes over a new reference. Errors: error_is_set if it is null.
    static reference taken(PyObject* object) {
        if (!object)
            throw error_is_set();
        return reference(object);
    }
    /// Adds a reference to a borrowed object.
    static reference shared(PyObject* object) {
        Py_INCREF(object);
        return reference(object);
    }
    static reference none() { return shared(Py_None); }

    PyObject* get() const { return object_; }
    PyObject* release() { return std::exchange(object_, nullptr); }

private:
    explicit reference(PyObject* object) : object_(object) {}
    PyObject* object_ = nullptr;
};

/// Lets other Python threads run while it lives. Expects: nothing of Python is used meanwhile.
class unlocked {
public:
    unlocked() : state_(PyEval_SaveThread()) {}
    unlocked(const unlocked&) = delete;
    unlocked& operator=(const unlocked&) = delete;
    ~unlocked() { PyEval_RestoreThread(state_); }

private:
    PyThreadState* state_;
};

/// Marks an object as busy while it lives, so that no other thread changes it or draws with it.
class busy {
public:
    /// Errors: value_error, if it is so already.
    busy(bool& mark, const char* name) : mark_(mark) {
        if (mark_)
            throw value_error(std::string(name) + ": it draws already, in another thread");
        mark_ = true;
    }
    busy(const busy&) = delete;
    busy& operator=(const busy&) = delete;
    ~busy() { mark_ = false; }

private:
    bool& mark_;
};

/// Passes the exception that is being handled on to Python.
void set_error() noexcept;

/// Calls a function of C++. After an exception, Python has that exception, and the result is
/// `failed`.
template <class Call, class Result> Result guarded(Call&& call, Result failed) noexcept {
    try {
        return call();
    } catch (...) {
        set_error();
        return failed;
    }
}

/// A Python object around a value of C++.
template <class T> struct object {
    PyObject head;
    T value;
};

template <class T> T& value_of(PyObject* self) {
    return reinterpret_cast<object<T>*>(self)->value;
}

/// The Python type of objects that hold a T; the module's state has it.
template <class T> PyTypeObject* type_of();

template <class T> bool is_a(PyObject* any) {
    return PyObject_TypeCheck(any, type_of<T>()) != 0;
}

/// Makes a new object around a value.
template <class T> reference made(T value) {
    static_assert(std::is_nothrow_move_constructible_v<T>); // or a half-made object would be freed
    reference result = reference::taken(PyType_GenericAlloc(type_of<T>(), 0));
    new (&value_of<T>(result.get())) T(std::move(value));
    return result;
}

template <class T> void destroy(PyObject* self) {
    PyTypeObject* type = Py_TYPE(self);
    value_of<T>(self).~T();
    reinterpret_cast<freefunc>(PyType_GetSlot(type, Py_tp_free))(self);
    Py_DECREF(type);
}

class arguments;

/// The kinds of functions that Python calls: functions of the module and of classes, constructors,
/// methods, and functions that read and write attributes.
using function_call = reference (*)(arguments&);
template <class T> using method_call = reference (*)(T&, arguments&);
template <class T> using getter_call = reference (*)(const T&);
template <class T> using setter_call = void (*)(T&, PyObject*);

/// Makes an entry of a type, other than methods and attributes.
template <class Call> PyType_Slot slot(int which, Call* call) {
    return {which, reinterpret_cast<void*>(call)};
}

/// Makes a type of these entries and adds it to the module.
/// Expects: tables that live forever.
/// Errors:  error_is_set.
PyTypeObject* new_type(PyObject* module, const char* name, const char* doc, std::size_t size,
                       std::vector<PyType_Slot> slots);

template <class T>
PyTypeObject* new_type(PyObject* module, const char* name, const char* doc, PyMethodDef* methods,
                       PyGetSetDef* attributes, std::vector<PyType_Slot> slots) {
    slots.push_back(slot(Py_tp_dealloc, destroy<T>));
    slots.push_back({Py_tp_methods, methods});
    slots.push_back({Py_tp_getset, attributes});
    return new_type(module, name, doc, sizeof(object<T>), std::move(slots));
}

} // namespace python

#endif
