// SPDX-License-Identifier: MIT
// Arrays by the buffer protocol: formats, strides, and nested sequences.
#include "arrays.h"

#include "arguments.h"
#include "types.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace python {

namespace {

int export_array(PyObject* self, Py_buffer* buffer, int flags) noexcept {
    return export_view(value_of<array_view>(self), self, buffer, flags);
}

} // namespace

int export_view(const array_view& view, PyObject* self, Py_buffer* buffer, int flags) noexcept {
    buffer->obj = nullptr;
    Py_ssize_t bytes = view.item;
    bool is_dense = true;
    for (std::size_t i = view.shape.size(); i-- > 0;) {
        is_dense = is_dense && view.strides[i] == bytes;
        bytes *= view.shape[i];
    }
    if ((flags & PyBUF_WRITABLE) == PyBUF_WRITABLE) {
        PyErr_SetString(PyExc_BufferError, "the arrays of l3d cannot be written to: copy them");
        return -1;
    }
    const bool takes_strides = (flags & PyBUF_STRIDES) == PyBUF_STRIDES;
    const bool wants_dense = (flags & PyBUF_C_CONTIGUOUS) == PyBUF_C_CONTIGUOUS ||
                             (flags & PyBUF_F_CONTIGUOUS) == PyBUF_F_CONTIGUOUS ||
                             (flags & PyBUF_ANY_CONTIGUOUS) == PyBUF_ANY_CONTIGUOUS;
    if (!is_dense && (!takes_strides || wants_dense)) {
        PyErr_SetString(PyExc_BufferError, "the rows of this array have gaps between them: "
                                           "bytes(...) or numpy.ascontiguousarray(...) copies it");
        return -1;
    }
    if ((flags & PyBUF_F_CONTIGUOUS) == PyBUF_F_CONTIGUOUS && view.shape.size() > 1) {
        PyErr_SetString(PyExc_BufferError, "the rows of this array come one after another, "
                                           "not its columns");
        return -1;
    }
    buffer->buf = const_cast<void*>(view.data);
    buffer->len = bytes;
    buffer->itemsize = view.item;
    buffer->readonly = 1;
    buffer->ndim = static_cast<int>(view.shape.size());
    buffer->format = (flags & PyBUF_FORMAT) ? const_cast<char*>(view.format) : nullptr;
    buffer->shape =
        (flags & PyBUF_ND) == PyBUF_ND ? const_cast<Py_ssize_t*>(view.shape.data()) : nullptr;
    buffer->strides = takes_strides ? const_cast<Py_ssize_t*>(view.strides.data()) : nullptr;
    buffer->suboffsets = nullptr;
    buffer->internal = nullptr;
    Py_INCREF(self);
    buffer->obj = self;
    return 0;
}

reference memory_of(array_view view) {
    return reference::taken(PyMemoryView_FromObject(made(std::move(view)).get()));
}

PyTypeObject* add_array_type(PyObject* module) {
    static PyMethodDef methods[] = {{}};
    static PyGetSetDef attributes[] = {{}};
    return new_type<array_view>(module, "l3d._Array", "Numbers that a memoryview shows.", methods,
                                attributes, {slot(Py_bf_getbuffer, export_array)});
}

number_array::number_array(PyObject* from, std::string what) : what_(std::move(what)) {
    if (PyObject_CheckBuffer(from) == 0 || PyBytes_Check(from)) {
        flatten(from, 0);
        return;
    }
    if (PyObject_GetBuffer(from, &buffer_, PyBUF_RECORDS_RO) != 0)
        throw error_is_set();
    is_buffer_ = true;
    const std::string format = buffer_.format ? buffer_.format : "B";
    const std::size_t order = format.find_first_not_of("@=<|");
    code_ = order == format.npos ? ' ' : format[order];
    const std::string codes = "dfbBhHiIlLqQ?";
    if (format.size() != order + 1 || codes.find(code_) == codes.npos) {
        PyBuffer_Release(&buffer_);
        throw type_error(what_ +
                         ": an array of floats or whole numbers of this machine is wanted, "
                         "not one of format '" +
                         format + "'");
    }
    for (int i = 0; i < buffer_.ndim; ++i)
        shape_.push_back(static_cast<std::size_t>(buffer_.shape[i]));
}

number_array::~number_array() {
    if (is_buffer_)
        PyBuffer_Release(&buffer_);
}

void number_array::flatten(PyObject* from, std::size_t depth) {
    constexpr std::size_t most_axes = 6;
    if (PyNumber_Check(from) != 0 && PySequence_Check(from) == 0) {
        if (depth != shape_.size())
            throw value_error(what_ + ": its rows have different lengths");
        flat_.push_back(PyFloat_AsDouble(from));
        if (PyErr_Occurred())
            throw error_is_set();
        return;
    }
    if (PyUnicode_Check(from) || PyBytes_Check(from) || PySequence_Check(from) == 0 ||
        depth == most_axes)
        throw type_error(what_ + ": an array or a sequence of numbers is wanted, not " +
                         shown(from));
    const Py_ssize_t count = PySequence_Size(from);
    if (count < 0)
        throw error_is_set();
    const auto length = static_cast<std::size_t>(count);
    if (depth == shape_.size() && flat_.empty())
        shape_.push_back(length);
    else if (depth >= shape_.size() || shape_[depth] != length)
        throw value_error(what_ + ": its rows have different lengths");
    for (Py_ssize_t i = 0; i < count; ++i)
        flatten(reference::taken(PySequence_GetItem(from, i)).get(), depth + 1);
}

std::size_t number_array::size() const {
    std::size_t result = 1;
    for (const std::size_t n : shape_)
        result *= n;
    return result;
}

namespace {

template <class Numbers> std::string shape_text(const Numbers& shape) {
    std::string result;
    for (const auto n : shape)
        result +=
            (result.empty() ? "" : " x ") +
            (n < decltype(n)(0) || n == decltype(n)(-1) ? std::string("n") : std::to_string(n));
    return result.empty() ? "a single number" : result;
}

} // namespace

void number_array::expect(std::initializer_list<int> shape) const {
    bool fits = shape.size() == shape_.size();
    for (std::size_t i = 0; fits && i < shape_.size(); ++i)
        fits = shape.begin()[i] < 0 || static_cast<std::size_t>(shape.begin()[i]) == shape_[i];
    if (!fits)
        throw value_error(what_ + ": the shape " + shape_text(shape) + " is wanted, not " +
                          shape_text(shape_));
}

std::string number_array::place(std::size_t index) const {
    std::string result;
    for (std::size_t i = shape_.size(); i-- > 0; index /= shape_[i])
        result = std::to_string(index % shape_[i]) + (result.empty() ? "" : ", ") + result;
    return what_ + "[" + result + "]";
}

/// Calls check(value, index) for each number and stores what it returns.
template <class From, class To, class Check>
void number_array::visit_as(To* to, Check&& check) const {
    const auto* base = static_cast<const char*>(buffer_.buf);
    const std::size_t axes = shape_.size(), count = size();
    std::vector<std::size_t> at(axes, 0);
    const Py_ssize_t inner = axes == 0 ? 0 : buffer_.strides[axes - 1];
    const std::size_t run = axes == 0 ? 1 : shape_[axes - 1];
    for (std::size_t index = 0; index < count;) {
        const char* from = base;
        for (std::size_t i = 0; i + 1 < axes; ++i)
            from += static_cast<Py_ssize_t>(at[i]) * buffer_.strides[i];
        for (std::size_t k = 0; k < run; ++k, ++index, from += inner) {
            From number;
            std::memcpy(&number, from, sizeof number); // it need not be aligned
            to[index] = check(number, index);
        }
        for (std::size_t i = axes > 0 ? axes - 1 : 0; i-- > 0;) {
            if (++at[i] < shape_[i])
                break;
            at[i] = 0;
        }
    }
}

template <class To, class Check> void number_array::visit(To* to, Check&& check) const {
    if (!is_buffer_) {
        for (std::size_t i = 0; i < flat_.size(); ++i)
            to[i] = check(flat_[i], i);
        return;
    }
    switch (code_) {
    case 'd':
        return visit_as<double>(to, check);
    case 'f':
        return visit_as<float>(to, check);
    case 'b':
        return visit_as<signed char>(to, check);
    case 'h':
        return visit_as<short>(to, check);
    case 'H':
        return visit_as<unsigned short>(to, check);
    case 'i':
        return visit_as<int>(to, check);
    case 'I':
        return visit_as<unsigned>(to, check);
    case 'l':
        return visit_as<long>(to, check);
    case 'L':
        return visit_as<unsigned long>(to, check);
    case 'q':
        return visit_as<long long>(to, check);
    case 'Q':
        return visit_as<unsigned long long>(to, check);
    default:
        return visit_as<unsigned char>(to, check);
    }
}

void number_array::copy_to(double* to, double most) const {
    visit(to, [&](auto number, std::size_t index) {
        const auto value = static_cast<double>(number);
        if (!(std::abs(value) <= most))
            throw value_error(place(index) + " is " + shown(python::number(value).get()) +
                              ", which is not within -" + shown(python::number(most).get()) +
                              " and " + shown(python::number(most).get()));
        return value;
    });
}

std::vector<double> number_array::doubles(double most) const {
    std::vector<double> result(size());
    copy_to(result.data(), most);
    return result;
}

std::vector<double> number_array::doubles_or_nan(double most) const {
    std::vector<double> result(size());
    visit(result.data(), [&](auto number, std::size_t index) {
        const auto value = static_cast<double>(number);
        if (std::abs(value) > most)
            throw value_error(place(index) + " is beyond " + shown(python::number(most).get()));
        return value;
    });
    return result;
}

std::vector<std::uint32_t> number_array::indices(std::uint32_t most) const {
    if (is_buffer_ && (code_ == 'd' || code_ == 'f') && size() > 0)
        throw type_error(what_ + ": whole numbers are wanted, not floats");
    std::vector<std::uint32_t> result(size());
    visit(result.data(), [&](auto number, std::size_t index) {
        if (!(number >= decltype(number)(0) &&
              static_cast<double>(number) <= static_cast<double>(most)) ||
            static_cast<double>(number) != std::floor(static_cast<double>(number)))
            throw value_error(place(index) + " is " +
                              shown(python::number(static_cast<double>(number)).get()) +
                              ", which is no whole number from 0 to " + std::to_string(most));
        return static_cast<std::uint32_t>(number);
    });
    return result;
}

} // namespace python
