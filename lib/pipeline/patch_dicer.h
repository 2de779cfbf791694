// SPDX-License-Identifier: MIT
// l3d_patch_dicer: turns patches into grids of micro-quads by adaptive forward differencing.
#ifndef L3D_PIPELINE_PATCH_DICER_H
#define L3D_PIPELINE_PATCH_DICER_H

#include "geom/normal_net.h"
#include "pipeline/dice_counts.h"
#include "pipeline/dice_view.h"
#include "pipeline/diced_pieces.h"
#include "pipeline/edge_polylines.h"
#include "pipeline/piece_drawer.h"
#include "pipeline/surface_piece.h"

/// Dices patches given as homogeneous image nets.
///
/// A patch is one piece; a piece that would need more than 32 steps a strip, or that crosses the
/// near plane and is not yet fine, is cut in two. A piece's rows are walked by forward
/// differences in T, restarted exactly at each strip. Along each side the piece fills the slit
/// between its own boundary row and the side's edge polyline, which both neighbours compute alike;
/// so pieces of any steps and any depth of cutting meet without a gap, and every vertex is an
/// exact surface point of known parameters, which is what makes the bound certain.
///
/// Cost: no allocation of its own once the largest piece has been seen.
template <class T> class l3d_patch_dicer {
public:
    /// Adds the patch's pieces to `out`, and to `counts` what it did.
    ///
    /// Expects: `edges` was built of this net and view, and has nothing more than its outer edges;
    ///          tolerance > 0, near > 0.
    void dice(const l3d_image_patch& net, const l3d_normal_net& normals, const l3d_dice_view& view,
              l3d_edge_polylines& edges, l3d_diced_pieces& out, l3d_dice_counts& counts);

    /// From now on, pieces that are no larger than any `other` has had allocate nothing.
    void reserve_as(const l3d_patch_dicer& other) { drawer_.reserve_as(other.drawer_); }

private:
    using piece = l3d_surface_piece;

    /// What stays the same for a patch.
    struct task {
        const l3d_dice_view& view;
        l3d_edge_polylines& edges;
        l3d_diced_pieces& out;
        l3d_dice_counts& counts;
        int cuts_left;
    };

    void dice_piece(const piece& p, task& of);
    void draw(const piece& p, const l3d_piece_nets<T>& nets, l3d_step_plan& plan,
              double vertex_error, task& of);
    void cut(const piece& p, bool along_u, task& of);

    l3d_piece_drawer<T> drawer_;
};

#endif
