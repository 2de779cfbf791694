// SPDX-License-Identifier: MIT
// l3d_lane_dicer: plans, walks, lights and closes an ordinary patch.
#include "dice/lanes/lane_dicer.h"

#include "geom/block_fixed.h"
#include "geom/forward_difference.h"
#include "dice/drawn_error.h"
#include "dice/piece_bounds.h"
#include "dice/edges/gap_filler.h"
#include "dice/lanes/lane_folds_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

using l3d_detail::lane_register;

/// Bounds the rounding of the doubles from which columns start, relative to the largest centred
/// coordinate. The power coefficients of a bicubic add up to at most 27^2 times its largest control
/// value. Some 25 roundings follow each other: of centring, of differences of differences, of
/// Horner's scheme in u, of balancing and of the weights of forward differences. 25 * 27^2 < 2^15.
constexpr double start_rounding = 0x1p15 * 0x1p-53;

/// Bounds the error of walking l3d_most_steps_whole steps in T, for coordinates up to `largest`.
/// First to third differences of control values are at most 2, 4 and 8 times `largest`. With more
/// strips, differences in a strip are smaller.
template <class T> double walking_error(double largest, int strips) {
    const double s = strips;
    return l3d_forward_difference_error<T>(l3d_most_steps_whole, largest, 2 * largest / s,
                                           4 * largest / (s * s), 8 * largest / (s * s * s));
}

l3d_block_starts starts_of(const l3d_step_plan& plan, const std::array<int, 4>& steps) {
    l3d_block_starts starts;
    starts.blocks = plan.strips;
    for (std::size_t i = 0; i < static_cast<std::size_t>(plan.strips); ++i)
        starts.first[i + 1] = starts.first[i] + steps[i];
    return starts;
}

} // namespace

/// The largest number that the registers for w have to hold.
template <class T> double l3d_lane_dicer<T>::walked_w(const l3d_dice_view& view) const {
    if (!view.is_parallel())
        return bounds_.most_w;
    // Smaller numbers are nothing but rounding.
    const double least = 0x1p-52 * view.w_middle;
    return std::max({least, bounds_.most_w - view.w_middle, view.w_middle - bounds_.least_w});
}

/// Bounds the error of vertices in pixels, if the registers of x, y and of w err by walk_xy and
/// walk_w after the last step.
template <class T>
double l3d_lane_dicer<T>::vertex_error(const l3d_dice_view& view, double walk_xy, double walk_w,
                                       double snap_error) const {
    const l3d_detail::centred_net& net = bounds_.net;
    const l3d_image_box& hull = bounds_.hull;
    const l3d_image_box& seen = bounds_.seen;
    const auto around_centre = [&](const l3d_image_box& box) {
        return l3d_image_box{box.left - net.x, box.top - net.y, box.right - net.x,
                             box.bottom - net.y}
            .reach();
    };
    l3d_vertex_accuracy accuracy;
    accuracy.error_xy = walk_xy + start_rounding * net.largest_xy;
    if (view.is_parallel()) // vertices are not divided by their own w
        accuracy.error_xy += 2 * l3d_parallel_part * view.w_middle * hull.reach();
    accuracy.error_w = walk_w + start_rounding * walked_w(view);
    accuracy.w_low = bounds_.least_w - view.error_w;
    accuracy.seen_reach = around_centre(seen);
    accuracy.reach = around_centre(view.drawn_box(hull));
    accuracy.snap_error = snap_error;
    // The errors of the transform and of moving the centre depend on places in the whole picture.
    const double moved = 4 * 0x1p-53 * bounds_.most_w * hull.reach();
    return accuracy.drawn_error(l3d_vertex_accuracy::in_front) +
           l3d_vertex_error(view.error_xy + moved, view.error_w, seen.reach(),
                            bounds_.least_w - accuracy.error_w);
}

/// Chooses the type of registers and their units. Returns false if no type is exact enough.
template <class T> bool l3d_lane_dicer<T>::choose_registers(const l3d_dice_view& view) {
    const l3d_detail::centred_net& net = bounds_.net;
    const int strips = bounds_.needs.strips;
    const double most_w = l3d_balanced_reach * walked_w(view);
    const double most_xy = std::max(l3d_balanced_reach * net.largest_xy,
                                    l3d_balanced_reach * bounds_.most_w / l3d_subpixel_one);
    const double reach = bounds_.hull.reach() + std::max(std::abs(net.x), std::abs(net.y));
    // The error of a vertex if walking added nothing. The centre of a folded quad is rounded to
    // sub-pixels once more.
    const double centre_snap = l3d_snap_error<double>(0);
    const double exact = vertex_error(view, 0, 0, l3d_snap_error<double>(reach) + centre_snap);
    const auto exact_enough = [&](double walk_xy, double walk_w, double snap, double allowance) {
        vertex_error_ = vertex_error(view, walk_xy, walk_w, snap + centre_snap);
        walk_w_ = walk_w;
        // An error of w moves the vertex along the line of sight.
        return vertex_error_ + view.focal * walk_w / bounds_.least_w - exact <= allowance;
    };

    // Takes the fastest registers that walk exactly enough.
    register_xy_ = register_w_ = 1;
    const double least = view.walk_allowance(exact);
    if constexpr (l3d_is_fixed<T>) {
        const int bits_xy = l3d_block_fraction_bits(most_xy);
        const int bits_w = l3d_block_fraction_bits(most_w);
        const auto walked_in = [&](lane_register kind, int more_bits, double snap,
                                   double allowance) {
            register_ = kind;
            register_xy_ = std::ldexp(1.0, bits_xy + more_bits);
            register_w_ = std::ldexp(1.0, bits_w + more_bits);
            return exact_enough(l3d_block_walk_error(bits_xy + more_bits, l3d_most_steps_whole),
                                l3d_block_walk_error(bits_w + more_bits, l3d_most_steps_whole),
                                snap, allowance);
        };
        // Both x and w are rounded to floats before the division: twice a float's snap error.
        const double snap = 2 * l3d_snap_error<float>(reach) - l3d_snap_error<float>(0);
        return walked_in(lane_register::fixed_32, 0, snap, std::min(view.tolerance / 16, least)) ||
               walked_in(lane_register::fixed_64, 32, l3d_snap_error<double>(reach),
                         view.walk_allowance());
    } else {
        const auto walked_in = [&]<class Number>(Number, lane_register kind, double allowance) {
            register_ = kind;
            return exact_enough(walking_error<Number>(most_xy, strips),
                                walking_error<Number>(most_w, strips),
                                l3d_snap_error<Number>(reach), allowance);
        };
        return (sizeof(T) == 4 && walked_in(0.0F, lane_register::float_32, least)) ||
               walked_in(0.0, lane_register::float_64, view.walk_allowance());
    }
}

template <class T>
const l3d_step_plan* l3d_lane_dicer<T>::plan(const l3d_patch_part& piece, const l3d_dice_view& view,
                                             double edge_vertex, const l3d_bend_bounds& bends) {
    l3d_detail::bounds_in_lanes(piece.net, view, bounds_);
    if (!bounds_.ordinary || !choose_registers(view))
        return nullptr;
    row_error_ = std::max(vertex_error_ - l3d_vertex_accuracy::of_centre(), edge_vertex);
    vertex_error_ = std::max(vertex_error_, edge_vertex);
    const double error_w = walk_w_ + start_rounding * walked_w(view) + view.error_w;
    const double of_depth = l3d_depth_vertex_error(view, error_w, bounds_.least_w);
    depth_error_ = vertex_error_ + of_depth;
    row_depth_error_ = row_error_ + of_depth;
    bounds_.needs.without_normals = 0;
    if (bends)
        bends.ask(piece, view, view.chord_budget(depth_error_), bounds_.needs);
    l3d_ask_for_outlines(piece, view, bounds_.needs);
    kind_ = l3d_whole_kind(view);
    if (kind_ == l3d_quad_kind::whole && bounds_.needs.without_normals == 0)
        kind_ = l3d_quad_kind::convex;
    plan_steps(view);
    // If quads turn out to fold, steps grow until fans fit. If there may be no room for that, plans
    // with fans at once.
    const double more = plan_.fan_error / view.chord_budget(vertex_error_);
    if (kind_ == l3d_quad_kind::convex && more > 1 &&
        std::max(plan_.most_u(), plan_.most_v()) * std::sqrt(more) > l3d_most_steps_whole - 2) {
        kind_ = l3d_quad_kind::whole;
        plan_steps(view);
    }
    return &plan_;
}

template <class T> void l3d_lane_dicer<T>::plan_steps(const l3d_dice_view& view) {
    plan_ = l3d_plan_steps(bounds_.needs, view.chord_budget(vertex_error_), kind_);
}

/// Adds the error of folded quads to the error of the plan, and tells whether the sum is within the
/// budget. Folded quads are looked for only if the budget would not allow every quad to be folded.
template <class T>
bool l3d_lane_dicer<T>::fits_with_folds(const l3d_surface_part& part, const l3d_dice_view& view) {
    const double budget = view.chord_budget(vertex_error_);
    if (kind_ != l3d_quad_kind::convex)
        return true;
    plan_.chord_error =
        plan_.fan_error <= budget
            ? plan_.fan_error
            : std::max(plan_.chord_error, l3d_detail::most_folded(part, plan_.errors));
    return plan_.chord_error <= budget;
}

template <class T>
l3d_surface_certificate
l3d_lane_dicer<T>::certificate(const l3d_patch_part& piece, const l3d_dice_view& view,
                               const l3d_bend_bounds& bends, const l3d_diced_piece& out) const {
    l3d_surface_certificate result = bends.certificate(piece, view, view.chord_budget(depth_error_),
                                                       bounds_.needs, plan_, out.slits, false);
    const unsigned blocks = result.without_normals;
    result.add_to_depth(depth_error_, blocks != 0 ? l3d_most_off_plane(out.part, blocks, view) : 0);
    return result;
}

/// Walks the planned grid: writes the places and depths of its vertices.
template <class T> void l3d_lane_dicer<T>::walk(const l3d_dice_view& view, l3d_surface_part& part) {
    // First, the parameters of columns and rows, and the size of the grid.
    u_.fill(plan_.strips, plan_.nu, plan_.balanced);
    v_.fill(plan_.strips, plan_.nv, plan_.balanced);
    part.block_columns = starts_of(plan_, plan_.nu);
    part.block_rows = starts_of(plan_, plan_.nv);
    part.grid.resize(static_cast<int>(u_.count), static_cast<int>(v_.count));
    part.grid.is_parallel = view.is_parallel();

    const l3d_detail::centred_net& net = bounds_.net;
    const l3d_detail::lane_walk how{.net = net,
                                    .u = u_,
                                    .strips = plan_.strips,
                                    .balanced = plan_.balanced,
                                    .rows = plan_.nv,
                                    .origin_x = view.centre_x() + net.x * l3d_subpixel_one,
                                    .origin_y = view.centre_y() + net.y * l3d_subpixel_one,
                                    .register_xy = register_xy_,
                                    .register_w = register_w_,
                                    .depth_scale = static_cast<float>(view.depth_scale),
                                    .w_middle = view.w_middle,
                                    .depth_slope = view.is_parallel() ? view.depth_slope() : 0};
    l3d_detail::walk_in_lanes(how, register_, part.grid);
}

template <class T>
void l3d_lane_dicer<T>::fill(const l3d_patch_part& piece, const l3d_normal_net& normals,
                             const l3d_dice_view& view, l3d_diced_piece& out) {
    l3d_surface_part& part = out.part;
    walk(view, part);
    const auto walk_finer = [&] {
        const l3d_step_plan coarser = plan_;
        plan_steps(view);
        if (std::max(plan_.most_u(), plan_.most_v()) > l3d_most_steps_whole) {
            plan_ = coarser;
            return false;
        }
        walk(view, part);
        return true;
    };
    if (!fits_with_folds(part, view)) {
        kind_ = l3d_quad_kind::whole;
        walk_finer();
    }
    constexpr int most_more = 2; // each round at most doubles the steps
    const double depth_budget = view.chord_budget(depth_error_);
    for (int more = 0;
         more < most_more && l3d_ask_for_planes(part, plan_, view, depth_budget, bounds_.needs) &&
         walk_finer();
         ++more) {
    }

    // Then levels or normals, at the parameters of the whole patch.
    u_.place(piece.u0, piece.u1);
    v_.place(piece.v0, piece.v1);
    out.has_levels = view.makes_levels();
    if (out.has_levels)
        l3d_detail::levels_in_lanes(normals, u_, v_, view.shading, numbers_, part.grid);
    else
        l3d_detail::normals_in_lanes(normals, u_, v_, view.shading, numbers_, part.grid);

    // Last, the data for slits and counts.
    out.u.assign(u_.at, u_.at + u_.count);
    out.v.assign(v_.at, v_.at + v_.count);
    out.bound = plan_.visible ? plan_.chord_error + vertex_error_ : 0;
}

template <class T>
bool l3d_lane_dicer<T>::dice(const l3d_image_patch& net, const l3d_normal_net& normals,
                             const l3d_dice_view& view, std::span<const l3d_edge_polyline, 4> edges,
                             l3d_diced_piece& out, l3d_dice_counts& counts,
                             const l3d_bend_bounds& bends) {
    double edge_chord = 0, edge_vertex = 0;
    for (const l3d_edge_polyline& edge : edges) {
        if (edge.strips().blocks == 0)
            return false;
        edge_chord = std::max(edge_chord, edge.chord_error());
        edge_vertex = std::max(edge_vertex, edge.vertex_error());
    }
    const l3d_patch_part whole{net};
    if (plan(whole, view, edge_vertex, bends) == nullptr ||
        std::max(plan_.most_u(), plan_.most_v()) > l3d_most_steps_whole)
        return false;

    fill(whole, normals, view, out);
    for (std::size_t side = 0; side < edges.size(); ++side) {
        l3d_close_side(out, side, edges[side], view);
        if (view.shading.antialias)
            l3d_note_outline_edge(out, side, edges[side], view);
        counts.add_edge(edges[side].size(), edges[side].bound());
    }
    // Slits lie between vertices of the patch and of its edges, each with its own error.
    counts.bound_px = std::max({counts.bound_px, out.bound, edge_chord + row_error_});
    counts.add_surface(certificate(whole, view, bends, out), edge_chord + row_depth_error_);
    ++counts.drawn;
    ++counts.pieces;
    ++counts.in_lanes;
    counts.samples += static_cast<std::int64_t>(u_.count * v_.count);
    return true;
}

template class l3d_lane_dicer<float>;
template class l3d_lane_dicer<double>;
template class l3d_lane_dicer<l3d_fixed<std::int64_t, 32>>;
