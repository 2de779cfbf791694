// SPDX-License-Identifier: MIT
// path_chains: cutting outlines into chains, and chains into rows.
#include "raster/paths/path_chains_p.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace l3d_detail {

chain::chain(const l3d_point_2d* all, std::size_t first, std::size_t last, std::int32_t height,
             std::uint8_t layer)
    : last_(static_cast<std::ptrdiff_t>(last)), step_(first < last ? 1 : -1) {
    top_ = static_cast<std::int32_t>(std::max(all[first].y, 0.0));
    bottom_ = static_cast<std::int32_t>(std::ceil(std::min<double>(all[last].y, height)));
    next_ = static_cast<std::ptrdiff_t>(first) + step_;
    while (all[next_].y <= 0)
        next_ += step_;
    piece_.direction = static_cast<std::int8_t>(-step_);
    piece_.layer = layer;
    piece_.corners.step = step_;
    piece_.leaves = all[next_ - step_];
    end_ = 0;
    if (piece_.leaves.y < 0) {
        edge_ = straight_edge(piece_.leaves, all[next_]);
        end_ = all[next_].y;
        piece_.leaves = {edge_.x_at(0), 0};
    }
}

void chain::enter_at_corners(std::int32_t row, const l3d_point_2d* all) {
    const double row_end = row + 1;
    const std::ptrdiff_t behind = last_ + step_;
    l3d_point_2d at = piece_.leaves;
    // A level edge on the border of two rows bounds no area in either.
    if (at.y == row)
        for (; next_ != behind && all[next_].y == at.y; next_ += step_)
            at = all[next_];
    piece_.enters = at;
    double left = at.x, right = at.x;
    const std::ptrdiff_t begin = next_;
    for (; next_ != behind && all[next_].y < row_end; next_ += step_) {
        left = std::min(left, all[next_].x);
        right = std::max(right, all[next_].x);
    }
    piece_.corners.first = all + begin;
    piece_.corners.count = static_cast<std::size_t>((next_ - begin) * step_);
    if (next_ == behind) {
        piece_.leaves = all[last_];
        --piece_.corners.count;
    } else if (all[next_].y == row_end) {
        piece_.leaves = all[next_];
    } else {
        edge_ = straight_edge(all[next_ - step_], all[next_]);
        end_ = all[next_].y;
        piece_.leaves = {edge_.x_at(row_end), row_end};
    }
    piece_.left = std::min(left, piece_.leaves.x);
    piece_.right = std::max(right, piece_.leaves.x);
}

void path_chains::clear(std::int32_t width, std::int32_t height, l3d_point_2d move) {
    width_ = width;
    height_ = height;
    move_ = move;
    corners_.clear();
    chains_.clear();
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

/// Ends an outline and cuts it into chains.
///
/// A chain begins at an edge that is not level, where the last such edge led the other way. The
/// outline's corners before the first turn are repeated behind its last corner, so that each
/// chain's corners lie side by side. Outlines beside the picture are dropped: a dashed line may
/// have a million of them.
void path_chains::end(std::uint8_t layer) {
    const l3d_point_2d closing = corners_[outline_];
    corners_.push(closing);
    if (reached_.most <= 0 || reached_.least >= width_)
        return corners_.keep(outline_); // being closed, it winds about no place of the picture
    if (reached_.least < 0 || reached_.most > width_)
        cut_at_sides();
    const std::size_t last = corners_.size() - 1, before = chains_.size();
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
    const auto place_of_turn = [&](std::size_t from, std::size_t end, bool down) {
        const l3d_point_2d* const all = corners_.data();
        return static_cast<std::size_t>(turn_from(all + from, all + end, down) - all);
    };
    std::size_t begin = outline_;
    while (begin < last && corners_[begin].y == corners_[begin + 1].y)
        ++begin;
    if (begin == last)
        return; // the outline is level
    bool down = corners_[begin].y < corners_[begin + 1].y;
    begin = place_of_turn(begin, last, down);
    const std::size_t again = begin - outline_;
    l3d_point_2d* const room = corners_.room(again);
    std::copy_n(corners_.data() + outline_ + 1, again, room);
    corners_.use(again);
    const std::size_t end = corners_.size() - 1;
    while (begin != end) {
        down = !down;
        const std::size_t turn = place_of_turn(begin, end, down);
        add_chain(begin, turn, down, layer);
        begin = turn;
    }
    if (chains_.size() > before)
        add_outline(before);
}

/// Adds an outline: its chains from `first` on, and the columns and rows that it reaches.
void path_chains::add_outline(std::size_t first) {
    std::int32_t top = height_, bottom = 0;
    for (std::size_t i = first; i < chains_.size(); ++i) {
        top = std::min(top, chains_[i].top());
        bottom = std::max(bottom, chains_[i].bottom());
    }
    const auto column = [this](double x) {
        return static_cast<std::int32_t>(std::clamp(x, 0.0, width_));
    };
    outlines_.push_back({{column(reached_.least), top, column(reached_.most) + 1, bottom},
                         first,
                         chains_.size() - first,
                         false});
}

void path_chains::add_chain(std::size_t first, std::size_t last, bool down, std::uint8_t layer) {
    if (!down)
        std::swap(first, last);
    if (corners_[last].y > 0 && corners_[first].y < height_)
        chains_.emplace_back(corners_.data(), first, last, height_, layer);
}

/// Finds the outlines that overlap no other one. Goes through them by their tops, and compares each
/// with those that have begun and not ended.
void path_chains::find_apart() {
    const auto is_pair = [](const outline& o) { return o.chains == 2; };
    if (std::ranges::none_of(outlines_, is_pair))
        return;
    std::ranges::sort(outlines_, {}, [](const outline& o) { return o.box.top; });
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

/// Sorts chains by the row that they begin in: counts those of each row, then puts each at its
/// row's place. Returns the end of the lowest row.
std::int32_t path_chains::sort() {
    const auto is_left_out = [](const chain& c) { return c.top() == c.bottom(); };
    top_ = height_;
    std::int32_t bottom = 0;
    for (const chain& c : chains_)
        if (!is_left_out(c)) {
            top_ = std::min(top_, c.top());
            bottom = std::max(bottom, c.bottom());
        }
    if (top_ >= bottom)
        return top_;
    begins_.assign(static_cast<std::size_t>(bottom - top_) + 2, 0);
    for (const chain& c : chains_)
        if (!is_left_out(c))
            ++begins_[static_cast<std::size_t>(c.top() - top_) + 2];
    for (std::size_t row = 2; row < begins_.size(); ++row)
        begins_[row] += begins_[row - 1];
    order_.resize(begins_.back());
    for (std::size_t i = 0; i < chains_.size(); ++i)
        if (!is_left_out(chains_[i]))
            order_[begins_[static_cast<std::size_t>(chains_[i].top() - top_) + 1]++] =
                static_cast<std::uint32_t>(i);
    return bottom;
}

std::span<const std::uint32_t> path_chains::begun_in(std::int32_t row) const {
    const auto place = static_cast<std::size_t>(row - top_);
    return std::span(order_).subspan(begins_[place], begins_[place + 1] - begins_[place]);
}

} // namespace l3d_detail
