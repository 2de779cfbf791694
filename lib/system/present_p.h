// SPDX-License-Identifier: MIT
// present: makes a frame once the pipeline is up to date, for both dispatchers.
#ifndef L3D_SYSTEM_PRESENT_P_H
#define L3D_SYSTEM_PRESENT_P_H

#include "pipeline/pipeline.h"
#include "system/frame_writer.h"
#include "tool_2d/screen.h"

#include <chrono>

namespace l3d_detail {

/// Makes a frame, after the pipeline's events and update. It draws a picture if the screen's pixels
/// are `stale` or the pipeline needs a new picture, and shows the changed pixels. The writer gets
/// the pixels in any case, since a numbered sequence has a file for every frame. Returns whether a
/// picture was drawn.
///
/// Errors:  as l3d_frame_writer::frame.
inline bool present(l3d_pipeline& pipeline, l3d_screen& screen, l3d_frame_writer& writer,
                    bool stale) {
    using clock = std::chrono::steady_clock;
    const bool drawn = stale || pipeline.needs_redraw();
    if (drawn)
        pipeline.draw_event();
    const auto start = clock::now();
    if (stale)
        screen.show();
    else if (drawn)
        screen.show(pipeline.changed());
    const auto shown = clock::now();
    writer.frame(screen.pixels());
    const auto written = clock::now();
    if (drawn)
        pipeline.frame_event({std::chrono::duration<double>(shown - start).count(),
                              std::chrono::duration<double>(written - shown).count()});
    return drawn;
}

/// Whether frame number `frame`, the writer's next frame, needs no picture. This is so before the
/// first wanted frame, and for a frame whose file exists if the settings say resume.
inline bool only_passes(int frame, const l3d_frame_settings& settings,
                        const l3d_frame_writer& writer, l3d_size size) {
    return frame < settings.first_frame || (settings.resume && writer.has_frame(size));
}

/// Lets a frame pass whose picture is not wanted, without drawing it if the pipeline allows that.
/// Returns whether the screen's pixels are stale afterwards.
inline bool skip(l3d_pipeline& pipeline, l3d_frame_writer& writer, bool stale) {
    writer.skip_frame();
    if (pipeline.skip_event())
        return true;
    if (stale || pipeline.needs_redraw())
        pipeline.draw_event();
    return false;
}

} // namespace l3d_detail

#endif
