// SPDX-License-Identifier: MIT
// l3d_lane_carpenter_dicer: halves patches until they are flat, and makes polygons of these.
#include "compare/dicers/lane_carpenter_dicer.h"

#include "dice/near_clip.h"
#include "dice/normal_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// The most halvings of a patch, both directions together.
constexpr int deepest = 24;

using point = l3d_vector<double, 3>;

/// A net in the picture, with depths in pixels. In it, 1 / w of a plane is linear, and one pixel of
/// depth changes it by 1 / (focal w).
l3d_bezier_patch<double, 3> in_pixels(const l3d_image_patch& net, const l3d_dice_view& view) {
    const double w = l3d_depth_range_of(net.points).least;
    l3d_bezier_patch<double, 3> result;
    for (std::size_t i = 0; i < net.points.size(); ++i) {
        const l3d_image_point& h = net.points[i];
        result.points[i] = {h[0] / h[2], h[1] / h[2], view.focal * w / h[2]};
    }
    return result;
}

double distance_from_chord(const point& p, const point& a, const point& b) {
    const point along = b - a, there = p - a;
    const double length = l3d_dot(along, along);
    const double t = length > 0 ? std::clamp(l3d_dot(there, along) / length, 0.0, 1.0) : 0;
    return l3d_length(point(there - along * t));
}

double bend_of(const std::array<point, 4>& p) {
    return std::max(distance_from_chord(p[1], p[0], p[3]), distance_from_chord(p[2], p[0], p[3]));
}

/// The largest bend of the net's lines along u, and of those along v.
std::array<double, 2> bends_of(const l3d_bezier_patch<double, 3>& p) {
    std::array<double, 2> result{};
    for (int line = 0; line < 4; ++line) {
        result[0] = std::max(result[0], bend_of(p.row(line).points));
        result[1] = std::max(result[1], bend_of(p.column(line).points));
    }
    return result;
}

} // namespace

bool l3d_is_polygon(const l3d_image_patch& net, const l3d_dice_view& view, double tolerance) {
    const auto p = in_pixels(net, view);
    for (const auto& side : {p.row(0), p.row(3), p.column(0), p.column(3)})
        if (bend_of(side.points) > tolerance)
            return false;
    // For a quad without area, straight sides decide alone, since the diagonals define no plane.
    const point across =
        l3d_cross<double>(point(p.at(3, 3) - p.at(0, 0)), point(p.at(3, 0) - p.at(0, 3)));
    const double size = l3d_length(across);
    if (!(size > 0))
        return bends_of(p)[0] <= tolerance && bends_of(p)[1] <= tolerance;
    const point middle = (p.at(0, 0) + p.at(0, 3) + p.at(3, 0) + p.at(3, 3)) * 0.25;
    return std::all_of(p.points.begin(), p.points.end(), [&](const point& each) {
        return std::abs(l3d_dot(point(each - middle), across)) <= tolerance * size;
    });
}

void l3d_lane_carpenter_dicer::dice(const l3d_image_patch& net, const l3d_normal_net& normals,
                                    const l3d_dice_view& view, l3d_piece_pool& out,
                                    l3d_dice_counts& counts) {
    task of{normals, view, out.next(), counts};
    of.out.bound = counts.bound_px = std::numeric_limits<double>::infinity();
    divide({net}, of);
}

void l3d_lane_carpenter_dicer::divide(const l3d_patch_part& p, task& of) {
    if (l3d_image_box_of(p.net.points).intersected(of.view.margin()).empty())
        return;
    if (p.depth < deepest && !l3d_is_polygon(p.net, of.view, of.view.tolerance)) {
        const auto [along_u, along_v] = bends_of(in_pixels(p.net, of.view));
        const bool cuts_u = along_u != along_v ? along_u > along_v : p.depth % 2 == 0;
        for (const l3d_patch_part& half : l3d_halves(p, cuts_u))
            divide(half, of);
        return;
    }
    std::array<l3d_dice_vertex, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const bool high_u = i % 2 == 1, high_v = i / 2 == 1;
        corners[i] = l3d_canonical_vertex(p.net.at(high_v ? 3 : 0, high_u ? 3 : 0), of.view).dice;
        corners[i].u = high_u ? p.u1 : p.u0;
        corners[i].v = high_v ? p.v1 : p.v0;
        const auto normal = l3d_unit_normal(of.normals.evaluate(corners[i].u, corners[i].v));
        std::copy(normal.begin(), normal.end(), corners[i].vertex.normal);
    }
    of.counts.samples += 4;
    ++of.counts.pieces;
    of.out.add_triangle(corners[0], corners[1], corners[3]);
    of.out.add_triangle(corners[0], corners[3], corners[2]);
}
