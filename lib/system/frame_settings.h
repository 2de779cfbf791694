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
    /// Units: frames; 0: until the pipeline is done (with a window), one (without a display).
    int frames = 0;

    /// The first of these whose picture is wanted; those before only pass. Expects: less than
    /// `frames`, or 0.
    int first_frame = 0;

    /// Whether a frame whose file is there already only passes, too.
    bool resume = false;

    /// Units: frames per second; 0: as many as can be made; empty: what the screen is good for.
    std::optional<double> fps;

    /// Whether update_event gets 1 / fps instead of the time measured. Always so without a
    /// display; with a window it makes the pictures repeatable.
    bool fixed_step = false;

    /// A name for l3d_frame_writer; empty: nothing is written.
    std::string output;

    /// What the highest bytes of pixel words say in the files that are written.
    l3d_alpha alpha = l3d_alpha::none;

    /// The beginning of lines on stderr.
    std::string program = "l3d";

    /// Units: seconds; the step of time that frames without a measured one get. The same for every
    /// screen, so that their pictures are.
    double step() const { return 1 / (fps && *fps > 0 ? *fps : 60); }
};

#endif
