// SPDX-License-Identifier: MIT
// l3d_step_plan: how finely a piece of a patch is diced, from the error bound.
#ifndef L3D_PIPELINE_STEP_PLAN_H
#define L3D_PIPELINE_STEP_PLAN_H

#include "geom/step_bound.h"
#include "pipeline/dice_view.h"

#include <array>
#include <span>

/// Steps per strip of a piece that is cut into strips x strips blocks.
///
/// The grid is a tensor product, so that it is watertight inside by construction: all blocks of
/// a u-strip share its steps. Integers, not powers of two: on the teapot that saves a third of
/// the quads, and four strips instead of one save another third.
struct l3d_step_plan {
    static constexpr int most_strips = 4;

    int strips = 1;
    std::array<int, most_strips> nu{1, 1, 1, 1}, nv{1, 1, 1, 1};
    double chord_error = 0; ///< bound of the visible blocks' chord error, in pixels
    bool visible = false;   ///< whether any block may reach into the picture

    int most_u() const { return *std::max_element(nu.begin(), nu.begin() + strips); }
    int most_v() const { return *std::max_element(nv.begin(), nv.begin() + strips); }
};

/// Which of the two ways to draw a quad the plan is for.
enum class l3d_quad_kind {
    whole,     ///< convex quads whole: only for pieces that need no clipping
    triangles, ///< two triangles, clipped
};

/// The fewest steps (greedily) with which every visible block keeps its chord error at or below
/// `budget`.
///
/// Shape:   blocks[4 * b + a] (or [0] for one strip) is u-strip a, v-strip b.
/// Units:   budget in pixels.
/// Expects: budget > 0; for `whole`, every w > view.near.
/// Errors:  with `triangles`, the bound holds where the interpolated w is at least view.near;
///          enough steps are taken that the exact w is then at least half of that.
l3d_step_plan l3d_plan_steps(std::span<const l3d_image_patch> blocks, const l3d_dice_view& view,
                             double budget, l3d_quad_kind kind);

#endif
