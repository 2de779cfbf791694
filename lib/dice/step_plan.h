// SPDX-License-Identifier: MIT
// l3d_step_plan: decides from error bounds how finely a piece of a patch is diced.
#ifndef L3D_DICE_STEP_PLAN_H
#define L3D_DICE_STEP_PLAN_H

#include "geom/step_bound.h"
#include "scene/dice_view.h"
#include "geom/patch_part.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

/// The largest number of steps along a direction of a net that is one block although it is not
/// small. Four strips would need at least four steps.
inline constexpr int l3d_most_steps_of_one_block = 3;

/// The largest width or height of a net that may be one block. Larger nets get four strips along
/// each direction. A quarter of this size is 24 pixels, below which a net is small (l3d_is_small).
/// Units: pixels.
inline constexpr double l3d_largest_one_block = 96;

/// Whether a net is diced as one block. A net is one block if it is small (l3d_is_small), or so
/// flat that three steps in each direction keep the tolerances of places and depth. Any other net
/// is diced as 4 x 4 blocks, whose vertices are balanced.
///
/// No proof relies on the choice, as each way has its own bounds.
/// Expects: every w > 0; `hull` is the net's box.
/// Cost:    next to nothing for small nets and for large nets, else the cost of l3d_bends_of.
bool l3d_is_one_block(const l3d_image_patch& net, const l3d_image_box& hull,
                      const l3d_dice_view& view);

/// Whether an edge is diced as one strip, not as four. The answer depends on the edge alone, and is
/// the same for the edge that runs in the opposite direction. So both patches at the edge agree.
bool l3d_is_one_strip(const l3d_image_curve& edge, const l3d_image_box& hull,
                      const l3d_dice_view& view);

/// How much a net bends, as seen from the eye. The members are the largest second differences of
/// the net's control points along u and along v, and the largest mixed difference. Where depth is
/// kept, a length along the line of sight counts like one across it.
struct l3d_net_bends {
    double uu = 0, vv = 0, uv = 0, least_w = 0;
};
/// Measures the differences of a net. `focal` is 0 where depth is not kept.
/// Expects: as l3d_is_one_block.
/// Cost:    some 300 instructions.
l3d_net_bends l3d_bends_of(const l3d_image_patch& net, const l3d_image_box& hull, double focal);

/// The way in which quads will be drawn. The error of a quad, and so the choice of steps, depends
/// on it.
enum class l3d_quad_kind {
    convex, ///< as `whole`, but plans leave out the error of folded quads, which the caller adds
    whole, ///< convex quads are drawn whole, folded quads as fans; only for pieces without clipping
    trimmed,   ///< as `whole`, but trims cut some quads into triangles
    triangles, ///< each quad is drawn as two triangles, which are clipped
};

/// The kind of quads in pieces that need no clipping. It is `trimmed` if the view's patch has trims
/// that cut it, else `whole`.
l3d_quad_kind l3d_whole_kind(const l3d_dice_view& view);

/// The second derivatives and other facts that decide how many steps each block of a piece needs.
///
/// Shape: element strips * b + a of each array is u-strip a, v-strip b. A block that is not visible
///        has zeros everywhere.
struct l3d_block_needs {
    static constexpr int most_strips = 4;
    static constexpr std::size_t most_blocks = 16;
    using per_block = std::array<double, most_blocks>;

    int strips = 1;
    bool visible = false;       ///< whether any block is visible
    bool keeps_depth = false;   ///< whether the arrays depth_uu, depth_uv and depth_vv count
    per_block uu{}, uv{}, vv{}; ///< l3d_second_bounds of the image, in pixels
    /// The second bounds of w, in units of l3d_dice_view::depth_budget.
    per_block depth_uu{}, depth_uv{}, depth_vv{};
    per_block least_w{}; ///< least exact w of a drawn point, in visible blocks

    /// Whether vertices inside strips are balanced (l3d_balance). They are balanced in nets of
    /// sixteen blocks that are drawn without clipping.
    bool balanced = false;
    /// Bounds of the mixed third and fourth derivatives, for errors of balanced vertices. The
    /// bounds hold for every block. Units: pixels.
    double uuv = 0, uvv = 0, uuvv = 0;

    /// Bounds of derivatives along the unit normal by a block's own parameters (l3d_bend_numbers),
    /// and bounds of |S_uuuv| and |S_uvvv|. Units: budgets of depth.
    struct normal_bends {
        per_block uu{}, uv{}, vv{}, uuu{}, uuv{}, uvv{}, vvv{}, uuvv{}, uuuv{}, uvvv{};

        /// Removes the needs of block i.
        void clear(std::size_t i) {
            uu[i] = uv[i] = vv[i] = uuu[i] = uuv[i] = uvv[i] = vvv[i] = uuvv[i] = 0;
            uuuv[i] = uvvv[i] = 0;
        }

        /// Multiplies the needs of block i by a factor, so that a plan makes the block's errors
        /// smaller by this factor.
        void refine(std::size_t i, double by) {
            for (per_block* of : {&uu, &uv, &vv, &uuu, &uuv, &uvv, &vvv, &uuvv, &uuuv, &uvvv})
                (*of)[i] *= by;
        }
    };
    bool keeps_bends = false;     ///< whether `bends` counts
    unsigned without_normals = 0; ///< a bit for each visible block that may lack normals
    normal_bends bends;

    /// The fewest steps that keep quads small enough to be filled fast. Some quads may still be
    /// larger: points of a perspective curve may be farther apart than its control points.
    per_block least_u{}, least_v{};

    /// The factor by which errors have to be smaller where outlines may be. Outlines may be along
    /// the piece's sides, and in the blocks of `folds`, which may fold over. No bound relies on
    /// this factor.
    double finer_outlines = 1;
    unsigned folds = 0;
};

/// The largest side of a micro-quad. The rasterizer's 32-bit edge functions take boxes of at most
/// 64 pixels. A square of 48 pixels that stands on a corner has a box of 48 sqrt(2) = 68 pixels.
/// But numbers of steps are rounded up, which makes quads smaller, so nearly all fit. Units:
/// pixels.
inline constexpr double l3d_largest_quad = 48;

/// Finds the needs of the blocks of any piece's net. It is the slow twin of
/// l3d_detail::bounds_in_lanes, which takes no pieces that have to be clipped.
///
/// Shape:   1 or 16 blocks of the net, in the order of l3d_block_needs.
/// Units:   `budget` is the budget of errors of places, in pixels.
/// Expects: every w > view.near, unless the kind is `triangles`.
l3d_block_needs l3d_needs_of(const l3d_image_net& net, std::span<const l3d_image_patch> blocks,
                             const l3d_dice_view& view, double budget, l3d_quad_kind kind);

/// Notes in `needs` where the view wants finer steps because of outlines. Expects: needs with as
/// many strips as the piece has.
void l3d_ask_for_outlines(const l3d_patch_part& piece, const l3d_dice_view& view,
                          l3d_block_needs& needs);

/// The number of steps in each strip of a piece, and the error bounds that follow. The piece is cut
/// into strips x strips blocks.
///
/// All blocks of a u-strip share the strip's steps. So the grid has no gaps inside. Steps may be
/// any whole numbers, not only powers of two. On the teapot this choice saves a third of the quads,
/// and four strips instead of one save another third.
struct l3d_step_plan {
    static constexpr int most_strips = l3d_block_needs::most_strips;

    int strips = 1;
    std::array<int, most_strips> nu{1, 1, 1, 1}, nv{1, 1, 1, 1};
    double chord_error = 0; ///< bound of the visible blocks' chord error, in pixels
    double fan_error = 0;   ///< the same bound if every quad were folded; at least chord_error
    /// The chord error of each block. Shape: element 4 b + a is u-strip a, v-strip b.
    alignas(64) l3d_block_needs::per_block errors{};
    /// Bound of the visible blocks' error along the normal, in budgets of depth.
    double bend_error = 0;
    bool visible = false;  ///< whether any block may reach into the picture
    bool balanced = false; ///< whether vertices inside strips are moved, see l3d_balance

    int most_u() const { return *std::max_element(nu.begin(), nu.begin() + strips); }
    int most_v() const { return *std::max_element(nv.begin(), nv.begin() + strips); }
};

/// Chooses steps with which the chord error of every visible block is at most `budget`. A greedy
/// search keeps the number of steps small.
///
/// Let c be the weight of a direction's steps (1/8 h^2, or l3d_balanced_error). Let m be the weight
/// by which the direction's vertices are moved (0, or l3d_balance h^2). A quad errs by at most
///     c_u uu + c_v vv + m_u m_v uuvv + d k,
///     d = h_u h_v uv + 2 m_u h_v uuv + 2 m_v h_u uvv + 4 m_u m_v uuvv.
/// d bounds the corners' mixed difference. k is 1/16 or 1/4, see l3d_second_bounds, or 0 for
/// `convex`. Slits between a grid's border row and the side's edge err as much as unbalanced
/// chords. So the outer blocks' unbalanced chords keep the budget, too.
///
/// Along the normal, a quad errs by at most
///     c_u uu + c_v vv + 0.0322 (h_u^3 uuu + h_v^3 vvv)
/// and further terms (NUMERICS, section 3, Depth). This error keeps a budget of its own.
///
/// Outlines get finer steps only if no piece has to be cut for them. So outlines never ask for more
/// than l3d_most_steps_whole steps a strip, and `triangles` get no finer steps.
///
/// Units:   budget in pixels.
/// Expects: budget > 0.
/// Errors:  with `triangles`, the bound holds where the interpolated w is at least view.near. The
///          plan has enough steps that the exact w is then at least half of the interpolated w.
l3d_step_plan l3d_plan_steps(const l3d_block_needs& needs, double budget, l3d_quad_kind kind);

/// Bounds the error along the normal that the steps of any plan leave. Units: budgets of depth, as
/// in l3d_step_plan::bend_error.
double l3d_bend_error_of(const l3d_block_needs& needs, const l3d_step_plan& plan);

/// Plans the steps of a net from the nets of its blocks.
/// Shape:   as l3d_needs_of.
/// Expects: as l3d_needs_of.
inline l3d_step_plan l3d_plan_steps(const l3d_image_net& net,
                                    std::span<const l3d_image_patch> blocks,
                                    const l3d_dice_view& view, double budget, l3d_quad_kind kind) {
    return l3d_plan_steps(l3d_needs_of(net, blocks, view, budget, kind), budget, kind);
}

#endif
