// SPDX-License-Identifier: MIT
// l3d_frame_settings: how many frames a program makes, how fast, and where they are written.
#ifndef L3D_SYSTEM_FRAME_SETTINGS_H
#define L3D_SYSTEM_FRAME_SETTINGS_H

#include "base/public.h"
#include "tool_2d/image_file.h"

#include <optional>
#include <string>

/// The settings with which a dispatcher is made.
struct L3D_PUBLIC l3d_frame_settings {
    /// The number of frames; 0: until the pipeline is done (with a window), one (without a
    /// display).
    int frames = 0;

    /// The first frame whose picture is wanted; of those before it, only the time passes. Expects:
    /// less than `frames`, or 0.
    int first_frame = 0;

    /// Whether frames whose file is there already are left out, too.
    bool resume = false;

    /// Frames per second; 0: as many as possible; empty: the screen's choice.
    std::optional<double> fps;

    /// Whether update_event gets 1 / fps instead of the time measured. Always so without a
    /// display; with a window it makes the pictures repeatable.
    bool fixed_step = false;

    /// A name for l3d_frame_writer; empty: nothing is written.
    std::string output;

    /// The meaning of the highest bytes of pixel words in the files that are written.
    l3d_alpha alpha = l3d_alpha::none;

    /// The beginning of lines on stderr.
    std::string program = "l3d";

    /// The time from frame to frame where it is not measured, in seconds. It is the same for every
    /// screen, so that their pictures are.
    double step() const { return 1 / (fps && *fps > 0 ? *fps : 60); }
};

#endif
