// SPDX-License-Identifier: MIT
// A sum of l3d_fixed and double would hide in which of the two it is rounded.
#include "geom/fixed.h"

#include <cstdint>

using fixed = l3d_fixed<std::int32_t, 14>;

fixed sum(fixed a, double b);

fixed sum(fixed a, double b) {
#ifdef L3D_MUST_FAIL
    return a + b;
#else
    return a + fixed(b);
#endif
}
