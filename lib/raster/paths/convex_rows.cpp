// SPDX-License-Identifier: MIT
// convex_rows: whether an outline is convex, and what its borders cover of a row.
#include "raster/paths/convex_rows_p.h"

#include <cmath>
#include <limits>

namespace l3d_detail {

namespace {

/// Where the edges lead down, and where they lead up.
struct turns {
    std::size_t down_begin = 0, down_edges = 0, up_begin = 0, up_edges = 0;
    bool to_the_right = false; ///< with y down: the edges that lead down are on the right
};

/// How the edges of a convex outline turn; false if it is none.
///
/// All turns are less than half a circle and to the same side, so the directions go around as often
/// as they change from up to down.
bool find_turns(std::span<const l3d_point_2d> corners, turns& result) {
    const std::size_t count = corners.size();
    bool left = false, right = false;
    int begins = 0; // of runs of edges that lead down
    double before_x = 0, before_y = 0;
    bool was_down = false, was_up = false;
    // What leads to the first corner: the last edge of some length, and the last that is not level.
    for (std::size_t i = count; i-- > 0 && !was_down && !was_up;) {
        const l3d_point_2d& next = corners[i + 1 < count ? i + 1 : 0];
        const double x = next.x - corners[i].x, y = next.y - corners[i].y;
        if (before_x == 0 && before_y == 0) {
            before_x = x;
            before_y = y;
        }
        was_down = y > 0;
        was_up = y < 0;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const l3d_point_2d& next = corners[i + 1 < count ? i + 1 : 0];
        const double x = next.x - corners[i].x, y = next.y - corners[i].y;
        if (x == 0 && y == 0)
            continue;
        const double cross = before_x * y - before_y * x;
        if (cross > 0)
            right = true;
        else if (cross < 0)
            left = true;
        else if (before_x * x + before_y * y < 0)
            return false;
        if (left && right)
            return false;
        if (y > 0) {
            if (was_up) {
                if (++begins > 1)
                    return false;
                result.down_begin = i;
            }
            was_down = true;
            was_up = false;
        } else if (y < 0) {
            if (was_down)
                result.up_begin = i;
            was_up = true;
            was_down = false;
        }
        before_x = x;
        before_y = y;
    }
    if (begins != 1)
        return false;
    result.to_the_right = right;
    result.down_edges = (result.up_begin + count - result.down_begin) % count;
    result.up_edges = count - result.down_edges;
    return true;
}

} // namespace

bool convex_rows::begin(std::span<const l3d_point_2d> corners, std::int32_t width,
                        std::int32_t height) {
    if (corners.size() < 3)
        return false;
    double top = corners[0].y, bottom = top, left = corners[0].x, right = left;
    for (const l3d_point_2d& c : corners) {
        top = std::min(top, c.y);
        bottom = std::max(bottom, c.y);
        left = std::min(left, c.x);
        right = std::max(right, c.x);
    }
    turns found;
    if (left < 0 || right > width || !find_turns(corners, found))
        return false;
    top_ = static_cast<std::int32_t>(std::clamp<double>(top, 0, height));
    bottom_ = static_cast<std::int32_t>(std::ceil(std::clamp<double>(bottom, 0, height)));
    if (top_ >= bottom_)
        return true;
    const std::size_t side = found.to_the_right ? 1 : 0;
    const double sign = found.to_the_right ? -1 : 1;
    borders_[side].begin(corners, found.down_begin, found.down_edges, true, sign);
    borders_[1 - side].begin(corners, found.down_begin, found.up_edges, false, -sign);
    return true;
}

void convex_rows::border::begin(std::span<const l3d_point_2d> corners, std::size_t first,
                                std::size_t edges, bool forwards, double sign) {
    corners_ = corners;
    at_ = first;
    edges_ = edges;
    forwards_ = forwards;
    sign_ = sign;
    to_ = corners[first];
    take_edge();
    while (edges_ > 0 && to_.y <= 0) {
        --edges_;
        take_edge();
    }
    reached_ = from_;
    if (edges_ > 0 && from_.y < 0) {
        take_slope();
        reached_ = {x_at(0), 0};
    }
}

void convex_rows::border::take_edge() {
    from_ = to_;
    if (edges_ == 0)
        return;
    if (forwards_)
        at_ = at_ + 1 < corners_.size() ? at_ + 1 : 0;
    else
        at_ = at_ > 0 ? at_ - 1 : corners_.size() - 1;
    to_ = corners_[at_];
    sloped_ = false;
}

/// Only edges that go on below a row need it.
void convex_rows::border::take_slope() {
    sloped_ = true;
    slope_ = (to_.x - from_.x) / (to_.y - from_.y);
    per_column_ = sign_ / std::abs(slope_);
    left_ = std::min(from_.x, to_.x);
    right_ = std::max(from_.x, to_.x);
}

reached_columns convex_rows::border::add_row(double row_end, row_areas& areas) {
    reached_columns columns{std::numeric_limits<std::int32_t>::max(), -1};
    const auto go = [&](l3d_point_2d to, double height, double per_column) {
        const auto a = static_cast<std::int32_t>(reached_.x), b = static_cast<std::int32_t>(to.x);
        columns.first = std::min({columns.first, a, b});
        columns.last = std::max({columns.last, a, b});
        areas.add_border(reached_.x, to.x, height, per_column);
        reached_ = to;
    };
    for (; edges_ > 0 && to_.y <= row_end; --edges_, take_edge()) {
        const double height = sign_ * (to_.y - reached_.y);
        if (height != 0)
            go(to_, height, height / std::abs(to_.x - reached_.x));
        else
            reached_ = to_;
    }
    if (edges_ > 0 && reached_.y < row_end) {
        if (!sloped_)
            take_slope();
        go({x_at(row_end), row_end}, sign_ * (row_end - reached_.y), per_column_);
    }
    return columns;
}

} // namespace l3d_detail
