// SPDX-License-Identifier: MIT
// Checks of a screen that the tests of windows in shared memory share.
#ifndef L3D_TEST_TOOL_2D_SHARED_SCREEN_H
#define L3D_TEST_TOOL_2D_SHARED_SCREEN_H

#include "onlooker_x11.h"

#include <cstdlib>

inline bool is_shared(const l3d_screen& screen) {
    return screen.describe().ends_with("shared memory: yes");
}

/// Random pictures in a new window: how many pixels of the last are wrong. Three fill both buffers.
inline int wrong_after_pictures(l3d_screen& screen, unsigned seed) {
    const onlooker other;
    drop_events(screen);
    int wrong = 0;
    for (unsigned picture = 0; picture < 3; ++picture) {
        draw_random(screen.pixels(), seed + picture);
        show_for_certain(screen);
        wrong += std::abs(wrong_pixels(other, screen.pixels(), screen.info()));
    }
    return wrong;
}

#endif
