// SPDX-License-Identifier: MIT
// The sum of two places means nothing.
#include "geom/transform.h"

l3d_vector<float, 3> between(l3d_point<float> p, l3d_point<float> q);

l3d_vector<float, 3> between(l3d_point<float> p, l3d_point<float> q) {
#ifdef L3D_MUST_FAIL
    return p + q;
#else
    return p - q;
#endif
}
