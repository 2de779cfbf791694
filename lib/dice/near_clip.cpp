// SPDX-License-Identifier: MIT
// Clips in homogeneous coordinates: by the near and the far plane, a section and the guard band.
#include "dice/near_clip.h"

#include "dice/grid_light.h"

#include "dice/snap.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace {

/// A clipped triangle. Each of seven planes adds at most one corner, so it has at most ten corners.
/// Rounding can make a needle cross a plane back and forth. A needle covers nothing, so its excess
/// corners are dropped.
struct polygon {
    std::array<l3d_clip_vertex, 10> corners;
    std::array<bool, 10> is_cut{}; ///< whether a plane made the side from a corner to the next
    std::size_t count = 0;

    void add(const l3d_clip_vertex& v, bool cut) {
        if (count == corners.size())
            return;
        is_cut[count] = cut;
        corners[count++] = v;
    }
};

/// A plane that clips: it leaves the half-space n.h >= d of homogeneous points.
struct plane {
    l3d_image_point normal;
    double offset = 0;
    bool makes_border = false; ///< whether the plane may cut inside of the picture

    double distance(const l3d_image_point& h) const { return l3d_dot(normal, h) - offset; }
};

bool before(const l3d_image_point& a, const l3d_image_point& b) {
    for (int i = 0; i < 3; ++i)
        if (a[i] != b[i])
            return a[i] < b[i];
    return false;
}

/// Finds the point where the edge from a to b crosses the plane. The result for the edge from b to
/// a is the same, bit for bit.
l3d_clip_vertex crossing(const l3d_clip_vertex& a, const l3d_clip_vertex& b, const plane& cut,
                         const l3d_dice_view& view) {
    if (before(b.h, a.h))
        return crossing(b, a, cut, view);
    const double da = cut.distance(a.h), db = cut.distance(b.h);
    const double t = da / (da - db);
    l3d_clip_vertex result;
    result.h = a.h + (b.h - a.h) * t;
    result.dice.u = a.dice.u + (b.dice.u - a.dice.u) * t;
    result.dice.v = a.dice.v + (b.dice.v - a.dice.v) * t;
    const auto s = static_cast<float>(t);
    for (int i = 0; i < 3; ++i)
        result.dice.vertex.normal[i] =
            a.dice.vertex.normal[i] * (1 - s) + b.dice.vertex.normal[i] * s;
    if (!view.makes_levels())
        l3d_make_unit(result.dice.vertex.normal);
    return result;
}

polygon cut_by(const polygon& in, const plane& cut, const l3d_dice_view& view) {
    polygon out;
    for (std::size_t i = 0; i < in.count; ++i) {
        const l3d_clip_vertex& a = in.corners[i];
        const l3d_clip_vertex& b = in.corners[(i + 1) % in.count];
        const bool a_inside = cut.distance(a.h) >= 0, b_inside = cut.distance(b.h) >= 0;
        if (a_inside)
            out.add(a, in.is_cut[i]);
        if (a_inside != b_inside)
            out.add(crossing(a, b, cut, view), a_inside ? cut.makes_border : in.is_cut[i]);
    }
    return out;
}

/// The planes that bound drawable points: near, far, section and guard band.
std::array<plane, 7> planes_of(const l3d_dice_view& view) {
    const double g = l3d_guard_band;
    return {{{{0, 0, 1}, view.near, true},
             {{0, 0, -1}, -view.far, true},
             {view.section.normal, -view.section.d, true},
             {{1, 0, g}, 0},
             {{-1, 0, g}, 0},
             {{0, 1, g}, 0},
             {{0, -1, g}, 0}}};
}

/// Sets the place and depth in the picture of a drawable point.
void project(l3d_clip_vertex& v, const l3d_dice_view& view) {
    const l3d_snapped s = l3d_snap(v.h[0], v.h[1], v.h[2]);
    v.dice.vertex.x = s.x + view.centre_x();
    v.dice.vertex.y = s.y + view.centre_y();
    v.dice.vertex.inv_w = view.depth_at(v.h[2]);
    v.drawable = true;
}

/// Planes made some sides of a clipped polygon. This function notes these sides as borders of
/// out.part. The polygon's triangles begin at index `first` of the part's triangles.
void note_cuts(const polygon& shape, std::size_t first, l3d_diced_piece& out) {
    for (std::size_t i = 0; i < shape.count; ++i) {
        if (!shape.is_cut[i])
            continue;
        const l3d_micro_vertex& a = shape.corners[i].dice.vertex;
        const l3d_micro_vertex& b = shape.corners[(i + 1) % shape.count].dice.vertex;
        const std::size_t triangle = first + std::clamp<std::size_t>(i, 1, shape.count - 2) - 1;
        out.part.border.push_back({.from_x = a.x,
                                   .from_y = a.y,
                                   .to_x = b.x,
                                   .to_y = b.y,
                                   .from_inv_w = a.inv_w,
                                   .to_inv_w = b.inv_w,
                                   .level = std::numeric_limits<float>::quiet_NaN(),
                                   .column = static_cast<int>(triangle),
                                   .always = true});
    }
}

} // namespace

bool l3d_drawable(const l3d_image_point& h, const l3d_dice_view& view) {
    const double reach = l3d_guard_band * h[2];
    return h[2] > view.near && h[2] < view.far && h[0] >= -reach && h[0] <= reach &&
           h[1] >= -reach && h[1] <= reach && view.section.distance(h) >= 0;
}

l3d_clip_vertex l3d_canonical_vertex(const l3d_image_point& h, const l3d_dice_view& view) {
    l3d_clip_vertex result;
    result.h = h;
    if (l3d_drawable(h, view))
        project(result, view);
    return result;
}

void l3d_clip_triangle(const l3d_clip_vertex& a, const l3d_clip_vertex& b, const l3d_clip_vertex& c,
                       const l3d_dice_view& view, l3d_diced_piece& out) {
    if (a.drawable && b.drawable && c.drawable)
        return out.add_triangle(a.dice, b.dice, c.dice);
    // Triangles wholly in or beyond the near plane, the far plane or a section are not drawn. Edges
    // in such a plane are left out, so slits there would have long chords.
    const auto [nearest, farthest] = std::minmax({a.h[2], b.h[2], c.h[2]});
    if (farthest <= view.near || nearest >= view.far ||
        view.section.cuts_off(std::array{a.h, b.h, c.h}))
        return;
    polygon shape;
    for (const auto* corner : {&a, &b, &c})
        shape.add(*corner, false);
    for (const plane& cut : planes_of(view)) {
        shape = cut_by(shape, cut, view);
        if (shape.count < 3)
            return;
    }
    for (std::size_t i = 0; i < shape.count; ++i)
        if (!shape.corners[i].drawable)
            project(shape.corners[i], view);
    if (view.shading.antialias && out.part.grid.rows == 0)
        note_cuts(shape, out.part.triangles.count, out);
    for (std::size_t i = 2; i < shape.count; ++i)
        out.add_triangle(shape.corners[0].dice, shape.corners[i - 1].dice, shape.corners[i].dice);
}

bool l3d_clip_segment(l3d_clip_vertex& a, l3d_clip_vertex& b, const l3d_dice_view& view) {
    if (a.drawable && b.drawable)
        return true;
    for (const plane& cut : planes_of(view)) {
        const bool a_inside = cut.distance(a.h) >= 0, b_inside = cut.distance(b.h) >= 0;
        if (!a_inside && !b_inside)
            return false;
        if (a_inside != b_inside)
            (a_inside ? b : a) = crossing(a, b, cut, view);
    }
    for (l3d_clip_vertex* end : {&a, &b})
        if (!end->drawable)
            project(*end, view);
    return true;
}
