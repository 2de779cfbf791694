// SPDX-License-Identifier: MIT
// pixel_area: what visits of outlines tell of a pixel; slabs where they do not.
#include "raster/paths/pixel_area_p.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace l3d_detail {

namespace {

/// The lower bounds of windings in a row of eight fields: 16 bits for each.
using row_bounds = std::array<std::uint64_t, 2>;
constexpr std::uint64_t in_all = 0x0001000100010001;

/// For each field, 1 there and in all fields behind; for the place behind the last field, nothing.
constexpr std::array<row_bounds, 9> behind{{{in_all, in_all},
                                            {in_all << 16, in_all},
                                            {in_all << 32, in_all},
                                            {in_all << 48, in_all},
                                            {0, in_all},
                                            {0, in_all << 16},
                                            {0, in_all << 32},
                                            {0, in_all << 48},
                                            {0, 0}}};

/// Adds 1 to the bounds of the fields from the first one on, or subtracts it.
void count_from(row_bounds& to, std::size_t first, bool subtracts) {
    const row_bounds& by = behind[first];
    for (std::size_t i = 0; i < by.size(); ++i)
        to[i] += subtracts ? -by[i] : by[i];
}

/// The height of the end that lies on the pixel's left side.
double height_on_left(const edge_cell& e) {
    return e.from.x <= e.to.x ? e.from.y : e.to.y;
}

} // namespace

void pixel_area::begin() {
    edges_.clear();
    visits_.clear();
    open_ = is_unclear_ = false;
    own_ = {};
}

void pixel_area::add(const edge_cell& cell) {
    if (!open_)
        visits_.push_back({edges_.size(), edges_.size()});
    // An edge that leads upwards adds 1 on its right.
    double adds = (cell.from.y - cell.to.y) * (1 - (cell.from.x + cell.to.x) / 2);
    if (cell.below_left != 0)
        adds += cell.below_left * (1 - height_on_left(cell));
    edges_.push_back(cell);
    own_[cell.layer] += adds;
    visit& v = visits_.back();
    ++v.end;
    v.adds += adds;
    is_unclear_ |= cell.begin == cell_begin::unclear;
    open_ = cell.begin == cell_begin::continues;
}

/// On which side of a visit another one lies. If that is known, neither crosses the other.
///
/// A visit's higher side is to the right of its edges. Where these all turn to the right, a place
/// to the right of all of their lines is on that side. One to the left of any line is on the other.
/// Where they all turn to the left, left and right change places. Edges that go back tell neither.
pixel_area::side pixel_area::side_of(const visit& of, const visit& other) const {
    constexpr double surely = 1e-10; // far above rounding
    const auto to_right = [](const edge_cell& e, const l3d_point_2d& p) {
        return (e.to.x - e.from.x) * (p.y - e.from.y) - (e.to.y - e.from.y) * (p.x - e.from.x);
    };
    bool turns_right = true, turns_left = true;
    for (std::size_t i = of.first + 1; i < of.end; ++i) {
        const edge_cell &before = edges_[i], &after = edges_[i - 1];
        const double turn = to_right(before, after.to);
        const bool goes_on = (before.to.x - before.from.x) * (after.to.x - after.from.x) +
                                 (before.to.y - before.from.y) * (after.to.y - after.from.y) >
                             0;
        turns_right &= turn > 0 || (turn == 0 && goes_on);
        turns_left &= turn < 0 || (turn == 0 && goes_on);
    }
    bool all_right = true, all_left = true, some_right = true, some_left = true;
    for (std::size_t k = other.first; k < other.end; ++k) {
        bool one_right = false, one_left = false;
        for (std::size_t i = of.first; i < of.end; ++i) {
            const double from = to_right(edges_[i], edges_[k].from);
            const double to = to_right(edges_[i], edges_[k].to);
            const bool right = std::min(from, to) > surely, left = std::max(from, to) < -surely;
            all_right &= right;
            all_left &= left;
            one_right |= right;
            one_left |= left;
        }
        some_right &= one_right;
        some_left &= one_left;
    }
    if (all_right || (turns_left && some_right))
        return side::higher;
    return all_left || (turns_right && some_left) ? side::lower : side::unknown;
}

/// Finds the windings on the lower sides of all visits. Returns false if two may cross. `least` is
/// the winding where all visits have their lower sides.
bool pixel_area::find_lower(int least) {
    for (visit& v : visits_)
        v.lower = least;
    for (std::size_t i = 1; i < visits_.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            visit &a = visits_[i], &b = visits_[k];
            const side of_a = side_of(b, a), of_b = side_of(a, b);
            if (of_a == side::unknown || of_b == side::unknown)
                return false;
            a.lower += of_a == side::higher ? 1 : 0;
            b.lower += of_b == side::higher ? 1 : 0;
        }
    return true;
}

/// Finds the fields in which the winding may be 0, a bit for each. `corner` is the winding at the
/// top left corner.
///
/// Each field has a lower bound of its windings. An edge that makes the winding fall counts from
/// the first field on that it may reach. One that makes it rise counts behind those that it may
/// reach. If the corner's winding is below 0, bounds are those of the negative windings.
void pixel_area::find_open(int corner) {
    constexpr int zero = 0x7fff; // a bound above it has its highest bit set
    open_fields_.fill(0xff);
    if (parts_.size() + changes_.size() + static_cast<std::size_t>(std::abs(corner)) > zero)
        return;
    const int sign = corner < 0 ? -1 : 1;
    const auto floor = [](double y) { return static_cast<int>(y); };
    const auto ceil = [](double y) {
        const int whole = static_cast<int>(y);
        return whole + (whole < y ? 1 : 0);
    };
    std::array<row_bounds, fields + 1> least; // a row more, for heights of 1
    const std::uint64_t at_corner = static_cast<std::uint64_t>(zero + sign * corner) * in_all;
    least.fill({at_corner, at_corner});
    for (const winding_change& c : changes_) {
        const int by = sign * c.direction;
        const double y = c.y * fields;
        for (int k = by < 0 ? floor(y) : ceil(y); k < fields; ++k)
            count_from(least[static_cast<std::size_t>(k)], 0, by < 0);
    }
    for (const row_edge& p : parts_) {
        const double slope = (p.x1 - p.x0) / (p.y1 - p.y0);
        // The margin covers the rounding of x and of up to eight steps, each below 1.
        constexpr double scale = 1 << 16, margin = 16;
        const bool falls = sign * p.direction < 0;
        const double y0 = p.y0 * fields, y1 = p.y1 * fields;
        const int begin = falls ? floor(y0) : ceil(y0);
        const int end = falls ? ceil(y1) : floor(y1);
        const double low = std::min(p.x0, p.x1) * fields, high = std::max(p.x0, p.x1) * fields;
        const auto fixed_low = static_cast<std::int64_t>(low * scale - margin);
        const auto fixed_high = static_cast<std::int64_t>(high * scale + margin);
        // Where an edge leads to the right, it is leftmost on top of a row of fields.
        std::int64_t x = falls ? fixed_low : fixed_high, step = 0;
        if (std::abs(slope) < 64) {
            const double row = begin + (falls == (slope < 0) ? 1 : 0);
            x = static_cast<std::int64_t>((p.x0 * fields + (row - y0) * slope) * scale +
                                          (falls ? -margin : margin));
            step = static_cast<std::int64_t>(slope * scale);
        }
        for (int k = begin; k < end; ++k, x += step) {
            const std::int64_t at =
                std::clamp<std::int64_t>(std::clamp(x, fixed_low, fixed_high), 0, fields << 16);
            const std::int64_t field = (falls ? at : at + 0xffff) >> 16;
            count_from(least[static_cast<std::size_t>(k)], static_cast<std::size_t>(field), falls);
        }
    }
    for (std::size_t k = 0; k < fields; ++k) {
        unsigned open = 0;
        for (std::size_t field = 0; field < fields; ++field)
            open |= (least[k][field / 4] >> (field % 4 * 16) & 0x8000) == 0 ? 1U << field : 0;
        open_fields_[k] = static_cast<std::uint8_t>(open);
    }
}

/// The range of the windings. `least` is the winding where all visits have their lower sides.
///
/// Two edges that follow each other, and meet elsewhere, do not cross here. If they turn to the
/// right, each place is on the higher side of one of them, else on the lower side of one.
pixel_area::windings_range pixel_area::range(int least) const {
    windings_range r{least, least + static_cast<int>(visits_.size())};
    for (std::size_t i = 0; i + 1 < visits_.size(); ++i) {
        const visit &second = visits_[i], &first = visits_[i + 1];
        const edge_cell &after = edges_[second.first], &before = edges_[first.first];
        if (second.end != second.first + 1 || first.end != first.first + 1 ||
            after.edge != before.edge + 1)
            continue;
        constexpr double surely = 1e-10; // far above rounding
        const double turn = (before.to.x - before.from.x) * (after.to.y - after.from.y) -
                            (before.to.y - before.from.y) * (after.to.x - after.from.x);
        r.least += turn > surely ? 1 : 0;
        r.most -= turn < -surely ? 1 : 0;
        ++i;
    }
    return r;
}

double pixel_area::inside(const std::array<double, 2>& sums, const fill_rules& rules) {
    // The rest of the sum, without what the pixel's edges add, is that of its corner.
    const windings w{{static_cast<int>(std::lrint(sums[0] - own_[0])),
                      static_cast<int>(std::lrint(sums[1] - own_[1]))}};
    if (rules.clips || is_unclear_)
        return cut(w, rules);
    double least = w.turns[0]; // where all visits have their lower sides
    bool are_clear = true;
    for (const visit& v : visits_) {
        // The visit adds its higher side's share, but for a whole number.
        constexpr double unclear = 1e-9; // far above rounding
        const double share = v.adds - std::floor(v.adds);
        are_clear &= share > unclear && share < 1 - unclear;
        least -= (share < unclear ? 1 : share) - v.adds;
    }
    const int lower = static_cast<int>(std::lrint(least));
    const windings_range all =
        are_clear ? range(lower) : windings_range{lower, lower + static_cast<int>(visits_.size())};
    if (rules.same_between({{all.least, 0}}, {{all.most, 0}}))
        return rules.inside({{all.least, 0}}) ? 1 : 0;
    constexpr std::size_t few = 4; // for more visits, looking for those that cross costs too much
    if (visits_.size() > few || !are_clear || !find_lower(lower))
        return cut(w, rules);
    double area = rules.inside(w) ? 1 : 0;
    for (const visit& v : visits_)
        area += (rules.inside({{v.lower + 1, 0}}) - rules.inside({{v.lower, 0}})) * v.adds;
    return area;
}

/// Finds the area from the edges' ends and crossings, but where fields are surely inside.
double pixel_area::cut(const windings& w, const fill_rules& rules) {
    parts_.clear();
    changes_.clear();
    for (const edge_cell& e : edges_) {
        if (e.below_left != 0)
            changes_.push_back({height_on_left(e), e.below_left, e.layer});
        if (e.from.y < e.to.y)
            parts_.push_back({e.from.x, e.from.y, e.to.x, e.to.y, -1, e.layer});
        else if (e.to.y < e.from.y)
            parts_.push_back({e.to.x, e.to.y, e.from.x, e.from.y, 1, e.layer});
    }
    slabs_.set_width(1);
    constexpr std::size_t many = 6; // for fewer visits, slabs cost less
    if (rules.clips || rules.rule[0] != l3d_winding::nonzero || visits_.size() < many)
        return slabs(parts_, changes_, w, 0, 1, rules);
    find_open(w.turns[0]);
    double area = 1;
    l3d_pixel_box open{}; // that of open fields in neighbouring rows
    const auto finish = [&] {
        if (!open.empty())
            area += box(open, w, rules) -
                    static_cast<double>((open.right - open.left) * (open.bottom - open.top)) /
                        (fields * fields);
        open = {};
    };
    for (int row = 0; row < fields; ++row) {
        const std::uint8_t here = open_fields_[static_cast<std::size_t>(row)];
        if (here == 0) {
            finish();
            continue;
        }
        const int left = std::countr_zero(here), right = static_cast<int>(std::bit_width(here));
        open = open.empty() ? l3d_pixel_box{left, row, right, row + 1}
                            : l3d_pixel_box{std::min(open.left, left), open.top,
                                            std::max(open.right, right), row + 1};
    }
    finish();
    return area;
}

/// The area inside in a box of fields. `corner` are the windings at the pixel's top left corner.
double pixel_area::box(const l3d_pixel_box& of, const windings& corner, const fill_rules& rules) {
    const auto place = [](int field) { return static_cast<double>(field) / fields; };
    const double left = place(of.left), right = place(of.right), top = place(of.top);
    const double bottom = place(of.bottom), width = right - left;
    windings beside = corner; // at the box's top left corner
    side_changes_.clear();
    const auto change = [&](double y, std::int8_t direction, std::uint8_t layer) {
        const winding_change c{y, direction, layer};
        if (y <= top)
            beside.cross(c);
        else if (y < bottom)
            side_changes_.push_back(c);
    };
    for (const winding_change& c : changes_)
        change(c.y, c.direction, c.layer);
    box_parts_.clear();
    for (const row_edge& p : parts_) {
        double y0 = std::max(p.y0, top), y1 = std::min(p.y1, bottom);
        if (y0 >= y1)
            continue;
        const straight_edge edge({p.x0, p.y0}, {p.x1, p.y1});
        double x0 = y0 == p.y0 ? p.x0 : edge.x_at(y0), x1 = y1 == p.y1 ? p.x1 : edge.x_at(y1);
        if (std::min(x0, x1) >= right)
            continue;
        const auto y_at = [&](double x) {
            return std::clamp(std::lerp(y0, y1, (x - x0) / (x1 - x0)), y0, y1);
        };
        // On the box's left, an edge only changes the windings along its side.
        if (std::max(x0, x1) <= left) {
            change(y0, p.direction, p.layer);
            change(y1, static_cast<std::int8_t>(-p.direction), p.layer);
            continue;
        }
        const double at_left = std::min(x0, x1) < left ? y_at(left) : y0;
        const double at_right = std::max(x0, x1) > right ? y_at(right) : y0;
        const double whole_y0 = y0, whole_y1 = y1;
        if (x0 < left) {
            change(whole_y0, p.direction, p.layer);
            change(at_left, static_cast<std::int8_t>(-p.direction), p.layer);
            y0 = at_left, x0 = left;
        } else if (x0 > right) {
            y0 = at_right, x0 = right;
        }
        if (x1 < left) {
            change(at_left, p.direction, p.layer);
            change(whole_y1, static_cast<std::int8_t>(-p.direction), p.layer);
            y1 = at_left, x1 = left;
        } else if (x1 > right) {
            y1 = at_right, x1 = right;
        }
        box_parts_.push_back(
            {(x0 - left) / width, y0, (x1 - left) / width, y1, p.direction, p.layer});
    }
    return slabs(box_parts_, side_changes_, beside, top, bottom, rules) * width;
}

/// The area inside between two heights, on the right of a side along which the windings are
/// `beside` at the top, and then change.
double pixel_area::slabs(std::span<const row_edge> edges, std::span<winding_change> changes,
                         windings beside, double top, double bottom, const fill_rules& rules) {
    std::ranges::sort(changes, {}, &winding_change::y);
    slabs_.add_cluster(edges, beside, rules, changes);
    double* const borders = slabs_.sums();
    double area = std::exchange(borders[0], 0);
    borders[1] = borders[2] = 0;
    // Where the left side is inside, all is but for what borders take away.
    for (const winding_change& c : changes) {
        area += rules.inside(beside) ? c.y - top : 0;
        beside.cross(c);
        top = c.y;
    }
    return area + (rules.inside(beside) ? bottom - top : 0);
}

} // namespace l3d_detail
