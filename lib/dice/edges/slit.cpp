// SPDX-License-Identifier: MIT
// l3d_fill_slit, l3d_close_side: merging two polylines along one curve.
#include "dice/edges/slit.h"

#include "dice/grid_light.h"
#include "raster/pixel_centres.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

l3d_pixel_centres<std::int32_t> centres_between(std::int32_t a, std::int32_t b, std::int32_t c) {
    return l3d_centres_in(std::min({a, b, c}), std::max({a, b, c}));
}

/// Units: 1/256 pixel.
std::int32_t centre_of(std::int32_t pixel) {
    return (pixel << l3d_subpixel_bits) + l3d_subpixel_one / 2;
}

/// Twice the signed area of p, q and (x, y).
std::int64_t turn(const l3d_micro_vertex& p, const l3d_micro_vertex& q, std::int32_t x,
                  std::int32_t y) {
    return std::int64_t{q.x - p.x} * (y - p.y) - std::int64_t{q.y - p.y} * (x - p.x);
}

/// Whether a triangle covers nothing: its box holds no pixel's centre, or a single one that lies
/// beyond one side, or its corners lie on one line. Nearly all triangles of slits are so.
bool covers_nothing(const l3d_micro_vertex& p, const l3d_micro_vertex& q,
                    const l3d_micro_vertex& r) {
    const auto along_x = centres_between(p.x, q.x, r.x), along_y = centres_between(p.y, q.y, r.y);
    if (along_x.none() || along_y.none())
        return true;
    if (!along_x.only_one() || !along_y.only_one())
        return turn(p, q, r.x, r.y) == 0;
    const std::int32_t x = centre_of(along_x.first), y = centre_of(along_y.first);
    const std::int64_t a = turn(p, q, x, y), b = turn(q, r, x, y), c = turn(r, p, x, y);
    return a + b + c == 0 || (std::min({a, b, c}) < 0 && std::max({a, b, c}) > 0);
}

/// Notes how far a triangle of a slit goes along the grid's side. A corner beyond the side's end
/// has the level of that end, whatever it should be: then it goes farther than anything is known
/// for.
void note_span(l3d_diced_piece& out, bool straight, bool along_u, double low, double high) {
    const std::vector<double>& at = along_u ? out.u : out.v;
    if (at.size() < 2)
        return;
    const double rounding = 1e-9 * (at.back() - at.front());
    if (low < at.front() - rounding || high > at.back() + rounding)
        low = -std::numeric_limits<double>::infinity();
    out.add_span(straight ? out.slits.straight : out.slits.bent, along_u, low, high);
}

void add(const l3d_clip_vertex& a, const l3d_clip_vertex& b, const l3d_clip_vertex& c,
         const l3d_dice_view& view, l3d_diced_piece& out) {
    const bool all_drawable = a.drawable && b.drawable && c.drawable;
    if (all_drawable && covers_nothing(a.dice.vertex, b.dice.vertex, c.dice.vertex))
        return;
    for (const bool along_u : {true, false}) {
        const auto [low, high] = along_u ? std::minmax({a.dice.u, b.dice.u, c.dice.u})
                                         : std::minmax({a.dice.v, b.dice.v, c.dice.v});
        note_span(out, true, along_u, low, high);
    }
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
        l3d_micro_vertex of_row = vertex(i), of_edge = point(j);
        while (i < i_end || j < j_end) {
            const bool along_row =
                i < i_end && (j == j_end || parameters_[i + 1] <= parameter_of(j + 1));
            const l3d_micro_vertex next = along_row ? vertex(i + 1) : point(j + 1);
            if (!covers_nothing(of_edge, of_row, next)) {
                const std::array<double, 3> along{parameter_of(j), parameters_[i],
                                                  along_row ? parameters_[i + 1]
                                                            : parameter_of(j + 1)};
                add({of_edge, of_row, next}, along, i);
            }
            ++(along_row ? i : j);
            (along_row ? of_row : of_edge) = next;
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

    /// Point j of the edge, without light.
    l3d_micro_vertex point(std::size_t j) const {
        return {edge_.x()[j], edge_.y()[j], edge_.inv_w()[j], {}};
    }

    /// A triangle whose corners are lit as the row is at their parameters, near its vertex `near`.
    void add(std::array<l3d_micro_vertex, 3> corners, const std::array<double, 3>& along,
             std::size_t near) {
        if (piece_.has_levels) {
            const auto bend = [&](std::size_t i, std::size_t k) {
                return level_at((along[i] + along[k]) / 2, near) -
                       (corners[i].normal[0] + corners[k].normal[0]) / 2;
            };
            for (std::size_t k = 0; k < corners.size(); ++k)
                corners[k].normal[0] = level_at(along[k], near);
            corners[0].normal[1] = bend(0, 1);
            corners[0].normal[2] = bend(0, 2);
            corners[1].normal[1] = 0;
            corners[1].normal[2] = bend(1, 2);
            corners[2].normal[1] = corners[2].normal[2] = 0;
        } else {
            for (std::size_t k = 0; k < corners.size(); ++k)
                set_normal_at(along[k], near, corners[k].normal);
        }
        const auto [low, high] = std::minmax({along[0], along[1], along[2]});
        note_span(piece_, false, along_u_, low, high);
        piece_.part.triangles.add(corners[0], corners[1], corners[2]);
        if (piece_.keep_parameters)
            for (std::size_t k = 0; k < along.size(); ++k)
                piece_.triangle_uv[k].push_back(
                    along_u_ ? l3d_diced_piece::parameters{along[k], across_}
                             : l3d_diced_piece::parameters{across_, along[k]});
    }

    /// Between which vertices of the row a parameter lies, and how far from the first to the next.
    /// One beyond an end, as of a point of the edge beside a row that begins after it, is there.
    struct place {
        std::size_t before, after;
        float part;
    };
    place place_of(double parameter, std::size_t near) const {
        std::size_t i = std::min(near, parameters_.size() - 2);
        while (i > 0 && parameters_[i] > parameter)
            --i;
        while (i + 2 < parameters_.size() && parameters_[i + 1] <= parameter)
            ++i;
        const double from = parameters_[i], to = parameters_[i + 1];
        const double part = std::clamp((parameter - from) / (to - from), 0.0, 1.0);
        return {first_ + i * step_, first_ + (i + 1) * step_, static_cast<float>(part)};
    }

    /// The row's level, a parabola between two vertices.
    float level_at(double parameter, std::size_t near) const {
        const place at = place_of(parameter, near);
        const auto& level = grid_.normal[0];
        const float bend = grid_.normal[along_u_ ? 1 : 2][at.before];
        return level[at.before] + at.part * (level[at.after] - level[at.before]) +
               4 * bend * at.part * (1 - at.part);
    }

    void set_normal_at(double parameter, std::size_t near, float (&normal)[3]) const {
        const place at = place_of(parameter, near);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& of = grid_.normal[k];
            normal[k] = of[at.before] + at.part * (of[at.after] - of[at.before]);
        }
        l3d_make_unit(normal);
    }

    /// The patch's parameter at a point of the edge.
    double parameter_of(std::size_t j) const { return at_zero_ + per_t_ * edge_.t()[j]; }

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

    // An edge point on this side of the surface: parameters and light along the row.
    const auto on_row = [&](std::size_t j) {
        l3d_clip_vertex v = edge.clip_vertex(j, view);
        const double s = (t[j] - t0) / (t1 - t0);
        v.dice.u = first.u + (last.u - first.u) * s;
        v.dice.v = first.v + (last.v - first.v) * s;
        const auto next = std::upper_bound(row.begin() + 1, row.end() - 1, t[j],
                                           [](double at, const auto& p) { return at < p.t; });
        const l3d_boundary_point &a = next[-1], &b = *next;
        const auto part = static_cast<float>(std::clamp((t[j] - a.t) / (b.t - a.t), 0.0, 1.0));
        const float *from = a.vertex.dice.vertex.normal, *to = b.vertex.dice.vertex.normal;
        for (std::size_t k = 0; k < 3; ++k)
            v.dice.vertex.normal[k] = from[k] + part * (to[k] - from[k]);
        if (!view.makes_levels())
            l3d_make_unit(v.dice.vertex.normal);
        return v;
    };

    const std::ptrdiff_t above = std::upper_bound(t, t + edge.size(), t0) - t;
    auto j = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above, 1) - 1);
    std::size_t i = 0;
    while (i + 1 < row.size() || (j + 1 < edge.size() && t[j + 1] <= t1)) {
        const l3d_boundary_point& p = row[i];
        const l3d_clip_vertex q = on_row(j);
        const bool along_row =
            i + 1 < row.size() && (j + 1 == edge.size() || row[i + 1].t <= t[j + 1]);
        if (along_row)
            add(q, p.vertex, row[++i].vertex, view, out);
        else
            add(q, p.vertex, on_row(++j), view, out);
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
