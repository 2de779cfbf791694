// SPDX-License-Identifier: MIT
// side_walk: walks along the corners of a chain, row by row.
#include "raster/paths/convex_fill_p.h"

#include <algorithm>

namespace l3d_detail {

side_walk::side_walk(const chain& of, const l3d_point_2d* corners)
    : chain_(of), step_(of.step()), next_(of.next_corner(corners)), behind_(of.behind(corners)),
      x_(of.begin().x), y_(of.begin().y), begin_(y_) {
    while ((behind_ - 2 * step_)->y == (behind_ - step_)->y)
        behind_ -= step_;
    skip_level();
}

/// Skips horizontal edges, which bound no area.
void side_walk::skip_level() {
    for (; next_ != behind_ && next_->y == y_; next_ += step_)
        x_ = next_->x;
}

std::size_t side_walk::straight_rows(std::int32_t row) const {
    if (next_ + step_ == behind_)
        return side_block::most_straight_rows;
    // Only whole rows count, up to the most that a block holds.
    const double rows = std::min<double>(next_->y - row, side_block::most_straight_rows);
    return static_cast<std::size_t>(rows);
}

/// The x at a height on the edge that leads to the next corner.
double side_walk::edge_at(double y) {
    if (edge_end_ != next_) {
        edge_ = straight_edge(*(next_ - step_), *next_);
        edge_end_ = next_;
    }
    return edge_.x_at(y);
}

/// Lays out rows of one edge. Does nothing and returns false if the chain has a corner on the way.
bool side_walk::lay_out_straight(double end, side_block& block) {
    block.straight = next_->y >= end || next_ + step_ == behind_;
    if (!block.straight)
        return false;
    y_ = std::min(end, next_->y);
    x_ = edge_at(y_);
    block.edge = edge_;
    if (next_->y == end) {
        x_ = next_->x;
        next_ += step_;
        skip_level();
    }
    return true;
}

void side_walk::lay_out(std::int32_t row, std::size_t count, side_block& block) {
    if (lay_out_straight(row + static_cast<double>(count), block))
        return;
    const std::ptrdiff_t step = step_;
    const l3d_point_2d *next = next_, *const first = next, *const behind = behind_;
    for (std::size_t lane = 0; lane < count; ++lane) {
        const double row_end = row + static_cast<double>(lane + 1);
        block.enters[lane] = x_;
        block.first[lane] = next;
        double *x = &block.x[0][lane], *y = &block.y[0][lane];
        const double* const x_end = x + side_block::most_corners * side_block::rows;
        for (; next != behind && next->y < row_end && x != x_end; next += step) {
            *x = next->x;
            *y = next->y;
            x += side_block::rows;
            y += side_block::rows;
        }
        for (; next != behind && next->y < row_end; next += step)
            ;
        std::ptrdiff_t corners = (next - block.first[lane]) * step;
        next_ = next;
        if (next == behind) { // the last corner is the chain's end
            --corners;
            x_ = (next - step_)->x;
            block.leaves[lane] = x_;
        } else if (next->y == row_end) {
            block.leaves[lane] = next->x;
            y_ = row_end;
            skip_level();
            next = next_;
        } else {
            x_ = edge_at(row_end);
            block.leaves[lane] = x_;
        }
        block.corners[lane] = static_cast<double>(corners);
    }
    y_ = row + static_cast<double>(count);
    // All lanes wait for the row with the most corners. Rows with a few more corners than the mean
    // still cost less in lanes than one by one. Circles and dashes are drawn fastest with four
    // more; two or eight are slower.
    const auto all = static_cast<double>((next - first) * step_);
    block.few_corners =
        std::min<double>(side_block::most_corners, all / static_cast<double>(count) + 4);
}

row_piece side_walk::piece_of(const side_block& block, std::int32_t row, std::size_t lane) const {
    row_piece piece{};
    const double top = std::max<double>(row, begin()), bottom = std::min<double>(row + 1, end());
    piece.enters = {block.straight ? block.edge.x_at(top) : block.enters[lane], top};
    piece.leaves = {block.straight ? block.edge.x_at(bottom) : block.leaves[lane], bottom};
    if (!block.straight)
        piece.corners = {block.first[lane], step_, static_cast<std::size_t>(block.corners[lane])};
    piece.direction = chain_.direction();
    piece.left = std::min(piece.enters.x, piece.leaves.x);
    piece.right = std::max(piece.enters.x, piece.leaves.x);
    for (std::size_t i = 0; i < piece.corners.count; ++i) {
        piece.left = std::min(piece.left, piece.corners[i].x);
        piece.right = std::max(piece.right, piece.corners[i].x);
    }
    return piece;
}

} // namespace l3d_detail
