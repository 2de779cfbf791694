// SPDX-License-Identifier: MIT
// The verdict on an anti-aliased picture: every pixel against the exact mean of its light.
#ifndef L3D_REFERENCE_BOX_VERDICT_H
#define L3D_REFERENCE_BOX_VERDICT_H

#include "reference/box_image.h"

#include <cstdint>
#include <span>
#include <vector>

namespace reference {

/// A pixel that is farther off than was promised. Units: levels.
struct broken_promise {
    int x = 0, y = 0;
    double drawn = 0, exact = 0;
    double bound = 0, unsure = 0;
    double beyond = 0; ///< error less all that is allowed
};

/// Units: counts in pixels; levels of 255.
struct box_verdict {
    std::int64_t pixels = 0; ///< of the picture
    std::int64_t shown = 0;  ///< covered exactly, in part or whole, or not drawn as background
    std::int64_t edges = 0;  ///< of those shown, where an edge may pass
    std::int64_t judged = 0; ///< of all pixels: those with a bound that is a number
    std::int64_t judged_shown = 0;
    std::int64_t vacuous = 0;    ///< of those judged: whatever the level, nothing would be said
    double judged_share() const; ///< of all pixels
    double judged_shown_share() const; ///< of those shown

    /// Of those judged: farther off than bound, unsure and half a level of rounding together.
    std::int64_t exceptions = 0;
    std::vector<broken_promise> worst; ///< sixteen at most, by falling `beyond`

    /// Over all that is shown, judged or not.
    double rms = 0, edge_rms = 0, largest = 0;
    int largest_x = -1, largest_y = -1;
    /// Means over what is judged and shown, and the largest of the picture.
    double mean_bound = 0, mean_unsure = 0, largest_unsure = 0;
};

/// Shape:   levels and bounds row by row, as large as the exact picture; 0 to 255.
/// Expects: bounds of each pixel's level before it is rounded; infinite or NaN where nothing is
///          promised: such a pixel is not judged, but counts for the errors.
box_verdict judge_boxes(std::span<const double> drawn, const box_image& exact,
                        std::span<const float> bounds);
box_verdict judge_boxes(std::span<const unsigned char> drawn, const box_image& exact,
                        std::span<const float> bounds);

} // namespace reference

#endif
