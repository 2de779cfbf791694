// SPDX-License-Identifier: MIT
// l3d_method_kept: finds grids that still fit, and dices the others.
#include "compare/method_kept.h"

#include "compare/dicers/micropolygon_dicer.h"
#include "dice/snap.h"
#include "geom/forward_difference.h"
#include "geom/real.h"
#include "pipeline/stopwatch_p.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// The factor by which a grid is diced finer than necessary, and the factor by which it is too fine
/// to be kept.
constexpr double headroom = 1.25, too_fine = 4;

/// The most cuts of a patch, as in l3d_micropolygon_dicer.
constexpr int most_pieces = 1 << 16;

bool fits(int steps, int wanted) {
    return wanted <= steps && steps <= std::max(too_fine * wanted, 2.0);
}

int steps_for(int wanted) {
    return static_cast<int>(std::ceil(wanted * headroom));
}

} // namespace

void l3d_kept_micropolygons::draw(const l3d_method_patch& patch, const l3d_dice_view& view,
                                  l3d_dice_counts& counts) {
    for (const auto& grid : grids_)
        grid->is_used = false;
    task of{patch, view, counts, most_pieces};
    visit({patch.net}, of);
    std::erase_if(grids_, [](const auto& grid) { return !grid->is_used; });
    counts.bound_px = std::numeric_limits<double>::infinity();
}

/// Draws a piece by a kept grid, or dices it. A piece is cut along u first, whichever side is
/// longer now, so that the next frame has the same pieces.
void l3d_kept_micropolygons::visit(const l3d_patch_part& p, task& of) {
    if (p.depth > 0 && l3d_outside(p.net.points, of.view.margin(), of.view.near, of.view.far))
        return;
    const auto [length_u, length_v] = l3d_micropolygon_lengths(p.net);
    const int wanted_u = l3d_micropolygons_along(length_u, quads_a_pixel_);
    const int wanted_v = l3d_micropolygons_along(length_v, quads_a_pixel_);
    kept_grid* grid = find(p);
    if (!grid || !fits(grid->steps_u(), wanted_u) || !fits(grid->steps_v(), wanted_v)) {
        const bool is_large = std::max(wanted_u, wanted_v) > l3d_most_micropolygons;
        const parts_kept inside = parts_inside(p);
        const bool stays_cut =
            inside != parts_kept::none && 2 * std::max(wanted_u, wanted_v) > l3d_most_micropolygons;
        if ((is_large || stays_cut) && of.cuts_left > 0) {
            --of.cuts_left;
            const bool along_u =
                is_large ? wanted_u > l3d_most_micropolygons : inside == parts_kept::narrower;
            for (const l3d_patch_part& half : l3d_halves(p, along_u))
                visit(half, of);
            return;
        }
        if (!grid) {
            grids_.push_back(std::make_unique<kept_grid>());
            grid = grids_.back().get();
            *grid = {p.u0, p.u1, p.v0, p.v1, {}, {}};
        }
        constexpr int most = 2 * l3d_most_micropolygons; // only if no cuts are left
        dice(*grid, of.patch, std::min(steps_for(wanted_u), most),
             std::min(steps_for(wanted_v), most));
        of.counts.samples += std::int64_t{grid->part.grid.columns} * grid->part.grid.rows;
    }
    grid->is_used = true;
    grid->part.material = of.patch.material;
    ++of.counts.pieces;
    project(*grid, of);
}

l3d_kept_micropolygons::kept_grid* l3d_kept_micropolygons::find(const l3d_patch_part& p) const {
    const auto found = std::find_if(grids_.begin(), grids_.end(), [&](const auto& grid) {
        return grid->u0 == p.u0 && grid->u1 == p.u1 && grid->v0 == p.v0 && grid->v1 == p.v1;
    });
    return found == grids_.end() ? nullptr : found->get();
}

l3d_kept_micropolygons::parts_kept
l3d_kept_micropolygons::parts_inside(const l3d_patch_part& p) const {
    const auto found = std::find_if(grids_.begin(), grids_.end(), [&](const auto& grid) {
        return grid->u0 >= p.u0 && grid->u1 <= p.u1 && grid->v0 >= p.v0 && grid->v1 <= p.v1 &&
               (grid->u1 - grid->u0 < p.u1 - p.u0 || grid->v1 - grid->v0 < p.v1 - p.v0);
    });
    return found == grids_.end()                       ? parts_kept::none
           : (*found)->u1 - (*found)->u0 < p.u1 - p.u0 ? parts_kept::narrower
                                                       : parts_kept::shorter;
}

void l3d_kept_micropolygons::dice(kept_grid& grid, const l3d_method_patch& patch, int steps_u,
                                  int steps_v) {
    l3d_micro_grid& to = grid.part.grid;
    to.resize(steps_u + 1, steps_v + 1);
    grid.part.block_columns = {1, {0, steps_u}};
    grid.part.block_rows = {1, {0, steps_v}};
    for (auto& coordinate : grid.place)
        coordinate.resize(static_cast<std::size_t>(to.pitch) * static_cast<std::size_t>(to.rows));
    columns_.resize(static_cast<std::size_t>(to.columns));
    for (int c = 0; c < to.columns; ++c) {
        const double u = grid.u0 + (grid.u1 - grid.u0) * c / steps_u;
        const auto whole = patch.surface->curve_at_u(u);
        // The part of the curve between v0 and v1, in its own parameter.
        std::array<l3d_patch_model::vector, 4> b;
        for (std::size_t k = 0; k < 4; ++k) {
            auto q = whole.points;
            for (std::size_t level = 3; level > 0; --level)
                for (std::size_t i = 0; i < level; ++i)
                    q[i] = l3d_lerp<double, 3>(q[i], q[i + 1], level <= k ? grid.v1 : grid.v0);
            b[k] = q[0];
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = static_cast<int>(i);
            auto walk = l3d_forward_difference<l3d_real, 3>::build(
                {b[0][at], b[1][at], b[2][at], b[3][at]}, steps_v);
            for (int r = 0; r < to.rows; ++r) {
                grid.place[i][to.index(r, c)] = static_cast<float>(l3d_to_double(walk.value()));
                walk.step();
            }
        }
        columns_.set(static_cast<std::size_t>(c), patch.normals, u);
    }
    for (int r = 0; r < to.rows; ++r) {
        const std::size_t at = to.index(r, 0);
        columns_.emit(grid.v0 + (grid.v1 - grid.v0) * r / steps_v, &to.normal[0][at],
                      &to.normal[1][at], &to.normal[2][at]);
    }
}

void l3d_kept_micropolygons::project(kept_grid& grid, const task& of) {
    const l3d_matrix<double>& m = *of.patch.to_image;
    l3d_micro_grid& to = grid.part.grid;
    const auto depth_scale = static_cast<float>(of.view.depth_scale);
    const double least = of.view.near / l3d_guard_band;
    for (int r = 0; r < to.rows; ++r)
        for (std::size_t i = to.index(r, 0), end = i + static_cast<std::size_t>(to.columns);
             i < end; ++i) {
            const auto x = double(grid.place[0][i]), y = double(grid.place[1][i]),
                       z = double(grid.place[2][i]);
            const double w = std::max(m(3, 0) * x + m(3, 1) * y + m(3, 2) * z + m(3, 3), least);
            const double reach = l3d_guard_band * w;
            const l3d_snapped s = l3d_snap(
                std::clamp(m(0, 0) * x + m(0, 1) * y + m(0, 2) * z + m(0, 3), -reach, reach),
                std::clamp(m(1, 0) * x + m(1, 1) * y + m(1, 2) * z + m(1, 3), -reach, reach), w);
            to.x[i] = s.x + of.view.centre_x();
            to.y[i] = s.y + of.view.centre_y();
            to.inv_w[i] = s.inv_w * depth_scale;
        }
}

void l3d_kept_micropolygons::add_to(std::vector<const l3d_surface_part*>& parts) const {
    for (const auto& grid : grids_)
        parts.push_back(&grid->part);
}

std::size_t l3d_kept_micropolygons::bytes() const {
    constexpr std::size_t each = 2 * sizeof(std::int32_t) + 7 * sizeof(float);
    std::size_t sum = 0;
    for (const auto& grid : grids_)
        sum += sizeof(kept_grid) + each * grid->part.grid.x.size();
    return sum;
}

l3d_method_kept::l3d_method_kept(int quads_a_pixel, const l3d_rasterizer_factory& rasterizers,
                                 l3d_workers& workers)
    : quads_a_pixel_(quads_a_pixel), surface_(rasterizers.create_surface(workers)),
      patches_(workers) {}

void l3d_method_kept::do_draw(const l3d_method_frame& frame, l3d_stage_times& times) {
    const l3d_detail::stopwatch dicing;
    if (!diced_of_.holds(frame.scene)) {
        diced_of_.remember(frame.scene);
        kept_.clear();
        is_seen_.clear();
        for (const l3d_patch_instance& instance : frame.scene.instances()) {
            const std::size_t count = instance.model().patches().size();
            auto& kept = kept_.emplace_back();
            for (std::size_t i = 0; i < count; ++i)
                kept.emplace_back(quads_a_pixel_);
            is_seen_.emplace_back(count);
        }
    }
    for (auto& of_instance : is_seen_)
        std::ranges::fill(of_instance, char{0});
    const auto clipped =
        patches_.dice_each(frame, [this](const l3d_method_patch& patch, const l3d_dice_view& view,
                                         int, l3d_piece_pool&, l3d_dice_counts& counts) {
            is_seen_[patch.placed.instance][patch.placed.patch] = 1;
            kept_[patch.placed.instance][patch.placed.patch].draw(patch, view, counts);
        });
    parts_.assign(clipped.begin(), clipped.end());
    for (std::size_t i = 0; i < kept_.size(); ++i)
        for (std::size_t j = 0; j < kept_[i].size(); ++j)
            if (is_seen_[i][j])
                kept_[i][j].add_to(parts_);
            else
                kept_[i][j].clear();
    times.dice += dicing.milliseconds();
    l3d_fill_parts(*surface_, frame, parts_, times);
}

std::size_t l3d_method_kept::bytes() const {
    std::size_t sum = 0;
    for (const auto& of_instance : kept_)
        for (const l3d_kept_micropolygons& each : of_instance)
            sum += each.bytes();
    return sum;
}
