// SPDX-License-Identifier: MIT
// path_chains: cuts outlines into chains, and chains into rows.
#include "raster/paths/path_chains_p.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace l3d_detail {

chain::chain(const l3d_point_2d* all, std::size_t first, std::size_t last, std::int32_t height)
    : last_(static_cast<std::ptrdiff_t>(last)), step_(first < last ? 1 : -1) {
    top_ = static_cast<std::int32_t>(std::max(all[first].y, 0.0));
    bottom_ = static_cast<std::int32_t>(std::ceil(std::min<double>(all[last].y, height)));
    next_ = static_cast<std::ptrdiff_t>(first) + step_;
    while (all[next_].y <= 0)
        next_ += step_;
    begin_ = all[next_ - step_];
    if (begin_.y < 0)
        begin_ = {straight_edge(begin_, all[next_]).x_at(0), 0};
}

void path_chains::clear(std::int32_t width, std::int32_t height, l3d_point_2d move) {
    width_ = width;
    height_ = height;
    move_ = move;
    corners_.clear();
    chains_.clear();
    blocks_.clear();
    outlines_.clear();
}

void path_chains::begin(l3d_point_2d corner) {
    outline_ = corners_.size();
    corners_.push({corner.x + move_.x, corner.y + move_.y});
    reached_ = {corners_.back().x, corners_.back().x};
}

void path_chains::lines(std::span<const l3d_point_2d> corners) {
    const double dx = move_.x, dy = move_.y;
    // Each bound waits for the one before it, so four are found side by side.
    constexpr std::size_t at_once = 4;
    std::array<double, at_once> least, most;
    least.fill(reached_.least);
    most.fill(reached_.most);
    l3d_point_2d* const to = corners_.room(corners.size());
    const auto move = [&](std::size_t i, std::size_t k) {
        to[i] = {corners[i].x + dx, corners[i].y + dy};
        least[k] = std::min(least[k], to[i].x);
        most[k] = std::max(most[k], to[i].x);
    };
    std::size_t i = 0;
    for (; i + at_once <= corners.size(); i += at_once)
        for (std::size_t k = 0; k < at_once; ++k)
            move(i + k, k);
    for (; i < corners.size(); ++i)
        move(i, 0);
    corners_.use(corners.size());
    reached_ = {std::ranges::min(least), std::ranges::max(most)};
}

void path_chains::cut_at_sides() {
    const auto uncut = corners_.all().subspan(outline_);
    uncut_.assign(uncut.begin(), uncut.end());
    corners_.keep(outline_);
    l3d_point_2d from = uncut_[0];
    for (const l3d_point_2d& to : uncut_) {
        const double left = std::min(from.x, to.x), right = std::max(from.x, to.x);
        const auto cross = [&](double side) {
            if (left < side && side < right) {
                const double y = from.y + (side - from.x) * ((to.y - from.y) / (to.x - from.x));
                corners_.push(
                    {side, std::clamp(y, std::min(from.y, to.y), std::max(from.y, to.y))});
            }
        };
        cross(from.x < to.x ? 0 : width_);
        cross(from.x < to.x ? width_ : 0);
        corners_.push({std::clamp(to.x, 0.0, width_), to.y});
        from = to;
    }
}

/// Ends an outline, and cuts it into blocks and perhaps chains. Outlines beside the picture are
/// dropped, since a dashed line may have a million outlines there.
void path_chains::end(std::uint8_t layer) {
    const l3d_point_2d closing = corners_[outline_];
    corners_.push(closing);
    if (reached_.most <= 0 || reached_.least >= width_)
        return corners_.keep(outline_); // a closed outline beside the picture winds around no pixel
    if (reached_.least < 0 || reached_.most > width_)
        cut_at_sides();
    const std::size_t last = corners_.size() - 1, first_block = blocks_.size();
    add_blocks(last);
    double top = blocks_[first_block].top, bottom = blocks_[first_block].bottom;
    for (std::size_t i = first_block + 1; i < blocks_.size(); ++i) {
        top = std::min(top, blocks_[i].top);
        bottom = std::max(bottom, blocks_[i].bottom);
    }
    const double seen_top = std::max(top, 0.0), seen_bottom = std::min<double>(bottom, height_);
    if (seen_top >= seen_bottom) { // it is above, below, or level
        blocks_.resize(first_block);
        return corners_.keep(outline_);
    }
    const auto column = [this](double x) {
        return static_cast<std::int32_t>(std::clamp(x, 0.0, width_));
    };
    const std::size_t chains = chains_.size();
    const bool is_pair = add_pair(last);
    outlines_.push_back(
        {{column(reached_.least), static_cast<std::int32_t>(seen_top), column(reached_.most) + 1,
          static_cast<std::int32_t>(std::ceil(seen_bottom))},
         first_block,
         blocks_.size() - first_block,
         is_pair ? chains : outline::none,
         layer,
         false});
}

/// Divides the edges of the present outline into blocks.
void path_chains::add_blocks(std::size_t last) {
    constexpr std::size_t edges = 64;
    const l3d_point_2d* const all = corners_.data();
    for (std::size_t i = outline_; i < last;) {
        const std::size_t first = i, end = std::min(i + edges, last);
        double top = all[i].y, bottom = top;
        for (; i < end; ++i) {
            top = std::min(top, all[i + 1].y);
            bottom = std::max(bottom, all[i + 1].y);
        }
        blocks_.push_back(
            {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end), top, bottom});
    }
}

/// Cuts the present outline into two chains. Does nothing and returns false if the outline turns
/// more often.
///
/// A chain begins at the first edge after the outline turned from up to down, or from down to up;
/// horizontal edges do not count. The outline's corners before the first turn are repeated after
/// its last corner, so that each chain's corners lie side by side. Expects: not all edges are
/// horizontal.
bool path_chains::add_pair(std::size_t last) {
    // The next edge that leads the other way, or the last corner.
    const auto turn_from = [](const l3d_point_2d* at, const l3d_point_2d* end, bool down) {
        if (down)
            while (at != end && at[1].y >= at[0].y)
                ++at;
        else
            while (at != end && at[1].y <= at[0].y)
                ++at;
        return at;
    };
    const l3d_point_2d *first = corners_.data() + outline_, *const end = corners_.data() + last;
    while (first[0].y == first[1].y)
        ++first;
    const bool down = first[0].y < first[1].y;
    const l3d_point_2d* const turn = turn_from(first, end, down);
    const l3d_point_2d* const second = turn_from(turn, end, !down);
    if (turn_from(second, end, down) != end)
        return false;
    const auto begin = static_cast<std::size_t>(turn - corners_.data());
    std::size_t middle = static_cast<std::size_t>(second - corners_.data());
    const std::size_t again = begin - outline_;
    l3d_point_2d* const room = corners_.room(again);
    std::copy_n(corners_.data() + outline_ + 1, again, room);
    corners_.use(again);
    if (middle == last) { // level edges at the outline's end continue with the repeated corners
        const l3d_point_2d* const all = corners_.data();
        middle = static_cast<std::size_t>(
            turn_from(all + middle, all + corners_.size() - 1, !down) - all);
    }
    add_chain(begin, middle, !down);
    add_chain(middle, corners_.size() - 1, down);
    return true;
}

void path_chains::add_chain(std::size_t first, std::size_t last, bool down) {
    if (!down)
        std::swap(first, last);
    chains_.emplace_back(corners_.data(), first, last, height_);
}

void path_chains::sort() {
    std::ranges::sort(outlines_, {}, [](const outline& o) { return o.box.top; });
}

/// Finds the outlines whose boxes meet no other outline's box. It goes through the outlines in the
/// order of their tops. It compares each outline with the outlines that begin above its top and
/// have not ended there.
void path_chains::find_apart() {
    if (std::ranges::none_of(outlines_, &outline::is_pair))
        return;
    // Where very many outlines lie side by side, comparing all costs more than it saves.
    std::size_t looks = 64 * outlines_.size();
    active_.clear();
    for (outline& next : outlines_) {
        next.apart = true;
        std::size_t kept = 0;
        for (outline* const other : active_) {
            if (other->box.bottom <= next.box.top)
                continue;
            active_[kept++] = other;
            if (!other->box.intersected(next.box).empty())
                next.apart = other->apart = false;
        }
        if (looks < active_.size()) {
            for (outline& o : outlines_)
                o.apart = false;
            return;
        }
        looks -= active_.size();
        active_.resize(kept);
        active_.push_back(&next);
    }
}

} // namespace l3d_detail
