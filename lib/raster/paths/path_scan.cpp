// SPDX-License-Identifier: MIT
// path_scan: chains come and go with the rows; clusters of their pieces become spans.
#include "raster/paths/path_scan_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>

namespace l3d_detail {

namespace {

/// Whether it is certain that no point of `left` lies right of the point of `right` at the same
/// height. Both lie between the same heights. With level edges it is never certain.
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

} // namespace

std::span<const covered_span> path_scan::convert(const order& wanted) {
    spans_.clear();
    values_.clear();
    box_ = wanted.box;
    full_ = wanted.full;
    full_value_ = static_cast<int>(full_ + 0.5);
    rules_ = {{wanted.inside, wanted.clip_inside}, wanted.clip != nullptr};
    if (box_.empty() || full_value_ == 0 || !wanted.path.is_number() ||
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
    if (wanted.clip == nullptr)
        add_pairs();
    add_all();
    values_.room(most_lanes);
    return spans_.all();
}

/// Cuts a path's outlines into chains. In the scan's coordinates, pixel 0 is [0, 1), and its sample
/// is its middle.
void path_scan::take_outlines(const l3d_path& path, std::uint8_t layer) {
    const seen_box seen{box_.left - 0.5, box_.top - 0.5, box_.right - 0.5, box_.bottom - 0.5};
    visit_flat(
        path, l3d_flat_enough, seen, flat_room_, [&](l3d_point_2d to) { chains_.begin(to); },
        [&](std::span<const l3d_point_2d> to) { chains_.lines(to); },
        [&](bool) { chains_.end(layer); });
}

void path_scan::add_all() {
    const std::int32_t bottom = chains_.sort();
    places_.clear();
    for (std::int32_t row = chains_.top(); row < bottom; ++row) {
        begin_row(row);
        add_row(row);
    }
}

/// Adds those outlines of two chains that no other outline comes near.
void path_scan::add_pairs() {
    chains_.find_apart();
    for (const path_chains::outline& o : chains_.outlines())
        if (o.apart && o.chains == 2)
            add_pair(chains_.chains()[o.first], chains_.chains()[o.first + 1]);
}

/// Adds an outline that only turns at its top and its bottom, as all convex ones do.
void path_scan::add_pair(chain& a, chain& b) {
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
                             full_};
        pair_spans result{spans_.room(count), values_.room(pair_spans::most_values * count),
                          values_.size()};
        // A single row is found sooner without lanes.
        std::uint32_t others = count > 1 ? cover_rows(pair, result) : 1;
        spans_.use(result.span_count);
        values_.use(result.value_count);
        for (; others != 0; others &= others - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(others));
            const std::int32_t other = row + static_cast<std::int32_t>(lane);
            a.take_piece(walks[0].piece_of(blocks_[0], other, lane));
            b.take_piece(walks[1].piece_of(blocks_[1], other, lane));
            add_pair_row(other, a, b);
        }
        row += static_cast<std::int32_t>(count);
    }
    a.leave_out();
    b.leave_out();
}

void path_scan::add_pair_row(std::int32_t row, const chain& a, const chain& b) {
    const row_piece &one = a.piece(), &other = b.piece();
    if (one.right <= other.left || is_left_of(one, other)) {
        add_borders(row, one, other);
    } else if (other.right <= one.left || is_left_of(other, one)) {
        add_borders(row, other, one);
    } else {
        places_ = {place_of(a), place_of(b)};
        std::ranges::sort(places_, std::less<>());
        add_row(row);
    }
}

void path_scan::add_borders(std::int32_t row, const row_piece& left_piece,
                            const row_piece& right_piece) {
    const auto reached = [](const row_piece& p) {
        return reached_columns{static_cast<std::int32_t>(p.left),
                               static_cast<std::int32_t>(p.right)};
    };
    const reached_columns left = reached(left_piece), right = reached(right_piece);
    add_border(left_piece, 1);
    add_border(right_piece, -1);
    if (right.first <= left.last + 1) {
        add_values(row, {left.first, std::max(left.last, right.last)}, 0);
    } else {
        const double covered = add_values(row, left, 0);
        add_solid(row, left.last + 1, right.first, value_of(covered));
        add_values(row, right, covered);
    }
}

/// Lists the pieces of a row from left to right. Those that go on from the row above hardly change
/// their order, so insertion sorts them. Those that begin here may be anywhere.
void path_scan::begin_row(std::int32_t row) {
    const auto enter = [&](std::uint32_t index) {
        chain& entering = chains_.chains()[index];
        entering.enter(row, chains_.corners());
        return place_of(entering);
    };
    std::size_t kept = 0;
    for (const place& p : places_) {
        if (chains_.chains()[p.chain].bottom() <= row)
            continue;
        const place moving = enter(p.chain);
        std::size_t hole = kept++;
        for (; hole > 0 && moving < places_[hole - 1]; --hole)
            places_[hole] = places_[hole - 1];
        places_[hole] = moving;
    }
    places_.resize(kept);
    begun_.clear();
    for (const std::uint32_t index : chains_.begun_in(row))
        begun_.push_back(enter(index));
    if (begun_.empty())
        return;
    std::ranges::sort(begun_, std::less<>());
    merged_.clear();
    std::ranges::merge(places_, begun_, std::back_inserter(merged_), std::less<>());
    places_.swap(merged_);
}

void path_scan::add_row(std::int32_t row) {
    const auto column = [](double x) { return static_cast<std::int32_t>(x); };
    windings w;
    std::int32_t done = 0; // the column before which all have their spans
    for (std::size_t i = 0; i < places_.size();) {
        const std::size_t begin = i;
        const std::int32_t first = column(places_[i].left);
        std::int32_t last = column(places_[i].right);
        for (++i; i < places_.size() && column(places_[i].left) <= last; ++i)
            last = std::max(last, column(places_[i].right));
        const bool was_inside = rules_.inside(w);
        bordered_ = false;
        if (i - begin == 1)
            add_through(piece_of(places_[begin]), w);
        else
            add_cluster(row, std::span(places_).subspan(begin, i - begin), w);
        if (!bordered_)
            continue; // nothing changes: the solid span goes on through the cluster
        if (was_inside)
            add_solid(row, done, first, full_value_);
        add_values(row, {first, last}, was_inside ? 1 : 0);
        done = last + 1;
    }
    if (rules_.inside(w))
        add_solid(row, done, width_, full_value_);
}

/// Adds the borders in a cluster. On return `w` holds the windings right of it.
void path_scan::add_cluster(std::int32_t row, std::span<const place> places, windings& w) {
    for (std::size_t i = 0; i < places.size();) {
        const std::size_t begin = i;
        double right = places[i].right;
        bool overlap = false;
        for (++i; i < places.size() && places[i].left <= right; ++i) {
            overlap |= places[i].left < right;
            right = std::max(right, places[i].right);
        }
        if (i - begin == 1)
            add_through(piece_of(places[begin]), w);
        else
            add_run(row, places.subspan(begin, i - begin), overlap, w);
    }
}

/// Adds a piece that leads through the whole row.
void path_scan::add_through(const row_piece& piece, windings& w) {
    const bool was_inside = rules_.inside(w);
    w.cross(piece);
    if (const int sign = rules_.inside(w) - was_inside; sign != 0)
        add_border(piece, sign);
}

void path_scan::add_border(const row_piece& piece, int sign) {
    bordered_ = true;
    if (piece.corners.empty())
        return areas_.add_border(piece.enters.x, piece.leaves.x,
                                 sign * (piece.leaves.y - piece.enters.y));
    pixel_sum sum(areas_, piece.enters.x);
    piece.visit([&](const l3d_point_2d& from, const l3d_point_2d& to) {
        sum.add_border(from.x, to.x, sign * (to.y - from.y));
    });
}

/// Adds the borders in a run of pieces without a gap. On return `w` holds the windings right of it.
void path_scan::add_run(std::int32_t row, std::span<const place> places, bool overlap,
                        windings& w) {
    const windings left = w;
    std::array<double, 2> risen{};
    windings low = left, high = left; // least and most anywhere in the run
    for (const place& p : places) {
        const row_piece& piece = piece_of(p);
        risen[piece.layer] += piece.direction * piece.height();
        (piece.direction < 0 ? low : high).cross(piece);
    }
    for (std::size_t layer = 0; layer < (rules_.clips ? 2U : 1U); ++layer)
        w.turns[layer] += static_cast<int>(std::lrint(risen[layer])); // whole but for rounding
    if (rules_.same_between(low, high) || (!overlap && add_meeting(places, left)))
        return;
    bordered_ = true;
    // Slabs of few pieces cost less than pixels one by one.
    constexpr std::size_t many = 16;
    if (places.size() > many)
        return add_crowd(row, places, left);
    edges_.clear();
    for (const place& p : places) {
        const row_piece& piece = piece_of(p);
        piece.visit([&](const l3d_point_2d& from, const l3d_point_2d& to) {
            if (from.y < to.y)
                edges_.push_back(
                    {from.x, from.y - row, to.x, to.y - row, piece.direction, piece.layer});
        });
    }
    areas_.add_cluster(edges_, left, rules_);
}

/// Adds a run of many pieces, in the order of their outlines.
void path_scan::add_crowd(std::int32_t row, std::span<const place> places, const windings& left) {
    crowd_.assign(places.begin(), places.end());
    std::ranges::sort(crowd_, {}, &place::chain);
    cells_.begin(width_);
    std::uint32_t next_chain = 0;
    l3d_point_2d last{};
    for (const place& p : crowd_) {
        const row_piece& piece = piece_of(p);
        way_.clear();
        way_.push_back({piece.enters.x, piece.enters.y - row});
        piece.visit([&](const l3d_point_2d&, const l3d_point_2d& to) {
            way_.push_back({to.x, to.y - row});
        });
        const bool is_up = piece.direction > 0;
        if (is_up)
            std::ranges::reverse(way_);
        // Chains of an outline follow each other, and meet where it turns.
        const bool follows = p.chain == next_chain && way_[0].x == last.x && way_[0].y == last.y;
        cell_begin begin = way_[0].y == (is_up ? 1 : 0) ? cell_begin::enters
                           : follows                    ? cell_begin::continues
                                                        : cell_begin::unclear;
        for (std::size_t i = 1; i < way_.size(); ++i) {
            cells_.add(way_[i - 1], way_[i], piece.layer, begin);
            begin = cell_begin::continues;
        }
        next_chain = p.chain + 1;
        last = way_.back();
    }
    cells_.add_to(areas_.sums(), left, rules_);
}

/// Adds pieces that lie side by side and only meet. Does nothing and returns false if they are
/// many, or if one of them has an edge of the inside in only a part of its height.
bool path_scan::add_meeting(std::span<const place> places, const windings& left) {
    constexpr std::size_t most = 6;
    if (places.size() > most)
        return false;
    std::array<double, 2 * most> cuts;
    std::size_t count = 0;
    for (const place& p : places) {
        cuts[count++] = piece_of(p).enters.y;
        cuts[count++] = piece_of(p).leaves.y;
    }
    std::sort(cuts.begin(), cuts.begin() + count);
    std::array<windings, 2 * most> between; // between two cuts, left of the next piece
    between.fill(left);
    std::array<int, most> signs{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const row_piece& piece = piece_of(places[i]);
        bool known = false;
        for (std::size_t k = 0; k + 1 < count; ++k) {
            if (cuts[k] == cuts[k + 1] || cuts[k] < piece.enters.y || cuts[k] >= piece.leaves.y)
                continue;
            const bool was_inside = rules_.inside(between[k]);
            between[k].cross(piece);
            const int sign = rules_.inside(between[k]) - was_inside;
            if (known && sign != signs[i])
                return false;
            known = true;
            signs[i] = sign;
        }
    }
    for (std::size_t i = 0; i < places.size(); ++i)
        if (signs[i] != 0)
            add_border(piece_of(places[i]), signs[i]);
    return true;
}

/// Makes room for a value in each of some columns: in the last span if it ends where they begin,
/// else in a new span.
void path_scan::add_span(std::int32_t row, std::int32_t first, std::int32_t end) {
    if (ends_at(row, first))
        spans_.back().between = spans_.back().beyond = spans_.back().last = end;
    else
        spans_.push({row, first, end, end, end, 0, values_.size()});
}

/// Whether the last span ends at a place with columns that have a value each, and these values are
/// the last of all. Such a span can grow.
bool path_scan::ends_at(std::int32_t row, std::int32_t column) {
    if (spans_.size() == 0)
        return false;
    const covered_span& s = spans_.back();
    return s.row == row && s.last == column && s.between == s.last &&
           s.values + s.values_before() == values_.size();
}

/// Adds a span and returns the place of its values, which are still to be found.
std::uint8_t* path_scan::add_values(std::int32_t row, const reached_columns& columns) {
    const std::int32_t end = std::min(columns.last + 1, width_) + box_.left;
    const std::int32_t first = columns.first + box_.left;
    if (first < end)
        add_span(row + box_.top, first, end);
    const auto count = static_cast<std::size_t>(columns.last + 1 - columns.first);
    std::uint8_t* const values = values_.room(count);
    values_.use(count);
    return values;
}

/// Adds up the sums from left to right, stores the values of the coverage, and sets the sums back
/// to 0. Takes the coverage on the columns' left, and returns that on their right.
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

/// Adds columns of one value. If they are few and follow columns with a value each, they get a
/// value each, too: a span of their own would cost as much.
void path_scan::add_solid(std::int32_t row, std::int32_t first, std::int32_t end, int value) {
    constexpr std::int32_t few = 32;
    if (first >= end || value == 0)
        return;
    const std::int32_t y = row + box_.top, left = first + box_.left, right = end + box_.left;
    if (right - left < few && ends_at(y, left)) {
        const auto count = static_cast<std::size_t>(right - left);
        add_span(y, left, right);
        std::fill_n(values_.room(count), count, static_cast<std::uint8_t>(value));
        values_.use(count);
    } else if (spans_.size() > 0 && spans_.back().value == value && spans_.back().row == y &&
               spans_.back().beyond == left && spans_.back().last == left) {
        spans_.back().beyond = spans_.back().last = right;
    } else {
        spans_.push({y, left, left, right, right, value, 0});
    }
}

} // namespace l3d_detail
