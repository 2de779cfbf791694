// SPDX-License-Identifier: MIT
// l3d_fill_slit: merging two polylines along one curve.
#include "pipeline/slit.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace {

/// Sign of twice the signed area of a triangle in the picture, x right, y down.
int orientation(const l3d_clip_vertex& a, const l3d_clip_vertex& b, const l3d_clip_vertex& c) {
    if (a.drawable && b.drawable && c.drawable) {
        const l3d_micro_vertex &p = a.dice.vertex, &q = b.dice.vertex, &r = c.dice.vertex;
        const std::int64_t area =
            std::int64_t{q.x - p.x} * (r.y - p.y) - std::int64_t{q.y - p.y} * (r.x - p.x);
        return (area > 0) - (area < 0);
    }
    // Of the part in front of the eye, as the determinant of homogeneous points tells.
    const double area = l3d_dot(a.h, l3d_cross(b.h, c.h));
    return (area > 0) - (area < 0);
}

class filler {
public:
    filler(const l3d_dice_view& view, std::vector<l3d_dice_vertex>& triangles)
        : view_(view), triangles_(triangles) {}

    void add(const l3d_clip_vertex& a, const l3d_clip_vertex& b, const l3d_clip_vertex& c,
             int facing) {
        const int turn = orientation(a, b, c);
        const bool all_drawable = a.drawable && b.drawable && c.drawable;
        if (turn == 0 && all_drawable)
            return;
        const bool swap = turn * facing < 0;
        l3d_clip_triangle(a, swap ? c : b, swap ? b : c, view_, triangles_);
    }

private:
    const l3d_dice_view& view_;
    std::vector<l3d_dice_vertex>& triangles_;
};

} // namespace

void l3d_fill_slit(std::span<const l3d_boundary_point> row, const l3d_edge_polyline& edge,
                   const l3d_dice_view& view, std::vector<l3d_dice_vertex>& triangles) {
    const auto& points = edge.points();
    const double t0 = row.front().t, t1 = row.back().t;
    const l3d_dice_vertex &first = row.front().vertex.dice, &last = row.back().vertex.dice;
    filler fill(view, triangles);

    // An edge point on this side of the surface: parameters along the row, the row's normal.
    const auto on_row = [&](std::size_t j, const l3d_boundary_point& near_by) {
        l3d_clip_vertex v = points[j].vertex;
        const double s = (points[j].t - t0) / (t1 - t0);
        v.dice.u = first.u + (last.u - first.u) * s;
        v.dice.v = first.v + (last.v - first.v) * s;
        std::copy_n(near_by.vertex.dice.vertex.normal, 3, v.dice.vertex.normal);
        return v;
    };

    const auto above = std::upper_bound(points.begin(), points.end(), t0,
                                        [](double t, const l3d_edge_point& p) { return t < p.t; });
    auto j = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - points.begin(), 1) - 1);
    std::size_t i = 0;
    while (i + 1 < row.size() || (j + 1 < points.size() && points[j + 1].t <= t1)) {
        const l3d_boundary_point& p = row[i];
        const l3d_clip_vertex q = on_row(j, p);
        const bool along_row =
            i + 1 < row.size() && (j + 1 == points.size() || row[i + 1].t <= points[j + 1].t);
        if (along_row)
            fill.add(q, p.vertex, row[++i].vertex, p.facing);
        else
            fill.add(q, p.vertex, on_row(++j, p), p.facing);
    }
}
