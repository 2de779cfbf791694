// SPDX-License-Identifier: MIT
// Lists the names of arithmetics, and the one of l3d_real.
#include "compare/arithmetic.h"

#include "geom/real.h"

#include <type_traits>

l3d_arithmetic l3d_real_arithmetic() {
    return std::is_same_v<l3d_real, float>    ? l3d_arithmetic::float_32
           : std::is_same_v<l3d_real, double> ? l3d_arithmetic::float_64
                                              : l3d_arithmetic::fixed_32_32;
}

const char* l3d_name_of(l3d_arithmetic arithmetic) {
    switch (arithmetic) {
    case l3d_arithmetic::float_32:
        return "float";
    case l3d_arithmetic::float_64:
        return "double";
    case l3d_arithmetic::fixed_16_16:
        return "16.16";
    case l3d_arithmetic::block_32:
        return "32-bit block";
    case l3d_arithmetic::fixed_32_32:
        return "32.32";
    }
    return "";
}
