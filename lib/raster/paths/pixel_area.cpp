// SPDX-License-Identifier: MIT
// pixel_area: what visits of outlines tell of a pixel; slabs where they do not.
#include "raster/paths/pixel_area_p.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace l3d_detail {

namespace {

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
/// A visit's higher side is to the right of its edges. Where these all turn to the right, a place is
/// on that side if it is to the right of all of their lines, and on the left one if it is to the left
/// of one line. Where they all turn to the left, left and right change places.
pixel_area::side pixel_area::side_of(const visit& of, const visit& other) const {
    constexpr double surely = 1e-10; // far above rounding
    const auto to_right = [](const edge_cell& e, const l3d_point_2d& p) {
        return (e.to.x - e.from.x) * (p.y - e.from.y) - (e.to.y - e.from.y) * (p.x - e.from.x);
    };
    bool turns_right = true, turns_left = true;
    for (std::size_t i = of.first + 1; i < of.end; ++i) {
        const double turn = to_right(edges_[i], edges_[i - 1].to); // the one before leads on
        turns_right &= turn >= 0;
        turns_left &= turn <= 0;
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

/// Whether the winding is certainly at least 1, or at most -1, wherever in the pixel. `corner` is
/// that of its top left corner.
///
/// The pixel has 8 x 8 fields, and each has a lower bound of its windings. An edge that makes the
/// winding fall counts from the first field on that it may reach. One that makes it rise counts
/// behind those that it may reach. A row's bounds are the bytes of a word.
bool pixel_area::is_wound_about(int corner) const {
    constexpr int fields = 8, zero = 127; // a byte above it has its highest bit set
    constexpr std::uint64_t ones = 0x0101010101010101;
    if (corner == 0 && changes_.empty())
        return false; // as is the corner itself
    if (parts_.size() + changes_.size() + static_cast<std::size_t>(std::abs(corner)) > zero)
        return false;
    const int sign = corner < 0 ? -1 : 1;
    const auto floor = [](double y) { return static_cast<int>(y); };
    const auto ceil = [](double y) {
        const int whole = static_cast<int>(y);
        return whole + (whole < y ? 1 : 0);
    };
    std::array<std::uint64_t, fields + 1> least;
    least.fill(ones * static_cast<std::uint64_t>(zero + sign * corner));
    for (const winding_change& c : changes_) {
        const int by = sign * c.direction;
        const double y = c.y * fields;
        for (int k = by < 0 ? floor(y) : ceil(y); k < fields; ++k)
            least[static_cast<std::size_t>(k)] += by < 0 ? -ones : ones;
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
            const std::uint64_t behind = field < fields ? ones << (field << 3) : 0;
            least[static_cast<std::size_t>(k)] += falls ? -behind : behind;
        }
    }
    std::uint64_t all = ~std::uint64_t{0};
    for (std::size_t k = 0; k < fields; ++k)
        all &= least[k];
    return (all & 128 * ones) == 128 * ones;
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
        return slabs(w, rules);
    double least = w.turns[0]; // where all visits have their lower sides
    bool are_clear = true;
    for (const visit& v : visits_) {
        // What the visit adds differs from its higher side's share by a whole number.
        constexpr double unclear = 1e-9; // far above rounding
        const double share = v.adds - std::floor(v.adds);
        are_clear &= share > unclear && share < 1 - unclear;
        least -= (share < unclear ? 1 : share) - v.adds;
    }
    const int lower = static_cast<int>(std::lrint(least));
    const windings_range all = range(lower);
    if (rules.same_between({{all.least, 0}}, {{all.most, 0}}))
        return rules.inside({{all.least, 0}}) ? 1 : 0;
    constexpr std::size_t few = 4; // for more visits, looking for those that cross costs too much
    if (visits_.size() > few || !are_clear || !find_lower(lower))
        return slabs(w, rules);
    double area = rules.inside(w) ? 1 : 0;
    for (const visit& v : visits_)
        area += (rules.inside({{v.lower + 1, 0}}) - rules.inside({{v.lower, 0}})) * v.adds;
    return area;
}

double pixel_area::slabs(const windings& w, const fill_rules& rules) {
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
    constexpr std::size_t many = 6; // for fewer visits, slabs cost less
    if (!rules.clips && rules.rule[0] == l3d_winding::nonzero && visits_.size() >= many &&
        is_wound_about(w.turns[0]))
        return 1;
    slabs_.set_width(1);
    std::ranges::sort(changes_, {}, &winding_change::y);
    slabs_.add_cluster(parts_, w, rules, changes_);
    double* const borders = slabs_.sums();
    double area = std::exchange(borders[0], 0);
    borders[1] = borders[2] = 0;
    // Where the left side is inside, all is but for what borders take away.
    windings left = w;
    double top = 0;
    for (const winding_change& c : changes_) {
        area += rules.inside(left) ? c.y - top : 0;
        left.cross(c);
        top = c.y;
    }
    return area + (rules.inside(left) ? 1 - top : 0);
}

} // namespace l3d_detail
