// SPDX-License-Identifier: MIT
// l3d_trim_region: makes polygons of loops, and cuts polygons by Sutherland's and Hodgman's scheme.
#include "geom/trims/trim_region.h"

#include "base/formatted_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace {

using curve = std::vector<std::array<double, 3>>;

/// The point of a polygon's side from a to b where the coordinate `along` is `at`. The point is the
/// same, bit for bit, for the side from b to a.
l3d_trim_place crossing(l3d_trim_place a, l3d_trim_place b, std::size_t along, double at) {
    if (b < a)
        std::swap(a, b);
    const double t = (at - a[along]) / (b[along] - a[along]);
    const std::size_t other = 1 - along;
    const auto [low, high] = std::minmax(a[other], b[other]);
    l3d_trim_place result;
    result[along] = at;
    result[other] = std::clamp(a[other] + (b[other] - a[other]) * t, low, high);
    return result;
}

/// Whether a polygon is the box itself: it has the box's four corners, and no other.
bool is_box(const l3d_trim_polygon& p, const l3d_trim_box& box) {
    const auto is_corner = [&](const l3d_trim_place& at) {
        return (at[0] == box.least[0] || at[0] == box.most[0]) &&
               (at[1] == box.least[1] || at[1] == box.most[1]);
    };
    for (std::size_t i = 0; i < p.size(); ++i) {
        const l3d_trim_place &a = p[i], &b = p[(i + 1) % p.size()];
        if (!is_corner(a) || (a[0] == b[0]) == (a[1] == b[1]))
            return false;
    }
    return p.size() == 4 && p[0] != p[2] && p[1] != p[3];
}

bool is_of_boxes(const l3d_trim_region& region, const l3d_trim_box& box) {
    return std::ranges::all_of(region.polygons,
                               [&](const l3d_trim_polygon& p) { return is_box(p, box); });
}

bool is_flat(const l3d_trim_polygon& polygon) {
    if (polygon.size() < 3)
        return true;
    const auto same = [&](std::size_t k) {
        return std::ranges::all_of(
            polygon, [&](const l3d_trim_place& p) { return p[k] == polygon.front()[k]; });
    };
    return same(0) || same(1);
}

l3d_trim_polygon part_of(const l3d_trim_polygon& polygon, std::size_t along, double at,
                         bool above) {
    l3d_trim_polygon result;
    const auto add = [&](const l3d_trim_place& p, l3d_trim_use side) {
        if (result.empty() || result.back() != p) {
            result.push_back({p, side});
            return;
        }
        // The side before has lost its length, but not its part of the edge.
        const l3d_trim_use& before = result.back().side;
        if (before.edge == side.edge && before.to == side.from)
            side.from = before.from;
        result.back().side = side;
    };
    const auto is_in = [&](const l3d_trim_place& p) {
        return above ? p[along] >= at : p[along] <= at;
    };
    // Each corner that is in gives at most one corner, and so does each side that is cut.
    const auto in = std::ranges::count_if(polygon, is_in);
    if (in == 0)
        return result;
    const auto out = static_cast<std::ptrdiff_t>(polygon.size()) - in;
    result.reserve(static_cast<std::size_t>(in + 2 * std::min(in, out)));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const l3d_trim_corner& a = polygon[i];
        const l3d_trim_corner& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        l3d_trim_use before = a.side, behind = a.side;
        const bool is_cut = is_in(a) != is_in(b);
        if (is_cut && a.side.edge != l3d_no_edge)
            before.to = behind.from = a.side.at((at - a[along]) / (b[along] - a[along]));
        if (is_in(a))
            add(a, is_cut ? before : a.side);
        if (is_cut)
            add(crossing(a, b, along, at), is_in(a) ? l3d_trim_use() : behind);
    }
    while (result.size() > 1 && result.back() == result.front())
        result.pop_back();
    return result;
}

l3d_trim_region part_of(const l3d_trim_region& region, std::size_t along, double at, bool above) {
    l3d_trim_region result;
    for (const l3d_trim_polygon& polygon : region.polygons) {
        l3d_trim_polygon part = part_of(polygon, along, at, above);
        if (!is_flat(part))
            result.polygons.push_back(std::move(part));
    }
    return result;
}

std::array<curve, 2> halves_of(const curve& whole) {
    // Halves homogeneous points, so that weights count.
    curve row = whole;
    for (auto& p : row) {
        p[0] *= p[2];
        p[1] *= p[2];
    }
    std::array<curve, 2> result{row, row};
    const std::size_t n = row.size();
    for (std::size_t level = 1; level < n; ++level) {
        for (std::size_t i = 0; i + level < n; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                row[i][k] = (row[i][k] + row[i + 1][k]) / 2;
        result[0][level] = row[0];
        result[1][n - 1 - level] = row[n - 1 - level];
    }
    for (curve& half : result)
        for (auto& p : half) {
            p[0] /= p[2];
            p[1] /= p[2];
        }
    return result;
}

/// Bounds how far a curve is from its chord, in space. The curve's points are means of control
/// points.
double off_chord(const curve& of, const l3d_trim_place& lengths) {
    const auto scaled = [&](const std::array<double, 3>& p) {
        return l3d_trim_place{p[0] * lengths[0], p[1] * lengths[1]};
    };
    const l3d_trim_place a = scaled(of.front()), b = scaled(of.back());
    const double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
    double result = 0, heaviest = 0;
    for (std::size_t i = 1; i + 1 < of.size(); ++i) {
        const l3d_trim_place p = scaled(of[i]);
        const double along = (p[0] - a[0]) * x + (p[1] - a[1]) * y;
        const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
        result = std::max(result, std::abs(p[0] - a[0] - t * x) + std::abs(p[1] - a[1] - t * y));
        heaviest = std::max(heaviest, of[i][2]);
    }
    return result * l3d_share_between(of.size(), std::min(of.front()[2], of.back()[2]), heaviest);
}

l3d_trim_box hull_of(const curve& of) {
    l3d_trim_box hull{{of[0][0], of[0][1]}, {of[0][0], of[0][1]}};
    for (const auto& p : of)
        for (std::size_t k = 0; k < 2; ++k) {
            hull.least[k] = std::min(hull.least[k], p[k]);
            hull.most[k] = std::max(hull.most[k], p[k]);
        }
    return hull;
}

/// Adds the corners of a curve to a polygon, except for the last one, which begins the next curve.
void flatten(const curve& of, const l3d_trim_use& use, const l3d_trim_place& lengths,
             const std::function<double(const l3d_trim_box&)>& wanted, int halvings,
             l3d_trim_polygon& to, l3d_flatness& sum) {
    const double off = off_chord(of, lengths);
    const double allowed = off > 0 ? wanted(hull_of(of)) : 0;
    if (off > allowed && halvings > 0) {
        const auto [first, second] = halves_of(of);
        const double middle = use.at(0.5);
        flatten(first, {use.edge, use.from, middle}, lengths, wanted, halvings - 1, to, sum);
        flatten(second, {use.edge, middle, use.to}, lengths, wanted, halvings - 1, to, sum);
        return;
    }
    to.push_back({{of.front()[0], of.front()[1]}, use});
    if (off > 0 && std::isfinite(allowed)) {
        sum.off = std::max(sum.off, off);
        sum.share = std::max(sum.share, off / allowed);
    }
}

/// Makes a polygon of a loop.
void flatten(const l3d_trim_loop& loop, const l3d_trim_place& lengths,
             const std::function<double(const l3d_trim_box&)>& wanted, l3d_trim_polygon& to,
             l3d_flatness& sum) {
    constexpr int most_halvings = 16; // each lets the distances from chords fall by 4
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const l3d_trim_curve &one = loop[i], &next = loop[i + 1 < loop.size() ? i + 1 : 0];
        flatten(one.points, {one.edge, one.from, one.to}, lengths, wanted, most_halvings, to, sum);
        // Where rounding left a gap, a straight side closes it, which belongs to the end of the
        // curve's edge.
        const l3d_trim_place end{one.points.back()[0], one.points.back()[1]};
        if (end != l3d_trim_place{next.points.front()[0], next.points.front()[1]})
            to.push_back({end, {one.edge, one.to, one.to}});
    }
}

/// Says which error a loop's curves have, or "". The loop need not be closed if it `may_be_open`.
std::string complaint_of(const l3d_trim_loop& loop, bool may_be_open) {
    if (loop.empty())
        return "has no curve";
    std::array<double, 2> least{HUGE_VAL, HUGE_VAL}, most{-HUGE_VAL, -HUGE_VAL};
    for (const l3d_trim_curve& one : loop) {
        if (one.points.size() < 2 || one.points.size() > l3d_bpt_largest_degree + 1)
            return "has a curve of " + std::to_string(one.points.size()) + " control points";
        for (const auto& p : one.points) {
            for (std::size_t k = 0; k < 2; ++k) {
                if (!(std::abs(p[k]) <= l3d_bpt_largest_coordinate))
                    return "has a coordinate that is not finite, or beyond 1e12";
                least[k] = std::min(least[k], p[k]);
                most[k] = std::max(most[k], p[k]);
            }
            if (!l3d_is_weight(p[2]))
                return l3d_detail::formatted("has the weight %g, which is not from 1e-100 to 1e12",
                                             p[2]);
        }
    }
    if (may_be_open)
        return "";
    const double widest = 0x1p-20 * std::max(most[0] - least[0], most[1] - least[1]);
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto& end = loop[i].points.back();
        const auto& next = loop[i + 1 < loop.size() ? i + 1 : 0].points.front();
        if (!(std::abs(end[0] - next[0]) <= widest && std::abs(end[1] - next[1]) <= widest))
            return l3d_detail::formatted("is open from (%g, %g) to (%g, %g)", end[0], end[1],
                                         next[0], next[1]);
    }
    return "";
}

std::string complaint_of(std::span<const l3d_trim_loop> loops, bool may_be_open) {
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (const std::string why = complaint_of(loops[i], may_be_open); !why.empty())
            return "trim " + std::to_string(i + 1) + ' ' + why;
    return "";
}

} // namespace

std::string l3d_trims_complaint(std::span<const l3d_trim_loop> loops) {
    return complaint_of(loops, false);
}

std::string l3d_trim_curves_complaint(std::span<const l3d_trim_loop> loops) {
    return complaint_of(loops, true);
}

double l3d_share_between(std::size_t points, double lightest_end, double heaviest_between) {
    const double of_ends = 2.0 / static_cast<double>(1U << (points - 1));
    const double ends = lightest_end * of_ends, between = heaviest_between * (1 - of_ends);
    return between > 0 ? between / (between + ends) : 0;
}

double l3d_off_chord(const l3d_trim_curve& curve, const l3d_trim_place& lengths) {
    return off_chord(curve.points, lengths);
}

l3d_flatness l3d_flat_trims(std::span<const l3d_trim_loop> loops, const l3d_trim_place& lengths,
                            const std::function<double(const l3d_trim_box&)>& wanted,
                            l3d_trim_region& to) {
    l3d_flatness result;
    for (const l3d_trim_loop& loop : loops) {
        l3d_trim_polygon& polygon = to.polygons.emplace_back();
        l3d_flatness sum;
        // A loop around an area stays, however small the area is: the map of doubt knows a border
        // by its sides.
        for (double part = 1; part > 0x1p-16 && is_flat(polygon); part /= 4) {
            polygon.clear();
            sum = {};
            flatten(
                loop, lengths, [&](const l3d_trim_box& box) { return part * wanted(box); }, polygon,
                sum);
        }
        if (is_flat(polygon))
            to.polygons.pop_back();
        result.off = std::max(result.off, sum.off);
        result.share = std::max(result.share, sum.share);
    }
    return result;
}

double l3d_flat_trims(std::span<const l3d_trim_loop> loops, const l3d_trim_place& lengths,
                      double wanted, l3d_trim_region& to) {
    return l3d_flat_trims(
               loops, lengths, [=](const l3d_trim_box&) { return wanted; }, to)
        .off;
}

bool l3d_trim_region::is_all_of(const l3d_trim_box& box) const {
    return polygons.size() % 2 == 1 && is_of_boxes(*this, box);
}

bool l3d_trim_region::is_none_of(const l3d_trim_box& box) const {
    return polygons.size() % 2 == 0 && is_of_boxes(*this, box);
}

bool l3d_trim_region::follows_edges() const {
    return std::ranges::any_of(polygons, [](const l3d_trim_polygon& polygon) {
        return std::ranges::any_of(
            polygon, [](const l3d_trim_corner& c) { return c.side.edge != l3d_no_edge; });
    });
}

bool l3d_trim_region::contains(const l3d_trim_place& at) const {
    bool inside = false;
    for (const l3d_trim_polygon& polygon : polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const l3d_trim_place& a = polygon[i];
            const l3d_trim_place& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
            if ((a[1] <= at[1]) != (b[1] <= at[1]) && crossing(a, b, 1, at[1])[0] > at[0])
                inside = !inside;
        }
    return inside;
}

std::array<l3d_trim_region, 2> l3d_trim_region::halves(std::size_t along, double at) const {
    return {part_of(*this, along, at, false), part_of(*this, along, at, true)};
}

l3d_trim_region l3d_trim_region::within(const l3d_trim_box& box) const {
    l3d_trim_region result = part_of(*this, 0, box.least[0], true);
    result = part_of(result, 0, box.most[0], false);
    result = part_of(result, 1, box.least[1], true);
    return part_of(result, 1, box.most[1], false);
}

l3d_trim_region l3d_trim_region::in_box(const l3d_trim_box& box) const {
    l3d_trim_region result = *this;
    for (l3d_trim_polygon& polygon : result.polygons)
        for (l3d_trim_place& p : polygon)
            for (std::size_t k = 0; k < 2; ++k)
                p[k] = (p[k] - box.least[k]) / (box.most[k] - box.least[k]);
    return result;
}

void l3d_join_stretches(std::vector<std::array<double, 2>>& of) {
    std::ranges::sort(of);
    std::size_t kept = 0;
    for (const auto& one : of)
        if (kept > 0 && one[0] <= of[kept - 1][1])
            of[kept - 1][1] = std::max(of[kept - 1][1], one[1]);
        else
            of[kept++] = one;
    of.resize(kept);
}

std::vector<std::array<double, 2>> l3d_trim_region::stretches(std::size_t along, double at) const {
    // Looks at sides on the line. If an odd number of them lies at a place, the region ends there.
    std::vector<std::array<double, 2>> result;
    for (const l3d_trim_region& half : halves(along, at)) {
        std::vector<double> ends;
        for (const l3d_trim_polygon& polygon : half.polygons)
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const l3d_trim_place& a = polygon[i];
                const l3d_trim_place& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
                if (a[along] == at && b[along] == at)
                    ends.insert(ends.end(), {a[1 - along], b[1 - along]});
            }
        std::ranges::sort(ends);
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
            if (ends[i] < ends[i + 1])
                result.push_back({ends[i], ends[i + 1]});
    }
    l3d_join_stretches(result);
    return result;
}
