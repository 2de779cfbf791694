// SPDX-License-Identifier: MIT
// A program that is compiled against the library must say which l3d_real it was built with.
// The error says: pkg-config --cflags l3d
#ifdef L3D_MUST_FAIL
#undef L3D_REAL_FLOAT
#undef L3D_REAL_DOUBLE
#undef L3D_REAL_FIXED
#endif
#include "geom/real.h"
