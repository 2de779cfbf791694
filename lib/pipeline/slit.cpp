// SPDX-License-Identifier: MIT
// l3d_fill_slit, l3d_close_side: merging two polylines along one curve.
#include "pipeline/slit.h"

#include <algorithm>
#include <cstdint>

namespace {

/// Whether a triangle covers nothing, as its corners lie on one line.
bool flat(const l3d_micro_vertex& p, const l3d_micro_vertex& q, const l3d_micro_vertex& r) {
    return std::int64_t{q.x - p.x} * (r.y - p.y) == std::int64_t{q.y - p.y} * (r.x - p.x);
}

void add(const l3d_clip_vertex& a, const l3d_clip_vertex& b, const l3d_clip_vertex& c,
         const l3d_dice_view& view, l3d_diced_piece& out) {
    const bool all_drawable = a.drawable && b.drawable && c.drawable;
    if (!all_drawable || !flat(a.dice.vertex, b.dice.vertex, c.dice.vertex))
        l3d_clip_triangle(a, b, c, view, out);
}

/// A side of a grid as a row of vertices.
class grid_side {
public:
    grid_side(l3d_diced_piece& piece, std::size_t side)
        : grid_(piece.part.grid), along_u_(side < 2), parameters_(along_u_ ? piece.u : piece.v),
          across_(along_u_ ? (side == 1 ? piece.v.back() : piece.v.front())
                           : (side == 3 ? piece.u.back() : piece.u.front())),
          first_(side == 1   ? grid_.index(grid_.rows - 1, 0)
                 : side == 3 ? grid_.index(0, grid_.columns - 1)
                             : 0),
          step_(along_u_ ? 1 : static_cast<std::size_t>(grid_.pitch)),
          blocks_(along_u_ ? piece.part.block_columns : piece.part.block_rows) {}

    std::size_t size() const { return parameters_.size(); }
    const l3d_block_starts& blocks() const { return blocks_; }

    /// Parameter along the side, from 0 to 1.
    double t(std::size_t i) const { return of_parameter(parameters_[i]); }

    l3d_dice_vertex vertex(std::size_t i) const {
        const std::size_t at = first_ + i * step_;
        return with_parameters({grid_.x[at],
                                grid_.y[at],
                                grid_.inv_w[at],
                                {grid_.normal[0][at], grid_.normal[1][at], grid_.normal[2][at]}},
                               parameters_[i]);
    }

    /// A point of the edge as one of this row's surface, with the normal of vertex `near_by`.
    l3d_dice_vertex on_row(const l3d_edge_polyline& edge, std::size_t j,
                           std::size_t near_by) const {
        const std::size_t at = first_ + near_by * step_;
        const double low = parameters_.front(), high = parameters_.back();
        return with_parameters({edge.x()[j],
                                edge.y()[j],
                                edge.inv_w()[j],
                                {grid_.normal[0][at], grid_.normal[1][at], grid_.normal[2][at]}},
                               low + (high - low) * edge.t()[j]);
    }

    /// Puts vertex i where the edge has its point j.
    void take_over(std::size_t i, const l3d_edge_polyline& edge, std::size_t j) {
        const std::size_t at = first_ + i * step_;
        grid_.x[at] = edge.x()[j];
        grid_.y[at] = edge.y()[j];
        grid_.inv_w[at] = edge.inv_w()[j];
    }

private:
    double of_parameter(double parameter) const {
        return (parameter - parameters_.front()) / (parameters_.back() - parameters_.front());
    }
    l3d_dice_vertex with_parameters(const l3d_micro_vertex& vertex, double along) const {
        return along_u_ ? l3d_dice_vertex{vertex, along, across_}
                        : l3d_dice_vertex{vertex, across_, along};
    }

    l3d_micro_grid& grid_;
    bool along_u_;
    const std::vector<double>& parameters_;
    double across_;
    std::size_t first_, step_;
    const l3d_block_starts& blocks_;
};

} // namespace

void l3d_fill_slit(std::span<const l3d_boundary_point> row, const l3d_edge_polyline& edge,
                   const l3d_dice_view& view, l3d_diced_piece& out) {
    const double t0 = row.front().t, t1 = row.back().t;
    const l3d_dice_vertex &first = row.front().vertex.dice, &last = row.back().vertex.dice;
    const double* t = edge.t();

    // An edge point on this side of the surface: parameters along the row, the row's normal.
    const auto on_row = [&](std::size_t j, const l3d_boundary_point& near_by) {
        l3d_clip_vertex v = edge.clip_vertex(j, view);
        const double s = (t[j] - t0) / (t1 - t0);
        v.dice.u = first.u + (last.u - first.u) * s;
        v.dice.v = first.v + (last.v - first.v) * s;
        std::copy_n(near_by.vertex.dice.vertex.normal, 3, v.dice.vertex.normal);
        return v;
    };

    const std::ptrdiff_t above = std::upper_bound(t, t + edge.size(), t0) - t;
    auto j = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above, 1) - 1);
    std::size_t i = 0;
    while (i + 1 < row.size() || (j + 1 < edge.size() && t[j + 1] <= t1)) {
        const l3d_boundary_point& p = row[i];
        const l3d_clip_vertex q = on_row(j, p);
        const bool along_row =
            i + 1 < row.size() && (j + 1 == edge.size() || row[i + 1].t <= t[j + 1]);
        if (along_row)
            add(q, p.vertex, row[++i].vertex, view, out);
        else
            add(q, p.vertex, on_row(++j, p), view, out);
    }
}

void l3d_close_side(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge) {
    grid_side row(piece, side);
    const l3d_block_starts &mine = row.blocks(), &its = edge.strips();
    const auto last = [](const l3d_block_starts& starts) {
        return static_cast<std::size_t>(starts.first[static_cast<std::size_t>(starts.blocks)]);
    };
    row.take_over(0, edge, 0);
    row.take_over(last(mine), edge, last(its));
    const auto fill = [&](std::size_t i, std::size_t i_end, std::size_t j, std::size_t j_end) {
        while (i < i_end || j < j_end) {
            const l3d_dice_vertex q = row.on_row(edge, j, i), p = row.vertex(i);
            const bool along_row = i < i_end && (j == j_end || row.t(i + 1) <= edge.t()[j + 1]);
            const l3d_dice_vertex next = along_row ? row.vertex(i + 1) : row.on_row(edge, j + 1, i);
            if (!flat(q.vertex, p.vertex, next.vertex))
                piece.add_triangle(q, p, next);
            ++(along_row ? i : j);
        }
    };
    if (mine.blocks != its.blocks)
        return fill(0, last(mine), 0, last(its));
    for (std::size_t s = 0; s < static_cast<std::size_t>(mine.blocks); ++s) {
        const auto i = static_cast<std::size_t>(mine.first[s]),
                   i_end = static_cast<std::size_t>(mine.first[s + 1]);
        const auto j = static_cast<std::size_t>(its.first[s]),
                   j_end = static_cast<std::size_t>(its.first[s + 1]);
        row.take_over(i_end, edge, j_end);
        if (i_end - i != j_end - j) {
            fill(i, i_end, j, j_end);
            continue;
        }
        for (std::size_t k = 1; i + k < i_end; ++k)
            row.take_over(i + k, edge, j + k);
    }
}
