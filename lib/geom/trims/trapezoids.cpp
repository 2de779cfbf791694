// SPDX-License-Identifier: MIT
// l3d_trapezoids: sweeps a line of equal v upwards, and stops at corners and crossings.
#include "geom/trims/trapezoids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

double l3d_trapezoids::side::at(double v) const {
    if (v <= low[1])
        return low[0];
    if (v >= high[1])
        return high[0];
    return low[0] + (high[0] - low[0]) * ((v - low[1]) / (high[1] - low[1]));
}

l3d_trim_use l3d_trapezoids::side::use_between(double from_v, double to_v) const {
    if (use.edge == l3d_no_edge)
        return use;
    const auto at_v = [&](double v) { return use.at((v - low[1]) / (high[1] - low[1])); };
    return {use.edge, at_v(from_v), at_v(to_v)};
}

void l3d_trapezoids::begin(const l3d_trim_region& region) {
    sides_.clear();
    corners_.clear();
    active_.clear();
    open_.clear();
    pool_.clear();
    next_side_ = next_corner_ = 0;
    is_begun_ = false;
    for (const l3d_trim_polygon& polygon : region.polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            l3d_trim_place a = polygon[i], b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
            l3d_trim_use use = polygon[i].side;
            corners_.push_back(a);
            if (a[1] == b[1])
                continue;
            if (a[1] > b[1]) {
                std::swap(a, b);
                std::swap(use.from, use.to);
            }
            side& one = sides_.emplace_back();
            one.low = a;
            one.high = b;
            one.use = use;
        }
    std::ranges::sort(corners_, {}, [](const l3d_trim_place& p) { return std::pair(p[1], p[0]); });
    std::ranges::sort(sides_, {}, [](const side& s) { return s.low[1]; });
}

/// Moves the line to the next corner or crossing, and ends and begins trapezoids there. Returns
/// false after the last corner.
bool l3d_trapezoids::next_line() {
    if (is_begun_ && next_v_ == std::numeric_limits<double>::infinity())
        return false;
    if (!is_begun_ && corners_.empty())
        return false;
    v_ = is_begun_ ? next_v_ : corners_.front()[1];
    is_begun_ = true;
    first_corner_ = next_corner_;
    while (next_corner_ < corners_.size() && corners_[next_corner_][1] <= v_)
        ++next_corner_;
    std::erase_if(active_, [&](std::size_t i) { return sides_[i].high[1] <= v_; });
    while (next_side_ < sides_.size() && sides_[next_side_].low[1] <= v_)
        active_.push_back(next_side_++);
    const bool is_last = next_corner_ == corners_.size();
    next_v_ = is_last ? std::numeric_limits<double>::infinity() : corners_[next_corner_][1];
    new_open_.clear();
    if (!is_last)
        pair_up(next_v_ = order_until(next_v_));
    end_and_begin();
    return true;
}

/// Sorts the sides that cross the line from left to right, by their places in the middle between v_
/// and `next`. If two sides cross before `next`, the lowest crossing replaces `next`. Returns the v
/// up to which the order holds.
double l3d_trapezoids::order_until(double next) {
    // Sides that are nearer than this count as met.
    constexpr double rounding = 0x1p-44;
    for (;;) {
        const double middle = v_ + (next - v_) / 2;
        keys_.resize(sides_.size());
        for (const std::size_t i : active_)
            keys_[i] = sides_[i].at(middle);
        std::ranges::sort(active_, {}, [&](std::size_t i) { return std::pair(keys_[i], i); });
        double first = next;
        for (std::size_t i = 0; i + 1 < active_.size(); ++i) {
            const side &a = sides_[active_[i]], &b = sides_[active_[i + 1]];
            const double below = a.at(v_) - b.at(v_), above = a.at(next) - b.at(next);
            if (std::max(below, above) <= rounding || below == above)
                continue;
            const double at = v_ + (next - v_) * (below / (below - above));
            if (at > v_ && at < first)
                first = at;
        }
        if (first == next)
            return next;
        next = first;
    }
}

/// Finds the trapezoids that are open above v_. By the odd rule, the region lies between sides 0
/// and 1, 2 and 3, and so on.
void l3d_trapezoids::pair_up(double next) {
    for (std::size_t i = 0; i + 1 < active_.size(); i += 2) {
        side& left = sides_[active_[i]];
        const side& right = sides_[active_[i + 1]];
        if (left.at(v_) == right.at(v_) && left.at(next) == right.at(next))
            continue;
        left.next_right = active_[i + 1];
        new_open_.push_back(active_[i]);
    }
}

/// Ends the trapezoids that do not continue above v_, and begins new ones.
void l3d_trapezoids::end_and_begin() {
    ended_.clear();
    marks_.clear();
    for (std::size_t i = first_corner_; i < next_corner_; ++i)
        marks_.push_back(corners_[i][0]);
    const auto goes_on = [&](const side& left) { return left.right == left.next_right; };
    for (const std::vector<std::size_t>* some : {&open_, &new_open_})
        for (const std::size_t i : *some)
            if (const side& left = sides_[i]; !goes_on(left))
                for (const std::size_t right : {some == &open_ ? left.right : none,
                                                some == &new_open_ ? left.next_right : none})
                    if (right != none)
                        marks_.insert(marks_.end(), {left.at(v_), sides_[right].at(v_)});
    std::ranges::sort(marks_);
    marks_.erase(std::unique(marks_.begin(), marks_.end()), marks_.end());
    // Finds the points of the line between two sides, as the first index and the count.
    const auto between = [&](const side& left, const side& right) {
        double from = left.at(v_), to = right.at(v_);
        if (from > to)
            std::swap(from, to); // they meet here, up to rounding
        const auto first = std::ranges::lower_bound(marks_, from);
        const auto last = std::ranges::upper_bound(marks_, to);
        return std::pair(static_cast<std::size_t>(first - marks_.begin()),
                         static_cast<std::size_t>(last - first));
    };
    for (const std::size_t i : open_) {
        const side& left = sides_[i];
        if (goes_on(left))
            continue;
        const auto [high, count] = between(left, sides_[left.right]);
        ended_.push_back({left.low_v, left.first_low, left.low_count, high, count, i, left.right});
    }
    for (const std::size_t i : open_)
        if (!goes_on(sides_[i]))
            sides_[i].right = none;
    for (const std::size_t i : new_open_) {
        side& left = sides_[i];
        if (left.right != left.next_right) {
            const auto [low, count] = between(left, sides_[left.next_right]);
            left.right = left.next_right;
            left.low_v = v_;
            left.first_low = pool_.size();
            left.low_count = count;
            pool_.insert(pool_.end(), marks_.begin() + static_cast<std::ptrdiff_t>(low),
                         marks_.begin() + static_cast<std::ptrdiff_t>(low + count));
        }
        left.next_right = none;
    }
    open_ = new_open_;
}
