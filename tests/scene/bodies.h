// SPDX-License-Identifier: MIT
// Closed bodies of bicubic patches whose common edges have the same control points, bit for bit.
#ifndef L3D_TESTS_SCENE_BODIES_H
#define L3D_TESTS_SCENE_BODIES_H

#include "geom/matrix.h"
#include "reference/exact.h"
#include "reference/random_numbers.h"

#include <vector>

namespace dice_tests {

/// Nearly a unit sphere about the origin: a cube's six faces. Normals point out of it.
std::vector<reference::patch> ball();

/// Nearly a torus about the y axis: 4 x 4 patches. Normals point out of it.
std::vector<reference::patch> ring(double radius, double thickness);

/// Nearly a unit sphere: 4 x 2 patches about the y axis, one edge of each a point, its pole.
/// Normals point out of it.
std::vector<reference::patch> globe();

enum class body_kind {
    bent,      ///< a ball, waved and twisted
    flattened, ///< a globe, pressed together until it is up to 20 times as wide as thick
    toroidal,  ///< a ring, waved
    starfish   ///< a ball with three to seven arms, more or less deep
};

/// Within about 2 of the origin, some star-shaped and some not. Normals point out of it.
std::vector<reference::patch> random_body(reference::random_numbers& random, body_kind kind);

/// Elsewhere. Expects: a placement of l3d_patch_scene.
std::vector<reference::patch> placed(std::vector<reference::patch> patches,
                                     const l3d_matrix<double>& placement);

/// With u running the other way, so that normals turn round.
std::vector<reference::patch> inside_out(std::vector<reference::patch> patches);

} // namespace dice_tests

#endif
