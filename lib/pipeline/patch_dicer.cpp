// SPDX-License-Identifier: MIT
// l3d_patch_dicer: what is left out, cut, and drawn how finely.
#include "pipeline/patch_dicer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>

namespace {

/// Cuts per patch at most; then pieces are drawn with the steps that are allowed, and the frame
/// reports the larger bound. 4096 pieces of (4 * 32)^2 quads are 67 million quads.
constexpr int most_pieces = 4096;

/// As deep as halving a parameter stays exact in doubles, with room for the strips' quarters.
constexpr int deepest = 48;

/// Whether a box (pixels from the picture's corner) holds no pixel centre k + 1/2, even when
/// snapping moves its points by half a sub-pixel.
bool holds_no_centre(const l3d_image_box& box) {
    constexpr double slack = 1.0 / l3d_subpixel_one;
    const auto none = [](double low, double high) {
        return std::floor(high + slack - 0.5) < std::ceil(low - slack - 0.5);
    };
    return none(box.left, box.right) || none(box.top, box.bottom);
}

} // namespace

template <class T> void l3d_patch_dicer<T>::begin(const l3d_dice_view& view) {
    view_ = view;
    counts_ = {};
}

template <class T>
void l3d_patch_dicer<T>::dice(const image_net& net, const l3d_normal_net& normals,
                              l3d_dice_sink& sink) {
    if (!view_.keep_all)
        if (std::int64_t* reason = reason_to_leave_out(l3d_converted<double>(net))) {
            ++*reason;
            return;
        }
    ++counts_.drawn;
    drawer_.begin(view_, normals, sink);
    pieces_left_ = most_pieces;
    edges_used_ = 0;
    piece whole{net, 0, 1, 0, 1, {}, 0};
    whole.sides[0].edge = new_edge(net.row(0));
    whole.sides[1].edge = new_edge(net.row(3));
    whole.sides[2].edge = new_edge(net.column(0));
    whole.sides[3].edge = new_edge(net.column(3));
    dice_piece(whole);
}

/// The count of patches that are left out for the same reason as this one; null if it may be seen.
template <class T>
std::int64_t* l3d_patch_dicer<T>::reason_to_leave_out(const l3d_image_patch& net) {
    const l3d_depth_range depth = l3d_depth_range_of(net.points);
    if (depth.most <= view_.near)
        return &counts_.behind;
    if (depth.least >= view_.far)
        return &counts_.beyond;
    if (outside(net))
        return &counts_.offscreen;
    if (depth.least <= view_.near)
        return nullptr;
    const l3d_image_box window = view_.window();
    const l3d_image_box box = l3d_image_box_of(net.points);
    return holds_no_centre({box.left - window.left, box.top - window.top, box.right - window.left,
                            box.bottom - window.top})
               ? &counts_.subpixel
               : nullptr;
}

template <class T> bool l3d_patch_dicer<T>::outside(const l3d_image_patch& net) const {
    return l3d_outside(net.points, view_.margin(), view_.near, view_.far);
}

template <class T>
std::size_t l3d_patch_dicer<T>::new_edge(const l3d_bezier_curve<wide, 3>& curve) {
    if (edges_used_ == edges_.size())
        edges_.emplace_back();
    l3d_edge_polyline& edge = edges_[edges_used_];
    edge.build(curve, view_);
    counts_.bound_px = std::max(counts_.bound_px, edge.bound());
    counts_.samples += static_cast<std::int64_t>(edge.points().size());
    return edges_used_++;
}

template <class T> void l3d_patch_dicer<T>::dice_piece(const piece& p) {
    const l3d_piece_nets<T> nets(p.net, view_);
    if ((!view_.keep_all || p.depth > 0) && outside(nets.net()))
        return drawer_.close_hidden(p, counts_.bound_px, edges_);

    double chord_error = 0, vertex_error = nets.vertex_error();
    for (const l3d_piece_side& side : p.sides) {
        chord_error = std::max(chord_error, edges_[side.edge].chord_error());
        vertex_error = std::max(vertex_error, edges_[side.edge].vertex_error());
    }
    const double budget = view_.chord_budget(vertex_error);
    const auto kind = nets.whole() ? l3d_quad_kind::whole : l3d_quad_kind::triangles;
    l3d_step_plan plan = l3d_plan_steps(nets.blocks(), view_, budget, kind);

    const int most = nets.whole() ? l3d_most_steps_whole : l3d_most_steps_clipped;
    const int wanted = std::max(plan.most_u(), plan.most_v());
    if (wanted > most && p.depth < deepest && pieces_left_ > 0)
        return cut(p, plan.most_u() >= plan.most_v());

    if (wanted > l3d_most_steps_whole) {
        // Errors fall with the square of the steps, at the least.
        const double ratio = static_cast<double>(wanted) / l3d_most_steps_whole;
        plan.chord_error *= nets.whole() ? ratio * ratio : std::numeric_limits<double>::infinity();
        for (auto* steps : {&plan.nu, &plan.nv})
            for (int& n : *steps)
                n = std::min(n, l3d_most_steps_whole);
    }
    const double bound = plan.visible ? plan.chord_error + vertex_error : 0;
    // Slits lie between vertices of the piece and of its sides, each off by its own error.
    counts_.bound_px = std::max({counts_.bound_px, bound, chord_error + vertex_error});
    drawer_.draw(p, nets, plan, bound, counts_.bound_px, edges_);
    ++counts_.pieces;
    counts_.clipped += !nets.whole();
    counts_.samples += drawer_.samples();
}

template <class T> void l3d_patch_dicer<T>::cut(const piece& p, bool along_u) {
    --pieces_left_;
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
    const std::size_t edge = new_edge(along_u ? low.net.column(3) : low.net.row(3));
    low.sides[along_u ? 3 : 1] = high.sides[along_u ? 2 : 0] = l3d_piece_side{edge, 0, 1};
    dice_piece(low);
    dice_piece(high);
}

template class l3d_patch_dicer<float>;
template class l3d_patch_dicer<double>;
template class l3d_patch_dicer<l3d_fixed<std::int64_t, 32>>;
