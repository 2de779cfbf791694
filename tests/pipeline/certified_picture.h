// SPDX-License-Identifier: MIT
// A picture with its map of doubt, and what is found where both meet the exact picture.
#ifndef L3D_TESTS_PIPELINE_CERTIFIED_PICTURE_H
#define L3D_TESTS_PIPELINE_CERTIFIED_PICTURE_H

#include "../dice/scene.h"

#include "pipeline/pipeline_afd.h"
#include "reference/box_image.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace pipeline_tests {

/// Levels and their bounds. Shape: row by row.
struct certified_picture {
    std::vector<double> levels;
    std::vector<float> bounds;
};

/// Draws a scene by a pipeline of its own. Expects: a grey background.
certified_picture certified(const dice_tests::scene& s, const l3d_afd_settings& settings);

/// Sums over all pixels of some pictures. Units: levels.
struct certified_sum {
    std::int64_t pixels = 0;
    std::int64_t shown = 0;   ///< a surface covers some of them
    std::int64_t edges = 0;   ///< of those, pixels that an edge may pass
    std::int64_t vacuous = 0; ///< of those shown, pixels whose bound forbids no level
    std::int64_t exceptions = 0;
    std::int64_t unjudged = 0;            ///< pictures of which the exact renderer knew nothing
    double squares = 0, edge_squares = 0; ///< of errors, where a surface is shown
    double bounds = 0, edge_bounds = 0;   ///< likewise
    double largest_unsure = 0;            ///< of the exact picture itself
    std::string where;                    ///< the first exceptions

    /// A pixel is an exception if it is farther off than its bound and the exact one's doubt.
    void add(const certified_picture& drawn, const reference::box_image& exact);
    void add(const certified_sum& more);
    void print(const std::string& name) const;
};

} // namespace pipeline_tests

#endif
