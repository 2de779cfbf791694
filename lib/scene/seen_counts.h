// SPDX-License-Identifier: MIT
// l3d_seen_counts: how many of a frame's shapes were drawn, and why others were not.
#ifndef L3D_SCENE_SEEN_COUNTS_H
#define L3D_SCENE_SEEN_COUNTS_H

#include <cstdint>

/// What is counted alike of patches and of triangles.
struct l3d_seen_counts {
    std::int64_t drawn = 0;
    std::int64_t offscreen = 0; ///< left out: beyond one side of the window
    std::int64_t subpixel = 0;  ///< left out: what is around it holds no pixel centre
    std::int64_t clipped = 0;   ///< of those drawn, at the near plane, the far one or guard band

    /// Both together: of other shapes.
    void add(const l3d_seen_counts& other) {
        drawn += other.drawn;
        offscreen += other.offscreen;
        subpixel += other.subpixel;
        clipped += other.clipped;
    }
};

#endif
