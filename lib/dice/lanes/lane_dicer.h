// SPDX-License-Identifier: MIT
// l3d_lane_dicer: dices ordinary patches, blocks and columns side by side in SIMD lanes.
#ifndef L3D_DICE_LANES_LANE_DICER_H
#define L3D_DICE_LANES_LANE_DICER_H

#include "geom/normal_net.h"
#include "geom/real.h"
#include "scene/counts.h"
#include "scene/dice_view.h"
#include "dice/diced_piece.h"
#include "dice/edges/edge_polyline.h"
#include "dice/lanes/lane_light_p.h"
#include "dice/lanes/lane_rows_p.h"
#include "geom/patch_part.h"
#include "dice/bend_bounds.h"

#include <span>

/// Dices patches, and pieces of patches, that need neither clipping nor cutting. The slow twin is
/// l3d_patch_dicer, which takes all patches.
///
/// Lives: one for each worker.
/// Cost:  no allocation, unless `out` has to be larger than ever before.
template <class T> class l3d_lane_dicer {
public:
    /// Dices a patch in one piece: makes its grid and fills its slits.
    ///
    /// Shape:   edges in the order of l3d_edge_polylines::outer(), made for this net and view.
    /// Expects: tolerance > 0, near > 0.
    /// Errors:  returns false, with nothing written, if the patch is not ordinary. An ordinary
    ///          patch reaches neither the near nor the far plane, and stays within the guard band.
    ///          Neither the ordinary patch nor an edge of it needs more than 32 steps in a strip,
    ///          and walking the patch in T is exact enough.
    bool dice(const l3d_image_patch& net, const l3d_normal_net& normals, const l3d_dice_view& view,
              std::span<const l3d_edge_polyline, 4> edges, l3d_diced_piece& out,
              l3d_dice_counts& counts, const l3d_bend_bounds& bends = {});

    /// Plans the steps of a patch or piece. `edge_vertex` is the error of the vertices of its
    /// edges. fill() cannot take a plan with more than 32 steps a strip.
    /// Lives:  until the next plan is made.
    /// Errors: null if the patch is not ordinary, or no walk is exact enough.
    const l3d_step_plan* plan(const l3d_patch_part& piece, const l3d_dice_view& view,
                              double edge_vertex, const l3d_bend_bounds& bends);

    /// The proven bounds of depth and shade for the piece of the last plan. The bounds include the
    /// rounding of vertices.
    l3d_surface_certificate certificate(const l3d_patch_part& piece, const l3d_dice_view& view,
                                        const l3d_bend_bounds& bends,
                                        const l3d_diced_piece& out) const;

    /// The error of depth of vertices in the slits of the piece that was planned last.
    /// Units: pixels at the vertices' depth.
    double row_depth_error() const { return row_depth_error_; }

    /// Makes the grid for the last plan, with its parameters and its bound.
    /// Expects: the last plan was made for this piece, and has at most 32 steps a strip.
    void fill(const l3d_patch_part& piece, const l3d_normal_net& normals, const l3d_dice_view& view,
              l3d_diced_piece& out);

    /// Bounds how much the rounding of vertices adds to the chord error in slits of the piece that
    /// was planned last. Units: pixels.
    double row_error() const { return row_error_; }

private:
    void walk(const l3d_dice_view& view, l3d_surface_part& part);
    bool choose_registers(const l3d_dice_view& view);
    void plan_steps(const l3d_dice_view& view);
    bool fits_with_folds(const l3d_surface_part& part, const l3d_dice_view& view);
    double walked_w(const l3d_dice_view& view) const;
    double vertex_error(const l3d_dice_view& view, double walk_xy, double walk_w,
                        double snap_error) const;

    l3d_detail::lane_bounds bounds_;
    l3d_step_plan plan_;
    l3d_quad_kind kind_ = l3d_quad_kind::whole; ///< the kind of quads in the plan
    l3d_detail::lane_parameters u_, v_;
    l3d_detail::lane_register register_ = l3d_detail::lane_register::float_32;
    double register_xy_ = 1, register_w_ = 1;
    double vertex_error_ = 0, row_error_ = 0, depth_error_ = 0, row_depth_error_ = 0, walk_w_ = 0;
    l3d_detail::vertex_numbers numbers_; ///< working memory, kept between patches
};

#endif
