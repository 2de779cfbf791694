// SPDX-License-Identifier: MIT
// l3d_frame_report: a frame's cost, error bounds, and skipped work, for patches.
#ifndef L3D_PIPELINE_FRAME_REPORT_H
#define L3D_PIPELINE_FRAME_REPORT_H

#include "base/public.h"
#include "scene/counts.h"
#include "pipeline/report_parts.h"

#include <cstdint>
#include <limits>
#include <string>

/// Times of the stages of a frame of patches. Units: milliseconds.
struct L3D_PUBLIC l3d_stage_times : l3d_common_times {
    double transform = 0; ///< finding what may be seen, sorted front to back
    double dice = 0;      ///< control nets to the image, bounds, steps, forward differences
    double outlines = 0;  ///< finding the pixels that outlines reach; not part of total
    double error_map = 0; ///< bounding the error of each pixel; not part of total
};

/// The report of one frame of patches.
struct L3D_PUBLIC l3d_frame_report : l3d_common_report {
    double tolerance_px = 0; ///< the error of places that was asked for, in pixels
    double near = 0; ///< nearest distance drawn: the camera's, unless rounding asks for more
    l3d_stage_times time_ms;  ///< times of the stages, in milliseconds
    std::int64_t patches = 0; ///< patches of all instances, seen or not
    l3d_dice_counts dice;     ///< patches seen, steps, and the certified bounds
    /// Pixels that stay from the last frame, as nothing changed there.
    std::int64_t pixels_kept = 0;

    /// How much of the bounds of places and depth comes from curved models, whose patches stand for
    /// surfaces that are not bicubic.
    double curved_px = 0;

    /// Pixels that any outline's bound reaches, where nothing is certain about what is seen. It is
    /// none_counted if nobody asked, or if only a part of the picture was drawn.
    std::int64_t outline_pixels = l3d_surface_counts::none_counted;

    /// The largest part of any pixel's square that may show another surface, or the background,
    /// than in the exact picture, from 0 to 1. It counts surfaces drawn in another place, and not
    /// the sampling of pixels. It is infinite if nobody asked for the map of errors, or if places
    /// or depth have no bound.
    double coverage_bound = std::numeric_limits<double>::infinity();
    /// The largest error of any channel in pixels that lie inside one surface, in levels of 255. It
    /// is infinite if nobody asked for the map of errors.
    double color_bound = std::numeric_limits<double>::infinity();

    /// One line of JSON, without the line's end.
    std::string json() const;

    /// The work that this frame did not need, and the test that proved it, a line each.
    std::string explanation() const;

private:
    std::string left_out_in_part() const;
};

#endif
