// SPDX-License-Identifier: MIT
// How a patch bends and its normal turns, exactly and at many points: the judge of bounds.
#ifndef L3D_TESTS_SCENE_EXACT_BENDS_H
#define L3D_TESTS_SCENE_EXACT_BENDS_H

#include "scene/bends/surface_bends.h"

#include <array>

namespace dice_tests {

using bend_numbers = l3d_bend_numbers<double>;

/// The numbers in their order, with names.
struct named_bend {
    const char* name;
    int order;
    double bend_numbers::*of;
};
extern const std::array<named_bend, 17> all_bends;

bend_numbers bends_of_block(const l3d_surface_bends& bends, std::size_t block);
bend_numbers bends_of_whole(const l3d_surface_bends& bends);

/// The largest values at points x points places of each block, its corners among them, in long
/// double. Zero where the normal is. Own formulas: N's derivatives from Leibniz' rule for r N = M
/// and r r = M . M, one order after the other.
struct exact_bends {
    std::array<bend_numbers, 16> of_blocks;
    bend_numbers of_whole;

    exact_bends(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals,
                int points);
};

} // namespace dice_tests

#endif
