// SPDX-License-Identifier: MIT
// l3d_fill_gap, l3d_close_side: merge two polylines along one curve.
#include "dice/edges/gap_filler.h"

#include "dice/grid_light.h"
#include "dice/facing_fix.h"
#include "raster/pixel_centres.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace {

/// The place of a slit triangle's corner in the picture. Units: 1/256 pixel.
struct slit_place {
    std::int32_t x, y;
};

l3d_pixel_centres<std::int32_t> centres_between(std::int32_t a, std::int32_t b, std::int32_t c) {
    return l3d_centres_in(std::min(std::min(a, b), c), std::max(std::max(a, b), c));
}

/// The place of a pixel's centre along x or y. Units: 1/256 pixel.
std::int32_t centre_of(std::int32_t pixel) {
    return (pixel << l3d_subpixel_bits) + l3d_subpixel_one / 2;
}

/// Twice the signed area of the triangle with the corners p, q and (x, y).
std::int64_t turn(const slit_place& p, const slit_place& q, std::int32_t x, std::int32_t y) {
    return std::int64_t{q.x - p.x} * (y - p.y) - std::int64_t{q.y - p.y} * (x - p.x);
}

/// Whether triangles without a pixel's centre may be left out. They may not be left out where trims
/// cut triangles. The part of a triangle that trims leave has newly snapped corners. So the part
/// may hold a centre although the triangle holds none.
bool counts_centres(const l3d_dice_view& view) {
    return !view.keep.centreless && view.trim == nullptr;
}

/// Whether a triangle certainly holds no pixel's centre, not even on its sides. Looks at the pixels
/// in the given columns and rows, one line of pixels along the longer side of the triangle's box
/// after another.
bool holds_no_centre(const slit_place& p, const slit_place& q, const slit_place& r,
                     const l3d_pixel_centres<std::int32_t>& columns,
                     const l3d_pixel_centres<std::int32_t>& rows) {
    constexpr double pixels = 1.0 / l3d_subpixel_one;
    constexpr double slack = 0x1p-20; // far more than rounding, in pixels
    const bool by_rows = rows.last - rows.first <= columns.last - columns.first;
    const std::int32_t lines = by_rows ? rows.last - rows.first : columns.last - columns.first;
    // Counts from the pixel before the first one, so that places are positive.
    const std::int32_t x = centre_of(columns.first - 1), y = centre_of(rows.first - 1);
    struct corner {
        double along, across;
    };
    const auto corner_of = [&](const slit_place& at) {
        const double dx = pixels * (at.x - x), dy = pixels * (at.y - y);
        return by_rows ? corner{dx, dy} : corner{dy, dx};
    };
    corner first = corner_of(p), middle = corner_of(q), last = corner_of(r);
    if (middle.across < first.across)
        std::swap(first, middle);
    if (last.across < middle.across)
        std::swap(middle, last);
    if (middle.across < first.across)
        std::swap(first, middle);
    const auto slope = [](const corner& from, const corner& to) {
        return to.across > from.across ? (to.along - from.along) / (to.across - from.across) : 0;
    };
    const double whole = slope(first, last), before = slope(first, middle),
                 behind = slope(middle, last);
    for (std::int32_t line = 1; line <= lines + 1; ++line) {
        const double beyond = line - middle.across;
        const double a = first.along + whole * (line - first.across);
        const double b = middle.along + beyond * (beyond < 0 ? before : behind);
        const double end = std::max(a, b) + slack;
        if (static_cast<std::int32_t>(end) >= std::min(a, b) - slack)
            return false;
    }
    return true;
}

/// Whether a triangle certainly covers no pixel's centre. The triangle covers none if its box holds
/// no centre or its corners lie on one line. It also covers none if no centre in the box lies in
/// the triangle or on its sides. Without `by_centres`, this last test is made only if the box has a
/// single centre. Nearly all triangles of slits cover nothing.
inline bool covers_nothing(const slit_place& p, const slit_place& q, const slit_place& r,
                           bool by_centres) {
    const auto along_x = centres_between(p.x, q.x, r.x);
    if (along_x.none())
        return true;
    const auto along_y = centres_between(p.y, q.y, r.y);
    if (along_y.none() || turn(p, q, r.x, r.y) == 0)
        return true;
    // A line of pixels takes some 15 instructions, and a triangle that is drawn takes some 500.
    constexpr std::int32_t most_lines = 32;
    const std::int32_t columns = along_x.last - along_x.first, rows = along_y.last - along_y.first;
    const bool looks = by_centres ? std::min(columns, rows) < most_lines : columns + rows == 0;
    return looks && holds_no_centre(p, q, r, along_x, along_y);
}

/// Notes how far a triangle of a slit reaches along the grid's side. If a corner lies beyond the
/// side's end, it has the shade level of that end, which no bound covers. Then the span is
/// infinite.
void note_span(l3d_diced_piece& out, bool straight, bool along_u, double low, double high) {
    const std::vector<double>& at = along_u ? out.u : out.v;
    if (at.size() < 2)
        return;
    const double rounding = 1e-9 * (at.back() - at.front());
    if (low < at.front() - rounding || high > at.back() + rounding)
        low = -std::numeric_limits<double>::infinity();
    out.add_span(straight ? out.slits.straight : out.slits.bent, along_u, low, high);
}

slit_place place_of(const l3d_clip_vertex& v) {
    return {v.dice.vertex.x, v.dice.vertex.y};
}

void add(l3d_clip_vertex a, l3d_clip_vertex b, l3d_clip_vertex c, float side, bool is_kept,
         const l3d_dice_view& view, l3d_diced_piece& out) {
    const bool all_drawable = a.drawable && b.drawable && c.drawable;
    if (!is_kept && all_drawable &&
        covers_nothing(place_of(a), place_of(b), place_of(c), counts_centres(view)))
        return;
    for (const bool along_u : {true, false}) {
        const auto [low, high] = along_u ? std::minmax({a.dice.u, b.dice.u, c.dice.u})
                                         : std::minmax({a.dice.v, b.dice.v, c.dice.v});
        note_span(out, true, along_u, low, high);
    }
    for (l3d_clip_vertex* corner : {&a, &b, &c})
        for (float& number : corner->dice.vertex.normal)
            number *= side;
    l3d_clip_triangle(a, b, c, view, out);
}

/// Notes the segment from one point of an edge to the next as a border of the part, at the triangle
/// that was added last.
void note_edge(l3d_clip_vertex a, l3d_clip_vertex b, const l3d_dice_view& view,
               l3d_diced_piece& out) {
    if (out.part.triangles.count == 0 || !l3d_clip_segment(a, b, view))
        return;
    l3d_border_edge edge = l3d_border_edge::between(a.dice.vertex, b.dice.vertex);
    edge.column = static_cast<int>(out.part.triangles.count) - 1;
    edge.always = true;
    out.part.border.push_back(edge);
}

/// Fills the slit along a side of a piece's grid. The side is a row of vertices, along an edge.
class closing_side {
public:
    closing_side(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge,
                 const l3d_dice_view& view, double t0, double t1)
        : piece_(piece), grid_(piece.part.grid), edge_(edge), by_centres_(counts_centres(view)),
          along_u_(side < 2), parameters_(along_u_ ? piece.u : piece.v),
          across_(along_u_ ? (side == 1 ? piece.v.back() : piece.v.front())
                           : (side == 3 ? piece.u.back() : piece.u.front())),
          first_(side == 1   ? grid_.index(grid_.rows - 1, 0)
                 : side == 3 ? grid_.index(0, grid_.columns - 1)
                             : 0),
          step_(along_u_ ? 1 : static_cast<std::size_t>(grid_.pitch)), side_(side),
          per_t_((parameters_.back() - parameters_.front()) / (t1 - t0)),
          at_zero_(parameters_.front() - per_t_ * t0) {}

    /// Moves vertex i of the row to the edge's point j.
    void take_over(std::size_t i, std::size_t j) {
        const std::size_t at = first_ + i * step_;
        grid_.x[at] = edge_.x()[j];
        grid_.y[at] = edge_.y()[j];
        grid_.inv_w[at] = edge_.inv_w()[j];
    }

    /// Adds the triangles between vertices i to i_end of the row and points j to j_end of the edge.
    void fill(std::size_t i, std::size_t i_end, std::size_t j, std::size_t j_end) {
        const auto parameter_behind = [&](std::size_t at) {
            return at < j_end ? parameter_of(at + 1) : std::numeric_limits<double>::infinity();
        };
        slit_corner of_row = vertex(i), of_edge = point(j, parameter_of(j));
        double along_edge = parameter_behind(j);
        while (i < i_end || j < j_end) {
            const bool along_row = i < i_end && parameters_[i + 1] <= along_edge;
            const slit_corner next = along_row ? vertex(i + 1) : point(j + 1, along_edge);
            if (!covers_nothing(of_edge.at, of_row.at, next.at, by_centres_))
                add(lit(of_edge, i), lit(of_row, i), lit(next, i), i);
            if (along_row) {
                ++i;
                of_row = next;
            } else {
                along_edge = parameter_behind(++j);
                of_edge = next;
            }
        }
    }

private:
    /// A vertex of the row or a point of the edge, and its parameter.
    struct slit_corner {
        slit_place at;
        std::size_t index; ///< the index of the grid's vertex or of the edge's point
        bool on_edge;
        double along;
    };

    slit_corner vertex(std::size_t i) const {
        const std::size_t at = first_ + i * step_;
        return {{grid_.x[at], grid_.y[at]}, at, false, parameters_[i]};
    }
    slit_corner point(std::size_t j, double along) const {
        return {{edge_.x()[j], edge_.y()[j]}, j, true, along};
    }

    /// A corner of a slit's triangle, with the row's shade level at the corner's parameter.
    struct row_point {
        std::int32_t x, y;
        float inv_w, level;
        double along;

        l3d_micro_vertex lit(float a, float b, float c) const { return {x, y, inv_w, {a, b, c}}; }
    };

    /// Gives a corner its shade level. The corner lies near the row's vertex `near`.
    row_point lit(const slit_corner& of, std::size_t near) const {
        const auto point = [&](float inv_w, float level) {
            return row_point{of.at.x, of.at.y, inv_w, level, of.along};
        };
        if (!of.on_edge)
            return point(grid_.inv_w[of.index], grid_.normal[0][of.index]);
        return point(edge_.inv_w()[of.index], piece_.has_levels ? level_at(of.along, near) : 0);
    }

    /// Adds a triangle near the row's vertex `near`. The triangle's corners get the row's light at
    /// their parameters.
    void add(const row_point& a, const row_point& b, const row_point& c, std::size_t near) {
        const float seen = side_beside(near);
        if (piece_.has_levels) {
            const auto bend = [&](const row_point& from, const row_point& to) {
                return seen *
                       (level_at((from.along + to.along) / 2, near) - (from.level + to.level) / 2);
            };
            piece_.part.triangles.add(a.lit(seen * a.level, bend(a, b), bend(a, c)),
                                      b.lit(seen * b.level, 0, bend(b, c)),
                                      c.lit(seen * c.level, 0, 0));
        } else {
            const auto lit_by_normal = [&](const row_point& corner) {
                l3d_micro_vertex result = corner.lit(0, 0, 0);
                set_normal_at(corner.along, near, result.normal);
                for (float& component : result.normal)
                    component *= seen;
                return result;
            };
            piece_.part.triangles.add(lit_by_normal(a), lit_by_normal(b), lit_by_normal(c));
        }
        note_span(piece_, false, along_u_, std::min({a.along, b.along, c.along}),
                  std::max({a.along, b.along, c.along}));
        if (piece_.keep_parameters)
            for (std::size_t k = 0; k < 3; ++k) {
                const double along = k == 0 ? a.along : k == 1 ? b.along : c.along;
                piece_.triangle_uv[k].push_back(along_u_
                                                    ? l3d_diced_piece::parameters{along, across_}
                                                    : l3d_diced_piece::parameters{across_, along});
            }
    }

    /// The sign that turns the light beside vertex i of the row to the side that the neighbouring
    /// quad shows. That quad begins at the vertex, or ends there at the last vertex. Whether a
    /// slit's own triangle turns left or right is chance.
    float side_beside(std::size_t i) const {
        const int quad = static_cast<int>(std::min(i, parameters_.size() - 2));
        return along_u_ ? l3d_side_of_quad(grid_, side_ == 1 ? grid_.rows - 2 : 0, quad, side_)
                        : l3d_side_of_quad(grid_, quad, side_ == 3 ? grid_.columns - 2 : 0, side_);
    }

    /// The place of a parameter in the row, as two neighbouring vertices and the share of the way
    /// from the first to the second. A parameter beyond an end of the row counts as that end.
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

    /// The row's shade level at a parameter, by the parabola between two vertices.
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

    /// The patch's parameter at point j of the edge.
    double parameter_of(std::size_t j) const { return at_zero_ + per_t_ * edge_.t()[j]; }

    l3d_diced_piece& piece_;
    l3d_micro_grid& grid_;
    const l3d_edge_polyline& edge_;
    bool by_centres_, along_u_;
    const std::vector<double>& parameters_;
    double across_;
    std::size_t first_, step_, side_;
    /// The linear map from the edge's parameters to the side's parameters. Its factors are powers
    /// of two.
    double per_t_, at_zero_;
};

} // namespace

void l3d_fill_gap(std::span<const l3d_boundary_point> row, const l3d_edge_polyline& edge,
                  const l3d_dice_view& view, l3d_diced_piece& out, bool is_border) {
    const bool notes = is_border && view.shading.antialias;
    const double t0 = row.front().t, t1 = row.back().t;
    const l3d_dice_vertex &first = row.front().vertex.dice, &last = row.back().vertex.dice;
    const double* t = edge.t();

    // Gives point j of the edge the row's parameters and light.
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
        const float side = row[std::min(i, row.size() - 2)].side;
        if (along_row) {
            add(q, p.vertex, row[++i].vertex, side, false, view, out);
            continue;
        }
        const l3d_clip_vertex next = on_row(++j);
        add(q, p.vertex, next, side, notes, view, out); // empty triangles have sides, too
        if (notes)
            note_edge(q, next, view, out);
    }
}

void l3d_close_side(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge,
                    const l3d_dice_view& view, double t0, double t1) {
    closing_side row(piece, side, edge, view, t0, t1);
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

void l3d_note_outline_edge(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge,
                           const l3d_dice_view& view, double t0, double t1) {
    const l3d_micro_grid& grid = piece.part.grid;
    const bool along_u = side < 2, at_end = side == 1 || side == 3;
    // The border runs so that the quad is on its right if its corners p00 p10 p11 p01 turn to the
    // right.
    const bool forward = side == 0 || side == 3;
    const std::vector<double>& parameters = along_u ? piece.u : piece.v;
    const double per_t = (parameters.back() - parameters.front()) / (t1 - t0);
    const std::size_t first = edge.point_before(t0), last = edge.point_before(t1);
    const int quads = static_cast<int>(parameters.size()) - 1;
    const int across = at_end ? (along_u ? grid.rows : grid.columns) - 2 : 0;
    constexpr int sides[] = {0, 2, 3, 1}; // v = 0, v = 1, u = 0, u = 1
    const int side_of_quad = sides[side];
    int quad = 0;
    for (std::size_t i = first; i < last; ++i) {
        const double middle =
            parameters.front() + per_t * ((edge.t()[i] + edge.t()[i + 1]) / 2 - t0);
        while (quad + 1 < quads && parameters[static_cast<std::size_t>(quad) + 1] <= middle)
            ++quad;
        const int row = along_u ? across : quad, column = along_u ? quad : across;
        // The grid's vertex where the quad's side begins, whose level is noted.
        const std::size_t vertex =
            grid.index(row + (along_u && at_end ? 1 : 0), column + (!along_u && at_end ? 1 : 0));
        l3d_micro_vertex from{edge.x()[i], edge.y()[i], edge.inv_w()[i], {}};
        l3d_micro_vertex to{edge.x()[i + 1], edge.y()[i + 1], edge.inv_w()[i + 1], {}};
        if (edge.strips().blocks == 0) {
            l3d_clip_vertex a = edge.clip_vertex(i, view), b = edge.clip_vertex(i + 1, view);
            if (!l3d_clip_segment(a, b, view))
                continue;
            from = a.dice.vertex;
            to = b.dice.vertex;
        }
        if (!forward)
            std::swap(from, to);
        if (piece.keep_parameters) {
            const auto along = [&](std::size_t j) {
                return parameters.front() - per_t * t0 + per_t * edge.t()[j]; // as closing_side
            };
            piece.border_along.push_back(forward ? std::array{along(i), along(i + 1)}
                                                 : std::array{along(i + 1), along(i)});
        }
        piece.part.border.push_back(
            {from.x, from.y, to.x, to.y, from.inv_w, to.inv_w,
             piece.has_levels ? grid.normal[0][vertex] : std::numeric_limits<float>::quiet_NaN(),
             row, column, side_of_quad});
    }
}
