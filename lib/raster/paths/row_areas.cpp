// SPDX-License-Identifier: MIT
// row_areas: cuts a row into slabs at ends and crossings, and adds areas right of straight borders.
#include "raster/paths/row_areas_p.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace l3d_detail {

namespace {

/// The x of an edge at a height between its ends. It is exact at the ends, and never beyond them.
double x_at(const row_edge& p, double y) {
    if (y <= p.y0)
        return p.x0;
    if (y >= p.y1)
        return p.x1;
    const double x = p.x0 + (p.x1 - p.x0) * ((y - p.y0) / (p.y1 - p.y0));
    return std::clamp(x, std::min(p.x0, p.x1), std::max(p.x0, p.x1));
}

} // namespace

void row_areas::set_width(std::int32_t width) {
    const std::size_t needed = static_cast<std::size_t>(width) + 2;
    if (sums_.size() < needed)
        sums_.resize(needed, 0.0);
}

void row_areas::add_cluster(std::span<const row_edge> edges, const windings& left,
                            const fill_rules& rules, std::span<const winding_change> changes) {
    ends_.clear();
    sorted_.clear();
    for (const row_edge& p : edges) {
        if (p.y0 >= p.y1)
            continue; // a level edge bounds no area, and only joins others
        ends_.push_back(p.y0);
        ends_.push_back(p.y1);
        sorted_.push_back(&p);
    }
    for (const winding_change& c : changes)
        ends_.push_back(c.y);
    sort_few(ends_, std::less<>());
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    sort_few(sorted_, [](const row_edge* a, const row_edge* b) { return a->y0 < b->y0; });
    chords_.clear();
    windings w = left;
    std::size_t next = 0, next_change = 0;
    for (std::size_t i = 1; i < ends_.size(); ++i) {
        const double top = ends_[i - 1], bottom = ends_[i];
        std::size_t kept = 0;
        for (const chord& c : chords_)
            if (c.edge->y1 > top)
                chords_[kept++] = {c.x1, 0, c.edge};
        chords_.resize(kept);
        for (; next < sorted_.size() && sorted_[next]->y0 <= top; ++next)
            chords_.push_back({sorted_[next]->x0, 0, sorted_[next]});
        for (chord& c : chords_)
            c.x1 = x_at(*c.edge, bottom);
        for (; next_change < changes.size() && changes[next_change].y <= top; ++next_change)
            w.cross(changes[next_change]);
        if (!chords_.empty())
            add_slab(top, bottom, w, rules);
    }
}

void row_areas::add_slab(double top, double bottom, const windings& left, const fill_rules& rules) {
    windings low = left, high = left; // least and most anywhere in the slab
    for (const chord& c : chords_)
        (c.edge->direction < 0 ? low : high).cross(*c.edge);
    if (rules.same_between(low, high))
        return;
    // Chords that begin at one place are in the order of their lower ends. From one slab to the
    // next, few chords change places.
    sort_few(chords_, std::less<>());
    if (std::ranges::is_sorted(chords_, {}, &chord::x1)) {
        add_ordered(chords_, top, bottom, left, rules);
        return;
    }
    // Chords of two groups do not cross if all lower ends of the left group are left of all lower
    // ends of the right group.
    least_after_.resize(chords_.size() + 1);
    least_after_.back() = std::numeric_limits<double>::infinity();
    for (std::size_t i = chords_.size(); i-- > 0;)
        least_after_[i] = std::min(least_after_[i + 1], chords_[i].x1);
    windings w = left;
    for (std::size_t i = 0; i < chords_.size();) {
        const std::size_t begin = i;
        double most = chords_[i].x1;
        for (++i; i < chords_.size() && most > least_after_[i]; ++i)
            most = std::max(most, chords_[i].x1);
        const auto group = std::span(chords_).subspan(begin, i - begin);
        w = group.size() == 1 ? add_ordered(group, top, bottom, w, rules)
                              : add_crossing(group, top, bottom, w, rules);
    }
}

/// Adds chords that cross. At a crossing, two neighbouring chords change places. Only these two
/// chords may become borders of the inside there, or cease to be borders.
windings row_areas::add_crossing(std::span<const chord> chords, double top, double bottom,
                                 const windings& left, const fill_rules& rules) {
    find_crossings(chords, top, bottom);
    tracks_.clear();
    before_.clear();
    windings w = left;
    for (const chord& c : chords) {
        before_.push_back(w);
        w.cross(*c.edge);
        tracks_.push_back({tracks_.size(), top, rules.inside(w) - rules.inside(before_.back())});
    }
    const auto end_border = [&](std::size_t index, double y) {
        const chord& c = chords[index];
        const auto& [place, since, sign] = tracks_[index];
        const auto x_at = [&](double at) {
            return std::lerp(c.x0, c.x1, (at - top) / (bottom - top));
        };
        if (sign != 0 && since < y)
            add_border(x_at(since), x_at(y), sign * (y - since));
    };
    const auto set_sign = [&](std::size_t index, int sign, double y) {
        if (tracks_[index].sign == sign)
            return;
        end_border(index, y);
        tracks_[index].since = y;
        tracks_[index].sign = sign;
    };
    const auto change_places = [&](const crossing& c, double y) {
        const std::size_t place = tracks_[c.from_left].place;
        if (tracks_[c.from_right].place != place + 1)
            return false;
        windings between = before_[place];
        between.cross(*chords[c.from_right].edge);
        windings after = between;
        after.cross(*chords[c.from_left].edge);
        set_sign(c.from_right, rules.inside(between) - rules.inside(before_[place]), y);
        set_sign(c.from_left, rules.inside(after) - rules.inside(between), y);
        before_[place + 1] = between;
        tracks_[c.from_left].place = place + 1;
        tracks_[c.from_right].place = place;
        return true;
    };
    // Where several chords cross in one place, rounding may change the order of their crossings. A
    // crossing of chords that are not yet beside each other waits for the crossings with the chords
    // between them.
    waiting_.clear();
    for (const crossing& c : crossings_) {
        waiting_.push_back(c);
        while (std::erase_if(waiting_,
                             [&](const crossing& next) { return change_places(next, c.y); }) > 0)
            ;
    }
    for (std::size_t i = 0; i < chords.size(); ++i)
        end_border(i, bottom);
    return w;
}

/// Sorts chords by their lower ends, by insertion. Two chords that change places cross.
void row_areas::find_crossings(std::span<const chord> chords, double top, double bottom) {
    crossings_.clear();
    by_lower_.clear();
    for (std::size_t i = 0; i < chords.size(); ++i) {
        const chord& moving = chords[i];
        std::size_t hole = by_lower_.size();
        by_lower_.push_back(i);
        for (; hole > 0 && chords[by_lower_[hole - 1]].x1 > moving.x1; --hole) {
            const std::size_t other = by_lower_[hole - 1];
            const double above = moving.x0 - chords[other].x0;
            const double below = chords[other].x1 - moving.x1;
            crossings_.push_back({std::lerp(top, bottom, above / (above + below)), other, i});
            by_lower_[hole] = other;
        }
        by_lower_[hole] = i;
    }
    std::ranges::sort(crossings_, {}, &crossing::y);
}

/// Adds chords that do not cross. Returns the winding numbers right of all chords.
windings row_areas::add_ordered(std::span<const chord> chords, double top, double bottom,
                                const windings& left, const fill_rules& rules) {
    windings w = left;
    bool was_inside = rules.inside(w);
    for (const chord& c : chords) {
        w.cross(*c.edge);
        const bool is_inside = rules.inside(w);
        if (is_inside != was_inside)
            add_border(c.x0, c.x1, is_inside ? bottom - top : top - bottom);
        was_inside = is_inside;
    }
    return w;
}

} // namespace l3d_detail
