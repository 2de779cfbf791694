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
#include "pipeline/normal_columns.h"
#include "pipeline/slit.h"
#include "pipeline/step_plan.h"
#include "pipeline/strip_walker.h"

#include <array>
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
    /// A stretch of an edge polyline that a piece's side lies along.
    struct side {
        std::size_t edge = 0;
        double t0 = 0, t1 = 1;
    };

    /// Sides: [0] v low, [1] v high (both along u), [2] u low, [3] u high (both along v).
    struct piece {
        image_net net;
        double u0 = 0, u1 = 1, v0 = 0, v1 = 1;
        std::array<side, 4> sides;
        int depth = 0;
    };

    /// The piece in double, cut into blocks, as the bounds need it.
    struct blocks;

    void dice_piece(const piece& p);
    void cut(const piece& p, bool along_u);
    void draw_whole(const piece& p, const blocks& nets, const l3d_step_plan& plan, double bound);
    void draw_clipped(const piece& p, const blocks& nets, const l3d_step_plan& plan);
    void close_hidden(const piece& p);
    void fill_parameters(const piece& p, const l3d_step_plan& plan);
    void walk_rows(const l3d_step_plan& plan);
    void evaluate_grid(const blocks& nets, const l3d_step_plan& plan);
    void evaluate_whole(const blocks& nets, const l3d_step_plan& plan);
    void set_corners(const piece& p);
    l3d_clip_vertex corner(const piece& p, bool high_u, bool high_v) const;
    template <class VertexAt, class FacingAt>
    void fill_slits(const piece& p, VertexAt vertex_at, FacingAt facing_at);
    void fill_slit(const side& along);
    std::size_t new_edge(const l3d_bezier_curve<wide, 3>& curve);

    l3d_dice_view view_;
    l3d_dice_counts counts_;
    const l3d_normal_net* normals_ = nullptr;
    l3d_dice_sink* sink_ = nullptr;
    int pieces_left_ = 0;

    // Kept between patches and frames only for their memory.
    std::vector<l3d_edge_polyline> edges_;
    std::size_t edges_used_ = 0;
    std::vector<image_net> strip_nets_;
    l3d_strip_walker<T> walker_;
    l3d_normal_columns normal_columns_;
    l3d_micro_grid grid_;
    std::vector<double> u_, v_;
    std::vector<l3d_clip_vertex> clip_grid_;
    std::array<std::vector<float>, 3> normal_row_;
    std::vector<l3d_boundary_point> boundary_;
    std::vector<l3d_dice_vertex> triangles_;
};

#endif
