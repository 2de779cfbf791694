// SPDX-License-Identifier: MIT
// path_chains: cutting outlines into chains, and chains into rows.
#include "raster/paths/path_chains_p.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace l3d_detail {

chain::chain(std::span<const l3d_point_2d> all, std::size_t first, std::size_t last,
             std::int32_t height, std::int8_t direction, std::uint8_t layer)
    : next_(first + 1), last_(last) {
    top_ = static_cast<std::int32_t>(std::max(all[first].y, 0.0));
    bottom_ = static_cast<std::int32_t>(std::ceil(std::min<double>(all[last].y, height)));
    while (all[next_].y <= 0)
        ++next_;
    piece_.direction = direction;
    piece_.layer = layer;
    const l3d_point_2d from = all[next_ - 1];
    piece_.leaves = from.y < 0 ? l3d_point_2d{x_at(0, all), 0} : from;
}

/// On the edge that leads to the next corner. It never leaves the edge's ends.
double chain::x_at(double y, std::span<const l3d_point_2d> all) {
    const l3d_point_2d from = all[next_ - 1], to = all[next_];
    if (sloped_ != next_) {
        sloped_ = next_;
        slope_ = (to.x - from.x) / (to.y - from.y);
    }
    return std::clamp(from.x + (y - from.y) * slope_, std::min(from.x, to.x),
                      std::max(from.x, to.x));
}

void chain::enter(std::int32_t row, std::span<const l3d_point_2d> all) {
    const double row_end = row + 1;
    l3d_point_2d at = piece_.leaves;
    if (sloped_ == next_ && all[next_].y > row_end) { // along one edge
        piece_.enters = at;
        piece_.leaves = {x_at(row_end, all), row_end};
        piece_.left = std::min(at.x, piece_.leaves.x);
        piece_.right = std::max(at.x, piece_.leaves.x);
        piece_.corners = {};
        return;
    }
    // A level edge between two rows ties nothing together in either.
    if (at.y == row)
        for (; next_ <= last_ && all[next_].y == at.y; ++next_)
            at = all[next_];
    piece_.enters = at;
    double left = at.x, right = at.x;
    const auto reach = [&](double x) {
        left = std::min(left, x);
        right = std::max(right, x);
    };
    const std::size_t begin = next_;
    for (; next_ <= last_ && all[next_].y < row_end; ++next_)
        reach(all[next_].x);
    const bool ends = next_ > last_;
    const std::size_t inside = next_ - begin - (ends ? 1 : 0);
    if (ends)
        piece_.leaves = all[last_];
    else
        piece_.leaves = {all[next_].y == row_end ? all[next_].x : x_at(row_end, all), row_end};
    reach(piece_.leaves.x);
    piece_.left = left;
    piece_.right = right;
    piece_.corners = all.subspan(begin, inside);
}

void path_chains::clear(std::int32_t width, std::int32_t height) {
    width_ = width;
    height_ = height;
    corners_.clear();
    chains_.clear();
}

void path_chains::begin(l3d_point_2d corner) {
    first_ = last_ = corner;
    outline_.assign(1, {std::clamp<double>(corner.x, 0, width_), corner.y});
}

void path_chains::line(l3d_point_2d corner) {
    go(corner, true);
}

void path_chains::go(l3d_point_2d to, bool keep_end) {
    const l3d_point_2d from = last_;
    const double left = std::min(from.x, to.x), right = std::max(from.x, to.x), width = width_;
    const auto cross = [&](double side) {
        if (left < side && side < right) {
            const double y = from.y + (side - from.x) * ((to.y - from.y) / (to.x - from.x));
            outline_.push_back(
                {side, std::clamp(y, std::min(from.y, to.y), std::max(from.y, to.y))});
        }
    };
    if (left < 0 || right > width) {
        cross(from.x < to.x ? 0 : width);
        cross(from.x < to.x ? width : 0);
    }
    if (keep_end)
        outline_.push_back({std::clamp(to.x, 0.0, width), to.y});
    last_ = to;
}

/// Chains begin at an edge that is not level, where the last one that was not led the other way.
void path_chains::end(std::uint8_t layer) {
    go(first_, false);
    const std::size_t count = outline_.size();
    const auto next_of = [count](std::size_t i) { return i + 1 < count ? i + 1 : 0; };
    const auto rise = [&](std::size_t i) { return outline_[next_of(i)].y - outline_[i].y; };
    int before = 0;
    std::size_t begin = 0, edge = 0;
    bool found = false;
    for (; edge < count && !found; ++edge) {
        const double dy = rise(edge);
        const int way = (dy > 0) - (dy < 0);
        if (way != 0) {
            found = before == -way;
            before = way;
            begin = edge;
        }
    }
    if (!found)
        return; // it is level, or has one edge
    std::size_t edges = 0, at = begin;
    bool down = before > 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double dy = rise(at);
        if (down ? dy < 0 : dy > 0) {
            add_chain(begin, edges, down, layer);
            begin = at;
            edges = 0;
            down = !down;
        }
        ++edges;
        at = next_of(at);
    }
    add_chain(begin, edges, down, layer);
}

void path_chains::add_chain(std::size_t first, std::size_t edges, bool down, std::uint8_t layer) {
    const std::size_t begin = corners_.size(), count = outline_.size();
    const std::size_t last = (first + edges) % count;
    const l3d_point_2d& upper = outline_[down ? first : last];
    const l3d_point_2d& lower = outline_[down ? last : first];
    if (lower.y <= 0 || upper.y >= height_)
        return;
    std::size_t at = first;
    for (std::size_t i = 0; i <= edges; ++i) {
        corners_.push_back(outline_[at]);
        at = at + 1 < count ? at + 1 : 0;
    }
    if (!down)
        std::reverse(corners_.begin() + static_cast<std::ptrdiff_t>(begin), corners_.end());
    chains_.push_back(
        {corners_, begin, begin + edges, height_, static_cast<std::int8_t>(down ? -1 : 1), layer});
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
