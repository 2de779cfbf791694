// SPDX-License-Identifier: MIT
// Rational patches and patches of high degrees: random ones, and what each cell of a model is of
// them.
#ifndef L3D_TESTS_STABILITY_CURVED_CASES_H
#define L3D_TESTS_STABILITY_CURVED_CASES_H

#include "cases.h"

#include "scene/patch_model.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace stability {

/// One curved patch, with a view, a picture and a tolerance of its own: rational of degrees 1 to 3
/// from odd seeds; of degrees 4 to 15, rational or not, from even ones. The same seed gives the
/// same case everywhere.
test_case curved_case(std::uint64_t seed);

/// The part of a surface that a drawn patch stands for: `du` by `dv`, from (u, v).
struct seen_part {
    std::size_t surface = 0;
    double u = 0, v = 0, du = 1, dv = 1;
};

/// The parts of pieces that a model's patches stand for, at any level.
std::vector<seen_part> parts_of(const l3d_patch_model& model);

} // namespace stability

#endif
