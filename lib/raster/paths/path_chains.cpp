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
        take_edge(piece_.leaves, all[next_]);
        piece_.leaves = {x_at(0), 0};
    }
}

void chain::take_edge(l3d_point_2d from, l3d_point_2d to) {
    x0_ = from.x;
    y0_ = from.y;
    end_ = to.y;
    slope_ = (to.x - from.x) / (to.y - from.y);
    least_ = std::min(from.x, to.x);
    most_ = std::max(from.x, to.x);
}

void chain::enter_at_corners(std::int32_t row, const l3d_point_2d* all) {
    const double row_end = row + 1;
    const std::ptrdiff_t behind = last_ + step_;
    l3d_point_2d at = piece_.leaves;
    // A level edge between two rows ties nothing together in either.
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
        take_edge(all[next_ - step_], all[next_]);
        piece_.leaves = {x_at(row_end), row_end};
    }
    piece_.left = std::min(left, piece_.leaves.x);
    piece_.right = std::max(right, piece_.leaves.x);
}

void path_chains::clear(std::int32_t width, std::int32_t height) {
    width_ = width;
    height_ = height;
    corners_.clear();
    chains_.clear();
}

void path_chains::begin(l3d_point_2d corner) {
    first_ = last_ = corner;
    outline_ = corners_.size();
    corners_.push_back({std::clamp(corner.x, 0.0, width_), corner.y});
}

void path_chains::go(l3d_point_2d to, bool keep_end) {
    const l3d_point_2d from = last_;
    const double left = std::min(from.x, to.x), right = std::max(from.x, to.x);
    const auto cross = [&](double side) {
        if (left < side && side < right) {
            const double y = from.y + (side - from.x) * ((to.y - from.y) / (to.x - from.x));
            corners_.push_back(
                {side, std::clamp(y, std::min(from.y, to.y), std::max(from.y, to.y))});
        }
    };
    if (left < 0 || right > width_) {
        cross(from.x < to.x ? 0 : width_);
        cross(from.x < to.x ? width_ : 0);
    }
    if (keep_end)
        corners_.push_back({std::clamp(to.x, 0.0, width_), to.y});
    last_ = to;
}

/// Chains begin at an edge that is not level, where the last one that was not led the other way.
/// The outline's first corners are there again behind its last one, up to the first turn: so each
/// chain's corners are beside each other.
void path_chains::end(std::uint8_t layer) {
    go(first_, false);
    corners_.push_back(corners_[outline_]);
    const std::size_t last = corners_.size() - 1;
    const auto way_of = [this](std::size_t edge) {
        const double dy = corners_[edge + 1].y - corners_[edge].y;
        return (dy > 0) - (dy < 0);
    };
    int way = 0;
    std::size_t begin = outline_;
    for (; begin < last; ++begin) {
        const int next = way_of(begin);
        if (next * way < 0)
            break;
        way = next != 0 ? next : way;
    }
    if (begin == last)
        return; // it is level, or has one edge
    for (std::size_t i = outline_ + 1; i <= begin; ++i)
        corners_.push_back(corners_[i]);
    bool down = way < 0;
    for (std::size_t edge = begin + 1; edge < corners_.size() - 1; ++edge) {
        const double dy = corners_[edge + 1].y - corners_[edge].y;
        if (down ? dy < 0 : dy > 0) {
            add_chain(begin, edge, down, layer);
            begin = edge;
            down = !down;
        }
    }
    add_chain(begin, corners_.size() - 1, down, layer);
}

void path_chains::add_chain(std::size_t first, std::size_t last, bool down, std::uint8_t layer) {
    if (!down)
        std::swap(first, last);
    if (corners_[last].y > 0 && corners_[first].y < height_)
        chains_.emplace_back(corners_.data(), first, last, height_, layer);
}

/// Counts the chains of each row, then puts them where their row begins.
std::int32_t path_chains::sort() {
    top_ = 0;
    if (chains_.empty())
        return 0;
    top_ = std::ranges::min_element(chains_, {}, &chain::top)->top();
    const std::int32_t bottom = std::ranges::max_element(chains_, {}, &chain::bottom)->bottom();
    begins_.assign(static_cast<std::size_t>(bottom - top_) + 2, 0);
    for (const chain& c : chains_)
        ++begins_[static_cast<std::size_t>(c.top() - top_) + 2];
    for (std::size_t row = 2; row < begins_.size(); ++row)
        begins_[row] += begins_[row - 1];
    order_.resize(chains_.size());
    for (std::size_t i = 0; i < chains_.size(); ++i)
        order_[begins_[static_cast<std::size_t>(chains_[i].top() - top_) + 1]++] =
            static_cast<std::uint32_t>(i);
    return bottom;
}

std::span<const std::uint32_t> path_chains::begun_in(std::int32_t row) const {
    const auto place = static_cast<std::size_t>(row - top_);
    return std::span(order_).subspan(begins_[place], begins_[place + 1] - begins_[place]);
}

} // namespace l3d_detail
