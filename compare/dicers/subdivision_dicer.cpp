// SPDX-License-Identifier: MIT
// l3d_subdivision_dicer: halves patches recursively until they are flat.
#include "compare/dicers/subdivision_dicer.h"

#include "geom/step_bound.h"
#include "dice/near_clip.h"
#include "dice/normal_columns.h"
#include "compare/dicers/uniform_grid.h"

#include <algorithm>
#include <cstdint>

namespace {

/// The most halvings of a patch, both directions together: triangles are then 2^-12 of it.
constexpr int deepest = 24;

l3d_image_curve edge_of(const l3d_image_patch& net, std::size_t side) {
    return side < 2 ? net.row(side == 0 ? 0 : 3) : net.column(side == 2 ? 0 : 3);
}

bool has_area(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c) {
    return std::int64_t{b.x - a.x} * (c.y - a.y) != std::int64_t{b.y - a.y} * (c.x - a.x);
}

} // namespace

l3d_dice_vertex l3d_subdivision_dicer::vertex_at(const l3d_image_point& h, double u, double v,
                                                 task& of) {
    l3d_dice_vertex result = l3d_canonical_vertex(h, of.view).dice;
    const auto normal = l3d_unit_normal(of.normals.evaluate(u, v));
    std::copy(normal.begin(), normal.end(), result.vertex.normal);
    result.u = u;
    result.v = v;
    ++of.counts.samples;
    return result;
}

/// Whether an edge is straight. Its chord's error, an eighth of the second derivative, is within
/// the budget, and the chord's w errs by an eighth at most.
bool l3d_subdivision_dicer::is_straight(const l3d_image_curve& edge, task& of) {
    const l3d_image_box seen = l3d_image_box_of(edge.points).intersected(of.view.margin());
    if (seen.empty())
        return true;
    const double least = l3d_depth_range_of(edge.points).least;
    const double error = l3d_second_bound_of(edge, seen, least) / 8;
    if (error > of.budget || l3d_depth_bound_of(edge) > least)
        return false;
    of.chord_error = std::max(of.chord_error, error);
    return true;
}

void l3d_subdivision_dicer::dice(const l3d_image_patch& net, const l3d_normal_net& normals,
                                 const l3d_dice_view& view, l3d_piece_pool& out,
                                 l3d_dice_counts& counts) {
    const double vertex_error =
        l3d_evaluated_accuracy(net, view).drawn_error(l3d_vertex_accuracy::in_front);
    task of{normals, view, view.chord_budget(vertex_error), out.next(), counts};
    piece whole{{net}, {}, {}};
    for (const bool high_v : {false, true})
        for (const bool high_u : {false, true})
            whole.corners[2 * std::size_t{high_v} + std::size_t{high_u}] =
                vertex_at(net.at(high_v ? 3 : 0, high_u ? 3 : 0), high_u, high_v, of);
    for (std::size_t side = 0; side < whole.straight.size(); ++side)
        whole.straight[side] = is_straight(edge_of(net, side), of);
    divide(whole, of);
    of.out.bound = of.chord_error + vertex_error;
    counts.bound_px = std::max(counts.bound_px, of.out.bound);
}

void l3d_subdivision_dicer::divide(piece& p, task& of) {
    const l3d_image_box seen = l3d_image_box_of(p.net.points).intersected(of.view.margin());
    if (seen.empty())
        return;
    const double least = l3d_depth_range_of(p.net.points).least;
    const l3d_second_bounds image = l3d_second_bounds_of(p.net, seen, least);
    const double error = image.triangle_error(1, 1);
    const auto& straight = p.straight;
    const bool bent_u = !straight[0] || !straight[1], bent_v = !straight[2] || !straight[3];
    const bool flat =
        error <= of.budget && l3d_depth_bounds_of(p.net).triangle_error(1, 1) <= least / 8;
    if ((flat && !bent_u && !bent_v) || p.depth == deepest) {
        of.chord_error = std::max(of.chord_error, error);
        const auto& c = p.corners;
        of.out.add_triangle(c[0], c[1], c[3]);
        of.out.add_triangle(c[0], c[3], c[2]);
        ++of.counts.pieces;
        return;
    }
    // The cut runs across bent edges. A straight edge need not be halved for its own sake.
    const bool along_u = bent_u != bent_v ? bent_u : image.uu >= image.vv;
    cut(p, along_u, of);
}

void l3d_subdivision_dicer::cut(const piece& p, bool along_u, task& of) {
    auto [low, high] = l3d_halves(p, along_u);
    for (const std::size_t high_side : {std::size_t{0}, std::size_t{1}}) {
        // The cut halves this edge: its ends, and its middle.
        const std::size_t side = (along_u ? 0 : 2) + high_side;
        const std::size_t a = along_u ? 2 * high_side : high_side;
        const std::size_t b = along_u ? a + 1 : a + 2;
        const l3d_image_curve half = edge_of(low.net, side);
        const l3d_dice_vertex middle =
            along_u ? vertex_at(half.points[3], low.u1, high_side ? p.v1 : p.v0, of)
                    : vertex_at(half.points[3], high_side ? p.u1 : p.u0, low.v1, of);
        if (p.straight[side]) {
            if (has_area(p.corners[a].vertex, middle.vertex, p.corners[b].vertex))
                of.out.add_triangle(p.corners[a], middle, p.corners[b]);
        } else {
            low.straight[side] = is_straight(half, of);
            high.straight[side] = is_straight(edge_of(high.net, side), of);
        }
        low.corners[b] = high.corners[a] = middle;
    }
    const std::size_t new_side = along_u ? 3 : 1;
    low.straight[new_side] = high.straight[new_side - 1] =
        is_straight(edge_of(low.net, new_side), of);
    divide(low, of);
    divide(high, of);
}
