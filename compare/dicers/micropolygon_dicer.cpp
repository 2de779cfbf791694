// SPDX-License-Identifier: MIT
// l3d_micropolygon_dicer: splits patches into small pieces, and dices these.
#include "compare/dicers/micropolygon_dicer.h"

#include "dice/piece_bounds.h"
#include "dice/step_plan.h"

#include <algorithm>
#include <cmath>

namespace {

/// The most cuts of a patch. 2^16 pieces of 32 x 32 quads are sixty million.
constexpr int most_pieces = 1 << 16;

/// The tolerance of the polylines along which pieces meet, in pixels.
constexpr double edge_tolerance = 1.0 / 16;

} // namespace

std::array<double, 2> l3d_micropolygon_lengths(const l3d_image_patch& net) {
    std::array<double, 2> longest{};
    const auto distance = [](const l3d_image_point& a, const l3d_image_point& b) {
        return std::hypot(a[0] / a[2] - b[0] / b[2], a[1] / a[2] - b[1] / b[2]);
    };
    for (int line = 0; line < 4; ++line) {
        double along_u = 0, along_v = 0;
        for (int i = 0; i < 3; ++i) {
            along_u += distance(net.at(line, i), net.at(line, i + 1));
            along_v += distance(net.at(i, line), net.at(i + 1, line));
        }
        longest = {std::max(longest[0], along_u), std::max(longest[1], along_v)};
    }
    return longest;
}

int l3d_micropolygons_along(double length, int a_pixel) {
    constexpr int most = 1 << 20;
    return length * a_pixel < most ? std::max(1, static_cast<int>(std::ceil(length * a_pixel)))
                                   : most;
}

void l3d_micropolygon_dicer::dice(const l3d_image_patch& net, const l3d_normal_net& normals,
                                  const l3d_dice_view& view, l3d_piece_pool& out,
                                  l3d_dice_counts& counts) {
    l3d_dice_view fine = view;
    fine.tolerance = std::min(view.tolerance, edge_tolerance);
    edges_.build(net, fine);
    for (const l3d_edge_polyline& edge : edges_.outer())
        counts.add_edge(edge.size(), edge.bound());
    drawer_.begin(fine, normals, edges_);
    l3d_surface_piece whole{{net}, {}};
    for (std::size_t side = 0; side < whole.sides.size(); ++side)
        whole.sides[side].edge = side;
    task of{fine, out, counts, most_pieces};
    dice_piece(whole, of);
}

void l3d_micropolygon_dicer::dice_piece(const l3d_surface_piece& p, task& of) {
    if (p.depth > 0 && l3d_outside(p.net.points, of.view.margin(), of.view.near, of.view.far))
        return drawer_.close_hidden(p, of.out.next());
    const auto [length_u, length_v] = l3d_micropolygon_lengths(p.net);
    const int wanted_u = l3d_micropolygons_along(length_u, quads_a_pixel_);
    const int wanted_v = l3d_micropolygons_along(length_v, quads_a_pixel_);
    if (std::max(wanted_u, wanted_v) > l3d_most_micropolygons && of.cuts_left > 0)
        return cut(p, wanted_u >= wanted_v, of);

    const l3d_piece_bounds<l3d_real> nets(p.net, of.view);
    l3d_step_plan plan;
    plan.visible = true;
    plan.strips = nets.blocks().size() == 1 ? 1 : l3d_step_plan::most_strips;
    const auto steps = [&](int wanted) {
        return std::min((wanted + plan.strips - 1) / plan.strips, l3d_most_steps_whole);
    };
    plan.nu.fill(steps(wanted_u));
    plan.nv.fill(steps(wanted_v));
    double vertex_error = nets.vertex_error();
    for (const l3d_piece_side& side : p.sides)
        vertex_error = std::max(vertex_error, edges_[side.edge].vertex_error());
    double chord_error = 0, side_error = 0;
    for (const l3d_image_patch& block : nets.blocks()) {
        const l3d_image_box seen = l3d_image_box_of(block.points).intersected(of.view.margin());
        if (!seen.empty())
            chord_error =
                std::max(chord_error,
                         l3d_second_bounds_of(block, seen, l3d_depth_range_of(block.points).least)
                             .quad_error(plan.nu[0], plan.nv[0]));
    }
    for (const l3d_piece_side& side : p.sides)
        side_error = std::max(side_error, edges_[side.edge].chord_error());
    l3d_diced_piece& piece = of.out.next();
    drawer_.draw(p, nets, plan, piece);
    piece.bound = chord_error + vertex_error;
    of.counts.bound_px = std::max(
        {of.counts.bound_px, piece.bound, std::max(side_error, chord_error) + vertex_error});
    ++of.counts.pieces;
    of.counts.samples += static_cast<std::int64_t>(piece.u.size() * piece.v.size());
}

void l3d_micropolygon_dicer::cut(const l3d_surface_piece& p, bool along_u, task& of) {
    --of.cuts_left;
    for (const l3d_surface_piece& half : l3d_cut_piece(p, along_u, of.view, edges_, of.counts))
        dice_piece(half, of);
}
