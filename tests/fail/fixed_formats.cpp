// SPDX-License-Identifier: MIT
// Two fixed-point formats do not mix: their raw values count different units.
#include "geom/fixed.h"

#include <cstdint>

using coarse = l3d_fixed<std::int32_t, 8>;
using fine = l3d_fixed<std::int32_t, 20>;

fine sum(fine a, coarse b);

fine sum(fine a, coarse b) {
#ifdef L3D_MUST_FAIL
    return a + b;
#else
    return a + fine(b);
#endif
}
