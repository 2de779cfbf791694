// SPDX-License-Identifier: MIT
// pixel_area: finds an area by visits, by fields that are surely inside, by borders, or by slabs.
#include "raster/paths/pixel_area_p.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace l3d_detail {

namespace {

constexpr auto is_higher = [](const winding_change& a, const winding_change& b) {
    return a.y < b.y;
};

} // namespace

void pixel_area::add(const edge_record* all, std::uint32_t last, std::size_t layer) {
    std::size_t lane = edges_.count % edge_block::size;
    edge_block* b = lane > 0 ? &blocks_.back() : nullptr;
    for (std::uint32_t i = last; i != 0; i = all[i].before) {
        if (lane == 0) {
            b = blocks_.room(1);
            blocks_.use(1);
        }
        const edge_record& r = all[i];
        b->x0[lane] = r.from.x;
        b->y0[lane] = r.from.y;
        b->x1[lane] = r.to.x;
        b->y1[lane] = r.to.y;
        b->edge[lane] = r.edge;
        lane = (lane + 1) % edge_block::size;
        ++edges_.count;
    }
    edges_.blocks = {blocks_.begin(), blocks_.size()};
    if (layer == 0)
        edges_.first_clip = edges_.count;
}

/// Finds bounds of the winding number, relative to the number at the pixel's corner, from the
/// visits of outlines.
///
/// A visit is an outline's passage through the pixel, from side to side. The winding number on a
/// visit's higher side is larger by 1 than on its lower side. If a visit adds less than 0, the
/// pixel's top left corner is on its higher side. Two successive edges whose corner lies outside
/// the pixel do not cross inside. If the two edges turn to the right, each place is on the higher
/// side of at least one edge. If they turn to the left, each place is on the lower side of at least
/// one edge.
pixel_area::windings_range pixel_area::find_range() const {
    constexpr double unclear = 1e-9, surely = 1e-10; // far above rounding
    windings_range range;
    int turns_right = 0, turns_left = 0; // pairs of visits, by the turn between them
    bool are_shares_clear = true;        // whether each visit has places on both sides
    double adds = 0;
    int edges_of_visit = 0;
    const edge_block* alone = nullptr; // the edge before, if it is a visit by itself and in no pair
    std::size_t lane_of_alone = 0;
    edges_.visit([&](const edge_block& b, std::size_t lane, std::size_t) {
        adds += b.adds[lane];
        ++edges_of_visit;
        if (b.begins(lane) == cell_begin::continues)
            return;
        const int on_higher = adds < unclear ? 1 : 0;
        const double share = adds + on_higher;
        are_shares_clear &= share > unclear && share < 1 - unclear;
        range.least -= on_higher;
        range.most += 1 - on_higher;
        const bool is_alone = edges_of_visit == 1;
        adds = 0;
        edges_of_visit = 0;
        if (is_alone && alone != nullptr && alone->index(lane_of_alone) == b.index(lane) + 1) {
            const l3d_point_2d way = b.way(lane), next = alone->way(lane_of_alone);
            const double turn = way.x * next.y - way.y * next.x;
            turns_right += turn > surely ? 1 : 0;
            turns_left += turn < -surely ? 1 : 0;
            alone = nullptr;
        } else {
            alone = is_alone ? &b : nullptr;
            lane_of_alone = lane;
        }
    });
    if (are_shares_clear) {
        range.least += turns_right;
        range.most -= turns_left;
    }
    return range;
}

double pixel_area::inside(const l3d_point_2d& corner, const std::array<double, 2>& sums,
                          std::uint32_t visits, const fill_rules& rules) {
    const auto [own, before] = place_edges(edges_, corner);
    std::array<double, 2> left{own, 0};
    windings beside{{static_cast<int>(before), 0}};
    if (rules.clips)
        edges_.visit([&](const edge_block& b, std::size_t lane, std::size_t i) {
            if (edges_.layer(i) == 0)
                return;
            left[0] -= b.adds[lane];
            left[1] += b.adds[lane];
            beside.turns[0] += static_cast<int>(b.up_left[lane]);
            beside.turns[1] -= static_cast<int>(b.up_left[lane]);
        });
    // Without the parts of the pixel's edges, the sum is the winding number at the pixel's corner.
    const windings at_corner{{static_cast<int>(std::lrint(sums[0] - left[0])),
                              static_cast<int>(std::lrint(sums[1] - left[1]))}};
    for (std::size_t layer = 0; layer < 2; ++layer)
        beside.turns[layer] += at_corner.turns[layer];
    const auto is_same = [&] {
        const windings_range range = find_range();
        return rules.same_between({{at_corner.turns[0] + range.least}},
                                  {{at_corner.turns[0] + range.most}});
    };
    // The sum is the least winding number plus each visit's share, half on average.
    const bool is_clear = !rules.clips && visits < unclear_visits;
    const bool is_likely = is_clear && visits <= 2 * std::abs(sums[0]);
    if (is_likely && is_same())
        return rules.inside(at_corner) ? 1 : 0;
    // Fields take some 60 instructions for each of n edges, borders 70 for each of n^2 pairs. But
    // the fields of few edges seldom decide.
    constexpr std::uint32_t many = 6;
    if (!rules.clips && rules.rule[0] == l3d_winding::nonzero && visits >= many) {
        const std::uint64_t open =
            find_open(edges_, beside.turns[0], at_corner.turns[0] < 0 ? -1 : 1);
        if (open == 0)
            return 1;
        if (open != all_fields)
            set_heights(edges_, open);
    }
    if (is_clear && !is_likely && is_same())
        return rules.inside(at_corner) ? 1 : 0;
    find_changes();
    const std::optional<double> area = between_borders(at_corner, beside, rules);
    return area ? *area : slabs(at_corner, rules);
}

/// Converts an edge of the pixel to a border between inside and outside.
row_edge pixel_area::border(const edge_block& b, std::size_t lane, std::size_t i) const {
    return {b.x0[lane],
            b.y0[lane],
            b.x1[lane],
            b.y1[lane],
            static_cast<std::int8_t>(b.turns[lane]),
            static_cast<std::uint8_t>(edges_.layer(i))};
}

/// The covered area, from the parts of edges that have the inside on only one side. `beside` are
/// the winding numbers left of all edges. Returns nothing if two edges are so close that rounding
/// may confuse which of them is on the left.
std::optional<double> pixel_area::between_borders(const windings& corner, const windings& beside,
                                                  const fill_rules& rules) {
    constexpr double same = 1e-12, close = 1e-7;
    double area = on_left(corner, rules);
    bool is_close = false;
    edges_.visit([&](const edge_block& e, std::size_t at, std::size_t i) {
        const double top = e.top[at], bottom = e.bottom[at];
        if (top >= bottom)
            return;
        windings left = beside;
        passed_.clear();
        const auto change = [&](double y, int by, std::size_t layer) {
            if (y <= top)
                left.turns[layer] += by;
            else if (y < bottom)
                passed_.push({y, static_cast<std::int8_t>(by), static_cast<std::uint8_t>(layer)});
        };
        edges_.visit([&](const edge_block& other, std::size_t lane, std::size_t k) {
            const std::size_t layer = edges_.layer(k);
            const double upper = other.y0[lane], lower = other.y1[lane];
            if (lower <= top || upper >= bottom) {
                left.turns[layer] +=
                    static_cast<int>(lower <= top ? other.down_left[lane] : other.up_left[lane]);
                return;
            }
            if (k == i)
                return;
            const double begin = std::max(top, upper), end = std::min(bottom, lower);
            const double above = other.x_at(lane, begin) - e.x_at(at, begin);
            const double below = other.x_at(lane, end) - e.x_at(at, end);
            const double apart = std::max(std::abs(above), std::abs(below));
            bool begins_left = above < 0, ends_left = below < 0;
            if (apart < close) {
                is_close |= apart > same;
                begins_left = ends_left = k < i;
            }
            // `is_left` may change at four heights: at the top, at `begin`, at the crossing, and at
            // `end`.
            const int direction = static_cast<int>(other.turns[lane]);
            bool is_left = false;
            const auto set = [&](bool to, double y) {
                if (to != is_left)
                    change(y, to ? direction : -direction, layer);
                is_left = to;
            };
            set(other.up_left[lane] != 0, top);
            set(begins_left, begin);
            if (begins_left != ends_left)
                set(ends_left, begin + (end - begin) * (above / (above - below)));
            set(other.down_left[lane] != 0, end);
        });
        if (passed_.size() > 1)
            sort_few(passed_, is_higher);
        const row_edge own = border(e, at, i);
        double from = top;
        const auto pass = [&](double to) {
            windings right = left;
            right.cross(own);
            const int sign = rules.inside(right) - rules.inside(left);
            if (sign != 0)
                area += sign * (to - from) * (1 - (e.x_at(at, from) + e.x_at(at, to)) / 2);
            from = to;
        };
        for (const winding_change& c : passed_.all()) {
            pass(c.y);
            left.cross(c);
        }
        pass(bottom);
    });
    return is_close ? std::nullopt : std::optional(area);
}

/// Finds the changes of the winding numbers down the pixel's left side. The numbers change at ends
/// of edges that lie on this side.
void pixel_area::find_changes() {
    changes_.clear();
    edges_.visit([&](const edge_block& b, std::size_t lane, std::size_t i) {
        const bool up = b.up_left[lane] != 0;
        if (up || b.down_left[lane] != 0)
            changes_.push({up ? b.y0[lane] : b.y1[lane],
                           static_cast<std::int8_t>(up ? -b.turns[lane] : b.turns[lane]),
                           static_cast<std::uint8_t>(edges_.layer(i))});
    });
    sort_few(changes_, is_higher);
}

/// The covered area that the winding numbers at the pixel's left side would give without any edges.
double pixel_area::on_left(windings beside, const fill_rules& rules) const {
    double area = 0, top = 0;
    for (const winding_change& c : changes_.all()) {
        area += rules.inside(beside) ? c.y - top : 0;
        beside.cross(c);
        top = c.y;
    }
    return area + (rules.inside(beside) ? 1 - top : 0);
}

/// Computes the covered area by cutting the pixel into horizontal slabs.
double pixel_area::slabs(const windings& corner, const fill_rules& rules) {
    slabs_.set_width(1);
    slab_edges_.clear();
    edges_.visit([&](const edge_block& b, std::size_t lane, std::size_t i) {
        slab_edges_.push_back(border(b, lane, i));
    });
    slabs_.add_cluster(slab_edges_, corner, rules, changes_.all());
    double* const borders = slabs_.sums();
    const double area = on_left(corner, rules) + borders[0];
    borders[0] = borders[1] = borders[2] = 0;
    return area;
}

} // namespace l3d_detail
