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

/// Farther from the exact level than this is seen as wrong; farther from all neighbours, as a
/// spark.
inline constexpr int far_levels = 20, spark_levels = 50;

/// The promises of a drawn picture. Units: pixels.
struct seen_bounds {
    double place = 0; ///< any drawn point is no farther from its exact place in the picture
    double depth = 0; ///< nor from the exact surface, along its normal
};

struct seen_pixel {
    int x = 0, y = 0;
    int drawn = 0, exact = 0; ///< levels
};

/// Units: counts in pixels; levels of 255.
struct seen_picture {
    std::int64_t shown = 0; ///< covered by one of both pictures, or by both

    /// Over all that is shown.
    double rms = 0;
    int largest = 0;
    std::array<std::int64_t, 256> histogram{}; ///< of differences

    /// Pixels that an outline's bound reaches, by kind; no level is known there. The rest is
    /// judged.
    std::array<std::int64_t, 5> outlines{};
    std::int64_t outline_pixels() const;
    std::int64_t judged = 0;
    double judged_share() const;
    double judged_rms = 0;
    int judged_largest = 0;
    double judged_depth_px = 0; ///< largest distance from the exact tangent plane

    std::vector<seen_pixel> far;   ///< judged, and farther than far_levels
    std::int64_t far_outlines = 0; ///< as far, but at an outline
    /// Those of far_outlines that show a surface in a level which the exact picture has nowhere
    /// within the bound of place, by far_levels: no outline that has moved a little explains it.
    std::vector<seen_pixel> strange;
    /// Those of `far` whose level the exact picture has nowhere within the bound of place, by
    /// far_levels. The rest is steep shading, moved by no more than the bound.
    std::int64_t far_anywhere = 0;
    std::int64_t holes = 0; ///< judged, covered exactly, and not drawn

    /// Sparks of the drawn picture, and of the exact one, where thin things show in single pixels,
    /// too.
    std::int64_t drawn_sparks = 0, exact_sparks = 0;
    /// Sparks of the drawn picture alone, at outlines, too, whose level the exact one has nowhere
    /// within the bound of place, by far_levels: no thin thing that has moved a little.
    std::vector<seen_pixel> sparks;
};

/// An outline is where the exact picture changes abruptly (outline_kind), by the second judge. Its
/// bound reaches a pixel whose centre is within bounds.place of it. The judge's sixteen ways may be
/// 2 % and 1e-3 px short, so these are added. The bound also reaches a pixel that has another sheet
/// within twice bounds.depth.
///
/// Outlines are looked for beside pixels whose neighbourhood changes, and wherever a pixel is far
/// from its exact level. So a pixel that is said to be far is far, and there may be more outlines
/// than are counted.
///
/// Shape:   greys and distances row by row, as large as the exact picture; distances along the
///          axis, infinite where nothing is.
/// Expects: both judges of the same patches, camera and size.
/// Cost:    0.1 ms for each pixel near an outline.
seen_picture judge_seen(std::span<const unsigned char> greys, std::span<const float> distances,
                        const exact_image& exact, const second_judge& outlines, seen_bounds bounds,
                        vec3 light);

/// Pixels farther than spark_levels from each of their eight neighbours.
std::vector<std::size_t> sparks_of(std::span<const unsigned char> greys, picture_size size);

} // namespace reference

#endif
