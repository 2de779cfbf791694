// SPDX-License-Identifier: MIT
// present: what both dispatchers do with the pixels after a pipeline had its turn.
#ifndef L3D_SYSTEM_PRESENT_P_H
#define L3D_SYSTEM_PRESENT_P_H

#include "pipeline/pipeline.h"
#include "system/frame_writer.h"
#include "tool_2d/screen.h"

#include <chrono>

namespace l3d_detail {

/// Shows the pixels if they were drawn anew, and hands them to the writer in any case: a numbered
/// sequence has a file for every frame.
inline l3d_frame_times present(l3d_screen& screen, bool drawn, l3d_frame_writer& writer) {
    using clock = std::chrono::steady_clock;
    const auto start = clock::now();
    if (drawn)
        screen.show();
    const auto shown = clock::now();
    writer.frame(screen.pixels());
    const auto written = clock::now();
    return {std::chrono::duration<double>(shown - start).count(),
            std::chrono::duration<double>(written - shown).count()};
}

} // namespace l3d_detail

#endif
