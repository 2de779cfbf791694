// SPDX-License-Identifier: MIT
// refusal: options that say nothing, or cannot be had, beside others.
#ifndef L3D_SYSTEM_OPTIONS_REFUSAL_P_H
#define L3D_SYSTEM_OPTIONS_REFUSAL_P_H

#include "base/error.h"

#include <initializer_list>
#include <string>

namespace l3d_detail {

/// A row of a table of options: its option is refused if it was given where nothing takes it.
struct refusal {
    const char* option;
    bool is_refused;
    std::string why; ///< begins in small letters, for it follows the option's name and a colon
};

/// Errors:  l3d_error(usage) that names the first option refused, and why.
inline void refuse(std::initializer_list<refusal> table) {
    for (const refusal& row : table)
        if (row.is_refused)
            throw l3d_error(l3d_exit::usage, std::string(row.option) + ": " + row.why);
}

} // namespace l3d_detail

#endif
