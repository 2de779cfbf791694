// SPDX-License-Identifier: MIT
// The verdict on an anti-aliased picture: every pixel against the exact mean of its light.
#ifndef L3D_REFERENCE_BOX_VERDICT_H
#define L3D_REFERENCE_BOX_VERDICT_H

#include "reference/box_image.h"

#include <cstdint>
#include <span>
#include <vector>

namespace reference {

/// A pixel whose error is larger than its bound promised. Units: levels.
struct broken_promise {
    int x = 0, y = 0;
    double drawn = 0, exact = 0;
    double bound = 0, unsure = 0;
    double beyond = 0; ///< the error less all that is allowed
};

/// How a picture compares with the exact one. Units: counts in pixels; levels of 255.
struct box_verdict {
    std::int64_t pixels = 0; ///< all pixels of the picture
    std::int64_t shown = 0;  ///< covered exactly, in part or whole, or not drawn as background
    std::int64_t edges = 0;  ///< shown pixels that an edge may pass
    std::int64_t judged = 0; ///< pixels with a bound that is a number
    std::int64_t judged_shown = 0;
    std::int64_t vacuous = 0; ///< judged pixels whose bound allows every level, and so says nothing
    double judged_share() const;       ///< judged / pixels
    double judged_shown_share() const; ///< judged_shown / shown

    /// Judged pixels whose error exceeds bound, unsure and half a level of rounding together.
    std::int64_t exceptions = 0;
    std::vector<broken_promise> worst; ///< sixteen exceptions at most, by falling `beyond`

    /// The errors of all shown pixels, judged or not.
    double rms = 0, edge_rms = 0, largest = 0;
    int largest_x = -1, largest_y = -1;
    /// Means over the judged and shown pixels, and the largest value in the picture.
    double mean_bound = 0, mean_unsure = 0, largest_unsure = 0;
};

/// Judges a drawn picture by the exact one.
/// Shape:   levels and bounds row by row, as large as the exact picture; levels from 0 to 255.
/// Expects: bounds of each pixel's level before it is rounded. A bound is infinite or NaN where
///          nothing is promised. Such a pixel is not judged, but counts for the errors.
box_verdict judge_boxes(std::span<const double> drawn, const box_image& exact,
                        std::span<const float> bounds);
box_verdict judge_boxes(std::span<const unsigned char> drawn, const box_image& exact,
                        std::span<const float> bounds);

} // namespace reference

#endif
