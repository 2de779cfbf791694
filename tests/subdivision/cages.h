// SPDX-License-Identifier: MIT
// Cages for tests of subdivision.
#ifndef L3D_TESTS_SUBDIVISION_CAGES_H
#define L3D_TESTS_SUBDIVISION_CAGES_H

#include "geom/files/model_file.h"

#include <string>
#include <vector>

namespace subdivision_tests {

/// A cage with its name.
struct named_cage {
    std::string name;
    l3d_model_file model;
    bool is_closed = true;
};

/// A cube from -1 to 1.
l3d_model_file cube();
/// Two wheels of `spokes` quads each, rim to rim: vertices of that many faces above and below.
l3d_model_file wheels(int spokes);
/// Quads around the y axis, all of them regular.
l3d_model_file torus_of_quads();
/// data/head.obj.
l3d_model_file head();

/// Closed and open ones, with vertices of 3 to 12 faces, polygons of 3 to 5 corners, and creases.
std::vector<named_cage> all_cages();

} // namespace subdivision_tests

#endif
