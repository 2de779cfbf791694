// SPDX-License-Identifier: MIT
// l3d_grid_builder: walks grids, evaluates vertices, clips quads.
#include "dice/grid_builder.h"

#include "dice/edges/gap_filler.h"
#include "dice/edges/shared_polylines.h"
#include "dice/grid_light.h"
#include "dice/facing_fix.h"
#include "dice/snap.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace {

/// Calls visit(column, u-strip, u in the strip) for each column of a plan. The last column lies at
/// the end of the last strip.
template <class Visit> void for_columns(const l3d_step_plan& plan, Visit visit) {
    std::size_t column = 0;
    for (int a = 0; a < plan.strips; ++a) {
        const int n = plan.nu[static_cast<std::size_t>(a)];
        for (int i = 0; i < n; ++i)
            visit(column++, static_cast<std::size_t>(a), static_cast<double>(i) / n);
    }
    visit(column, static_cast<std::size_t>(plan.strips - 1), 1.0);
}

/// The column at `u` of a block as a curve in v. A column between the strip's ends is balanced if
/// `balanced`.
l3d_image_curve column_at(const l3d_image_patch& block, double u, int steps, bool balanced) {
    l3d_image_curve column = block.curve_at_u(u);
    if (balanced && u > 0 && u < 1)
        for (int row = 0; row < 4; ++row)
            column.points[static_cast<std::size_t>(row)] =
                l3d_balanced(block.row(row), steps).evaluate(u);
    return column;
}

/// The factor 1 or -1 that turns a triangle's light to the side that it shows. If all corners show
/// one side, the triangle shows that side. If corners show different sides, an outline passes
/// through the triangle. Then the triangle's turn in the picture decides. A triangle that turns to
/// the right shows the side opposite to the normals.
float side_of(const std::array<l3d_clip_vertex, 3>& v) {
    if (v[0].away == v[1].away && v[1].away == v[2].away)
        return v[0].away ? -1.0F : 1.0F;
    return l3d_dot(v[0].h, l3d_cross(v[1].h, v[2].h)) > 0 ? -1.0F : 1.0F;
}

/// The place of parameters `at` relative to a box of parameters, from 0 to 1 across the box.
l3d_trim_place part_of(const l3d_trim_box& box, const l3d_trim_place& at) {
    return {(at[0] - box.least[0]) / (box.most[0] - box.least[0]),
            (at[1] - box.least[1]) / (box.most[1] - box.least[1])};
}

} // namespace

template <class T>
void l3d_grid_builder<T>::begin(const l3d_dice_view& view, const l3d_normal_net& normals,
                                const l3d_edge_polylines& edges) {
    view_ = view;
    normals_ = &normals;
    edges_ = &edges;
}

template <class T>
void l3d_grid_builder<T>::draw(const piece& p, const l3d_piece_bounds<T>& nets,
                               const l3d_step_plan& plan, l3d_diced_piece& out) {
    fill_parameters(p, plan, out);
    if (!nets.whole()) {
        evaluate_grid(nets, plan, out);
        set_clip_corners(p);
        for (l3d_clip_vertex& v : clip_grid_)
            v.away = l3d_light_vertex(view_, v.h, v.dice.vertex.normal);
        add_clipped_quads(out);
        for (std::size_t side = 0; side < p.sides.size(); ++side)
            fill_slit(
                p, side, [&](int r, int c) { return clip_vertex(r, c); },
                [&](int r, int c) { return side_of(half_of_quad(r, c, side % 3 == 0)); }, out);
        return;
    }
    l3d_micro_grid& grid = out.part.grid;
    grid.resize(columns_, rows_);
    grid.is_parallel = view_.is_parallel();
    if (nets.walked()) {
        walk_rows(nets, plan, out);
    } else {
        evaluate_grid(nets, plan, out);
        copy_evaluated(grid);
    }
    set_grid_corners(p, grid);
    l3d_light_grid(view_, *normals_, out, light_memory_);
    close(p, out);
}

template <class T> void l3d_grid_builder<T>::close(const piece& p, l3d_diced_piece& out) {
    l3d_micro_grid& grid = out.part.grid;
    columns_ = grid.columns;
    rows_ = grid.rows;
    set_grid_corners(p, grid);
    for (std::size_t side = 0; side < p.sides.size(); ++side) {
        const l3d_piece_side& along = p.sides[side];
        const l3d_edge_polyline& edge = (*edges_)[along.edge];
        if (edge.strips().blocks > 0) {
            l3d_close_side(out, side, edge, view_, along.t0, along.t1);
        } else {
            fill_slit(
                p, side, [&](int r, int c) { return grid_vertex(p, grid, r, c); },
                [&](int r, int c) { return l3d_side_of_quad(grid, r, c, side); }, out);
        }
        if (view_.shading.antialias)
            l3d_note_outline_edge(out, side, edge, view_, along.t0, along.t1);
    }
}

template <class T>
void l3d_grid_builder<T>::fill_parameters(const piece& p, const l3d_step_plan& plan,
                                          l3d_diced_piece& out) {
    const auto fill = [&](std::vector<double>& parameters, l3d_block_starts& starts,
                          const auto& steps, double low, double high) {
        parameters.clear();
        starts = {plan.strips, {}};
        for (int s = 0; s < plan.strips; ++s) {
            const auto strip = static_cast<std::size_t>(s);
            const int n = steps[strip];
            for (int i = 0; i < n; ++i)
                parameters.push_back(low +
                                     (high - low) * (s + static_cast<double>(i) / n) / plan.strips);
            starts.first[strip + 1] = starts.first[strip] + n;
        }
        parameters.push_back(high);
    };
    fill(out.u, out.part.block_columns, plan.nu, p.u0, p.u1);
    fill(out.v, out.part.block_rows, plan.nv, p.v0, p.v1);
    columns_ = static_cast<int>(out.u.size());
    rows_ = static_cast<int>(out.v.size());
    normal_columns_.resize(out.u.size());
    for (std::size_t c = 0; c < out.u.size(); ++c)
        normal_columns_.set(c, *normals_, out.u[c]);
}

template <class T>
void l3d_grid_builder<T>::walk_rows(const l3d_piece_bounds<T>& nets, const l3d_step_plan& plan,
                                    l3d_diced_piece& out) {
    const auto strips = static_cast<std::size_t>(plan.strips);
    l3d_micro_grid& grid = out.part.grid;
    walker_.resize(out.u.size(), nets.unit());
    int row = 0;
    const auto emit = [&] {
        const std::size_t at = grid.index(row, 0);
        walker_.emit(view_, &grid.x[at], &grid.y[at], &grid.inv_w[at]);
        normal_columns_.emit(out.v[static_cast<std::size_t>(row)], &grid.normal[0][at],
                             &grid.normal[1][at], &grid.normal[2][at]);
        ++row;
    };
    const auto for_curves = [&](std::size_t b, const auto& visit) {
        for_columns(plan, [&](std::size_t c, std::size_t a, double u) {
            visit(c, column_at(nets.blocks()[strips * b + a], u, plan.nu[a], plan.balanced));
        });
    };
    for (std::size_t b = 0; b < strips; ++b) {
        const int n = plan.nv[b];
        for_curves(b, [&](std::size_t c, const l3d_image_curve& curve) {
            walker_.place(c, curve.points[0]);
        });
        emit();
        for_curves(b, [&](std::size_t c, const l3d_image_curve& curve) {
            walker_.start(c, plan.balanced ? l3d_balanced(curve, n) : curve, n);
        });
        for (int i = 1; i < n; ++i) {
            walker_.step();
            emit();
        }
    }
    for_curves(strips - 1, [&](std::size_t c, const l3d_image_curve& curve) {
        walker_.place(c, curve.points[3]);
    });
    emit();
}

/// Evaluates every vertex of a piece by itself. The vertices may lie anywhere, even behind the eye.
template <class T>
void l3d_grid_builder<T>::evaluate_grid(const l3d_piece_bounds<T>& nets, const l3d_step_plan& plan,
                                        const l3d_diced_piece& out) {
    const std::size_t columns = out.u.size();
    clip_grid_.resize(columns * out.v.size());
    curves_.resize(columns);
    for (auto& component : normal_row_)
        component.resize(columns);
    const auto strips = static_cast<std::size_t>(plan.strips);
    std::size_t row = 0;
    const auto set_curves = [&](std::size_t b) {
        for_columns(plan, [&](std::size_t c, std::size_t a, double u) {
            curves_[c] = column_at(nets.blocks()[strips * b + a], u, plan.nu[a], plan.balanced);
        });
    };
    const auto emit = [&](double v) {
        normal_columns_.emit(out.v[row], normal_row_[0].data(), normal_row_[1].data(),
                             normal_row_[2].data());
        for (std::size_t c = 0; c < columns; ++c) {
            l3d_clip_vertex& vertex = clip_grid_[row * columns + c];
            vertex = l3d_canonical_vertex(curves_[c].evaluate(v), view_);
            vertex.dice.u = out.u[c];
            vertex.dice.v = out.v[row];
            for (std::size_t k = 0; k < 3; ++k)
                vertex.dice.vertex.normal[k] = normal_row_[k][c];
        }
        ++row;
    };
    for (std::size_t b = 0; b < strips; ++b) {
        const int n = plan.nv[b];
        set_curves(b);
        emit(0);
        if (plan.balanced)
            for (l3d_image_curve& curve : curves_)
                curve = l3d_balanced(curve, n);
        for (int i = 1; i < n; ++i)
            emit(static_cast<double>(i) / n);
    }
    set_curves(strips - 1);
    emit(1);
}

/// Copies evaluated vertices into the grid of a piece that needs no clipping.
template <class T> void l3d_grid_builder<T>::copy_evaluated(l3d_micro_grid& grid) const {
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            const l3d_clip_vertex& from = clip_vertex(row, column);
            const l3d_snapped s = l3d_snap(from.h[0], from.h[1], from.h[2]);
            const std::size_t at = grid.index(row, column);
            grid.x[at] = s.x + view_.centre_x();
            grid.y[at] = s.y + view_.centre_y();
            grid.inv_w[at] = view_.depth_at(from.h[2]);
            for (std::size_t k = 0; k < 3; ++k)
                grid.normal[k][at] = from.dice.vertex.normal[k];
        }
}

/// Moves the grid's corners to the places that l3d_canonical_vertex gives them. Pieces that share a
/// corner may walk to it in different ways.
template <class T>
void l3d_grid_builder<T>::set_grid_corners(const piece& p, l3d_micro_grid& grid) const {
    for (const bool high_v : {false, true})
        for (const bool high_u : {false, true}) {
            const l3d_micro_vertex exact = p.corner(high_u, high_v, view_).dice.vertex;
            const std::size_t at = grid.index(high_v ? rows_ - 1 : 0, high_u ? columns_ - 1 : 0);
            grid.x[at] = exact.x;
            grid.y[at] = exact.y;
            grid.inv_w[at] = exact.inv_w;
        }
}

template <class T> void l3d_grid_builder<T>::set_clip_corners(const piece& p) {
    for (const bool high_v : {false, true})
        for (const bool high_u : {false, true}) {
            l3d_clip_vertex& v = clip_vertex(high_v ? rows_ - 1 : 0, high_u ? columns_ - 1 : 0);
            l3d_clip_vertex exact = p.corner(high_u, high_v, view_);
            std::copy_n(v.dice.vertex.normal, 3, exact.dice.vertex.normal);
            v = exact;
        }
}

template <class T> void l3d_grid_builder<T>::add_clipped_quads(l3d_diced_piece& out) {
    const l3d_trim_block all{0, out.v.size() - 1, 0, out.u.size() - 1};
    if (view_.trim == nullptr)
        return add_clipped_block(all, out);
    const auto box_of = [&](const l3d_trim_block& of) {
        return l3d_trim_box{{out.u[of.column], out.v[of.row]},
                            {out.u[of.end_column], out.v[of.end_row]}};
    };
    const auto take = [&](const l3d_trim_block& of, const l3d_trim_region* region) {
        if (region == nullptr)
            return;
        const auto index = [](const std::vector<double>& along, double at, std::size_t last) {
            return static_cast<int>(std::min(
                static_cast<std::size_t>(std::ranges::lower_bound(along, at) - along.begin()),
                last));
        };
        if (region->is_all_of(box_of(of))) {
            if (view_.edges != nullptr)
                l3d_for_followed_sides(
                    *region, out.u, out.v, of,
                    [&](const l3d_trim_use& use, const l3d_trim_place& a, const l3d_trim_place& b) {
                        const auto vertex = [&](const l3d_trim_place& at) {
                            return clip_vertex(index(out.v, at[1], of.end_row),
                                               index(out.u, at[0], of.end_column));
                        };
                        add_strip(use, {vertex(a), vertex(b)},
                                  half_of_quad(index(out.v, a[1], of.end_row - 1),
                                               index(out.u, a[0], of.end_column - 1), true),
                                  out);
                    });
            return add_clipped_block(of, out);
        }
        trims_.cut(*region, box_of(of));
        for (const auto& [a, b, c] : trims_.triangles())
            add_trimmed(of, {a, b, c}, box_of(of), out);
        if (view_.edges != nullptr)
            for (const auto& [a, b, triangle, use] : trims_.followed())
                add_strip(use, {corner_at(of, box_of(of), a), corner_at(of, box_of(of), b)},
                          half_of_quad(static_cast<int>(of.row), static_cast<int>(of.column), true),
                          out);
    };
    l3d_for_trimmed_blocks(view_.trim->within(box_of(all)), out.u, out.v, all, take);
}

/// The vertex at a place of a quad, interpolated before projection. `at` has the patch's
/// parameters.
template <class T>
l3d_clip_vertex l3d_grid_builder<T>::corner_at(const l3d_trim_block& quad, const l3d_trim_box& box,
                                               const l3d_trim_place& at) const {
    const int r = static_cast<int>(quad.row), c = static_cast<int>(quad.column);
    const std::array of{clip_vertex(r, c), clip_vertex(r, c + 1), clip_vertex(r + 1, c + 1),
                        clip_vertex(r + 1, c)};
    const auto [s, t] = part_of(box, at);
    const std::array<double, 4> shares{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
    if (const auto whole = std::ranges::find(shares, 1.0); whole != shares.end())
        return of[static_cast<std::size_t>(whole - shares.begin())];
    l3d_image_point h{0.0, 0.0, 0.0};
    std::array<double, 3> normal{};
    for (std::size_t i = 0; i < of.size(); ++i) {
        h += of[i].h * shares[i];
        for (std::size_t n = 0; n < normal.size(); ++n)
            normal[n] += shares[i] * double{of[i].dice.vertex.normal[n]};
    }
    l3d_clip_vertex result = l3d_canonical_vertex(h, view_);
    result.dice.u = at[0];
    result.dice.v = at[1];
    for (std::size_t n = 0; n < normal.size(); ++n)
        result.dice.vertex.normal[n] = static_cast<float>(normal[n]);
    if (!view_.makes_levels())
        l3d_make_unit(result.dice.vertex.normal);
    return result;
}

template <class T>
void l3d_grid_builder<T>::add_trimmed(const l3d_trim_block& quad,
                                      const std::array<l3d_trim_place, 3>& triangle,
                                      const l3d_trim_box& box, l3d_diced_piece& out) const {
    double s_sum = 0, t_sum = 0;
    corners_of_half corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [s, t] = part_of(box, triangle[k]);
        s_sum += s;
        t_sum += t;
        corners[k] = corner_at(quad, box, triangle[k]);
    }
    const float side = side_of(
        half_of_quad(static_cast<int>(quad.row), static_cast<int>(quad.column), s_sum >= t_sum));
    for (l3d_clip_vertex& corner : corners)
        for (float& number : corner.dice.vertex.normal)
            number *= side;
    l3d_clip_triangle(corners[0], corners[1], corners[2], view_, out);
}

/// Adds the strip between a part of the trimmed region's border and the edge that the part follows.
/// The strip gets the light of the triangle beside it.
template <class T>
void l3d_grid_builder<T>::add_strip(const l3d_trim_use& use,
                                    const std::array<l3d_clip_vertex, 2>& border,
                                    const corners_of_half& beside, l3d_diced_piece& out) const {
    std::array<l3d_border_point, 2> ends{{{border[0], use.from}, {border[1], use.to}}};
    for (l3d_border_point& end : ends) {
        const l3d_dice_vertex& at = end.at.dice;
        if (at.u == out.u.front() || at.u == out.u.back() || at.v == out.v.front() ||
            at.v == out.v.back())
            out.crossings.push_back({{at.u, at.v}, use.edge, end.t});
        for (float& number : end.at.dice.vertex.normal)
            number *= side_of(beside);
        if (view_.makes_levels())
            end.at.dice.vertex.normal[1] = end.at.dice.vertex.normal[2] = 0;
    }
    if (use.edge < view_.edges->size())
        l3d_add_strip((*view_.edges)[use.edge], ends[0], ends[1], view_, out);
}

template <class T>
void l3d_grid_builder<T>::add_clipped_block(const l3d_trim_block& of, l3d_diced_piece& out) const {
    for (int r = static_cast<int>(of.row); r < static_cast<int>(of.end_row); ++r)
        for (int c = static_cast<int>(of.column); c < static_cast<int>(of.end_column); ++c) {
            for (const bool first : {true, false}) {
                corners_of_half half = half_of_quad(r, c, first);
                const float side = side_of(half);
                for (l3d_clip_vertex& corner : half)
                    for (float& number : corner.dice.vertex.normal)
                        number *= side;
                l3d_clip_triangle(half[0], half[1], half[2], view_, out);
            }
        }
}

/// A clipped piece draws a quad as two triangles. Returns the corners of one of these. The first
/// triangle has sides along low v and high u.
template <class T>
auto l3d_grid_builder<T>::half_of_quad(int row, int column, bool first) const -> corners_of_half {
    const l3d_clip_vertex &a = clip_vertex(row, column), &e = clip_vertex(row + 1, column + 1);
    if (first)
        return {a, clip_vertex(row, column + 1), e};
    return {a, e, clip_vertex(row + 1, column)};
}

template <class T>
l3d_clip_vertex l3d_grid_builder<T>::grid_vertex(const piece& p, const l3d_micro_grid& grid,
                                                 int row, int column) const {
    l3d_clip_vertex v;
    v.dice.vertex = grid.vertex(row, column);
    const double w = view_.w_at(v.dice.vertex.inv_w);
    v.h = {(v.dice.vertex.x - view_.centre_x()) * w / l3d_subpixel_one,
           (v.dice.vertex.y - view_.centre_y()) * w / l3d_subpixel_one, w};
    // The corner's exact place, since a clipped neighbour has to cut the edges there in the same
    // place.
    if (row % (rows_ - 1) == 0 && column % (columns_ - 1) == 0)
        v.h = p.corner(column > 0, row > 0, view_).h;
    v.drawable = true;
    return v;
}

/// Fills the slit along one side of a piece. `vertex_at` gives the vertices along the side, and
/// `side_at` the sign of the light beside each vertex.
template <class T>
template <class VertexAt, class SideAt>
void l3d_grid_builder<T>::fill_slit(const piece& p, std::size_t side, VertexAt vertex_at,
                                    SideAt side_at, l3d_diced_piece& out) {
    const bool along_u = side < 2;
    const int line = side % 2 == 0 ? 0 : (along_u ? rows_ : columns_) - 1;
    const double across = (along_u ? out.v : out.u)[static_cast<std::size_t>(line)];
    const std::vector<double>& parameters = along_u ? out.u : out.v;
    const double low = parameters.front(), high = parameters.back();
    const l3d_piece_side& along = p.sides[side];
    boundary_.clear();
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const auto i = static_cast<int>(k);
        const double fraction = (parameters[k] - low) / (high - low);
        l3d_boundary_point& point = boundary_.emplace_back();
        point.t = along.t0 + (along.t1 - along.t0) * fraction;
        point.vertex = along_u ? vertex_at(line, i) : vertex_at(i, line);
        if (out.has_levels) // the bends of sides are not known for pieces that clipping makes
            std::fill_n(point.vertex.dice.vertex.normal + 1, 2, 0.0F);
        point.vertex.dice.u = along_u ? parameters[k] : across;
        point.vertex.dice.v = along_u ? across : parameters[k];
        const int quad_beside = std::max(line - 1, 0);
        if (k + 1 < parameters.size())
            point.side = along_u ? side_at(quad_beside, i) : side_at(i, quad_beside);
    }
    // Only a clipped piece, which has no grid, notes its outer sides here.
    const bool is_border = out.part.grid.rows == 0 && along.edge < l3d_edge_polylines::sides;
    l3d_fill_gap(boundary_, (*edges_)[along.edge], view_, out, is_border);
}

template <class T> void l3d_grid_builder<T>::close_hidden(const piece& p, l3d_diced_piece& out) {
    for (std::size_t s = 0; s < p.sides.size(); ++s) {
        const bool along_u = s < 2, high = s % 2 == 1;
        boundary_.clear();
        for (const bool end : {false, true}) {
            l3d_boundary_point& point = boundary_.emplace_back();
            point.t = end ? p.sides[s].t1 : p.sides[s].t0;
            point.vertex = along_u ? p.corner(end, high, view_) : p.corner(high, end, view_);
            const l3d_dice_vertex& at = point.vertex.dice;
            const auto normal = l3d_unit_normal(normals_->evaluate(at.u, at.v));
            std::copy(normal.begin(), normal.end(), point.vertex.dice.vertex.normal);
            if (l3d_light_vertex(view_, point.vertex.h, point.vertex.dice.vertex.normal))
                boundary_.front().side = -1;
        }
        l3d_fill_gap(boundary_, (*edges_)[p.sides[s].edge], view_, out);
    }
}

template <class T> void l3d_grid_builder<T>::reserve_as(const l3d_grid_builder& other) {
    walker_.resize(other.walker_.room());
    normal_columns_.resize(other.normal_columns_.room());
    clip_grid_.reserve(other.clip_grid_.capacity());
    curves_.reserve(other.curves_.capacity());
    for (std::size_t k = 0; k < normal_row_.size(); ++k)
        normal_row_[k].reserve(other.normal_row_[k].capacity());
    boundary_.reserve(other.boundary_.capacity());
    for (std::size_t k = 0; k < light_memory_.size(); ++k)
        light_memory_[k].reserve(other.light_memory_[k].capacity());
}

template class l3d_grid_builder<float>;
template class l3d_grid_builder<double>;
template class l3d_grid_builder<l3d_fixed<std::int64_t, 32>>;
