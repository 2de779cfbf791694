// SPDX-License-Identifier: MIT
// l3d_patch_dicer: chooses which pieces to cut, and the steps of all pieces.
#include "dice/patch_dicer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// The largest number of halvings of a piece. After so many, parameters are still exact in doubles,
/// with room for strips' quarters.
constexpr int deepest = 48;

/// The largest number of vertices of all pieces that still wait when no piece is cut any more.
constexpr std::int64_t most_left_samples = l3d_most_samples / 8;

/// The number of vertices of a plan's grid.
std::int64_t samples_of(const l3d_step_plan& plan) {
    std::int64_t columns = 1, rows = 1;
    for (std::size_t i = 0; i < static_cast<std::size_t>(plan.strips); ++i) {
        columns += plan.nu[i];
        rows += plan.nv[i];
    }
    return columns * rows;
}

std::int64_t cost_of(const l3d_step_plan& plan, bool in_lanes) {
    return samples_of(plan) * (in_lanes ? 1 : l3d_evaluated_cost);
}

/// The cost of a piece's coarsest grid. u and v have four strips each, of one step, so the grid has
/// 5 x 5 samples. The budget reserves this cost for each waiting piece.
constexpr std::int64_t least_cost = 25 * l3d_evaluated_cost;

/// The factor by which a clipped piece's bounds grow if w of its chords errs by `error` instead of
/// the planned near / 2.
///
/// Errors are divided by the exact w. Where the interpolated w is `near`, the exact w is at least
/// near - error. The transform's error of w is at most near / 32, and is subtracted once more: (1/2
/// - 1/32) / (1/4 - 1/32) is less than 1.25 times 2. If near - error is below near / 4, there is no
/// bound.
double growth_by_depth(double error, double near) {
    const double w = near - error;
    if (w >= near / 2)
        return 1;
    return w >= near / 4 ? 1.25 * near / (2 * w) : std::numeric_limits<double>::infinity();
}

/// Bounds the error of w in the chords of a plan's triangles.
double depth_error(const l3d_image_patch& net, const l3d_step_plan& plan) {
    const auto strips = static_cast<std::size_t>(plan.strips);
    const auto least = [&](const auto& steps) {
        return plan.strips * *std::min_element(steps.begin(), steps.begin() + strips);
    };
    return l3d_depth_bounds_of(net).triangle_error(least(plan.nu), least(plan.nv));
}

} // namespace

template <class T>
void l3d_patch_dicer<T>::dice(const l3d_image_patch& net, const l3d_normal_net& normals,
                              const l3d_dice_view& view, l3d_edge_polylines& edges,
                              l3d_piece_pool& out, l3d_dice_counts& counts, l3d_dice_budget& budget,
                              l3d_lane_dicer<T>* lanes, const l3d_bend_bounds& bends) {
    ++counts.drawn;
    for (const l3d_edge_polyline& edge : edges.outer())
        counts.add_edge(edge.size(), edge.bound());
    drawer_.begin(view, normals, edges);
    piece whole{{net}, {}};
    for (std::size_t side = 0; side < whole.sides.size(); ++side)
        whole.sides[side].edge = side;
    task of{view, normals, edges, out, counts, bends, budget, l3d_most_samples, lanes};
    waiting_.clear();
    take(whole, of);
    for (std::size_t pieces = 1; may_cut(of) && pieces < l3d_most_pieces; ++pieces) {
        std::pop_heap(waiting_.begin(), waiting_.end());
        const waiting worst = waiting_.back();
        waiting_.pop_back();
        for (const piece& half :
             l3d_cut_piece(worst.p, worst.along_u, of.view, of.edges, of.counts))
            take(half, of);
    }
    of.samples_left = std::min(of.samples_left, most_left_samples);
    for (std::size_t left = waiting_.size(); left > 0; --left) {
        const auto shares = static_cast<std::int64_t>(left);
        draw_coarsely(waiting_[left - 1].p, of.samples_left / shares, budget.left / shares, of);
    }
}

/// Whether a piece has to be cut and may be cut. The budget must then suffice for drawing its
/// halves and all waiting pieces.
template <class T> bool l3d_patch_dicer<T>::may_cut(const task& of) const {
    if (waiting_.empty() || waiting_.front().excess <= 1)
        return false;
    const auto count = static_cast<std::int64_t>(waiting_.size());
    of.budget.is_short = of.budget.left < (count + 1) * least_cost + 2 * l3d_piece_cost;
    return !of.budget.is_short;
}

/// Whether a grid of this plan may be drawn at once. The rest of the budget must suffice for
/// drawing all waiting pieces.
template <class T>
bool l3d_patch_dicer<T>::fits(const l3d_step_plan& plan, bool in_lanes, const task& of) const {
    const std::int64_t kept = static_cast<std::int64_t>(waiting_.size()) * least_cost;
    return samples_of(plan) <= of.samples_left && cost_of(plan, in_lanes) <= of.budget.left - kept;
}

/// Lets a piece wait. A waiting piece is cut if its excess is above 1. Otherwise it is drawn after
/// all cuts.
template <class T>
void l3d_patch_dicer<T>::wait(const piece& p, const l3d_step_plan& plan, double excess) {
    waiting_.push_back({p, p.depth < deepest ? excess : 0, plan.most_u() >= plan.most_v()});
    std::push_heap(waiting_.begin(), waiting_.end());
}

template <class T>
auto l3d_patch_dicer<T>::plan_of(const piece& p, const task& of, bool with_outlines) const
    -> planned {
    planned result(l3d_piece_bounds<T>(p.net, of.view));
    result.vertex_error = result.nets.vertex_error();
    result.row_error = result.nets.row_error();
    for (const l3d_piece_side& side : p.sides) {
        const double of_side = of.edges[side.edge].vertex_error();
        result.vertex_error = std::max(result.vertex_error, of_side);
        result.row_error = std::max(result.row_error, of_side);
    }
    const bool whole = result.nets.whole();
    const l3d_quad_kind kind = whole ? l3d_whole_kind(of.view) : l3d_quad_kind::triangles;
    const double budget = of.view.chord_budget(result.vertex_error);
    result.needs = l3d_needs_of(result.nets.net(), result.nets.blocks(), of.view, budget, kind);
    const double of_depth =
        l3d_depth_vertex_error(of.view, result.nets.error_w(), of.view.drawn_w(p.net.w().least));
    result.depth_error = result.vertex_error + of_depth;
    result.row_depth_error = result.row_error + of_depth;
    result.depth_budget = of.view.chord_budget(result.depth_error);
    if (of.bends)
        of.bends.ask(p, of.view, result.depth_budget, result.needs);
    if (with_outlines)
        l3d_ask_for_outlines(p, of.view, result.needs);
    result.plan = l3d_plan_steps(result.needs, budget, kind);
    result.excess = static_cast<double>(std::max(result.plan.most_u(), result.plan.most_v())) /
                    (whole ? l3d_most_steps_whole : l3d_most_steps_clipped);
    return result;
}

/// Decides about a piece. It is left out if it is outside of the picture, and drawn if its plan
/// fits. Any other piece waits to be cut.
template <class T> void l3d_patch_dicer<T>::take(const piece& p, task& of) {
    of.budget.left -= l3d_piece_cost;
    if ((!of.view.keep.outside || p.depth > 0) &&
        (of.view.section.cuts_off(p.net.points) ||
         l3d_outside(p.net.points, of.view.margin(), of.view.near, of.view.far)))
        return drawer_.close_hidden(p, of.out.next());
    if (of.lanes != nullptr && take_in_lanes(p, of))
        return;
    const planned how = plan_of(p, of);
    if (how.excess <= 1 && fits(how.plan, false, of))
        draw(p, how, of);
    else
        wait(p, how.plan, how.excess);
}

/// Dices a piece in lanes, or lets it wait. Returns false, with nothing done, if lanes cannot dice
/// it.
template <class T> bool l3d_patch_dicer<T>::take_in_lanes(const piece& p, task& of) {
    double edge_vertex = 0;
    for (const l3d_piece_side& side : p.sides)
        edge_vertex = std::max(edge_vertex, of.edges[side.edge].vertex_error());
    const l3d_step_plan* plan = of.lanes->plan(p, of.view, edge_vertex, of.bends);
    if (plan == nullptr)
        return false;
    const double excess =
        static_cast<double>(std::max(plan->most_u(), plan->most_v())) / l3d_most_steps_whole;
    if (excess <= 1 && fits(*plan, true, of)) {
        l3d_diced_piece& out = of.out.next();
        of.lanes->fill(p, of.normals, of.view, out);
        drawer_.close(p, out);
        count(p, out, of.lanes->row_error(), true, of);
        count_surface(p, of.lanes->certificate(p, of.view, of.bends, out),
                      of.lanes->row_depth_error(), of);
        ++of.counts.in_lanes;
        return true;
    }
    wait(p, *plan, excess);
    return true;
}

/// Draws a piece with fewer steps than the tolerance needs.
template <class T>
void l3d_patch_dicer<T>::draw_coarsely(const piece& p, std::int64_t samples, std::int64_t cost,
                                       task& of) {
    planned how = plan_of(p, of, false);
    const bool whole = how.nets.whole();
    double ratio = 1;
    int most = l3d_most_steps_whole;
    const l3d_step_plan wanted = how.plan;
    do {
        ratio = 1;
        for (std::size_t i = 0; i < static_cast<std::size_t>(wanted.strips); ++i) {
            how.plan.nu[i] = std::min(wanted.nu[i], most);
            how.plan.nv[i] = std::min(wanted.nv[i], most);
            ratio = std::max({ratio, static_cast<double>(wanted.nu[i]) / how.plan.nu[i],
                              static_cast<double>(wanted.nv[i]) / how.plan.nv[i]});
        }
        most /= 2;
    } while (most > 0 && (samples_of(how.plan) > samples || cost_of(how.plan, false) > cost));
    // Errors of unbalanced vertices fall at least with the square of the steps. So does the error
    // of w. It multiplies vertex errors by 1 + ratio^2 / 8 + 1 / 8 instead of
    // l3d_vertex_accuracy::in_front, which is at most 1.25 ratio^2.
    if (ratio > 1) {
        if (how.plan.balanced)
            how.plan.chord_error /= 8 * l3d_balance;
        how.plan.balanced = false;
        how.plan.bend_error = l3d_bend_error_of(how.needs, how.plan);
        const double growth =
            whole ? ratio * ratio : growth_by_depth(depth_error(p.net, how.plan), of.view.near);
        how.plan.chord_error *= whole ? growth : ratio * ratio * growth;
        how.vertex_error *= growth;
        how.row_error *= growth;
        how.depth_error *= growth;
        how.row_depth_error *= growth;
        how.depth_growth = whole ? 1 : growth;
        of.budget.is_short = true;
    }
    draw(p, how, of);
}

template <class T> void l3d_patch_dicer<T>::draw(const piece& p, const planned& how, task& of) {
    l3d_diced_piece& out = of.out.next();
    drawer_.draw(p, how.nets, how.plan, out);
    out.bound = how.plan.visible ? how.plan.chord_error + how.vertex_error : 0;
    count(p, out, how.row_error, false, of);
    l3d_surface_certificate proven = of.bends.certificate(p, of.view, how.depth_budget, how.needs,
                                                          how.plan, out.slits, !how.nets.whole());
    proven.depth *= how.depth_growth;
    proven.depth_without_normals *= how.depth_growth;
    double off_plane = 0;
    if (proven.without_normals != 0)
        off_plane = how.nets.whole() ? l3d_most_off_plane(out.part, proven.without_normals, of.view)
                                     : std::numeric_limits<double>::infinity();
    proven.add_to_depth(how.depth_error, off_plane);
    if (std::isinf(how.depth_growth))
        proven.depth = proven.shade = how.depth_growth;
    count_surface(p, proven, how.row_depth_error, of);
    of.counts.clipped += !how.nets.whole();
}

/// Adds a piece's bounds of depth and shade to the counts. `row_depth_error` is the error of depth
/// in the vertices of the piece's slits.
template <class T>
void l3d_patch_dicer<T>::count_surface(const piece& p, const l3d_surface_certificate& proven,
                                       double row_depth_error, task& of) const {
    double side_error = 0;
    for (const l3d_piece_side& side : p.sides)
        side_error = std::max(side_error, of.edges[side.edge].chord_error());
    of.counts.add_surface(proven, side_error + row_depth_error);
}

/// Adds a drawn piece to the counts. `row_error` is the error of places in the vertices of the
/// piece's slits.
template <class T>
void l3d_patch_dicer<T>::count(const piece& p, const l3d_diced_piece& out, double row_error,
                               bool in_lanes, task& of) const {
    double side_error = 0;
    for (const l3d_piece_side& side : p.sides)
        side_error = std::max(side_error, of.edges[side.edge].chord_error());
    // Slits lie between vertices of the piece and of its sides, each with its own error.
    of.counts.bound_px = std::max({of.counts.bound_px, out.bound, side_error + row_error});
    ++of.counts.pieces;
    const auto samples = static_cast<std::int64_t>(out.u.size() * out.v.size());
    of.counts.samples += samples;
    of.samples_left = std::max(std::int64_t{0}, of.samples_left - samples);
    of.budget.left -= samples * (in_lanes ? 1 : l3d_evaluated_cost);
}

template class l3d_patch_dicer<float>;
template class l3d_patch_dicer<double>;
template class l3d_patch_dicer<l3d_fixed<std::int64_t, 32>>;
