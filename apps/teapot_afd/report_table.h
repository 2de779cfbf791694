// SPDX-License-Identifier: MIT
// Lines of the report's smaller tables.
#ifndef L3D_APPS_TEAPOT_AFD_REPORT_TABLE_H
#define L3D_APPS_TEAPOT_AFD_REPORT_TABLE_H

#include "base/formatted_p.h"

#include <string>
#include <type_traits>

template <class Field> std::string table_text(const Field& field) {
    if constexpr (std::is_floating_point_v<Field>)
        return l3d_detail::formatted("%.6g", field);
    else if constexpr (std::is_integral_v<Field>)
        return std::to_string(field);
    else
        return field;
}

/// A line of a table in a .csv file: the fields with commas between them, and the line's end.
template <class... Fields> std::string table_row(const Fields&... fields) {
    std::string line;
    ((line += (line.empty() ? "" : ",") + table_text(fields)), ...);
    return line + '\n';
}

#endif
