// SPDX-License-Identifier: MIT
// l3d_trim_triangles: makes triangles of trapezoids one above another, and matches their sides.
#include "geom/trims/trim_triangles.h"

#include <algorithm>
#include <tuple>

void l3d_trim_triangles::cut(const l3d_trim_region& region, const l3d_trim_box& box) {
    region_ = &region;
    box_ = box;
    triangles_.clear();
    border_.clear();
    followed_.clear();
    level_sides_.clear();
    for (std::vector<stretch>& side : sides_)
        side.clear();
    layers_.clear();
    trapezoids_.of(region, [this](const l3d_trapezoid& one) {
        if (one.low.size() + one.high.size() < 3)
            return; // a line without area
        if (one.low.size() > 2 || one.high.size() > 2)
            return take(one);
        layers_.push_back(
            {.low = {{{one.low.front(), one.low_v}, {one.low.back(), one.low_v}}},
             .high = {{{one.high.front(), one.high_v}, {one.high.back(), one.high_v}}},
             .use = {one.left, one.right},
             .side = {one.left_side, one.right_side}});
    });
    stack_layers();
    close_sides();
    find_level_border();
    find_followed();
}

/// Stacks layers that share a whole side of equal v. Stacked layers are one polygon, which every
/// line of equal v meets once. If a side continues from one layer to the next, it has no corner
/// between the two layers.
void l3d_trim_triangles::stack_layers() {
    const auto low_key = [this](std::size_t i) {
        const auto& [left, right] = layers_[i].low;
        return std::array{left[1], left[0], right[0]};
    };
    begins_.clear();
    for (std::size_t i = 0; i < layers_.size(); ++i)
        if (layers_[i].is_wide_below())
            begins_.push_back(i);
    std::ranges::sort(begins_, {}, low_key);
    for (layer& one : layers_) {
        if (!one.is_wide_above())
            continue;
        const auto& [left, right] = one.high;
        const std::array key{left[1], left[0], right[0]};
        const auto above = std::ranges::lower_bound(begins_, key, {}, low_key);
        if (above == begins_.end() || low_key(*above) != key || layers_[*above].goes_on)
            continue;
        one.next = *above;
        layers_[*above].goes_on = true;
    }
    for (std::size_t i = 0; i < layers_.size(); ++i)
        if (!layers_[i].goes_on)
            take_layers(i);
}

void l3d_trim_triangles::take_layers(std::size_t first) {
    for (std::size_t k = 0; k < 2; ++k) {
        auto& [corners, uses] = chains_[k];
        corners = {layers_[first].low[k]};
        uses.clear();
        bool begins = true; // whether a side begins
        for (std::size_t i = first; i != none; i = layers_[i].next) {
            const layer& one = layers_[i];
            if (begins)
                uses.push_back(one.use[k]);
            else
                uses.back().to = one.use[k].to;
            begins = one.next == none || layers_[one.next].side[k] != one.side[k];
            if (begins)
                corners.push_back(one.high[k]);
        }
    }
    join_corners();
}

/// Triangulates the polygon between two chains. Source: Garey, Johnson, Preparata and Tarjan,
/// Triangulating a simple polygon, 1978.
void l3d_trim_triangles::join_corners() {
    const auto &left = chains_[0].corners, &right = chains_[1].corners;
    // Lists all corners upwards. A corner that the chains have in common is on both.
    corners_.clear();
    std::size_t i = 0, j = 0;
    while (i < left.size() || j < right.size()) {
        const bool is_left = j == right.size() || (i < left.size() && left[i][1] <= right[j][1]);
        const bool is_both = i < left.size() && j < right.size() && left[i] == right[j];
        corners_.push_back({is_left ? left[i] : right[j],
                            {is_left ? i : none, is_both   ? j
                                                 : is_left ? none
                                                           : j}});
        i += is_left ? 1 : 0;
        j += is_left && !is_both ? 0 : 1;
    }
    waiting_.assign(corners_.begin(), corners_.begin() + 2);
    for (std::size_t k = 2; k < corners_.size(); ++k) {
        const chain_corner& next = corners_[k];
        const chain_corner last = waiting_.back();
        const std::size_t chain_of_next = next.place[0] != none ? 0 : 1;
        const bool is_common = next.place[0] != none && next.place[1] != none;
        if (is_common || last.place[chain_of_next] == none) {
            for (std::size_t n = 0; n + 1 < waiting_.size(); ++n)
                add_corners(waiting_[n], waiting_[n + 1], next);
            waiting_ = {last, next};
            continue;
        }
        chain_corner before = last;
        waiting_.pop_back();
        while (!waiting_.empty()) {
            const chain_corner& one = waiting_.back();
            const double turn = (next.at[0] - one.at[0]) * (before.at[1] - one.at[1]) -
                                (next.at[1] - one.at[1]) * (before.at[0] - one.at[0]);
            if (!(chain_of_next == 0 ? turn > 0 : turn < 0))
                break;
            add_corners(one, before, next);
            before = one;
            waiting_.pop_back();
        }
        waiting_.insert(waiting_.end(), {before, next});
    }
}

void l3d_trim_triangles::add_corners(const chain_corner& a, const chain_corner& b,
                                     const chain_corner& c) {
    const double turn =
        (b.at[0] - a.at[0]) * (c.at[1] - a.at[1]) - (b.at[1] - a.at[1]) * (c.at[0] - a.at[0]);
    triangles_.push_back({a.at, turn < 0 ? c.at : b.at, turn < 0 ? b.at : c.at});
    note_side(a, b);
    note_side(b, c);
    note_side(a, c);
}

/// Records a side of the last triangle, from a to b, if it is a side of the polygon between the
/// chains.
void l3d_trim_triangles::note_side(const chain_corner& a, const chain_corner& b) {
    const std::size_t triangle = triangles_.size() - 1;
    for (std::size_t k = 0; k < 2; ++k) {
        if (a.place[k] == none || b.place[k] == none)
            continue;
        const bool rises = a.place[k] < b.place[k];
        const l3d_trim_place &low = rises ? a.at : b.at, &high = rises ? b.at : a.at;
        const std::size_t at = std::min(a.place[k], b.place[k]);
        if (std::max(a.place[k], b.place[k]) != at + 1)
            continue;
        const l3d_trim_use& use = chains_[k].uses[at];
        if (low[0] == high[0] && low[0] == (k == 1 ? box_.most[0] : box_.least[0]))
            sides_[2 + k].push_back({low[1], high[1]});
        else if (k == 1)
            border_.push_back({low, high, triangle, use});
        else
            border_.push_back({high, low, triangle, {use.edge, use.to, use.from}});
        return;
    }
    if (a.at[1] != b.at[1])
        return;
    const l3d_trim_place &left = a.place[0] != none ? a.at : b.at,
                         &right = a.place[0] != none ? b.at : a.at;
    const bool is_low = left == chains_[0].corners.front() && right == chains_[1].corners.front();
    const bool is_high = left == chains_[0].corners.back() && right == chains_[1].corners.back();
    if (!is_low && !is_high)
        return;
    if (left[1] == box_.least[1] || left[1] == box_.most[1])
        sides_[is_high ? 1 : 0].push_back({left[0], right[0]});
    else
        level_sides_.push_back({left[1], left[0], right[0], is_high, triangle});
}

void l3d_trim_triangles::take(const l3d_trapezoid& one) {
    const auto take_level = [&](double from, double to, bool is_high) {
        const double v = is_high ? one.high_v : one.low_v;
        if (v == box_.least[1] || v == box_.most[1])
            sides_[is_high ? 1 : 0].push_back({from, to});
        else
            level_sides_.push_back({v, from, to, is_high, triangles_.size()});
    };
    const auto take_slanted = [&](double low, double high, bool is_right) {
        const l3d_trim_place from{low, one.low_v}, to{high, one.high_v};
        if (low == high && low == (is_right ? box_.most[0] : box_.least[0]))
            sides_[is_right ? 3 : 2].push_back({one.low_v, one.high_v});
        else if (is_right)
            border_.push_back({from, to, triangles_.size() - 1, one.right});
        else
            border_.push_back(
                {to, from, triangles_.size(), {one.left.edge, one.left.to, one.left.from}});
    };
    take_slanted(one.low.front(), one.high.front(), false);
    std::size_t i = 0, j = 0;
    while (i + 1 < one.low.size() || j + 1 < one.high.size()) {
        const l3d_trim_place low{one.low[i], one.low_v}, high{one.high[j], one.high_v};
        const bool is_low = j + 1 == one.high.size() ||
                            (i + 1 < one.low.size() && one.low[i + 1] <= one.high[j + 1]);
        if (is_low)
            take_level(one.low[i], one.low[i + 1], false);
        else
            take_level(one.high[j], one.high[j + 1], true);
        const l3d_trim_place next = is_low ? l3d_trim_place{one.low[++i], one.low_v}
                                           : l3d_trim_place{one.high[++j], one.high_v};
        triangles_.push_back({low, next, high});
    }
    take_slanted(one.low.back(), one.high.back(), true);
}

/// Joins the stretches of each side, and fills possible gaps by triangles without area. Gaps can
/// arise because a neighbour may have no corner where two stretches meet.
void l3d_trim_triangles::close_sides() {
    for (std::size_t k = 0; k < sides_.size(); ++k) {
        std::vector<stretch>& all = sides_[k];
        std::ranges::sort(all);
        const auto place = [&](double along) {
            return k < 2 ? l3d_trim_place{along, k == 0 ? box_.least[1] : box_.most[1]}
                         : l3d_trim_place{k == 2 ? box_.least[0] : box_.most[0], along};
        };
        std::size_t kept = 0;
        for (const stretch one : all) {
            if (kept == 0 || one[0] != all[kept - 1][1]) {
                all[kept++] = one;
                continue;
            }
            triangles_.push_back({place(all[kept - 1][0]), place(one[0]), place(one[1])});
            all[kept - 1][1] = one[1];
        }
        all.resize(kept);
    }
}

/// Finds the edge that a side of equal v follows. The side is a part of a polygon's side, and
/// follows the edge of that side.
l3d_trim_use l3d_trim_triangles::level_use(double v, double from, double to) const {
    for (const l3d_trim_polygon& polygon : region_->polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const l3d_trim_corner& a = polygon[i];
            const l3d_trim_corner& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
            if (a.side.edge == l3d_no_edge || a[1] != v || b[1] != v ||
                std::min(from, to) < std::min(a[0], b[0]) ||
                std::max(from, to) > std::max(a[0], b[0]))
                continue;
            const auto at = [&](double u) { return a.side.at((u - a[0]) / (b[0] - a[0])); };
            return {a.side.edge, at(from), at(to)};
        }
    return {};
}

/// Finds the border among sides of equal v. A side that is not on the border belongs to two
/// trapezoids.
void l3d_trim_triangles::find_level_border() {
    const auto key = [](const level_side& s) { return std::tuple(s.v, s.from, s.to); };
    std::ranges::sort(level_sides_, {}, key);
    for (std::size_t i = 0; i < level_sides_.size(); ++i) {
        const level_side& s = level_sides_[i];
        if (i + 1 < level_sides_.size() && key(level_sides_[i + 1]) == key(s)) {
            ++i;
            continue;
        }
        const l3d_trim_place from{s.from, s.v}, to{s.to, s.v};
        border_.push_back(s.is_high
                              ? border_side{to, from, s.triangle, level_use(s.v, s.to, s.from)}
                              : border_side{from, to, s.triangle, level_use(s.v, s.from, s.to)});
    }
    std::ranges::sort(border_, {}, &border_side::triangle);
}

/// Finds the parts of the border that follow edges. On a side of the box, a stretch may follow
/// several edges. The stretch then has corners between its ends, and triangles without area join
/// these corners to the stretch.
void l3d_trim_triangles::find_followed() {
    for (const border_side& side : border_)
        if (side.use.edge != l3d_no_edge)
            followed_.push_back(side);
    for (const l3d_trim_polygon& polygon : region_->polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const l3d_trim_corner& a = polygon[i];
            const l3d_trim_corner& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
            if (a.side.edge == l3d_no_edge || a == b)
                continue;
            const std::size_t across = a[1] == b[1] ? 1 : 0, along = 1 - across;
            const bool is_low = a[across] == box_.least[across];
            if (a[across] != b[across] || (!is_low && a[across] != box_.most[across]))
                continue;
            const double first = std::min(a[along], b[along]), last = std::max(a[along], b[along]);
            const auto place = [&](double at) {
                l3d_trim_place result = a;
                result[along] = at;
                return result;
            };
            const auto t = [&](double at) {
                return a.side.at((at - a[along]) / (b[along] - a[along]));
            };
            for (const stretch& one : sides_[(across == 1 ? 0 : 2) + (is_low ? 0 : 1)]) {
                const double from = std::max(one[0], first), to = std::min(one[1], last);
                if (!(from < to))
                    continue;
                followed_.push_back(
                    {place(from), place(to), triangles_.size(), {a.side.edge, t(from), t(to)}});
                if (to != one[1])
                    triangles_.push_back({place(from), place(to), place(one[1])});
            }
        }
}
