// SPDX-License-Identifier: MIT
// Defines the symbol and the name of this build's number type.
#include "geom/real.h"

#if defined(L3D_REAL_FLOAT)
const char l3d_built_with_float_real = 0;
const char* l3d_real_name() {
    return "float";
}
#elif defined(L3D_REAL_DOUBLE)
const char l3d_built_with_double_real = 0;
const char* l3d_real_name() {
    return "double";
}
#else
const char l3d_built_with_fixed_real = 0;
const char* l3d_real_name() {
    return "fixed";
}
#endif
