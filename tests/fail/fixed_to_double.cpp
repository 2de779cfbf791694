// SPDX-License-Identifier: MIT
// A 64-bit l3d_fixed holds more than a double: the loss must be written down.
#include "geom/fixed.h"

#include <cstdint>

using fixed = l3d_fixed<std::int64_t, 32>;

double value(fixed a);

double value(fixed a) {
#ifdef L3D_MUST_FAIL
    return a;
#else
    return static_cast<double>(a);
#endif
}
