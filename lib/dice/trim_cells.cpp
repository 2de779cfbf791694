// SPDX-License-Identifier: MIT
// l3d_trim_cells: makes vertices and triangles in the picture of what trims leave.
#include "dice/trim_cells.h"

#include "dice/edges/shared_polylines.h"
#include "dice/facing_fix.h"
#include "dice/grid_light.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace {

using parameters = l3d_patch_parameters;

template <std::size_t Corners>
std::array<double, Corners> middle(const std::array<double, Corners>& a,
                                   const std::array<double, Corners>& b) {
    std::array<double, Corners> result;
    for (std::size_t i = 0; i < Corners; ++i)
        result[i] = (a[i] + b[i]) / 2;
    return result;
}

l3d_border_edge side_of(const l3d_micro_vertex& from, const l3d_micro_vertex& to, int row,
                        int column, bool always) {
    l3d_border_edge edge = l3d_border_edge::between(from, to);
    edge.row = row;
    edge.column = column;
    edge.always = always;
    return edge;
}

} // namespace

void l3d_trim_error::add(const l3d_trim_error& other) {
    places_px = std::max(places_px, other.places_px);
    normals = std::max(normals, other.normals);
    levels = std::max(levels, other.levels);
}

l3d_trim_error l3d_trim_cells::cut(const l3d_trim_region& region, const l3d_dice_view& view,
                                   l3d_diced_piece& piece, const l3d_grid_trims& by,
                                   bool keeps_parameters) {
    view_ = &view;
    piece_ = &piece;
    error_ = {};
    slits_.clear();
    std::swap(slits_, piece.part.triangles);
    for (std::size_t k = 0; k < slits_uv_.size(); ++k) {
        slits_uv_[k].clear();
        std::swap(slits_uv_[k], piece.triangle_uv[k]);
    }
    piece.keep_parameters = keeps_parameters;
    border_.clear();
    trims_.clear();
    std::swap(border_, piece.part.border);
    std::swap(border_along_, piece.border_along);
    if (piece.part.grid.rows > 1)
        cut_grid(by);
    cut_slits(region, by);
    piece.keep_parameters = true; // for its slits, when it is diced again
    return error_;
}

void l3d_trim_cells::cut_grid(const l3d_grid_trims& by) {
    l3d_micro_grid& grid = piece_->part.grid;
    for (const auto& [row, column] : by.cut())
        grid.cut.push_back(static_cast<std::uint32_t>(
            grid.index(static_cast<int>(row), static_cast<int>(column))));
    for (const l3d_grid_trims::part& part : by.parts())
        if (part.is_whole)
            strip_whole(by, part);
        else
            cut_quad(by, part);
    if (!view_->shading.antialias)
        return;
    note_whole_quads(by);
    cut_border(by);
    piece_->part.border.insert(piece_->part.border.end(), trims_.begin(), trims_.end());
}

/// Whether the grid's quad lies in a block that back-face culling leaves out.
bool l3d_trim_cells::is_unseen(std::size_t row, std::size_t column) const {
    if (piece_->part.unseen == 0)
        return false;
    const auto block_of = [](const l3d_block_starts& starts, std::size_t at) {
        unsigned result = 0;
        while (static_cast<std::size_t>(starts.first[result + 1]) <= at)
            ++result;
        return result;
    };
    return (piece_->part.unseen >>
                (l3d_block_starts::most_blocks * block_of(piece_->part.block_rows, row) +
                 block_of(piece_->part.block_columns, column)) &
            1) != 0;
}

template <class Surface>
void l3d_trim_cells::add(const Surface& of, const typename Surface::point& a,
                         const typename Surface::point& b, const typename Surface::point& c) {
    const std::int64_t area = l3d_detail::twice_area(a.vertex, b.vertex, c.vertex);
    if (area == 0)
        return;
    std::array<l3d_dice_vertex, 3> p{
        {{a.vertex, a.uv.u, a.uv.v}, {b.vertex, b.uv.u, b.uv.v}, {c.vertex, c.uv.u, c.uv.v}}};
    if (view_->makes_levels()) {
        const auto bend = [&](const auto& from, const auto& to) {
            return static_cast<float>(of.level(middle(from.shares, to.shares)) -
                                      (from.level + to.level) / 2);
        };
        const float ab = bend(a, b), ac = bend(a, c), bc = bend(b, c);
        const std::array<std::array<float, 3>, 3> light{{{static_cast<float>(a.level), ab, ac},
                                                         {static_cast<float>(b.level), 0, bc},
                                                         {static_cast<float>(c.level), 0, 0}}};
        for (std::size_t i = 0; i < 3; ++i)
            std::ranges::copy(light[i], p[i].vertex.normal);
    }
    if constexpr (std::is_same_v<Surface, quad_surface>)
        if (piece_->part.grid.shows_both && area > 0)
            for (l3d_dice_vertex& corner : p)
                for (float& number : corner.vertex.normal)
                    number = -number;
    piece_->add_triangle(p[0], p[1], p[2]);
}

/// Makes a vertex of a point on a strip's border. The vertex has the light of one side of the
/// surface, and no bends.
template <class Point> l3d_dice_vertex l3d_trim_cells::lit(const Point& at, float side) const {
    l3d_dice_vertex result{at.vertex, at.uv.u, at.uv.v};
    float(&normal)[3] = result.vertex.normal;
    if (view_->makes_levels()) {
        normal[0] = static_cast<float>(at.level);
        normal[1] = normal[2] = 0;
    }
    for (float& number : normal)
        number *= side;
    return result;
}

bool l3d_trim_cells::has_strip(const l3d_trim_use& use) const {
    return view_->edges != nullptr && use.edge < view_->edges->size();
}

void l3d_trim_cells::add_strip(const l3d_trim_use& use, const l3d_dice_vertex& from,
                               const l3d_dice_vertex& to) {
    if (has_strip(use))
        l3d_add_strip((*view_->edges)[use.edge], l3d_border_point_of(from, use.from, *view_),
                      l3d_border_point_of(to, use.to, *view_), *view_, *piece_);
}

/// Notes where a border that follows an edge reaches a side of the piece. The slit beside the side
/// is cut at this place, too.
void l3d_trim_cells::note_crossing(const l3d_trim_place& at, std::uint32_t edge, double t) {
    if (at[0] == piece_->u.front() || at[0] == piece_->u.back() || at[1] == piece_->v.front() ||
        at[1] == piece_->v.back())
        piece_->crossings.push_back({at, edge, t});
}

const l3d_diced_piece::crossing* l3d_trim_cells::crossing_at(bool along_u, double across,
                                                             double along) const {
    constexpr double rounding = 0x1p-44; // borders are cut at lines in more than one order
    const auto& all = piece_->crossings;
    const auto here = std::ranges::find_if(all, [&](const l3d_diced_piece::crossing& c) {
        return c.at[along_u ? 1 : 0] == across &&
               std::abs(c.at[along_u ? 0 : 1] - along) <= rounding;
    });
    return here == all.end() ? nullptr : &*here;
}

/// Adds strips along those sides of whole quads that follow edges.
void l3d_trim_cells::strip_whole(const l3d_grid_trims& by, const l3d_grid_trims::part& part) {
    if (view_->edges == nullptr)
        return;
    const l3d_micro_grid& grid = piece_->part.grid;
    for (const l3d_grid_trims::grid_side& side : by.grid_sides(part.grid_sides)) {
        const float turn = l3d_side_of_quad(grid, static_cast<int>(side.quad_row),
                                            static_cast<int>(side.quad_column), 0);
        const auto vertex = [&](std::uint32_t row, std::uint32_t column, const l3d_trim_place& at) {
            l3d_dice_vertex result{grid.vertex(static_cast<int>(row), static_cast<int>(column)),
                                   at[0], at[1]};
            float(&normal)[3] = result.vertex.normal;
            if (view_->makes_levels())
                normal[1] = normal[2] = 0;
            for (float& number : normal)
                number *= turn;
            return result;
        };
        note_crossing(side.from, side.use.edge, side.use.from);
        note_crossing(side.to, side.use.edge, side.use.to);
        add_strip(side.use, vertex(side.row, side.column, side.from),
                  vertex(side.end_row, side.end_column, side.to));
    }
}

void l3d_trim_cells::cut_quad(const l3d_grid_trims& by, const l3d_grid_trims::part& part) {
    const auto corners = by.corners(part.corners);
    for (const l3d_grid_trims::corner_side& side : by.sides(part.followed)) {
        note_crossing(corners[side.from].at, side.use.edge, side.use.from);
        note_crossing(corners[side.to].at, side.use.edge, side.use.to);
    }
    if (is_unseen(part.of.row, part.of.column))
        return;
    const l3d_micro_grid& grid = piece_->part.grid;
    const int row = static_cast<int>(part.of.row), column = static_cast<int>(part.of.column);
    const quad_surface of(l3d_detail::corners_of(grid, grid.index(row, column)), *view_);
    error_.add(of.error(view_->makes_levels()));
    points_.clear();
    for (const l3d_grid_trims::corner& corner : corners)
        points_.push_back(of.point_at(corner, view_->makes_levels()));
    const auto side_between = [&](const l3d_grid_trims::corner_side& side, int at_row,
                                  int at_column, bool always) {
        return side_of(points_[side.from].vertex, points_[side.to].vertex, at_row, at_column,
                       always);
    };
    const bool notes = view_->shading.antialias;
    const auto triangles = by.triangles(part.triangles);
    const auto borders = by.sides(part.border);
    auto border = borders.begin();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto& [a, b, c] = triangles[i];
        add(of, points_[a], points_[b], points_[c]);
        // A triangle without area was not added: the side then belongs to the triangle before.
        const std::size_t last = piece_->part.triangles.count - 1;
        for (; notes && border != borders.end() && border->triangle == i; ++border)
            if (piece_->part.triangles.count > 0 && !has_strip(border->use))
                trims_.push_back(side_between(*border, -1, static_cast<int>(last), true));
    }
    if (!part.followed.is_empty() && view_->edges != nullptr) {
        const float turn = l3d_side_of_quad(grid, row, column, 0);
        for (const l3d_grid_trims::corner_side& side : by.sides(part.followed))
            add_strip(side.use, lit(points_[side.from], turn), lit(points_[side.to], turn));
    }
    if (notes)
        for (const l3d_grid_trims::corner_side& side : by.sides(part.inner))
            piece_->part.border.push_back(side_between(side, row, column, false));
}

/// Finds the quads that lie wholly inside the region. Notes as borders the sides at which such a
/// quad meets a quad that lies partly or wholly outside.
void l3d_trim_cells::note_whole_quads(const l3d_grid_trims& by) {
    const l3d_micro_grid& grid = piece_->part.grid;
    is_whole_.assign(grid.x.size(), false);
    for (const l3d_grid_trims::part& part : by.parts())
        for (std::size_t row = part.of.row; part.is_whole && row < part.of.end_row; ++row)
            for (std::size_t column = part.of.column; column < part.of.end_column; ++column)
                is_whole_[grid.index(static_cast<int>(row), static_cast<int>(column))] = true;
    const auto is_whole = [&](int row, int column) { return is_whole_[grid.index(row, column)]; };
    for (int row = 0; row + 1 < grid.rows; ++row)
        for (int column = 0; column + 1 < grid.columns; ++column) {
            if (!is_whole(row, column))
                continue;
            const auto add_side = [&](const l3d_micro_vertex& from, const l3d_micro_vertex& to) {
                piece_->part.border.push_back(side_of(from, to, row, column, false));
            };
            const l3d_micro_vertex p00 = grid.vertex(row, column),
                                   p10 = grid.vertex(row, column + 1),
                                   p11 = grid.vertex(row + 1, column + 1),
                                   p01 = grid.vertex(row + 1, column);
            if (row > 0 && !is_whole(row - 1, column))
                add_side(p00, p10);
            if (row + 2 < grid.rows && !is_whole(row + 1, column))
                add_side(p11, p01);
            if (column > 0 && !is_whole(row, column - 1))
                add_side(p01, p00);
            if (column + 2 < grid.columns && !is_whole(row, column + 1))
                add_side(p10, p11);
        }
}

/// Keeps the parts of the piece's border that the trimmed region reaches.
void l3d_trim_cells::cut_border(const l3d_grid_trims& by) {
    constexpr std::size_t sides[] = {
        0, 3, 1, 2}; // indices into kept() for a quad's sides v = 0, u = 1, v = 1, u = 0
    for (std::size_t i = 0; i < border_.size(); ++i) {
        const l3d_border_edge& edge = border_[i];
        const auto [begin, end] = border_along_[i];
        const bool rises = begin < end;
        std::array<l3d_micro_vertex, 2> ends{
            l3d_micro_vertex{edge.from_x, edge.from_y, edge.from_inv_w, {}},
            l3d_micro_vertex{edge.to_x, edge.to_y, edge.to_inv_w, {}}};
        if (!rises)
            std::swap(ends[0], ends[1]);
        const double low = std::min(begin, end), high = std::max(begin, end);
        if (low == high)
            continue;
        const l3d_detail::corners<2> of(ends, *view_);
        const auto at = [&](double along) {
            const double part = (along - low) / (high - low);
            return of.place({1 - part, part});
        };
        for (const auto& [from, to] : by.kept()[sides[edge.side]]) {
            if (to <= low || from >= high)
                continue;
            l3d_micro_vertex a = at(std::max(low, from)), b = at(std::min(high, to));
            if (!rises)
                std::swap(a, b);
            l3d_border_edge& kept = piece_->part.border.emplace_back(edge);
            kept.from_x = a.x;
            kept.from_y = a.y;
            kept.from_inv_w = a.inv_w;
            kept.to_x = b.x;
            kept.to_y = b.y;
            kept.to_inv_w = b.inv_w;
        }
    }
}

/// Cuts the triangles of slits, which lie along lines of equal u or v. Triangles that are parts of
/// clipped quads stay.
void l3d_trim_cells::cut_slits(const l3d_trim_region& region, const l3d_grid_trims& by) {
    const bool has_grid = piece_->part.grid.rows > 1;
    stretches of_line; // the stretches of `line`
    std::array<double, 2> line{-1, -1};
    for (std::size_t i = 0; i < slits_.count; ++i) {
        const parameters &a = slits_uv_[0][i], &b = slits_uv_[1][i], &c = slits_uv_[2][i];
        const bool along_u = a.v == b.v && b.v == c.v;
        const bool is_point =
            along_u && a.u == b.u && b.u == c.u; // a triangle that stands for a whole patch
        if (is_point || (!along_u && !(a.u == b.u && b.u == c.u))) {
            keep_slit(i);
            if (!is_point) // nothing is proven of light within a clipped quad
                error_.normals = error_.levels = std::numeric_limits<double>::infinity();
            continue;
        }
        const double across = along_u ? a.v : a.u;
        if (has_grid) {
            const bool is_low = across == (along_u ? piece_->v : piece_->u).front();
            cut_slit(i, along_u, by.kept()[(along_u ? 0 : 2) + (is_low ? 0 : 1)]);
            continue;
        }
        if (line != std::array{along_u ? 1.0 : 0.0, across}) {
            line = {along_u ? 1.0 : 0.0, across};
            of_line = region.stretches(along_u ? 1 : 0, across);
        }
        cut_slit(i, along_u, of_line);
    }
}

void l3d_trim_cells::keep_slit(std::size_t triangle) {
    std::array<l3d_dice_vertex, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
        const parameters& at = slits_uv_[k][triangle];
        corner[k] = {slits_.vertex(triangle, k), at.u, at.v};
    }
    piece_->add_triangle(corner[0], corner[1], corner[2]);
}

/// Keeps the parts of a slit's triangle beside the stretches `kept` of the grid's side. New corners
/// lie on the triangle's sides, and depend on the sides' ends alone.
void l3d_trim_cells::cut_slit(std::size_t triangle, bool along_u, const stretches& kept) {
    std::array<std::size_t, 3> order{0, 1, 2};
    const auto along = [&](std::size_t corner) {
        const parameters& at = slits_uv_[corner][triangle];
        return along_u ? at.u : at.v;
    };
    std::ranges::sort(order, {}, along);
    const std::size_t low = order[0], middle = order[1], high = order[2];
    auto first =
        std::ranges::partition_point(kept, [&](const stretch& one) { return one[1] < along(low); });
    const slit_surface of(
        {slits_.vertex(triangle, 0), slits_.vertex(triangle, 1), slits_.vertex(triangle, 2)},
        *view_);
    const auto between = [&](std::size_t from, std::size_t to, double at) {
        slit_surface::point result;
        const double part = (at - along(from)) / (along(to) - along(from));
        result.shares[from] = 1 - part;
        result.shares[to] = part;
        result.uv = slits_uv_[from][triangle];
        (along_u ? result.uv.u : result.uv.v) = at;
        of.put(result, view_->makes_levels());
        return result;
    };
    const auto by_way = [&](double at) {
        return at < along(middle) || along(middle) == along(high) ? between(low, middle, at)
                                                                  : between(middle, high, at);
    };
    const double across = along_u ? slits_uv_[0][triangle].v : slits_uv_[0][triangle].u;
    // Where the region ends, its border goes on across the slit, and so does the strip.
    const auto strip_end = [&](double at, const slit_surface::point& a,
                               const slit_surface::point& b) {
        if (const auto* const crossing = crossing_at(along_u, across, at))
            add_strip({crossing->edge, crossing->t, crossing->t}, lit(a, 1), lit(b, 1));
    };
    for (; first != kept.end() && (*first)[0] <= along(high); ++first) {
        const auto [from, to] = *first;
        if (from <= along(low) && to >= along(high))
            return keep_slit(triangle);
        const double begin = std::max(from, along(low)), end = std::min(to, along(high));
        if (!(begin < end))
            continue;
        error_.places_px = std::max(error_.places_px, l3d_trimmed_snap(*view_));
        const slit_surface::point straight = between(low, high, begin);
        slit_surface::point last = by_way(begin);
        if (begin == from)
            strip_end(begin, straight, last);
        if (begin < along(middle) && along(middle) < end) {
            slit_surface::point corner;
            corner.shares[middle] = 1;
            corner.uv = slits_uv_[middle][triangle];
            of.put(corner, view_->makes_levels());
            add(of, straight, last, corner);
            last = corner;
        }
        const slit_surface::point far = by_way(end);
        add(of, straight, last, far);
        const slit_surface::point end_straight = between(low, high, end);
        add(of, straight, far, end_straight);
        if (end == to)
            strip_end(end, end_straight, far);
    }
}
