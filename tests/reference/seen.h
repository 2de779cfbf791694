// SPDX-License-Identifier: MIT
// The picture as a person sees it: a drawn picture's grey levels against the exact ones.
#ifndef L3D_REFERENCE_SEEN_H
#define L3D_REFERENCE_SEEN_H

#include "reference/exact.h"
#include "reference/second_judge.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace reference {

/// A pixel looks wrong if its level is farther than far_levels from the exact one. It looks like a
/// spark if its level is farther than spark_levels from those of all neighbours.
inline constexpr int far_levels = 20, spark_levels = 50;

/// The errors that a drawn picture promises to keep. Units: pixels.
struct seen_bounds {
    double place = 0; ///< of any drawn point from its exact place in the picture
    double depth = 0; ///< of any drawn point from the exact surface, along its normal
};

struct seen_pixel {
    int x = 0, y = 0;
    int drawn = 0, exact = 0; ///< levels
};

/// How a drawn picture compares with the exact one for a person. Units: counts in pixels; levels of
/// 255.
struct seen_picture {
    std::int64_t shown = 0; ///< pixels that one of the pictures covers, or both

    /// The errors of all shown pixels.
    double rms = 0;
    int largest = 0;
    std::array<std::int64_t, 256> histogram{}; ///< number of pixels for each difference of levels

    /// Pixels that an outline's bound reaches, by kind. No level is known there. The other pixels
    /// are judged.
    std::array<std::int64_t, 5> outlines{};
    std::int64_t outline_pixels() const;
    std::int64_t judged = 0;
    double judged_share() const;
    double judged_rms = 0;
    int judged_largest = 0;
    double judged_depth_px = 0; ///< largest distance from the exact tangent plane

    std::vector<seen_pixel> far;   ///< judged pixels that are wrong by more than far_levels
    std::int64_t far_outlines = 0; ///< pixels at an outline that are wrong by more than far_levels
    /// Pixels of far_outlines that show a surface in a level that the exact picture has nowhere
    /// near. That is, nowhere within the bound of place is a level within far_levels of it. So no
    /// outline that has moved a little explains them.
    std::vector<seen_pixel> strange;
    /// The number of pixels in `far` whose level the exact picture has nowhere within the bound of
    /// place, up to far_levels. The rest is steep shading, moved by no more than the bound.
    std::int64_t far_anywhere = 0;
    std::int64_t holes = 0; ///< judged pixels that are covered exactly, and not drawn

    /// Sparks of the drawn picture, and of the exact one, in which thin things show as single
    /// pixels, too.
    std::int64_t drawn_sparks = 0, exact_sparks = 0;
    /// Sparks of the drawn picture alone, also at outlines, whose level the exact picture has
    /// nowhere within the bound of place, up to far_levels. So no thin thing that has moved a
    /// little explains them.
    std::vector<seen_pixel> sparks;
};

/// Compares a drawn picture with the exact one. An outline is where the exact picture changes
/// abruptly (outline_kind), by the second judge. Its bound reaches a pixel whose centre is within
/// bounds.place of it. The judge's sixteen ways may be 2 % and 1e-3 px short, so these are added.
/// The bound also reaches a pixel that has another sheet within twice bounds.depth.
///
/// Outlines are looked for beside pixels whose neighbourhood changes, and wherever a pixel is far
/// from its exact level. So no pixel in `far` is at an outline, though there may be more outlines
/// than are counted.
///
/// Shape:   greys and distances row by row, as large as the exact picture; distances along the
///          axis, infinite where nothing is.
/// Expects: both judges have the same patches, camera and size.
/// Cost:    0.1 ms for each pixel near an outline.
seen_picture judge_seen(std::span<const unsigned char> greys, std::span<const float> distances,
                        const exact_image& exact, const second_judge& outlines, seen_bounds bounds,
                        vec3 light);

/// The pixels whose level is farther than spark_levels from that of each of their eight neighbours.
std::vector<std::size_t> sparks_of(std::span<const unsigned char> greys, picture_size size);

} // namespace reference

#endif
