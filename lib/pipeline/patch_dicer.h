// SPDX-License-Identifier: MIT
// l3d_patch_dicer: turns patches into grids of micro-quads by adaptive forward differencing.
#ifndef L3D_PIPELINE_PATCH_DICER_H
#define L3D_PIPELINE_PATCH_DICER_H

#include "geom/bezier_patch.h"
#include "geom/normal_net.h"
#include "pipeline/dice_counts.h"
#include "pipeline/dice_sink.h"
#include "pipeline/dice_view.h"
#include "pipeline/edge_polyline.h"
#include "pipeline/piece_drawer.h"
#include "pipeline/surface_piece.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// Dices patches given as homogeneous image nets.
///
/// A patch is one piece; a piece that would need more than 32 steps a strip, or that crosses the
/// near plane and is not yet fine, is cut in two. A piece's rows are walked by forward
/// differences in T, restarted exactly at each strip. Along each side the piece fills the slit
/// between its own boundary row and the side's edge polyline, which both neighbours compute alike;
/// so pieces of any steps and any depth of cutting meet without a gap, and every vertex is an
/// exact surface point of known parameters, which is what makes the bound certain.
///
/// Cost: no allocation once the largest frame has been seen.
template <class T> class l3d_patch_dicer {
public:
    using wide = typename l3d_real_traits<T>::wide;
    using image_net = l3d_bezier_patch<wide, 3>;

    /// Starts a frame. Expects: tolerance > 0, near > 0.
    void begin(const l3d_dice_view& view);

    void dice(const image_net& net, const l3d_normal_net& normals, l3d_dice_sink& sink);

    const l3d_dice_counts& counts() const { return counts_; }

private:
    using piece = l3d_surface_piece<wide>;

    std::int64_t* reason_to_leave_out(const l3d_image_patch& net);
    bool outside(const l3d_image_patch& net) const;
    void dice_piece(const piece& p);
    void cut(const piece& p, bool along_u);
    std::size_t new_edge(const l3d_bezier_curve<wide, 3>& curve);

    l3d_dice_view view_;
    l3d_dice_counts counts_;
    l3d_piece_drawer<T> drawer_;
    int pieces_left_ = 0;
    std::vector<l3d_edge_polyline> edges_; ///< those in use first; the others keep their memory
    std::size_t edges_used_ = 0;
};

#endif
