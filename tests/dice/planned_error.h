// SPDX-License-Identifier: MIT
// The largest errors of a plan's quads, from the formulas of step_plan.h.
#ifndef L3D_TESTS_DICE_PLANNED_ERROR_H
#define L3D_TESTS_DICE_PLANNED_ERROR_H

#include "dice/step_plan.h"

#include <algorithm>
#include <cstddef>

namespace dice_tests {

/// The error of block (a, b), drawn whole in nu by nv steps, and of the slits at the patch's sides.
inline double planned_error(const l3d_block_needs& needs, std::size_t a, std::size_t b, int nu,
                            int nv) {
    const auto strips = static_cast<std::size_t>(needs.strips);
    const std::size_t i = strips * b + a;
    const l3d_second_bounds image{needs.uu[i], needs.uv[i], needs.vv[i]};
    if (!needs.balanced)
        return image.quad_error(nu, nv);
    if (image.uu + image.uv + image.vv == 0)
        return 0;
    const double hu = 1.0 / nu, hv = 1.0 / nv;
    const double moved_u = nu > 1 ? l3d_balance * hu * hu : 0;
    const double moved_v = nv > 1 ? l3d_balance * hv * hv : 0;
    const double both = moved_u * moved_v * needs.uuvv;
    const double mixed =
        hu * hv * image.uv + 2 * moved_u * hv * needs.uuv + 2 * moved_v * hu * needs.uvv + 4 * both;
    const double quad =
        l3d_balanced_error(nu) * image.uu + l3d_balanced_error(nv) * image.vv + both + mixed / 16;
    const double side_u = b % (strips - 1) == 0 ? hu * hu / 8 * image.uu : 0;
    const double side_v = a % (strips - 1) == 0 ? hv * hv / 8 * image.vv : 0;
    return std::max({quad, side_u, side_v});
}

} // namespace dice_tests

#endif
