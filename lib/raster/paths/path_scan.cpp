// SPDX-License-Identifier: MIT
// path_scan: edges come and go with the rows; clusters of their pieces become spans.
#include "raster/paths/path_scan_p.h"

#include "raster/paths/flat_curve_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace l3d_detail {

std::span<const covered_span> path_scan::convert(const order& wanted) {
    edges_.clear();
    spans_.clear();
    values_.clear();
    pieces_.clear();
    box_ = wanted.box;
    width_ = box_.right - box_.left;
    height_ = box_.bottom - box_.top;
    full_ = wanted.full;
    full_value_ = static_cast<int>(full_ + 0.5);
    rules_ = {{wanted.inside, wanted.clip_inside}, wanted.clip != nullptr};
    if (box_.empty() || full_value_ == 0 || !wanted.path.is_number() ||
        (wanted.clip != nullptr && !wanted.clip->is_number()))
        return {};
    areas_.set_width(width_);
    take_corners(wanted.path);
    if (ends_.size() == 1 && wanted.clip == nullptr && convex_.begin(corners_, width_, height_)) {
        add_convex();
    } else {
        add_edges(0);
        if (wanted.clip != nullptr) {
            take_corners(*wanted.clip);
            add_edges(1);
        }
        if (!edges_.empty())
            add_rows();
    }
    values_.resize(values_.size() + most_lanes);
    return spans_;
}

/// Lattice: here pixel 0 is [0, 1), and its sample is its middle.
void path_scan::take_corners(const l3d_path& path) {
    corners_.clear();
    ends_.clear();
    const double dx = 0.5 - box_.left, dy = 0.5 - box_.top;
    const seen_box seen{-dx, -dy, width_ - dx, height_ - dy};
    const auto go = [&](l3d_point_2d to) { corners_.push_back({to.x + dx, to.y + dy}); };
    visit_flat(path, l3d_flat_enough, seen, go, go, [&](bool) {
        if (ends_.empty() || ends_.back() < corners_.size())
            ends_.push_back(corners_.size());
    });
}

void path_scan::add_edges(std::uint8_t layer) {
    std::size_t begin = 0;
    for (const std::size_t end : ends_) {
        l3d_point_2d last = corners_[end - 1];
        for (; begin < end; ++begin) {
            add_edge(last, corners_[begin], layer);
            last = corners_[begin];
        }
    }
}

void path_scan::add_convex() {
    for (std::int32_t row = convex_.top(); row < convex_.bottom(); ++row) {
        const reached_columns left = convex_.add_left(row, areas_);
        const reached_columns right = convex_.add_right(row, areas_);
        if (left.first <= left.last && right.first <= right.last)
            add_convex_row(row, left, right);
    }
}

void path_scan::add_convex_row(std::int32_t row, const reached_columns& left,
                               const reached_columns& right) {
    // A run of values costs a few nanoseconds, however short it is; so does a span beside it.
    constexpr std::int32_t few = 32;
    if (right.first <= left.last + 1) {
        add_values(row, {left.first, std::max(left.last, right.last)}, 0);
    } else if (right.last - left.first < few) {
        std::uint8_t* value = add_values(row, {left.first, right.last});
        const double covered = run_up(left, 0, value);
        const std::int32_t between = right.first - left.last - 1;
        std::fill_n(value + (left.last + 1 - left.first), between, value_of(covered));
        run_up(right, covered, value + (right.first - left.first));
    } else {
        const double covered = add_values(row, left, 0);
        add_solid(row, left.last + 1, right.first, value_of(covered));
        add_values(row, right, covered);
    }
}

void path_scan::add_rows() {
    const std::int32_t bottom = std::ranges::max_element(edges_, {}, &edge::bottom)->bottom;
    top_ = std::ranges::min_element(edges_, {}, &edge::top)->top;
    sort_edges(bottom - top_);
    for (std::int32_t row = top_; row < bottom; ++row) {
        begin_row(row);
        if (!pieces_.empty())
            add_row(row);
    }
}

/// Cuts an edge at the sides of the box. What is outside moves to the side: so the windings inside
/// stay as they are, and outlines closed.
void path_scan::add_edge(l3d_point_2d from, l3d_point_2d to, std::uint8_t layer) {
    const bool down = from.y < to.y;
    const l3d_point_2d a = down ? from : to, b = down ? to : from;
    if (b.y < 0 || a.y > height_)
        return;
    const int direction = down ? -1 : 1;
    const double left = std::min(a.x, b.x), right = std::max(a.x, b.x), width = width_;
    if (left >= 0 && right <= width)
        return add_within(a.x, a.y, b.x, b.y, direction, layer);
    const auto y_at = [&](double x) {
        return std::clamp(a.y + (x - a.x) * ((b.y - a.y) / (b.x - a.x)), a.y, b.y);
    };
    l3d_point_2d before = a;
    const auto go = [&](l3d_point_2d next) {
        add_within(std::clamp(before.x, 0.0, width), before.y, std::clamp(next.x, 0.0, width),
                   next.y, direction, layer);
        before = next;
    };
    const std::array<double, 2> sides =
        a.x < b.x ? std::array<double, 2>{0, width} : std::array<double, 2>{width, 0};
    for (const double side : sides)
        if (left < side && side < right)
            go({side, y_at(side)});
    go(b);
}

void path_scan::add_within(double x0, double y0, double x1, double y1, int direction,
                           std::uint8_t layer) {
    // A level edge belongs to its row. Between two rows it ties nothing together.
    const auto row_of = [this](double y) {
        return static_cast<std::int32_t>(std::clamp<double>(y, 0, height_));
    };
    const std::int32_t top = row_of(y0), end = row_of(y1);
    const bool level = y0 == y1;
    if (level && y0 == top)
        return;
    const std::int32_t bottom = end < height_ && (level || end < y1) ? end + 1 : end;
    if (top < bottom)
        edges_.push_back({x0, y0, x1, y1, level ? 0 : (x1 - x0) / (y1 - y0), top, bottom,
                          static_cast<std::int8_t>(direction), layer});
}

row_piece path_scan::edge::piece_in(std::int32_t row, std::size_t index) const {
    row_piece p{x0, y0 - row, x1, y1 - row, 0, 0, direction, layer, index};
    if (p.y0 < 0 || p.y1 > 1) { // a part of it
        const double left = std::min(x0, x1), right = std::max(x0, x1);
        const auto x_at = [&](double y) { return std::clamp(x0 + (y - y0) * slope, left, right); };
        if (p.y0 < 0) {
            p.x0 = x_at(row);
            p.y0 = 0;
        }
        if (p.y1 > 1) {
            p.x1 = x_at(row + 1);
            p.y1 = 1;
        }
    }
    p.first = static_cast<std::int32_t>(std::min(p.x0, p.x1));
    p.last = static_cast<std::int32_t>(std::max(p.x0, p.x1));
    return p;
}

/// Counts the edges of each row, then puts them where their row begins.
void path_scan::sort_edges(std::int32_t rows) {
    begins_.assign(static_cast<std::size_t>(rows) + 2, 0);
    for (const edge& e : edges_)
        ++begins_[static_cast<std::size_t>(e.top - top_) + 2];
    for (std::size_t row = 2; row < begins_.size(); ++row)
        begins_[row] += begins_[row - 1];
    order_.resize(edges_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i)
        order_[begins_[static_cast<std::size_t>(edges_[i].top - top_) + 1]++] = i;
}

void path_scan::begin_row(std::int32_t row) {
    std::size_t kept = 0;
    for (const row_piece& p : pieces_)
        if (const edge& e = edges_[p.edge]; e.bottom > row)
            pieces_[kept++] = e.piece_in(row, p.edge);
    pieces_.resize(kept);
    const auto place = static_cast<std::size_t>(row - top_);
    const std::size_t begin = begins_[place], end = begins_[place + 1];
    for (std::size_t i = begin; i < end; ++i)
        pieces_.push_back(edges_[order_[i]].piece_in(row, order_[i]));
    sort_pieces(end - begin);
}

/// From one row to the next few pieces change places; new ones may be anywhere.
void path_scan::sort_pieces(std::size_t added) {
    if (std::ranges::is_sorted(pieces_, {}, &row_piece::first))
        return;
    keys_.clear();
    for (const row_piece& p : pieces_)
        keys_.push_back(std::uint64_t{static_cast<std::uint32_t>(p.first)} << 32 | keys_.size());
    constexpr std::size_t many = 24;
    if (added > many) {
        std::ranges::sort(keys_);
    } else {
        for (std::size_t i = 1; i < keys_.size(); ++i) {
            const std::uint64_t moving = keys_[i];
            std::size_t hole = i;
            for (; hole > 0 && keys_[hole - 1] > moving; --hole)
                keys_[hole] = keys_[hole - 1];
            keys_[hole] = moving;
        }
    }
    ordered_.clear();
    for (const std::uint64_t key : keys_)
        ordered_.push_back(pieces_[key & 0xffffffff]);
    pieces_.swap(ordered_);
}

void path_scan::add_row(std::int32_t row) {
    windings w;
    std::int32_t done = 0; // columns before it have their spans
    for (std::size_t i = 0; i < pieces_.size();) {
        const std::size_t begin = i;
        const std::int32_t first = pieces_[i].first;
        std::int32_t last = pieces_[i].last;
        for (++i; i < pieces_.size() && pieces_[i].first <= last; ++i)
            last = std::max(last, pieces_[i].last);
        if (rules_.inside(w))
            add_solid(row, done, first, full_value_);
        w = add_cluster(row, std::span(pieces_).subspan(begin, i - begin), last, w);
        done = last + 1;
    }
    if (rules_.inside(w))
        add_solid(row, done, width_, full_value_);
}

namespace {

/// The whole number that a sum is but for rounding.
int whole(double sum) {
    return static_cast<int>(sum < 0 ? sum - 0.5 : sum + 0.5);
}

} // namespace

/// Gives the windings right of it.
windings path_scan::add_cluster(std::int32_t row, std::span<const row_piece> pieces,
                                std::int32_t last, const windings& left) {
    std::array<double, 2> risen{};
    double height = 0;
    bool one_way = true;
    for (const row_piece& p : pieces) {
        const double h = p.y1 - p.y0;
        height += h;
        risen[p.layer] += p.direction * h;
        one_way &= h == 0 || (p.layer == pieces[0].layer && p.direction == pieces[0].direction);
    }
    windings right = left;
    for (std::size_t layer = 0; layer < 2; ++layer)
        right.turns[layer] += whole(risen[layer]);
    const bool was_inside = rules_.inside(left), is_inside = rules_.inside(right);
    const std::int32_t first = pieces[0].first, end = std::min(last + 1, width_);
    // All lead one way, and are a row high in sum, whole numbers apart from rounding: one chain.
    const bool one_chain = one_way && height > 0.5 && height < 1.5;
    if (one_chain && was_inside == is_inside) {
        if (is_inside)
            add_solid(row, first, end, full_value_);
        return right;
    }
    if (one_chain)
        for (const row_piece& p : pieces)
            areas_.add_border(p.x0, p.y0, p.x1, p.y1, is_inside ? 1 : -1);
    else
        areas_.add_cluster(pieces, left, rules_);
    add_values(row, {first, last}, was_inside ? 1 : 0);
    return right;
}

/// A span of values that are still to be found.
std::uint8_t* path_scan::add_values(std::int32_t row, const reached_columns& columns) {
    const std::int32_t end = std::min(columns.last + 1, width_);
    if (columns.first < end)
        spans_.push_back(
            {row + box_.top, columns.first + box_.left, end + box_.left, -1, values_.size()});
    const std::size_t before = values_.size();
    values_.resize(before + static_cast<std::size_t>(columns.last + 1 - columns.first));
    return &values_[before];
}

/// Runs up the sums from what is covered on their left, and takes them back to 0. Gives what is
/// covered on their right.
double path_scan::run_up(const reached_columns& columns, double covered, std::uint8_t* value) {
    double* sums = areas_.sums();
    for (std::int32_t column = columns.first; column <= columns.last; ++column) {
        covered += sums[column];
        *value++ = value_of(covered);
        sums[column] = 0;
    }
    covered += sums[columns.last + 1];
    sums[columns.last + 1] = 0;
    return covered;
}

double path_scan::add_values(std::int32_t row, const reached_columns& columns, double covered) {
    return run_up(columns, covered, add_values(row, columns));
}

void path_scan::add_solid(std::int32_t row, std::int32_t first, std::int32_t end, int value) {
    if (first >= end || value == 0)
        return;
    const std::int32_t y = row + box_.top, left = first + box_.left, right = end + box_.left;
    if (!spans_.empty() && spans_.back().value == value && spans_.back().row == y &&
        spans_.back().last == left)
        spans_.back().last = right;
    else
        spans_.push_back({y, left, right, value, 0});
}

} // namespace l3d_detail
