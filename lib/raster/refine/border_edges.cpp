// SPDX-License-Identifier: MIT
// border_edges: pairs edges by a table of their ends.
#include "raster/refine/border_edges_p.h"

#include "raster/refine/depth_steps_p.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace l3d_detail {

namespace {

/// Tells how a quad turns in the picture at one of its sides: 1 to the right, -1 to the left, 0 if
/// it covers nothing.
int turn_at(const l3d_micro_grid& grid, const l3d_border_edge& edge) {
    const quad_corners v = corners_of(grid, grid.index(edge.row, edge.column));
    const quad_turns turns(v);
    if (turns.level())
        return 0;
    const bool is_right = turns.folded()
                              ? piece_turns_right(v, projective_centre(v, grid.is_parallel),
                                                  static_cast<std::size_t>(edge.side))
                              : turns.area2() > 0;
    return is_right ? 1 : -1;
}

/// Tells how a triangle turns in the picture: 1 to the right, -1 to the left, 0 if it covers
/// nothing.
int turn_of(const l3d_micro_triangles& all, int triangle) {
    const std::int64_t area = all.double_area(static_cast<std::size_t>(triangle));
    return (area > 0 ? 1 : 0) - (area < 0 ? 1 : 0);
}

/// A hash of an edge, which is the same for both directions.
std::uint32_t hash_of(const contour_edge& edge) {
    const auto of = [](scan_point p) {
        const std::uint32_t mixed = static_cast<std::uint32_t>(p.x) * 0x9e3779b1u +
                                    static_cast<std::uint32_t>(p.y) * 0x85ebca77u;
        return mixed ^ mixed >> 15;
    };
    return (of(edge.from) + of(edge.to)) * 0x9e3779b1u;
}

bool equal(scan_point a, scan_point b) {
    return a.x == b.x && a.y == b.y;
}

} // namespace

void border_edges::add(const band_item& item) {
    const l3d_surface_part& part = *item.part;
    const grid_cells& cells = item.cells;
    std::span<const l3d_border_edge> of_quads = part.border, of_triangles = part.border;
    if (part.grid.rows >= 2) {
        const auto end = std::ranges::partition_point(
            part.border, [](const l3d_border_edge& e) { return e.row >= 0; });
        of_quads = {part.border.begin(), end};
        of_triangles = {end, part.border.end()};
    }
    if (item.triangle_begin < item.triangle_end) {
        const auto begin = std::ranges::lower_bound(
            of_triangles, static_cast<int>(item.triangle_begin), {}, &l3d_border_edge::column);
        for (auto e = begin; e != of_triangles.end() && e->column < int(item.triangle_end); ++e)
            if (reaches_rows(*e))
                add_edge(*e, turn_of(part.triangles, e->column));
        return;
    }
    for (const l3d_border_edge& e : of_quads)
        if (e.row >= cells.row_begin && e.row < cells.row_end && e.column >= cells.column_begin &&
            e.column < cells.column_end && reaches_rows(e))
            add_edge(e, turn_at(part.grid, e));
}

/// Whether an edge reaches the band's rows. A vertex on a pixel's border belongs to the pixel above
/// it.
bool border_edges::reaches_rows(const l3d_border_edge& edge) const {
    const auto [high, low] = std::minmax(edge.from_y, edge.to_y);
    return (high - 1) >> l3d_subpixel_bits < bottom_ && low >> l3d_subpixel_bits >= top_ &&
           (edge.from_x != edge.to_x || edge.from_y != edge.to_y);
}

void border_edges::add_edge(const l3d_border_edge& e, int turn) {
    if (turn == 0 && !e.always)
        return;
    contour_edge edge{{e.from_x, e.from_y}, {e.to_x, e.to_y}, e.nearest()};
    if (turn < 0)
        std::swap(edge.from, edge.to);
    edges_.push_back({edge, e.level, e.always ? kind::always : kind::contour});
}

std::span<const contour_edge> border_edges::match() {
    contours_.clear();
    if (edges_.empty())
        return contours_;
    const std::size_t places = std::bit_ceil(2 * edges_.size());
    table_.assign(places, 0);
    const int shift = 32 - std::countr_zero(places);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        border& here = edges_[i];
        if (here.is == kind::always)
            continue;
        std::size_t at = hash_of(here.edge) >> shift;
        for (;; at = (at + 1) % places) {
            if (table_[at] == 0) {
                table_[at] = static_cast<std::uint32_t>(i + 1);
                break;
            }
            border& other = edges_[table_[at] - 1];
            const bool along =
                equal(other.edge.from, here.edge.from) && equal(other.edge.to, here.edge.to);
            const bool against =
                equal(other.edge.from, here.edge.to) && equal(other.edge.to, here.edge.from);
            if (!along && !against)
                continue;
            here.is = kind::inside; // `other` stands for both: a fold, a crease or nothing
            other.is = along || std::abs(other.level - here.level) > jump_levels ? kind::contour
                                                                                 : kind::inside;
            break;
        }
    }
    // The surfaces around an edge may be nearer to the eye than the edge itself: by as much as
    // depth changes in a pixel. So an edge counts as nearer.
    constexpr float in_front = 1 + 1.0f / 512;
    for (border& b : edges_)
        if (b.is != kind::inside) {
            b.edge.nearest *= in_front;
            contours_.push_back(b.edge);
        }
    return contours_;
}

} // namespace l3d_detail
