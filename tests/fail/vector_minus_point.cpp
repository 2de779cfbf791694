// SPDX-License-Identifier: MIT
// A place can be moved back by a displacement, not the other way round.
#include "geom/transform.h"

l3d_point<float> moved_back(l3d_point<float> p, l3d_vector<float, 3> v);

l3d_point<float> moved_back(l3d_point<float> p, l3d_vector<float, 3> v) {
#ifdef L3D_MUST_FAIL
    return v - p;
#else
    return p - v;
#endif
}
