// SPDX-License-Identifier: MIT
// An int that becomes l3d_fixed by itself could be meant as a value or as raw bits.
#include "geom/fixed.h"

#include <cstdint>

using fixed = l3d_fixed<std::int32_t, 14>;

fixed scaled(fixed a, int factor);

fixed scaled(fixed a, int factor) {
#ifdef L3D_MUST_FAIL
    return a * factor;
#else
    return a * fixed(factor);
#endif
}
