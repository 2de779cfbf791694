// SPDX-License-Identifier: MIT
// path_scan: fills outlines of two chains one by one, and all others in bands.
#include "raster/paths/path_scan_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace l3d_detail {

namespace {

/// Whether `left` certainly has no point right of the point of `right` at the same height. Both
/// pieces span the same heights. With horizontal edges, the answer is always false.
bool is_left_of(const row_piece& left, const row_piece& right) {
    // Both are straight between their corners, so comparing corners is enough.
    const auto is_before = [](const row_piece& corners, const row_piece& edges, double way) {
        bool before = true;
        std::size_t i = 0;
        edges.visit([&](const l3d_point_2d& from, const l3d_point_2d& to) {
            before &= from.y < to.y || from.x == to.x;
            for (; i < corners.corners.count && corners.corners[i].y <= to.y; ++i) {
                const l3d_point_2d& corner = corners.corners[i];
                const double x = from.y < to.y ? straight_edge(from, to).x_at(corner.y) : to.x;
                before &= (x - corner.x) * way >= 0;
            }
        });
        return before;
    };
    return left.enters.x <= right.enters.x && left.leaves.x <= right.leaves.x &&
           is_before(left, right, 1) && is_before(right, left, -1);
}

/// Whether an outline is filled by add_pairs.
bool is_pair_apart(const path_chains::outline& o) {
    return o.apart && o.is_pair();
}

} // namespace

std::span<const covered_span> path_scan::convert(const order& wanted) {
    box_ = wanted.box;
    writer_.begin(box_, wanted.full);
    rules_ = {{wanted.inside, wanted.clip_inside}, wanted.clip != nullptr};
    if (box_.empty() || writer_.value_of(1) == 0 || !wanted.path.is_number() ||
        (wanted.clip != nullptr && !wanted.clip->is_number()))
        return {};
    // The sides of an empty box may be farther apart than an int can hold.
    width_ = box_.right - box_.left;
    height_ = box_.bottom - box_.top;
    areas_.set_width(width_);
    chains_.clear(width_, height_, {0.5 - box_.left, 0.5 - box_.top});
    take_outlines(wanted.path, 0);
    if (wanted.clip != nullptr)
        take_outlines(*wanted.clip, 1);
    chains_.sort();
    if (wanted.clip == nullptr)
        add_pairs();
    add_bands();
    writer_.values().room(most_lanes);
    return writer_.spans().all();
}

/// Takes a path's outlines. In the scan's coordinates, pixel 0 is [0, 1), and is sampled in its
/// middle.
void path_scan::take_outlines(const l3d_path& path, std::uint8_t layer) {
    const seen_box seen{box_.left - 0.5, box_.top - 0.5, box_.right - 0.5, box_.bottom - 0.5};
    visit_flat(
        path, l3d_flat_enough, seen, flat_room_, [&](l3d_point_2d to) { chains_.begin(to); },
        [&](std::span<const l3d_point_2d> to) { chains_.lines(to); },
        [&](bool) { chains_.end(layer); });
}

/// Adds the outlines of two chains that no other outline comes near.
void path_scan::add_pairs() {
    chains_.find_apart();
    for (const path_chains::outline& o : chains_.outlines())
        if (is_pair_apart(o))
            add_pair(chains_.chains()[o.chains], chains_.chains()[o.chains + 1]);
}

/// Adds an outline that only turns at its top and its bottom, as all convex outlines do.
void path_scan::add_pair(const chain& a, const chain& b) {
    kept_list<covered_span>& spans = writer_.spans();
    kept_list<std::uint8_t>& values = writer_.values();
    std::array<side_walk, 2> walks{side_walk(a, chains_.corners()),
                                   side_walk(b, chains_.corners())};
    for (std::int32_t row = a.top(); row < a.bottom();) {
        const auto left_over = static_cast<std::size_t>(a.bottom() - row);
        const std::size_t straight =
            std::min(walks[0].straight_rows(row), walks[1].straight_rows(row));
        const std::size_t count = std::min(std::max(straight, side_block::rows), left_over);
        std::array<double, 2> places{walks[0].x(), walks[1].x()};
        for (std::size_t i = 0; i < 2; ++i) {
            walks[i].lay_out(row, count, blocks_[i]);
            places[i] += walks[i].x();
        }
        const std::size_t left = places[0] <= places[1] ? 0 : 1;
        const side_pair pair{{&blocks_[left], &blocks_[1 - left]},
                             walks[0].begin(),
                             walks[0].end(),
                             row,
                             count,
                             width_,
                             box_.left,
                             box_.top,
                             writer_.full()};
        pair_spans result{spans.room(count), values.room(pair_spans::most_values * count),
                          values.size()};
        // A single row is found sooner without lanes.
        std::uint32_t others = count > 1 ? cover_rows(pair, result) : 1;
        spans.use(result.span_count);
        values.use(result.value_count);
        for (; others != 0; others &= others - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(others));
            const std::int32_t other = row + static_cast<std::int32_t>(lane);
            add_pair_row(other, walks[0].piece_of(blocks_[0], other, lane),
                         walks[1].piece_of(blocks_[1], other, lane));
        }
        row += static_cast<std::int32_t>(count);
    }
}

void path_scan::add_pair_row(std::int32_t row, const row_piece& one, const row_piece& other) {
    if (one.right <= other.left || is_left_of(one, other))
        add_borders(row, one, other);
    else if (other.right <= one.left || is_left_of(other, one))
        add_borders(row, other, one);
    else
        add_crossing(row, one, other);
}

void path_scan::add_borders(std::int32_t row, const row_piece& left, const row_piece& right) {
    const auto column = [](double x) { return static_cast<std::int32_t>(x); };
    add_border(left, 1);
    add_border(right, -1);
    if (column(right.left) <= column(left.right) + 1) {
        add_values(row, left.left, std::max(left.right, right.right), 0);
    } else {
        const double covered = add_values(row, left.left, left.right, 0);
        writer_.add_solid(row, column(left.right) + 1, column(right.left),
                          writer_.value_of(covered));
        add_values(row, right.left, right.right, covered);
    }
}

void path_scan::add_crossing(std::int32_t row, const row_piece& one, const row_piece& other) {
    edges_.clear();
    for (const row_piece* const piece : {&one, &other})
        piece->visit([&](const l3d_point_2d& from, const l3d_point_2d& to) {
            if (from.y < to.y)
                edges_.push_back({from.x, from.y - row, to.x, to.y - row, piece->direction, 0});
        });
    areas_.add_cluster(edges_, {}, rules_);
    add_values(row, std::min(one.left, other.left), std::max(one.right, other.right), 0);
}

void path_scan::add_border(const row_piece& piece, int sign) {
    if (piece.corners.empty())
        return areas_.add_border(piece.enters.x, piece.leaves.x,
                                 sign * (piece.leaves.y - piece.enters.y));
    pixel_sum sum(areas_, piece.enters.x);
    piece.visit([&](const l3d_point_2d& from, const l3d_point_2d& to) {
        sum.add_border(from.x, to.x, sign * (to.y - from.y));
    });
}

/// Adds up the sums from left to right, stores the values of the coverage, and sets the sums back
/// to 0. `covered` is the coverage left of the columns; returns the coverage right of the columns.
double path_scan::add_values(std::int32_t row, double left, double right, double covered) {
    const auto first = static_cast<std::int32_t>(left), last = static_cast<std::int32_t>(right);
    std::uint8_t* value = writer_.add_values(row, first, last + 1);
    double* const sums = areas_.sums();
    for (std::int32_t column = first; column <= last; ++column) {
        covered += sums[column];
        *value++ = writer_.value_of(covered);
        sums[column] = 0;
    }
    covered += sums[last + 1];
    sums[last + 1] = 0;
    return covered;
}

/// Adds the outlines that add_pairs has left, band by band. An outline is active in the bands into
/// which it reaches.
void path_scan::add_bands() {
    l3d_pixel_box reached{};
    for (const path_chains::outline& o : chains_.outlines())
        if (!is_pair_apart(o))
            reached = reached.empty() ? o.box
                                      : l3d_pixel_box{std::min(reached.left, o.box.left),
                                                      std::min(reached.top, o.box.top),
                                                      std::max(reached.right, o.box.right),
                                                      std::max(reached.bottom, o.box.bottom)};
    if (reached.empty())
        return;
    cells_.begin(reached, rules_);
    active_.clear();
    auto next = chains_.outlines().begin();
    for (std::int32_t top = reached.top; top < reached.bottom; top += cells_.rows()) {
        const std::int32_t bottom = std::min(top + cells_.rows(), reached.bottom);
        std::erase_if(active_, [&](const auto* o) { return o->box.bottom <= top; });
        for (; next != chains_.outlines().end() && next->box.top < bottom; ++next)
            if (!is_pair_apart(*next))
                active_.push_back(&*next);
        cells_.begin_band(top, bottom);
        for (const path_chains::outline* const o : active_)
            cells_.add(*o, chains_.corners(), chains_.blocks().data());
        cells_.write(writer_);
    }
}

} // namespace l3d_detail
