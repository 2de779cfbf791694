// SPDX-License-Identifier: MIT
// l3d_frame_dicer: gives each patch of a batch a slot, and each worker a memory.
#include "dice/frame_dicer.h"

#include "dice/error_color.h"
#include "dice/snap.h"
#include "scene/culling/facing_cones.h"
#include "scene/placed_net.h"
#include "dice/point_patch.h"
#include "scene/model_eye.h"
#include "scene/culling/visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace {

l3d_vector<double, 4> as_direction(const l3d_vector<double, 3>& v) {
    return {v[0], v[1], v[2], 0.0};
}

/// The tolerance for which trimmed patches are diced. It is smaller than the view's, since the
/// corners that trims make are snapped once more.
double trimmed_tolerance(const l3d_dice_view& view) {
    return std::max(view.tolerance - l3d_trimmed_snap(view), view.tolerance / 2);
}

/// Whether the near plane of a net's own view cuts off a part of the net that the camera's near
/// plane would leave.
bool is_pushed_away(const l3d_image_net& net, const l3d_dice_view& view, double camera_near) {
    return view.near != camera_near && net.w().least < view.near && net.w().most > camera_near;
}

/// For each of a piece's blocks along u or v, finds the patch's block that holds the piece's block.
/// The piece was made by halving the patch.
std::array<std::size_t, 4> blocks_along(const std::vector<double>& parameters) {
    const double low = parameters.front(), size = parameters.back() - low;
    std::array<std::size_t, 4> result;
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = static_cast<std::size_t>(4 * low + size * (static_cast<double>(k) + 0.5));
    return result;
}

/// Finds the piece's blocks that lie in the blocks `backs` of its patch. Counts these blocks and
/// their quads.
unsigned counted_backs(const l3d_diced_piece& piece, unsigned backs, l3d_dice_counts& counts) {
    constexpr std::size_t across = l3d_block_starts::most_blocks;
    const l3d_surface_part& part = piece.part;
    if (backs == 0 || part.grid.rows == 0 || part.block_rows.blocks != across)
        return 0;
    const auto& rows = part.block_rows.first;
    const auto& columns = part.block_columns.first;
    const auto in_rows = blocks_along(piece.v), in_columns = blocks_along(piece.u);
    unsigned result = 0;
    for (std::size_t i = 0; i < l3d_facing_cones::blocks; ++i) {
        const std::size_t row = i / across, column = i % across;
        if (backs >> (across * in_rows[row] + in_columns[column]) & 1) {
            result |= 1U << i;
            ++counts.back_blocks;
            counts.back_quads +=
                (rows[row + 1] - rows[row]) * (columns[column + 1] - columns[column]);
        }
    }
    return result;
}

/// Gives vertices their parameters in place of normals.
void put_parameters(l3d_diced_piece& piece) {
    l3d_micro_grid& grid = piece.part.grid;
    grid.shows_both = false;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const std::size_t at = grid.index(row, column);
            grid.normal[0][at] = static_cast<float>(piece.u[static_cast<std::size_t>(column)]);
            grid.normal[1][at] = static_cast<float>(piece.v[static_cast<std::size_t>(row)]);
            grid.normal[2][at] = 0;
        }
    l3d_micro_triangles& triangles = piece.part.triangles;
    for (std::size_t k = 0; k < piece.triangle_uv.size(); ++k)
        for (std::size_t i = 0; i < triangles.count; ++i) {
            auto& normal = triangles.corners(i, k).normal;
            const std::size_t at = i % l3d_micro_triangles::lanes;
            normal[0][at] = static_cast<float>(piece.triangle_uv[k][i].u);
            normal[1][at] = static_cast<float>(piece.triangle_uv[k][i].v);
            normal[2][at] = 0;
        }
}

} // namespace

template <class T> void l3d_frame_dicer<T>::begin(const l3d_dice_view& view) {
    view_ = view.unlifted();
    for (worker_space& space : each_worker_)
        space.view = view_;
    counts_ = {};
    next_slot_ = patches_before_ = 0;
    for (instance_edges& one : edges_)
        one.is_made = false;
    for (auto one = trims_.begin(); one != trims_.end();)
        one = one->second.forget_all_but(frame_) ? std::next(one) : trims_.erase(one);
    ++frame_;
    counts_.near_z = view_.near;
    budget_left_ = view_.budget();
}

template <class T>
std::span<const l3d_surface_part* const>
l3d_frame_dicer<T>::dice(const l3d_patch_scene& scene, const l3d_scene_culling& culling,
                         std::span<const l3d_placed_patch> batch) {
    first_slot_ = keeps_batches_ ? next_slot_ : 0;
    next_slot_ = first_slot_ + batch.size();
    while (slots_.size() < next_slot_)
        slots_.push_back(keep_parameters_ ? l3d_piece_pool::with_parameters() : l3d_piece_pool());
    if (outcomes_.size() < batch.size())
        outcomes_.resize(batch.size());
    const task of{scene, culling, batch};
    const std::int64_t allowance = culling.is_done() ? budget_left_ : budget_left_ / 2;
    const std::int64_t share =
        allowance / std::max<std::int64_t>(1, static_cast<std::int64_t>(batch.size()));
    wanted_.resize(batch.size());
    std::iota(wanted_.begin(), wanted_.end(), std::size_t{0});
    make_polylines(of);
    prepare_trims(of);
    dice_slots(of, share);
    dice_short_ones(of, allowance, share);
    parts_.clear();
    for (const l3d_piece_pool& slot : std::span(slots_).subspan(first_slot_, batch.size()))
        for (const l3d_diced_piece& piece : slot.used())
            parts_.push_back(&piece.part);
    for (const outcome& result : std::span(outcomes_).first(batch.size())) {
        counts_.add(result.counts);
        budget_left_ -= result.cost;
    }
    budget_left_ = std::max<std::int64_t>(0, budget_left_);
    share_memory_sizes();
    patches_before_ += batch.size();
    return parts_;
}

template <class T>
void l3d_frame_dicer<T>::name_polygons(std::size_t i, const l3d_detail::painted_part& like,
                                       std::size_t& next, l3d_detail::painted_parts& to) {
    for (l3d_diced_piece& piece : slot(i).used()) {
        l3d_surface_part& part = piece.part;
        l3d_micro_triangles& triangles = part.triangles;
        const std::size_t quads = l3d_detail::painted_part::quads(part);
        if (quads + triangles.count > l3d_surface_rasterizer::most_materials - next)
            continue;
        const auto first = static_cast<std::uint32_t>(next);
        next += quads + triangles.count;
        l3d_detail::painted_part painted = like;
        painted.first = first;
        painted.part = &part;
        for (std::size_t k = 0; k < painted.triangles.size(); ++k)
            painted.triangles[k] = piece.triangle_uv[k];
        to.add(painted, piece.u, piece.v);
        part.material = first;
        part.names_quads = true;
        triangles.materials.resize(triangles.count);
        std::iota(triangles.materials.begin(), triangles.materials.end(),
                  first + static_cast<std::uint32_t>(quads));
    }
}

/// Makes the polylines of edges that patches of a batch follow, for each instance that has none in
/// this frame.
template <class T> void l3d_frame_dicer<T>::make_polylines(const task& of) {
    for (const l3d_placed_patch& p : of.batch) {
        const l3d_patch_model& model = of.scene.instances()[p.instance].model();
        if (!model.follows_edges(p.patch))
            continue;
        if (edges_.size() <= p.instance)
            edges_.resize(p.instance + 1);
        instance_edges& one = edges_[p.instance];
        if (std::exchange(one.is_made, true))
            continue;
        one.lines.resize(model.edges().size());
        workers_.for_each(static_cast<int>(one.lines.size()), [&](int item, int) {
            const auto i = static_cast<std::size_t>(item);
            one.lines[i].make(model.edges()[i], of.culling.matrix(p), view_);
        });
        one.off_px = 0;
        for (const l3d_shared_polyline& line : one.lines)
            one.off_px = std::max(one.off_px, line.off_px);
        counts_.edges_px = std::max(counts_.edges_px, one.off_px);
    }
}

/// Makes sure that each trimmed model of the batch has its l3d_kept_trims.
template <class T> void l3d_frame_dicer<T>::prepare_trims(const task& of) {
    for (const l3d_placed_patch& p : of.batch) {
        const l3d_patch_model& model = of.scene.instances()[p.instance].model();
        if (model.has_trims())
            trims_.try_emplace(model.identity(), model).first->second.take_frame(frame_);
    }
}

/// Dices the slots in wanted_, on all workers. Each slot may spend the amount `share` of the
/// budget.
template <class T> void l3d_frame_dicer<T>::dice_slots(const task& of, std::int64_t share) {
    by_height_.clear();
    for (const std::size_t i : wanted_)
        by_height_.add(of.batch[i].middle);
    by_height_.sort_for(workers_);
    workers_.for_each_beside(static_cast<int>(wanted_.size()), [&](int item, int worker) {
        const std::size_t i = wanted_[by_height_[item]];
        dice_slot(i, of, share, each_worker_[static_cast<std::size_t>(worker)]);
    });
}

/// Shares the rest of the budget among patches whose share was too small, and dices these patches
/// again.
template <class T>
void l3d_frame_dicer<T>::dice_short_ones(const task& of, std::int64_t allowance,
                                         std::int64_t share) {
    for (;;) {
        std::int64_t left = allowance;
        wanted_.clear();
        for (std::size_t i = 0; i < of.batch.size(); ++i)
            if (outcomes_[i].is_short)
                wanted_.push_back(i);
            else
                left -= outcomes_[i].cost;
        if (wanted_.empty())
            return;
        const std::int64_t next = left / static_cast<std::int64_t>(wanted_.size());
        if (next < std::max<std::int64_t>(2 * share, 1)) // batches before may have used all
            return;
        share = next;
        dice_slots(of, share);
    }
}

template <class T>
void l3d_frame_dicer<T>::dice_slot(std::size_t i, const task& of, std::int64_t share,
                                   worker_space& space) {
    outcome& result = outcomes_[i];
    l3d_dice_budget budget{share, false};
    slot(i).clear();
    const bool inspects = l3d_sees_patches(view_.shading.mode);
    const l3d_patch_model& model = of.scene.instances()[of.batch[i].instance].model();
    const l3d_trim_region* const region = model.trim(of.batch[i].patch);
    const bool keeps_parameters = keep_parameters_ || inspects || view_.shading.paints;
    slot(i).keep_parameters(keeps_parameters || region);
    space.counts = {};
    space.view.trim = region;
    space.view.tolerance = region ? trimmed_tolerance(view_) : view_.tolerance;
    space.view.keep = view_.keep;
    space.view.edges = nullptr;
    space.view.edge_reach = 0;
    if (model.follows_edges(of.batch[i].patch)) {
        // A patch at an edge is always diced: strips of its neighbours end at its own, even where
        // the patch covers nothing.
        const instance_edges& edges = edges_[of.batch[i].instance];
        space.view.edges = &edges.lines;
        space.view.edge_reach = l3d_longest_shared_chord + edges.off_px;
        space.view.keep.centreless = space.view.keep.dicing = true;
    }
    dice_placed(i, of, budget, space);
    if (region)
        trim(model, of.batch[i].patch, slot(i), keeps_parameters, space);
    const std::uint32_t material =
        inspects ? static_cast<std::uint32_t>(patches_before_ + i)
                 : of.scene.material_of(of.batch[i].instance, of.batch[i].patch);
    std::int64_t unproven = 0;
    for (l3d_diced_piece& piece : slot(i).used()) {
        piece.part.material = material;
        piece.part.names_quads = false;
        if (inspects)
            put_parameters(piece);
        // Nothing is known of the patch's shades. Slits beside a block count as one quad.
        if (!model.has_normal_error(of.batch[i].patch))
            unproven += std::int64_t{piece.part.grid.rows} * piece.part.grid.columns +
                        std::int64_t{4 * l3d_block_needs::most_blocks};
    }
    if (!model.has_normal_error(of.batch[i].patch)) {
        space.counts.unproven_quads = unproven;
        space.counts.shade_bound = space.counts.normal_off = 0;
    }
    result.counts = space.counts;
    result.cost = share - budget.left;
    double bound = space.counts.bound_px;
    if (view_.focal > 0 && !(space.counts.depth_bound_px <= view_.tolerance + l3d_snapped_planes))
        bound = std::max(bound, space.counts.depth_bound_px);
    result.is_short = budget.is_short && !(bound <= view_.tolerance);
    if (bound <= view_.tolerance)
        return;
    result.counts.coarse = 1;
    result.counts.unfinished = result.is_short ? 1 : 0;
    result.counts.coarsest = {bound, of.batch[i].instance, of.batch[i].patch};
}

template <class T>
void l3d_frame_dicer<T>::dice_placed(std::size_t i, const task& of, l3d_dice_budget& budget,
                                     worker_space& space) {
    const l3d_placed_patch& p = of.batch[i];
    const l3d_scene_culling& culling = of.culling;
    const l3d_patch_instance& instance = of.scene.instances()[p.instance];
    const l3d_normal_net& normals = instance.model().normals(p.patch);
    // Cones lie far from a patch's other data, so the first is fetched early.
    __builtin_prefetch(&instance.model().facing(p.patch));
    const l3d_image_net net =
        l3d_placed_net(culling.matrix(p), instance.model().patches()[p.patch]);
    const l3d_patch_reach& reach = instance.model().reach(p.patch);
    const l3d_dice_view& view = space.view;
    space.view.take_share(view_, view_.share_of(instance.reach(reach.whole)));
    if (is_pushed_away(net, view, view_.near))
        space.counts.near_z = std::max(space.counts.near_z, view.near);
    if (l3d_left_out(net, view, space.counts))
        return;
    if (const auto point = view.keep.dicing ? std::nullopt : l3d_point_place_of(net, view)) {
        const auto n = instance.normal_matrix() * as_direction(normals.evaluate(0.5, 0.5));
        l3d_draw_point(*point, net, {n[0], n[1], n[2]}, view, slot(i), space.counts);
        return;
    }
    const unsigned backs = view.edges != nullptr && !view.one_sided
                               ? 0
                               : backs_of(instance, culling.matrix(p), p.patch);
    if (backs == l3d_facing_cones::all) {
        ++space.counts.backfacing;
        return;
    }
    space.view.folds = view_.shading.antialias ? folds_of(instance, culling.matrix(p), p.patch) : 0;
    build_edges(instance, culling.matrix(p), p.patch, net, space);
    const l3d_surface_bends& bends = instance.model().bends(p.patch);
    if (instance.scale() > 0)
        space.bends = l3d_bend_bounds(bends, instance.scale() * view.depth_scale, view.focal);
    else
        space.bends = l3d_bend_bounds(space.own_bends.emplace(bends.under(instance.placement())),
                                      view.depth_scale, view.focal);
    if (view.focal == 0)
        space.bends = {};
    if (instance.turns_normals())
        dice_patch(net, l3d_placed_normals(instance.normal_matrix(), normals), backs, slot(i),
                   budget, space);
    else
        dice_patch(net, normals, backs, slot(i), budget, space);
}

/// Builds the edges of a patch. An edge's rounding errors are bounded from its own control points
/// alone. So patches that share an edge get the same bounds for it. If two smaller patches lie
/// beyond an edge, the edge consists of their two edges.
template <class T>
void l3d_frame_dicer<T>::build_edges(const l3d_patch_instance& instance,
                                     const l3d_matrix<double>& to_image, std::size_t patch,
                                     const l3d_image_patch& net, worker_space& space) const {
    const l3d_patch_model& model = instance.model();
    const auto share_of = [&](const l3d_vector<double, 3>& reach) {
        return view_.share_of(instance.reach(reach));
    };
    std::array<double, l3d_edge_polylines::sides> shares;
    for (std::size_t e = 0; e < shares.size(); ++e)
        shares[e] = share_of(model.reach(patch).edges[e]);
    space.edges.build(net, view_, shares);
    const unsigned halved = model.halved_edges(patch);
    for (std::size_t e = 0; e < shares.size(); ++e) {
        if ((halved >> e & 1) == 0)
            continue;
        // Halves the edge in the model's space, as the smaller patches have it, and places it as
        // their rows are placed.
        const l3d_patch_model::patch& whole = model.patches()[patch];
        const auto [first, second] =
            (e < 2 ? whole.row(e == 0 ? 0 : 3) : whole.column(e == 2 ? 0 : 3)).split();
        l3d_patch_model::patch rows = whole;
        std::array<l3d_vector<double, 3>, 2> reaches{};
        for (int k = 0; k < 4; ++k) {
            rows.at(0, k) = first.points[static_cast<std::size_t>(k)];
            rows.at(1, k) = second.points[static_cast<std::size_t>(k)];
            for (int row = 0; row < 2; ++row)
                for (int i = 0; i < 3; ++i) {
                    double& reach = reaches[static_cast<std::size_t>(row)][i];
                    reach = std::max(reach, std::abs(rows.at(row, k)[i]));
                }
        }
        const l3d_image_patch placed = l3d_placed_net(to_image, rows);
        space.edges.build_halved(e, placed.row(0), placed.row(1), view_,
                                 {share_of(reaches[0]), share_of(reaches[1])});
    }
}

/// Reserves for each worker as much memory as any worker needed, since chance decides which worker
/// gets a patch.
template <class T> void l3d_frame_dicer<T>::share_memory_sizes() {
    worker_space& first = each_worker_.front();
    for (const worker_space& space : each_worker_)
        first.reserve_as(space);
    for (worker_space& space : each_worker_)
        space.reserve_as(first);
}

/// Finds the blocks of a patch that back-face culling leaves out, since only their backs are turned
/// to the eye. With one-sided surfaces, these blocks are left out of every patch. With two-sided
/// surfaces, the patch must belong to a closed body that is wholly in front of the near plane and
/// not opened by a section. The body's front hides its backs.
template <class T>
unsigned l3d_frame_dicer<T>::backs_of(const l3d_patch_instance& instance,
                                      const l3d_matrix<double>& to_image, std::size_t patch) const {
    const l3d_patch_model& model = instance.model();
    if (view_.keep.backs)
        return 0;
    const double share = view_.share_of(instance.reach());
    const double error_w = share * view_.error_w, near = view_.near_of(share);
    const bool is_outside = model.orientation() != 0 && !view_.section.is_on() &&
                            l3d_least_w_of(model, to_image) - error_w > near;
    if (!is_outside && !view_.one_sided)
        return 0;
    // Seen from outside, a body's back is its inside, whichever way its normals point.
    const double side = is_outside ? model.orientation() : 1;
    const auto eye = l3d_eye_of(to_image);
    return eye ? model.facing(patch).away_from(*eye, side) : 0;
}

/// Finds the blocks of a patch that may fold over as seen from the eye. A block may fold over
/// unless it is proven to show one side alone.
template <class T>
unsigned l3d_frame_dicer<T>::folds_of(const l3d_patch_instance& instance,
                                      const l3d_matrix<double>& to_image, std::size_t patch) const {
    const auto eye = l3d_eye_of(to_image);
    if (!eye)
        return l3d_facing_cones::all;
    const l3d_facing_cones& facing = instance.model().facing(patch);
    return l3d_facing_cones::all & ~(facing.away_from(*eye, 1) | facing.away_from(*eye, -1));
}

/// Cuts a patch's pieces at its trims. For a patch of one grid, the model's kept trims are used.
/// For a patch that was cut into pieces, trims are made for each piece.
template <class T>
void l3d_frame_dicer<T>::trim(const l3d_patch_model& model, std::size_t patch, l3d_piece_pool& out,
                              bool keeps_parameters, worker_space& space) {
    l3d_trim_error error;
    const l3d_trim_region& region = *model.trim(patch);
    l3d_kept_trims& kept = trims_.find(model.identity())->second;
    const std::span<l3d_diced_piece> pieces = out.used();
    for (l3d_diced_piece& piece : pieces) {
        const l3d_grid_trims* by = &space.trims_of_piece;
        if (piece.part.grid.rows > 1 && pieces.size() == 1)
            by = &kept.of(patch, piece.u, piece.v, space.workshop);
        else if (piece.part.grid.rows > 1)
            space.trims_of_piece.make(region, piece.u, piece.v, space.workshop);
        error.add(space.trims.cut(region, space.view, piece, *by, keeps_parameters));
    }
    space.counts.bound_px += error.places_px;
    space.counts.depth_bound_px += error.places_px;
    space.counts.normal_off += error.normals;
    space.counts.shade_bound += error.levels;
    for (const l3d_diced_piece& piece : pieces) {
        space.counts.strips_px = std::max(space.counts.strips_px, piece.strips.places);
        space.counts.strips_depth_px = std::max(space.counts.strips_depth_px, piece.strips.depth);
    }
}

template <class T>
void l3d_frame_dicer<T>::dice_patch(const l3d_image_patch& net, const l3d_normal_net& normals,
                                    unsigned backs, l3d_piece_pool& out, l3d_dice_budget& budget,
                                    worker_space& space) const {
    const bool diced = way_ == l3d_dice_way::lanes &&
                       space.lanes.dice(net, normals, space.view, space.edges.outer(), out.next(),
                                        space.counts, space.bends);
    if (!diced) {
        if (way_ == l3d_dice_way::lanes)
            out.give_back();
        space.general.dice(net, normals, space.view, space.edges, out, space.counts, budget,
                           way_ == l3d_dice_way::lanes ? &space.lanes : nullptr, space.bends);
    }
    for (l3d_diced_piece& piece : out.used()) {
        piece.part.error_color = l3d_error_color(piece.bound, view_.tolerance);
        piece.part.unseen =
            way_ == l3d_dice_way::lanes ? counted_backs(piece, backs, space.counts) : 0;
    }
}

template class l3d_frame_dicer<float>;
template class l3d_frame_dicer<double>;
template class l3d_frame_dicer<l3d_fixed<std::int64_t, 32>>;
