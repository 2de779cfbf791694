// SPDX-License-Identifier: MIT
// l3d_trim_triangles: trapezoids become triangles, and their sides are matched.
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
    trapezoids_.of(region, [this](const l3d_trapezoid& one) { take(one); });
    close_sides();
    find_level_border();
    find_followed();
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
    if (one.low.size() + one.high.size() < 3)
        return; // nothing but a line
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

/// Joins the stretches of each side. Between their ends a neighbour may have no corners.
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

/// The edge that a side of equal v follows: that of the polygon's side that it is a part of.
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

/// Two trapezoids share a side of equal v, unless it is border.
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

/// On the box's sides, a stretch may follow several edges. Its own side then has corners in
/// between; triangles without area join them to it.
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
