// SPDX-License-Identifier: MIT
// row_areas: slabs between ends and crossings, and the area right of a straight border.
#include "raster/paths/row_pieces_p.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace l3d_detail {

namespace {

/// Where a piece is at a height within it. Its ends are met exactly, and it never leaves them.
double x_at(const row_piece& p, double y) {
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

void row_areas::add_cluster(std::span<const row_piece> pieces, const windings& left,
                            const fill_rules& rules) {
    ends_.clear();
    sorted_.clear();
    for (const row_piece& p : pieces) {
        if (p.y0 >= p.y1)
            continue; // level: it bounds no area, and only ties others together
        ends_.push_back(p.y0);
        ends_.push_back(p.y1);
        sorted_.push_back(&p);
    }
    std::ranges::sort(ends_);
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    std::ranges::sort(sorted_, {}, &row_piece::y0);
    chords_.clear();
    std::size_t next = 0;
    for (std::size_t i = 1; i < ends_.size(); ++i) {
        const double top = ends_[i - 1], bottom = ends_[i];
        std::size_t kept = 0;
        for (const chord& c : chords_)
            if (c.piece->y1 > top)
                chords_[kept++] = {c.x1, 0, c.piece};
        chords_.resize(kept);
        for (; next < sorted_.size() && sorted_[next]->y0 <= top; ++next)
            chords_.push_back({sorted_[next]->x0, 0, sorted_[next]});
        for (chord& c : chords_)
            c.x1 = x_at(*c.piece, bottom);
        add_slab(top, bottom, left, rules);
    }
}

void row_areas::add_slab(double top, double bottom, const windings& left, const fill_rules& rules) {
    // Where several begin at one place, their lower ends tell the order.
    // From one slab to the next few change places.
    if (!std::is_sorted(chords_.begin(), chords_.end()))
        std::sort(chords_.begin(), chords_.end());
    if (std::ranges::is_sorted(chords_, {}, &chord::x1)) {
        add_ordered(chords_, top, bottom, left, rules);
        return;
    }
    // Where all lower ends before a chord are left of those from it on, nothing crosses.
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

windings row_areas::add_crossing(std::span<const chord> chords, double top, double bottom,
                                 const windings& left, const fill_rules& rules) {
    cut_chords_.assign(chords.begin(), chords.end());
    find_crossings(top, bottom);
    windings right;
    for (std::size_t i = 1; i < cuts_.size(); ++i) {
        const double y0 = cuts_[i - 1], y1 = cuts_[i];
        const auto at = [&](const chord& c, double y) {
            return std::lerp(c.x0, c.x1, (y - top) / (bottom - top));
        };
        cut_chords_.clear();
        for (const chord& c : chords)
            cut_chords_.push_back({at(c, y0), at(c, y1), c.piece});
        std::ranges::sort(cut_chords_, {}, [](const chord& c) { return c.x0 + c.x1; });
        right = add_ordered(cut_chords_, y0, y1, left, rules);
    }
    return right;
}

/// Sorts a copy by the lower ends, by insertion: two that change places cross.
void row_areas::find_crossings(double top, double bottom) {
    cuts_ = {top, bottom};
    for (std::size_t i = 1; i < cut_chords_.size(); ++i) {
        const chord moving = cut_chords_[i];
        std::size_t hole = i;
        for (; hole > 0 && cut_chords_[hole - 1].x1 > moving.x1; --hole) {
            const chord& other = cut_chords_[hole - 1];
            const double above = moving.x0 - other.x0, below = other.x1 - moving.x1;
            cuts_.push_back(std::lerp(top, bottom, above / (above + below)));
            cut_chords_[hole] = other;
        }
        cut_chords_[hole] = moving;
    }
    std::ranges::sort(cuts_);
    cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
}

/// Gives the windings right of them.
windings row_areas::add_ordered(std::span<const chord> chords, double top, double bottom,
                                const windings& left, const fill_rules& rules) {
    windings w = left;
    bool was_inside = rules.inside(w);
    for (const chord& c : chords) {
        w.cross(*c.piece);
        const bool is_inside = rules.inside(w);
        if (is_inside != was_inside)
            add_border(c.x0, top, c.x1, bottom, is_inside ? 1 : -1);
        was_inside = is_inside;
    }
    return w;
}

} // namespace l3d_detail
