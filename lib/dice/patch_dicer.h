// SPDX-License-Identifier: MIT
// l3d_patch_dicer: turns patches into grids of micro-quads by adaptive forward differencing.
#ifndef L3D_DICE_PATCH_DICER_H
#define L3D_DICE_PATCH_DICER_H

#include "geom/normal_net.h"
#include "scene/counts.h"
#include "scene/dice_view.h"
#include "dice/piece_pool.h"
#include "dice/edges/edge_polylines.h"
#include "dice/lanes/lane_dicer.h"
#include "dice/grid_builder.h"
#include "dice/surface_piece.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/// The largest number of pieces into which a patch is cut, by 2047 cuts. Some cuts are spent on
/// parts outside the picture.
inline constexpr std::size_t l3d_most_pieces = 2048;

/// The largest number of vertices of a patch, without the vertices of its edges. The patch has
/// about as many quads. A patch that fills 16384 x 16384 pixels and bends by all of their width
/// needs 2300^2 = 5 million vertices at the finest tolerance. Dicing and drawing so many vertices
/// takes some 2 seconds and 700 MB.
inline constexpr std::int64_t l3d_most_samples = std::int64_t{1} << 23;

/// The budget of a patch: the cost that dicing the patch may have. is_short tells afterwards
/// whether the patch could have used more.
///
/// Units: samples that are diced in lanes. A sample that is evaluated by itself costs as much as
///        l3d_evaluated_cost samples in lanes. A piece costs as much as l3d_piece_cost samples in
///        lanes.
struct l3d_dice_budget {
    std::int64_t left = std::numeric_limits<std::int64_t>::max() / 2;
    bool is_short = false; ///< whether the bound would be smaller with a larger budget
};

/// The costs of a sample that is evaluated by itself, and of a piece. The unit is a sample that is
/// diced in lanes, which takes some 20 ns in all. A sample that is evaluated by itself takes 0.3
/// us: it is lit, clipped and filled as two triangles. The plan of a piece takes 5 us. These times
/// were measured on spikes through the near plane.
inline constexpr std::int64_t l3d_evaluated_cost = 16, l3d_piece_cost = 256;

/// Dices any patch, given as a homogeneous image net. It is the slow twin of l3d_lane_dicer, and
/// also takes patches that have to be cut or clipped.
///
/// A patch starts as one piece. A piece is cut in two if it would need more than 32 steps a strip.
/// It is also cut if it has to be clipped and needs more than l3d_most_steps_clipped steps a strip.
/// The piece with the most excess steps is cut first. No patch is cut into more than
/// l3d_most_pieces pieces. If more pieces would be needed, the rest of the patch is drawn as finely
/// as the budget allows, and the bound tells the error.
///
/// Forward differences in T walk a piece's rows, and each strip restarts exactly. Along each side,
/// the piece fills the slit between its own boundary row and the side's edge polyline. Both
/// neighbours compute that polyline alike. So pieces meet without a gap, whatever their steps and
/// however often they were cut. Every vertex stands for an exact surface point of known parameters,
/// which makes the bound certain.
///
/// The cost of a patch is limited by its budget, too. Pieces are cut as long as the rest of the
/// budget suffices for drawing all waiting pieces. Then the waiting pieces get equal shares of the
/// rest.
///
/// Cost: no allocation once the patch with the most pieces has been seen. A patch gets at most
///       l3d_most_pieces grids and l3d_most_samples vertices.
template <class T> class l3d_patch_dicer {
public:
    /// Dices a patch: adds its pieces to `out` and its counts to `counts`. If `lanes` is not null,
    /// the lane dicer takes all pieces that it can dice.
    ///
    /// Expects: `edges` was built from this net and view, and has only the patch's outer edges;
    ///          tolerance > 0, near > 0.
    void dice(const l3d_image_patch& net, const l3d_normal_net& normals, const l3d_dice_view& view,
              l3d_edge_polylines& edges, l3d_piece_pool& out, l3d_dice_counts& counts,
              l3d_dice_budget& budget, l3d_lane_dicer<T>* lanes = nullptr,
              const l3d_bend_bounds& bends = {});

    /// Dices a patch without a budget.
    void dice(const l3d_image_patch& net, const l3d_normal_net& normals, const l3d_dice_view& view,
              l3d_edge_polylines& edges, l3d_piece_pool& out, l3d_dice_counts& counts) {
        l3d_dice_budget enough;
        dice(net, normals, view, edges, out, counts, enough);
    }

    /// Reserves memory, so that pieces no larger than any of `other` allocate nothing.
    void reserve_as(const l3d_patch_dicer& other) {
        drawer_.reserve_as(other.drawer_);
        waiting_.reserve(other.waiting_.capacity());
    }

private:
    using piece = l3d_surface_piece;

    /// A piece with its planned steps. `excess` is the ratio of the largest number of steps in a
    /// strip to the largest allowed number.
    struct planned {
        explicit planned(const l3d_piece_bounds<T>& of) : nets(of) {}

        l3d_piece_bounds<T> nets;
        l3d_step_plan plan;
        l3d_block_needs needs;
        double vertex_error = 0, row_error = 0, depth_error = 0, row_depth_error = 0;
        double depth_budget = 0, excess = 0;
        /// The factor by which bounds grow where w of chords errs more than planned.
        double depth_growth = 1;
    };

    /// A piece that waits to be cut, or to be drawn in the end.
    struct waiting {
        piece p;
        double excess = 0;
        bool along_u = false;

        friend bool operator<(const waiting& a, const waiting& b) { return a.excess < b.excess; }
    };

    /// The patch that is being diced, and its budget.
    struct task {
        const l3d_dice_view& view;
        const l3d_normal_net& normals;
        l3d_edge_polylines& edges;
        l3d_piece_pool& out;
        l3d_dice_counts& counts;
        const l3d_bend_bounds& bends;
        l3d_dice_budget& budget;
        std::int64_t samples_left = 0;
        l3d_lane_dicer<T>* lanes = nullptr;
    };

    planned plan_of(const piece& p, const task& of, bool with_outlines = true) const;
    bool fits(const l3d_step_plan& plan, bool in_lanes, const task& of) const;
    bool may_cut(const task& of) const;
    void wait(const piece& p, const l3d_step_plan& plan, double excess);
    void take(const piece& p, task& of);
    bool take_in_lanes(const piece& p, task& of);
    void count(const piece& p, const l3d_diced_piece& out, double row_error, bool in_lanes,
               task& of) const;
    void count_surface(const piece& p, const l3d_surface_certificate& proven,
                       double row_depth_error, task& of) const;
    void draw_coarsely(const piece& p, std::int64_t samples, std::int64_t cost, task& of);
    void draw(const piece& p, const planned& how, task& of);

    /// The waiting pieces as a heap, the piece with the largest excess on top.
    std::vector<waiting> waiting_;
    l3d_grid_builder<T> drawer_;
};

#endif
