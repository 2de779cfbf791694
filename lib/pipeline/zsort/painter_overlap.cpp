// SPDX-License-Identifier: MIT
// Compares overlapping triangles in the picture: exactly for whole ones, cautiously for pieces.
#include "pipeline/zsort/painter_overlap_p.h"

#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace l3d_detail {

namespace {

using triangle = std::array<l3d_micro_vertex, 3>;

/// Whether an edge of triangle `a` has all of triangle `b` on its outer side or on the edge's line.
bool an_edge_parts(const triangle& a, const triangle& b) {
    const std::int64_t area2 = twice_area(a[0], a[1], a[2]);
    for (std::size_t i = 0; i < 3; ++i) {
        const l3d_micro_vertex &p = a[i], &q = a[(i + 1) % 3];
        const auto outside = [&](const l3d_micro_vertex& v) {
            const std::int64_t side = twice_area(p, q, v);
            return area2 > 0 ? side <= 0 : side >= 0;
        };
        if (outside(b[0]) && outside(b[1]) && outside(b[2]))
            return true;
    }
    return false;
}

double doubled_area(std::span<const picture_point> region) {
    double sum = 0;
    for (std::size_t i = 2; i < region.size(); ++i)
        sum += (region[i - 1].x - region[0].x) * (region[i].y - region[0].y) -
               (region[i - 1].y - region[0].y) * (region[i].x - region[0].x);
    return sum;
}

/// Appends to `out` the part of a polygon where the function `inside` is not negative. `inside` is
/// linear along the polygon's sides.
template <class Inside>
void clip(std::span<const picture_point> polygon, const Inside& inside, picture_region& out) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const picture_point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double at_a = inside(a), at_b = inside(b);
        if (at_a >= 0)
            out.push_back(a);
        if ((at_a >= 0) != (at_b >= 0)) {
            const double t = at_a / (at_a - at_b);
            out.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
    }
}

/// Finds which of two triangles is in front, by more than `tie`, at the corners of one of the
/// triangles. `corners` are these corners, and `plane` is the depth plane of the other triangle.
/// `corners_are_first` tells whether `corners` belong to the first triangle.
front_parts front_at_corners(const triangle& corners, const l3d_picture_plane& plane, double tie,
                             bool corners_are_first) {
    front_parts front;
    for (const l3d_micro_vertex& v : corners) {
        const double nearer = v.inv_w - plane.at(v.x, v.y);
        front.first |= nearer > tie;
        front.second |= nearer < -tie;
    }
    return corners_are_first ? front : front_parts{front.second, front.first};
}

float nearest(const triangle& v) {
    return std::max({v[0].inv_w, v[1].inv_w, v[2].inv_w});
}

} // namespace

bool insides_meet(const triangle& a, const triangle& b) {
    return !an_edge_parts(a, b) && !an_edge_parts(b, a);
}

double tie_of(const triangle& a, const triangle& b) {
    return painter_tie * std::min(nearest(a), nearest(b));
}

front_parts front_over(std::span<const picture_point> region, const l3d_picture_plane& first,
                       const l3d_picture_plane& second, double tie) {
    front_parts front;
    for (const picture_point& p : region) {
        const double nearer = first.at(p.x, p.y) - second.at(p.x, p.y);
        front.first |= nearer > tie;
        front.second |= nearer < -tie;
    }
    return front;
}

picture_region region_of(const triangle& v) {
    picture_region region;
    for (const l3d_micro_vertex& corner : v)
        region.push_back({double(corner.x), double(corner.y)});
    return region;
}

void intersect(std::span<const picture_point> a, std::span<const picture_point> b,
               picture_region& out, picture_region& scratch) {
    constexpr double margin = 0x1p-12;
    const double sign = doubled_area(b) < 0 ? -1 : 1;
    out.assign(a.begin(), a.end());
    for (std::size_t i = 0; i < b.size() && !out.empty(); ++i) {
        const picture_point &p = b[i], &q = b[(i + 1) % b.size()];
        const double dx = sign * (q.x - p.x), dy = sign * (q.y - p.y);
        const double reach = margin * (std::abs(dx) + std::abs(dy));
        scratch.clear();
        clip(
            out,
            [&](const picture_point& v) { return dx * (v.y - p.y) - dy * (v.x - p.x) + reach; },
            scratch);
        out.swap(scratch);
    }
}

void keep_side(std::span<const picture_point> region, const l3d_picture_plane& first,
               const l3d_picture_plane& second, bool in_front, picture_region& out) {
    const double sign = in_front ? 1 : -1;
    out.clear();
    clip(
        region,
        [&](const picture_point& p) { return sign * (first.at(p.x, p.y) - second.at(p.x, p.y)); },
        out);
}

/// Tests corners first. If all corners of one triangle are on one side of the other triangle's
/// plane, this side decides. Otherwise it compares the planes over the triangles' common part.
front_parts front_of(const triangle& a, const triangle& b) {
    const double tie = tie_of(a, b);
    const l3d_picture_plane plane_a(a), plane_b(b);
    const front_parts at_a = front_at_corners(a, plane_b, tie, true);
    if (!at_a.mixed())
        return at_a;
    const front_parts at_b = front_at_corners(b, plane_a, tie, false);
    if (!at_b.mixed())
        return at_b;
    picture_region common, scratch;
    intersect(region_of(a), region_of(b), common, scratch);
    return front_over(common, plane_a, plane_b, tie);
}

} // namespace l3d_detail
