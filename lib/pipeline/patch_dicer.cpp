// SPDX-License-Identifier: MIT
// l3d_patch_dicer: what is cut, and drawn how finely.
#include "pipeline/patch_dicer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>

namespace {

/// Cuts per patch at most; then pieces are drawn with the steps that are allowed, and the frame
/// reports the larger bound. 4096 pieces of (4 * 32)^2 quads are 67 million quads.
constexpr int most_pieces = 4096;

/// As deep as halving a parameter stays exact in doubles, with room for the strips' quarters.
constexpr int deepest = 48;

} // namespace

template <class T>
void l3d_patch_dicer<T>::dice(const l3d_image_patch& net, const l3d_normal_net& normals,
                              const l3d_dice_view& view, l3d_edge_polylines& edges,
                              l3d_diced_pieces& out, l3d_dice_counts& counts) {
    ++counts.drawn;
    for (const l3d_edge_polyline& edge : edges.outer())
        counts.add_edge(edge.size(), edge.bound());
    drawer_.begin(view, normals, edges);
    piece whole{net, 0, 1, 0, 1, {}, 0};
    for (std::size_t side = 0; side < whole.sides.size(); ++side)
        whole.sides[side].edge = side;
    task of{view, edges, out, counts, most_pieces};
    dice_piece(whole, of);
}

template <class T> void l3d_patch_dicer<T>::dice_piece(const piece& p, task& of) {
    const l3d_piece_nets<T> nets(p.net, of.view);
    if ((!of.view.keep_all || p.depth > 0) &&
        l3d_outside(p.net.points, of.view.margin(), of.view.near, of.view.far)) {
        drawer_.close_hidden(p, of.out.next());
        return;
    }
    double vertex_error = nets.vertex_error();
    for (const l3d_piece_side& side : p.sides)
        vertex_error = std::max(vertex_error, of.edges[side.edge].vertex_error());
    const double budget = of.view.chord_budget(vertex_error);
    const auto kind = nets.whole() ? l3d_quad_kind::whole : l3d_quad_kind::triangles;
    l3d_step_plan plan = l3d_plan_steps(nets.net(), nets.blocks(), of.view, budget, kind);

    const int most = nets.whole() ? l3d_most_steps_whole : l3d_most_steps_clipped;
    const int wanted = std::max(plan.most_u(), plan.most_v());
    if (wanted > most && p.depth < deepest && of.cuts_left > 0)
        return cut(p, plan.most_u() >= plan.most_v(), of);

    if (wanted > l3d_most_steps_whole) {
        // Errors of what is not balanced fall with the square of the steps, at the least.
        const double ratio = static_cast<double>(wanted) / l3d_most_steps_whole;
        if (plan.balanced)
            plan.chord_error /= 8 * l3d_balance;
        plan.balanced = false;
        plan.chord_error *= nets.whole() ? ratio * ratio : std::numeric_limits<double>::infinity();
        for (auto* steps : {&plan.nu, &plan.nv})
            for (int& n : *steps)
                n = std::min(n, l3d_most_steps_whole);
    }
    draw(p, nets, plan, vertex_error, of);
}

template <class T>
void l3d_patch_dicer<T>::draw(const piece& p, const l3d_piece_nets<T>& nets, l3d_step_plan& plan,
                              double vertex_error, task& of) {
    l3d_diced_piece& out = of.out.next();
    drawer_.draw(p, nets, plan, out);
    out.bound = plan.visible ? plan.chord_error + vertex_error : 0;
    double side_error = 0;
    for (const l3d_piece_side& side : p.sides)
        side_error = std::max(side_error, of.edges[side.edge].chord_error());
    // Slits lie between vertices of the piece and of its sides, each off by its own error.
    of.counts.bound_px = std::max({of.counts.bound_px, out.bound, side_error + vertex_error});
    ++of.counts.pieces;
    of.counts.clipped += !nets.whole();
    of.counts.samples += static_cast<std::int64_t>(out.u.size() * out.v.size());
}

template <class T> void l3d_patch_dicer<T>::cut(const piece& p, bool along_u, task& of) {
    --of.cuts_left;
    piece low = p, high = p;
    low.depth = high.depth = p.depth + 1;
    if (along_u) {
        std::tie(low.net, high.net) = p.net.split_u();
        low.u1 = high.u0 = (p.u0 + p.u1) / 2;
    } else {
        std::tie(low.net, high.net) = p.net.split_v();
        low.v1 = high.v0 = (p.v0 + p.v1) / 2;
    }
    // The sides across the cut are halved; the cut itself is a new edge, whole for both.
    for (const std::size_t across : {along_u ? std::size_t{0} : 2, along_u ? std::size_t{1} : 3}) {
        const double middle = (p.sides[across].t0 + p.sides[across].t1) / 2;
        low.sides[across].t1 = high.sides[across].t0 = middle;
    }
    const std::size_t edge = of.edges.add(along_u ? low.net.column(3) : low.net.row(3), of.view);
    of.counts.add_edge(of.edges[edge].size(), of.edges[edge].bound());
    low.sides[along_u ? 3 : 1] = high.sides[along_u ? 2 : 0] = l3d_piece_side{edge, 0, 1};
    dice_piece(low, of);
    dice_piece(high, of);
}

template class l3d_patch_dicer<float>;
template class l3d_patch_dicer<double>;
template class l3d_patch_dicer<l3d_fixed<std::int64_t, 32>>;
