// SPDX-License-Identifier: MIT
// Arguments bound to names, and the sentences that refuse them.
#include "arguments.h"

#include "arrays.h"

#include <algorithm>
#include <cmath>

namespace python {

namespace {

/// The text of a Python object made by `of`, which returns a new reference to a str.
std::string text_by(PyObject* (*of)(PyObject*), PyObject* value) {
    const reference text = reference::taken(of(value));
    Py_ssize_t size = 0;
    const char* bytes = PyUnicode_AsUTF8AndSize(text.get(), &size);
    if (!bytes) { // lone surrogates
        PyErr_Clear();
        return "a text that is no UTF-8";
    }
    return {bytes, static_cast<std::size_t>(size)};
}

PyObject* type_name(PyObject* type) {
    return PyType_GetName(reinterpret_cast<PyTypeObject*>(type));
}

} // namespace

std::string name_of_type(PyTypeObject* type) {
    const std::string name = text_by(type_name, reinterpret_cast<PyObject*>(type));
    const bool is_vowel = std::string_view("AEIOUaeiou").find(name.front()) != std::string::npos;
    return (is_vowel ? "an " : "a ") + name;
}

std::string shown(PyObject* value) {
    constexpr std::size_t most = 60; // characters
    std::string result = text_by(PyObject_Repr, value);
    if (result.size() > most) {
        result.resize(most);
        while (!result.empty() && (result.back() & 0xc0) == 0x80) // within a character
            result.pop_back();
        result += "...";
    }
    return result;
}

double number_of(PyObject* value, const std::string& what, double least, double most) {
    const double number = PyFloat_AsDouble(value);
    if (number == -1 && PyErr_Occurred()) {
        PyErr_Clear();
        throw type_error(what + ": a number is wanted, not " + shown(value));
    }
    if (!(number >= least && number <= most)) {
        const bool is_bounded = std::isfinite(number);
        throw value_error(what +
                          (is_bounded
                               ? ": a number from " + shown(python::number(least).get()) + " to " +
                                     shown(python::number(most).get()) + " is wanted, not "
                               : ": a finite number is wanted, not ") +
                          shown(value));
    }
    return number;
}

std::int64_t whole_of(PyObject* value, const std::string& what, std::int64_t least,
                      std::int64_t most) {
    if (PyIndex_Check(value) == 0)
        throw type_error(what + ": a whole number is wanted, not " + shown(value));
    const reference index = reference::taken(PyNumber_Index(value));
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(index.get(), &overflow);
    if (overflow != 0 || number < least || number > most)
        throw value_error(what + ": a whole number from " + std::to_string(least) + " to " +
                          std::to_string(most) + " is wanted, not " + shown(value));
    return number;
}

bool flag_of(PyObject* value, const std::string& what) {
    if (PyUnicode_Check(value) || PySequence_Check(value) != 0)
        throw type_error(what + ": True or False is wanted, not " + shown(value));
    const int truth = PyObject_IsTrue(value);
    if (truth < 0)
        throw error_is_set();
    return truth != 0;
}

std::string text_of(PyObject* value, const std::string& what) {
    if (!PyUnicode_Check(value))
        throw type_error(what + ": a text is wanted, not " + shown(value));
    Py_ssize_t size = 0;
    const char* bytes = PyUnicode_AsUTF8AndSize(value, &size);
    if (!bytes) {
        PyErr_Clear();
        throw value_error(what + ": the text is no Unicode that UTF-8 can hold");
    }
    return {bytes, static_cast<std::size_t>(size)};
}

std::string path_of(PyObject* value, const std::string& what) {
    PyObject* bytes = nullptr;
    if (PyUnicode_FSConverter(value, &bytes) == 0) {
        if (!PyErr_ExceptionMatches(PyExc_TypeError))
            throw error_is_set();
        PyErr_Clear();
        throw type_error(what + ": the path of a file is wanted, not " + shown(value));
    }
    const reference owner = reference::taken(bytes);
    char* text = nullptr;
    Py_ssize_t size = 0;
    if (PyBytes_AsStringAndSize(bytes, &text, &size) != 0)
        throw error_is_set();
    return {text, static_cast<std::size_t>(size)};
}

std::uint32_t color_of(PyObject* value, const std::string& what) {
    constexpr std::int64_t white = 0xffffff;
    if (PyUnicode_Check(value)) {
        const std::string text = text_of(value, what);
        const bool is_hex = text.size() == 7 && text[0] == '#' &&
                            text.find_first_not_of("0123456789abcdefABCDEF", 1) == text.npos;
        if (!is_hex)
            throw value_error(what + ": a colour looks like '#ff8000', not like " + shown(value));
        return static_cast<std::uint32_t>(std::stoul(text.substr(1), nullptr, 16));
    }
    if (PyIndex_Check(value) != 0)
        return static_cast<std::uint32_t>(whole_of(value, what, 0, white));
    const number_array channels(value, what);
    channels.expect({3});
    std::uint32_t result = 0;
    for (const std::uint32_t channel : channels.indices(255))
        result = result << 8 | channel;
    return result;
}

std::vector<double> numbers_of(PyObject* value, const std::string& what, std::size_t count,
                               double most) {
    const number_array array(value, what);
    array.expect({static_cast<int>(count)});
    return array.doubles(most);
}

vector_3d vector_of(PyObject* value, const std::string& what, double most) {
    const std::vector<double> v = numbers_of(value, what, 3, most);
    return {v[0], v[1], v[2]};
}

l3d_point_2d point_of(PyObject* value, const std::string& what) {
    const std::vector<double> p = numbers_of(value, what, 2, farthest_pixel);
    return {p[0], p[1]};
}

l3d_matrix<double> matrix_of(PyObject* value, const std::string& what) {
    const number_array array(value, what);
    array.expect({4, 4});
    const std::vector<double> numbers = array.doubles(std::numeric_limits<double>::max());
    l3d_matrix<double> result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result(row, column) = numbers[static_cast<std::size_t>(4 * row + column)];
    return result;
}

l3d_size size_of(PyObject* value, const std::string& what) {
    const number_array array(value, what);
    array.expect({2});
    const std::vector<std::uint32_t> sides = array.indices(l3d_largest_side);
    if (sides[0] == 0 || sides[1] == 0)
        throw value_error(what + ": a width and height of at least 1 are wanted, not " +
                          shown(value));
    return {static_cast<int>(sides[0]), static_cast<int>(sides[1])};
}

std::size_t choice_of(PyObject* value, const std::string& what,
                      std::span<const std::string_view> names) {
    const std::string text = text_of(value, what);
    const auto found = std::ranges::find(names, text);
    if (found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    std::string all;
    for (const std::string_view name : names)
        all += (all.empty() ? "" : ", ") + std::string(name);
    throw value_error(what + ": one of " + all + " is wanted, not " + shown(value));
}

void arguments::are(std::string function, std::string_view names) {
    function_ = std::move(function);
    std::vector<std::string> all;
    std::size_t by_place = std::string_view::npos;
    for (std::size_t begin = 0; begin < names.size();) {
        const std::size_t end = std::min(names.find(' ', begin), names.size());
        if (const auto name = names.substr(begin, end - begin); name == "|")
            by_place = all.size();
        else if (!name.empty())
            all.emplace_back(name);
        begin = end + 1;
    }
    by_place = std::min(by_place, all.size());
    const auto count = static_cast<std::size_t>(PyTuple_Size(positional_));
    if (count > by_place)
        throw type_error(function_ + " takes " + std::to_string(by_place) +
                         " arguments by their places, not " + std::to_string(count));
    values_.clear();
    for (std::size_t i = 0; i < count; ++i)
        values_.emplace_back(all[i], PyTuple_GetItem(positional_, static_cast<Py_ssize_t>(i)));
    PyObject *key = nullptr, *value = nullptr;
    for (Py_ssize_t at = 0; named_ && PyDict_Next(named_, &at, &key, &value) != 0;) {
        const std::string name = text_of(key, function_);
        if (std::ranges::find(all, name) == all.end()) {
            std::string list;
            for (const std::string& known : all)
                list += (list.empty() ? "" : ", ") + known;
            throw type_error(function_ + " has no argument '" + name + "'" +
                             (list.empty() ? "" : ", but " + list));
        }
        if (given(name))
            throw type_error(function_ + " got '" + name + "' twice");
        values_.emplace_back(name, value);
    }
}

PyObject* arguments::given(std::string_view name) const {
    for (const auto& [known, value] : values_)
        if (known == name)
            return value;
    return nullptr;
}

PyObject* arguments::need(std::string_view name) const {
    PyObject* value = find(name);
    if (!value)
        throw type_error(function_ + " needs '" + std::string(name) + "'");
    return value;
}

reference number(double value) {
    return reference::taken(PyFloat_FromDouble(value));
}

reference number(std::int64_t value) {
    return reference::taken(PyLong_FromLongLong(value));
}

reference flag(bool value) {
    return reference::taken(PyBool_FromLong(value ? 1 : 0));
}

reference text(std::string_view value) {
    return reference::taken(
        PyUnicode_DecodeUTF8(value.data(), static_cast<Py_ssize_t>(value.size()), "replace"));
}

reference sides(l3d_size size) {
    return reference::taken(PyTuple_Pack(2, number(std::int64_t{size.width}).get(),
                                         number(std::int64_t{size.height}).get()));
}

reference numbers(std::span<const double> values) {
    reference result = reference::taken(PyTuple_New(static_cast<Py_ssize_t>(values.size())));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (PyTuple_SetItem(result.get(), static_cast<Py_ssize_t>(i),
                            number(values[i]).release()) != 0)
            throw error_is_set();
    return result;
}

} // namespace python
