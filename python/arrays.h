// SPDX-License-Identifier: MIT
// Arrays of numbers by Python's buffer protocol: those that come in, and those that go out.
#ifndef L3D_PYTHON_ARRAYS_H
#define L3D_PYTHON_ARRAYS_H

#include "object.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace python {

/// Numbers that Python code may look at without a copy. They are never changed.
///
/// Lives:   shares the object that holds the numbers.
struct array_view {
    std::shared_ptr<const void> keeps; ///< the owner of the numbers
    const void* data = nullptr;        ///< the number at index 0, 0, ...
    const char* format = "B"; ///< the number's type, in the notation of Python's module struct
    Py_ssize_t item = 1;      ///< bytes of a number
    std::vector<Py_ssize_t> shape{};   ///< numbers along each axis
    std::vector<Py_ssize_t> strides{}; ///< bytes from one number to the next along each axis

    /// A view of numbers without gaps, the last axis fastest.
    template <class Number>
    static array_view of(std::shared_ptr<const void> keeps, const Number* data,
                         std::initializer_list<std::size_t> shape);
};

/// Answers Py_bf_getbuffer for an object that has this view.
int export_view(const array_view& view, PyObject* self, Py_buffer* buffer, int flags) noexcept;

/// The view as a memoryview.
reference memory_of(array_view view);

/// Adds the type of the objects behind such memoryviews.
PyTypeObject* add_array_type(PyObject* module);

/// An array of numbers that came from Python: anything with the buffer protocol, or sequences
/// within sequences.
///
/// Lives:   the numbers may be read while it lives.
class number_array {
public:
    /// Errors: type_error for anything else, value_error for rows of different lengths.
    number_array(PyObject* from, std::string what);
    number_array(const number_array&) = delete;
    number_array& operator=(const number_array&) = delete;
    ~number_array();

    const std::vector<std::size_t>& shape() const { return shape_; }
    std::size_t size() const;

    /// Checks the shape; -1 stands for any number along an axis.
    /// Errors: value_error.
    void expect(std::initializer_list<int> shape) const;

    /// Copies all numbers as doubles, the last axis fastest.
    /// Errors:  value_error if one is not finite, or beyond `most`, with its place.
    void copy_to(double* to, double most) const;
    std::vector<double> doubles(double most) const;
    /// All numbers as doubles, of which some may be NaN, for no number.
    std::vector<double> doubles_or_nan(double most) const;
    /// All numbers as whole numbers from 0 to `most`.
    /// Errors:  value_error for other numbers, with the place; type_error for an array of floats.
    std::vector<std::uint32_t> indices(std::uint32_t most) const;

private:
    void flatten(PyObject* from, std::size_t depth);
    std::string place(std::size_t index) const;
    template <class To, class Check> void visit(To* to, Check&& check) const;
    template <class From, class To, class Check> void visit_as(To* to, Check&& check) const;

    std::string what_;
    std::vector<std::size_t> shape_;
    std::vector<double> flat_; ///< the numbers of sequences
    Py_buffer buffer_{};
    bool is_buffer_ = false;
    char code_ = 'd'; ///< the format of the numbers in the buffer
};

template <class Number> constexpr const char* format_of() {
    if constexpr (std::is_same_v<Number, double>)
        return "d";
    else if constexpr (std::is_same_v<Number, float>)
        return "f";
    else if constexpr (std::is_same_v<Number, std::uint32_t>)
        return "I";
    else
        return "B";
}

template <class Number>
array_view array_view::of(std::shared_ptr<const void> keeps, const Number* data,
                          std::initializer_list<std::size_t> shape) {
    array_view result{std::move(keeps), data, format_of<Number>(), sizeof(Number), {}, {}};
    for (const std::size_t n : shape)
        result.shape.push_back(static_cast<Py_ssize_t>(n));
    result.strides.resize(result.shape.size());
    Py_ssize_t step = sizeof(Number);
    for (std::size_t i = result.shape.size(); i-- > 0;) {
        result.strides[i] = step;
        step *= result.shape[i];
    }
    return result;
}

} // namespace python

#endif
