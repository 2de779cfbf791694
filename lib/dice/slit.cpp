// SPDX-License-Identifier: MIT
// l3d_fill_slit, l3d_close_side: merging two polylines along one curve.
#include "dice/slit.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace {

/// Whether numbers of 1/256 pixels have no pixel's centre, 256 k + 128, between them.
bool hold_no_centre(std::int32_t a, std::int32_t b, std::int32_t c) {
    constexpr std::int32_t half = l3d_subpixel_one / 2;
    const std::int32_t first = (std::min({a, b, c}) + half - 1) >> l3d_subpixel_bits;
    const std::int32_t last = (std::max({a, b, c}) - half) >> l3d_subpixel_bits;
    return last < first;
}

/// Whether a triangle covers nothing: its box holds no pixel's centre, or its corners lie on one
/// line. Most triangles of slits are so.
bool covers_nothing(const l3d_micro_vertex& p, const l3d_micro_vertex& q,
                    const l3d_micro_vertex& r) {
    return hold_no_centre(p.x, q.x, r.x) || hold_no_centre(p.y, q.y, r.y) ||
           std::int64_t{q.x - p.x} * (r.y - p.y) == std::int64_t{q.y - p.y} * (r.x - p.x);
}

void add(const l3d_clip_vertex& a, const l3d_clip_vertex& b, const l3d_clip_vertex& c,
         const l3d_dice_view& view, l3d_diced_piece& out) {
    const bool all_drawable = a.drawable && b.drawable && c.drawable;
    if (!all_drawable || !covers_nothing(a.dice.vertex, b.dice.vertex, c.dice.vertex))
        l3d_clip_triangle(a, b, c, view, out);
}

/// A side of a piece's grid as a row of vertices, and the edge it lies along.
class closing_side {
public:
    closing_side(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge, double t0,
                 double t1)
        : piece_(piece), grid_(piece.part.grid), edge_(edge), along_u_(side < 2),
          parameters_(along_u_ ? piece.u : piece.v),
          across_(along_u_ ? (side == 1 ? piece.v.back() : piece.v.front())
                           : (side == 3 ? piece.u.back() : piece.u.front())),
          first_(side == 1   ? grid_.index(grid_.rows - 1, 0)
                 : side == 3 ? grid_.index(0, grid_.columns - 1)
                             : 0),
          step_(along_u_ ? 1 : static_cast<std::size_t>(grid_.pitch)),
          per_t_((parameters_.back() - parameters_.front()) / (t1 - t0)),
          at_zero_(parameters_.front() - per_t_ * t0) {}

    /// Puts vertex i where the edge has its point j.
    void take_over(std::size_t i, std::size_t j) {
        const std::size_t at = first_ + i * step_;
        grid_.x[at] = edge_.x()[j];
        grid_.y[at] = edge_.y()[j];
        grid_.inv_w[at] = edge_.inv_w()[j];
    }

    /// Adds the triangles between vertices i to i_end and points j to j_end.
    void fill(std::size_t i, std::size_t i_end, std::size_t j, std::size_t j_end) {
        l3d_micro_vertex of_row = vertex(i), of_edge = on_row(j, of_row);
        while (i < i_end || j < j_end) {
            const bool along_row =
                i < i_end && (j == j_end || parameters_[i + 1] <= parameter_of(j + 1));
            const l3d_micro_vertex next = along_row ? vertex(i + 1) : on_row(j + 1, of_row);
            if (!covers_nothing(of_edge, of_row, next)) {
                piece_.part.triangles.add(of_edge, of_row, next);
                if (piece_.keep_parameters)
                    keep_parameters(i, j, along_row);
            }
            ++(along_row ? i : j);
            (along_row ? of_row : of_edge) = next;
            std::copy_n(of_row.normal, 3, of_edge.normal);
        }
    }

private:
    l3d_micro_vertex vertex(std::size_t i) const {
        const std::size_t at = first_ + i * step_;
        return {grid_.x[at],
                grid_.y[at],
                grid_.inv_w[at],
                {grid_.normal[0][at], grid_.normal[1][at], grid_.normal[2][at]}};
    }

    /// A point of the edge as one of this row's surface, with the normal of a vertex near by.
    l3d_micro_vertex on_row(std::size_t j, const l3d_micro_vertex& near_by) const {
        return {edge_.x()[j],
                edge_.y()[j],
                edge_.inv_w()[j],
                {near_by.normal[0], near_by.normal[1], near_by.normal[2]}};
    }

    /// The patch's parameter at a point of the edge.
    double parameter_of(std::size_t j) const { return at_zero_ + per_t_ * edge_.t()[j]; }

    void keep_parameters(std::size_t i, std::size_t j, bool along_row) {
        const std::array<double, 3> along{parameter_of(j), parameters_[i],
                                          along_row ? parameters_[i + 1] : parameter_of(j + 1)};
        for (std::size_t k = 0; k < along.size(); ++k)
            piece_.triangle_uv[k].push_back(along_u_
                                                ? l3d_diced_piece::parameters{along[k], across_}
                                                : l3d_diced_piece::parameters{across_, along[k]});
    }

    l3d_diced_piece& piece_;
    l3d_micro_grid& grid_;
    const l3d_edge_polyline& edge_;
    bool along_u_;
    const std::vector<double>& parameters_;
    double across_;
    std::size_t first_, step_;
    double per_t_, at_zero_; ///< of parameters along the side by the edge's: whole powers of two
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

void l3d_close_side(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge,
                    double t0, double t1) {
    closing_side row(piece, side, edge, t0, t1);
    const l3d_block_starts& mine = side < 2 ? piece.part.block_columns : piece.part.block_rows;
    const auto start = [](const l3d_block_starts& starts, int block) {
        return static_cast<std::size_t>(starts.first[static_cast<std::size_t>(block)]);
    };
    const std::size_t last = start(mine, mine.blocks);
    const l3d_block_starts* its = edge.strips_between(t0, t1);
    if (its == nullptr || mine.blocks != its->blocks) {
        const std::size_t from = edge.point_before(t0), to = edge.point_before(t1);
        if (t0 == 0)
            row.take_over(0, from);
        if (t1 == 1)
            row.take_over(last, to);
        return row.fill(0, last, from, to);
    }
    row.take_over(0, start(*its, 0));
    for (int s = 0; s < mine.blocks; ++s) {
        const std::size_t i = start(mine, s), i_end = start(mine, s + 1);
        const std::size_t j = start(*its, s), j_end = start(*its, s + 1);
        row.take_over(i_end, j_end);
        if (i_end - i != j_end - j)
            row.fill(i, i_end, j, j_end);
        else
            for (std::size_t k = 1; i + k < i_end; ++k)
                row.take_over(i + k, j + k);
    }
}
