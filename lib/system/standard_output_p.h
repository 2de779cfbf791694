// SPDX-License-Identifier: MIT
// check_written: checks that printed text has arrived.
#ifndef L3D_SYSTEM_STANDARD_OUTPUT_P_H
#define L3D_SYSTEM_STANDARD_OUTPUT_P_H

#include "base/error.h"

#include <ostream>

namespace l3d_detail {

/// Flushes the standard output, to learn whether the printed text has arrived. `out` is its stream.
/// Errors: l3d_error(failure) if any text was lost.
inline void check_written(std::ostream& out) {
    if (!(out << std::flush))
        throw l3d_error(l3d_exit::failure, "cannot write to the standard output");
}

} // namespace l3d_detail

#endif
