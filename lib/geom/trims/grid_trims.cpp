// SPDX-License-Identifier: MIT
// l3d_grid_trims: halves regions along the grid's lines until each part is that of a single quad.
#include "geom/trims/grid_trims.h"

#include <algorithm>

bool l3d_grid_trims::is_for(std::span<const double> u, std::span<const double> v) const {
    return std::ranges::equal(u, u_) && std::ranges::equal(v, v_);
}

void l3d_grid_trims::make(const l3d_trim_region& region, std::span<const double> u,
                          std::span<const double> v, workshop& in) {
    u_.assign(u.begin(), u.end());
    v_.assign(v.begin(), v.end());
    parts_.clear();
    corners_.clear();
    triangles_.clear();
    sides_.clear();
    grid_sides_.clear();
    cut_.clear();
    for (std::vector<stretch>& side : kept_)
        side.clear();
    const auto take = [&](const l3d_trim_block& of, const l3d_trim_region* here) {
        if (here == nullptr)
            leave_out(of);
        else if (here->is_all_of(
                     {{u_[of.column], v_[of.row]}, {u_[of.end_column], v_[of.end_row]}}))
            keep_all(*here, of);
        else
            cut_quad(*here, of, in);
    };
    l3d_for_trimmed_blocks(region.within({{u.front(), v.front()}, {u.back(), v.back()}}), u_, v_,
                           {0, v.size() - 1, 0, u.size() - 1}, take);
    std::ranges::sort(cut_);
    for (std::vector<stretch>& side : kept_)
        l3d_join_stretches(side);
}

void l3d_grid_trims::leave_out(const l3d_trim_block& of) {
    for (std::size_t row = of.row; row < of.end_row; ++row)
        for (std::size_t column = of.column; column < of.end_column; ++column)
            cut_.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column)});
}

void l3d_grid_trims::keep_all(const l3d_trim_region& region, const l3d_trim_block& of) {
    part& whole = parts_.emplace_back(part{.of = of, .is_whole = true});
    whole.grid_sides.begin = static_cast<std::uint32_t>(grid_sides_.size());
    const auto visit = [&](const l3d_trim_use& use, const l3d_trim_place& from,
                           const l3d_trim_place& to) {
        const auto place_of = [](const std::vector<double>& all, double at) {
            return static_cast<std::uint32_t>(std::ranges::lower_bound(all, at) - all.begin());
        };
        const auto within = [](std::uint32_t at, std::size_t end) {
            return std::min(at, static_cast<std::uint32_t>(end) - 1);
        };
        const std::uint32_t row = place_of(v_, from[1]), column = place_of(u_, from[0]);
        grid_sides_.push_back({row, column, place_of(v_, to[1]), place_of(u_, to[0]),
                               within(row, of.end_row), within(column, of.end_column), from, to,
                               use});
    };
    l3d_for_followed_sides(region, u_, v_, of, visit);
    whole.grid_sides.end = static_cast<std::uint32_t>(grid_sides_.size());
    if (of.row == 0)
        kept_[0].push_back({u_[of.column], u_[of.end_column]});
    if (of.end_row + 1 == v_.size())
        kept_[1].push_back({u_[of.column], u_[of.end_column]});
    if (of.column == 0)
        kept_[2].push_back({v_[of.row], v_[of.end_row]});
    if (of.end_column + 1 == u_.size())
        kept_[3].push_back({v_[of.row], v_[of.end_row]});
}

void l3d_grid_trims::cut_quad(const l3d_trim_region& region, const l3d_trim_block& of,
                              workshop& in) {
    auto& [quad, places, inner] = in;
    leave_out(of);
    const l3d_trim_box box{{u_[of.column], v_[of.row]}, {u_[of.end_column], v_[of.end_row]}};
    quad.cut(region, box);
    const std::array at_border{of.row == 0, of.end_row + 1 == v_.size(), of.column == 0,
                               of.end_column + 1 == u_.size()};
    // Notes sides within the grid so that the quad is on their left, if u runs to the right and v
    // upwards.
    inner.clear();
    for (std::size_t side = 0; side < at_border.size(); ++side)
        for (const auto& [from, to] : quad.sides()[side]) {
            if (at_border[side])
                kept_[side].push_back({from, to});
            else if (side == 0)
                inner.push_back({{{from, box.least[1]}, {to, box.least[1]}}});
            else if (side == 1)
                inner.push_back({{{to, box.most[1]}, {from, box.most[1]}}});
            else if (side == 2)
                inner.push_back({{{box.least[0], to}, {box.least[0], from}}});
            else
                inner.push_back({{{box.most[0], from}, {box.most[0], to}}});
        }
    places.clear();
    for (const auto& triangle : quad.triangles())
        places.insert(places.end(), triangle.begin(), triangle.end());
    for (const auto& sides : {quad.border(), quad.followed()})
        for (const auto& one : sides)
            places.insert(places.end(), {one.from, one.to});
    for (const auto& ends : inner)
        places.insert(places.end(), ends.begin(), ends.end());
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const auto index_of = [&places = places](const l3d_trim_place& at) {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(places, at) - places.begin());
    };
    const auto add = [](auto& to, const auto& from, const auto& made) {
        range result{static_cast<std::uint32_t>(to.size()), 0};
        for (const auto& one : from)
            to.push_back(made(one));
        result.end = static_cast<std::uint32_t>(to.size());
        return result;
    };
    const auto made_side = [&](const l3d_trim_triangles::border_side& one) {
        return corner_side{index_of(one.from), index_of(one.to),
                           static_cast<std::uint32_t>(one.triangle), one.use};
    };
    part& one = parts_.emplace_back(part{.of = of});
    one.corners = add(corners_, places, [&](const l3d_trim_place& at) {
        corner result{.at = at};
        for (std::size_t k = 0; k < 2; ++k)
            result.part[k] = (at[k] - box.least[k]) / (box.most[k] - box.least[k]);
        return result;
    });
    one.triangles = add(triangles_, quad.triangles(), [&](const auto& triangle) {
        return std::array{index_of(triangle[0]), index_of(triangle[1]), index_of(triangle[2])};
    });
    one.border = add(sides_, quad.border(), made_side);
    one.followed = add(sides_, quad.followed(), made_side);
    one.inner = add(sides_, inner, [&](const auto& ends) {
        return corner_side{index_of(ends[0]), index_of(ends[1]), 0, {}};
    });
}
