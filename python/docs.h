// SPDX-License-Identifier: MIT
// The documentation of everything that Python sees. It is written in l3d/__init__.pyi alone.
#ifndef L3D_PYTHON_DOCS_H
#define L3D_PYTHON_DOCS_H

#include <string_view>

namespace python {

struct doc_row {
    std::string_view name;
    const char* text;
};

inline constexpr doc_row doc_rows[] = {
#include "python/docs.inc"
};

/// The text for a name such as "Model.load". A call with a name that has none does not compile.
consteval const char* doc(std::string_view name) {
    for (const doc_row& row : doc_rows)
        if (row.name == name)
            return row.text;
    throw "l3d/__init__.pyi has no such name";
}

} // namespace python

#endif
