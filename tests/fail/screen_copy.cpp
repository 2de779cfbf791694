// SPDX-License-Identifier: MIT
// A screen owns its window and its pixels: there is one of it.
#include "tool_2d/screen_memory.h"

void use_twice(l3d_screen_memory& first);

void use_twice(l3d_screen_memory& first) {
#ifdef L3D_MUST_FAIL
    l3d_screen_memory second = first;
#else
    l3d_screen_memory& second = first;
#endif
    second.show();
}
