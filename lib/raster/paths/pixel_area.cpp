// SPDX-License-Identifier: MIT
// pixel_area: what visits tell of a pixel; fields that are surely inside; borders; slabs.
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

void pixel_area::begin() {
    parts_.clear();
    last_ = before_last_ = {};
    range_ = {};
    turns_right_ = turns_left_ = 0;
    are_shares_clear_ = true;
    open_ = is_unclear_ = false;
    own_ = {};
    before_ = {};
}

/// Finds the fields in which the winding may be 0, a bit for each, row by row.
/// `beside` is the winding on the left of all parts. `sign` is -1 if bounds are to be those of the
/// negative windings, else 1.
///
/// Each field has a lower bound of its windings. An edge that makes the winding fall counts from
/// the first field on that it may reach. One that makes it rise counts behind those that it may
/// reach.
///
/// Bounds are counted in all fields at once: word i has the bits 2^i of their counters.
std::uint64_t pixel_area::find_open(int beside, int sign) const {
    const std::size_t most = parts_.size() + static_cast<std::size_t>(std::abs(beside));
    const auto high = static_cast<std::size_t>(std::bit_width(most));
    // A counter has its highest bit if its bound is above 0.
    const std::uint64_t begin =
        (std::uint64_t{1} << high) - 1 + static_cast<std::uint64_t>(sign * beside);
    std::array<std::uint64_t, 64> bits;
    for (std::size_t i = 0; i <= high; ++i)
        bits[i] = (begin >> i & 1) != 0 ? all_fields : 0;
    const auto floor = [](double y) { return static_cast<int>(y); };
    const auto ceil = [](double y) {
        const int whole = static_cast<int>(y);
        return whole + (whole < y ? 1 : 0);
    };
    const auto rows_from = [](int row) { return row < rows ? all_fields << (row * columns) : 0; };
    for (const part& p : parts_.all()) {
        constexpr double margin = 1e-9; // far above rounding
        const bool falls = sign * p.direction < 0;
        const int top = falls != p.up_left ? floor(p.y0 * rows) : ceil(p.y0 * rows);
        const int bottom = falls != p.down_left ? ceil(p.y1 * rows) : floor(p.y1 * rows);
        const int column = falls ? floor(std::max(std::min(p.x0, p.x1) - margin, 0.0) * columns)
                                 : ceil(std::min(std::max(p.x0, p.x1) + margin, 1.0) * columns);
        const std::uint64_t above = ~rows_from(top), below = rows_from(bottom);
        std::uint64_t where = in_each_row * (all_in_row & all_in_row << column) & ~(above | below);
        where |= (p.up_left ? above : 0) | (p.down_left ? below : 0);
        const std::uint64_t borrow = falls ? all_fields : 0;
        for (std::size_t i = 0; where != 0 && i <= high; ++i) {
            const std::uint64_t before = bits[i];
            bits[i] = before ^ where;
            where &= before ^ borrow;
        }
    }
    return ~bits[high];
}

/// The heights between which an edge may pass open fields. Returns an empty range if there are
/// none.
pixel_area::range_of_y pixel_area::open_heights(const part& p, std::uint64_t open) {
    if (open == all_fields)
        return {p.y0, p.y1};
    range_of_y result{1, 0};
    // An edge on the side of a field, but for rounding, belongs to it.
    constexpr double margin = 1e-9;
    const auto column = [](double x) {
        return std::clamp(static_cast<int>(x * columns), 0, columns - 1);
    };
    double top = p.y0, at_top = p.x0;
    for (int row = static_cast<int>(top * rows); top < p.y1; ++row) {
        const double bottom = std::min(static_cast<double>(row + 1) / rows, p.y1);
        const double at_bottom = p.x_at(bottom);
        const int left = column(std::min(at_top, at_bottom) - margin);
        const int right = column(std::max(at_top, at_bottom) + margin);
        const unsigned passed = (2U << right) - (1U << left);
        if ((open >> (row * columns) & passed) != 0)
            result = {std::min(result.top, top), bottom};
        top = bottom;
        at_top = at_bottom;
    }
    return result;
}

double pixel_area::inside(const std::array<double, 2>& sums, const fill_rules& rules) {
    // The rest of the sum, without what the pixel's edges add, is that of its corner.
    const windings corner{{static_cast<int>(std::lrint(sums[0] - own_[0])),
                           static_cast<int>(std::lrint(sums[1] - own_[1]))}};
    end_visit();
    if (!rules.clips && !is_unclear_) {
        windings_range all{corner.turns[0] + range_.least, corner.turns[0] + range_.most};
        if (are_shares_clear_) {
            all.least += turns_right_;
            all.most -= turns_left_;
        }
        if (rules.same_between({{all.least, 0}}, {{all.most, 0}}))
            return rules.inside({{all.least, 0}}) ? 1 : 0;
    }
    std::uint64_t open = all_fields;
    // Fields take some 100 instructions for each of n edges, borders 40 for each of n^2 / 2 pairs.
    constexpr int many = 6;
    if (!rules.clips && rules.rule[0] == l3d_winding::nonzero &&
        range_.most - range_.least >= many) {
        open = find_open(corner.turns[0] + before_.turns[0], corner.turns[0] < 0 ? -1 : 1);
        if (open == 0)
            return 1;
    }
    find_changes();
    const std::optional<double> area = between_borders(corner, open, rules);
    return area ? *area : slabs(corner, rules);
}

/// The area inside, from the parts of edges that have it on one side alone. Returns nothing if two
/// edges are so close that rounding may tell wrong which one is on the left.
std::optional<double> pixel_area::between_borders(const windings& corner, std::uint64_t open,
                                                  const fill_rules& rules) {
    constexpr double same = 1e-12, close = 1e-7;
    double area = on_left(corner, rules);
    windings beside = corner;
    for (std::size_t layer = 0; layer < 2; ++layer)
        beside.turns[layer] += before_.turns[layer];
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const part& e = parts_[i];
        const range_of_y heights = open_heights(e, open);
        const double top = heights.top, bottom = heights.bottom;
        if (top >= bottom)
            continue;
        windings left = beside;
        passed_.clear();
        const auto change = [&](double y, int by, std::uint8_t layer) {
            if (y <= top)
                left.turns[layer] += by;
            else if (y < bottom)
                passed_.push({y, static_cast<std::int8_t>(by), layer});
        };
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            const part& other = parts_[k];
            if (k == i)
                continue;
            if (other.y1 <= top || other.y0 >= bottom) {
                if (other.y1 <= top ? other.down_left : other.up_left)
                    left.cross(other);
                continue;
            }
            const double begin = std::max(top, other.y0), end = std::min(bottom, other.y1);
            const double above = other.x_at(begin) - e.x_at(begin);
            const double below = other.x_at(end) - e.x_at(end);
            const double apart = std::max(std::abs(above), std::abs(below));
            bool begins_left = above < 0, ends_left = below < 0;
            if (apart < close) {
                if (apart > same)
                    return std::nullopt;
                begins_left = ends_left = k < i;
            }
            // On the left or not: above its upper end, below that, above its lower end, below that.
            bool is_left = false;
            const auto set = [&](bool to, double y) {
                if (to != is_left)
                    change(y, to ? other.direction : -other.direction, other.layer);
                is_left = to;
            };
            set(other.up_left, top);
            set(begins_left, begin);
            if (begins_left != ends_left)
                set(ends_left, begin + (end - begin) * (above / (above - below)));
            set(other.down_left, end);
        }
        sort_few(passed_, is_higher);
        double from = top;
        const auto pass = [&](double to) {
            windings right = left;
            right.cross(e);
            const int sign = rules.inside(right) - rules.inside(left);
            if (sign != 0)
                area += sign * (to - from) * (1 - (e.x_at(from) + e.x_at(to)) / 2);
            from = to;
        };
        for (const winding_change& c : passed_.all()) {
            pass(c.y);
            left.cross(c);
        }
        pass(bottom);
    }
    return area;
}

/// Finds the changes of the windings down the pixel's left side, where edges come to it.
void pixel_area::find_changes() {
    changes_.clear();
    for (const part& p : parts_.all())
        if (p.up_left)
            changes_.push({p.y0, static_cast<std::int8_t>(-p.direction), p.layer});
        else if (p.down_left)
            changes_.push({p.y1, p.direction, p.layer});
    sort_few(changes_, is_higher);
}

/// The area inside that the left side would have on its right if there were no edges.
double pixel_area::on_left(windings beside, const fill_rules& rules) const {
    double area = 0, top = 0;
    for (const winding_change& c : changes_.all()) {
        area += rules.inside(beside) ? c.y - top : 0;
        beside.cross(c);
        top = c.y;
    }
    return area + (rules.inside(beside) ? 1 - top : 0);
}

/// The area inside, from slabs.
double pixel_area::slabs(const windings& corner, const fill_rules& rules) {
    slabs_.set_width(1);
    slab_edges_.assign(parts_.all().begin(), parts_.all().end());
    slabs_.add_cluster(slab_edges_, corner, rules, changes_.all());
    double* const borders = slabs_.sums();
    const double area = on_left(corner, rules) + borders[0];
    borders[0] = borders[1] = borders[2] = 0;
    return area;
}

} // namespace l3d_detail
