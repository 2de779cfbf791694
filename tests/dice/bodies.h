// SPDX-License-Identifier: MIT
// Closed bodies of bicubic patches whose common edges have the same control points, bit for bit.
#ifndef L3D_TESTS_DICE_BODIES_H
#define L3D_TESTS_DICE_BODIES_H

#include "reference/exact.h"

#include <vector>

namespace dice_tests {

/// Nearly a unit sphere about the origin: a cube's six faces. Normals point out of it.
std::vector<reference::patch> ball();

/// Nearly a torus about the y axis: 4 x 4 patches. Normals point out of it.
std::vector<reference::patch> ring(double radius, double thickness);

/// With u running the other way, so that normals turn round.
std::vector<reference::patch> inside_out(std::vector<reference::patch> patches);

} // namespace dice_tests

#endif
