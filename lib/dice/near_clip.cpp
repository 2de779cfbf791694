// SPDX-License-Identifier: MIT
// Clipping against near plane, far plane and guard band, in homogeneous coordinates.
#include "dice/near_clip.h"

#include "dice/grid_light.h"

#include "dice/snap.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace {

/// A triangle cut by six planes has at most nine corners. Rounding can make a needle turn back and
/// forth across a plane: of such, which cover nothing, corners too many are dropped.
struct polygon {
    std::array<l3d_clip_vertex, 9> corners;
    std::size_t count = 0;

    void add(const l3d_clip_vertex& v) {
        if (count < corners.size())
            corners[count++] = v;
    }
};

/// A half-space n.h >= d of homogeneous points.
struct plane {
    l3d_image_point normal;
    double offset = 0;

    double distance(const l3d_image_point& h) const { return l3d_dot(normal, h) - offset; }
};

bool before(const l3d_image_point& a, const l3d_image_point& b) {
    for (int i = 0; i < 3; ++i)
        if (a[i] != b[i])
            return a[i] < b[i];
    return false;
}

/// The point of edge a b on the plane, the same for b a.
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
            out.add(a);
        if (a_inside != b_inside)
            out.add(crossing(a, b, cut, view));
    }
    return out;
}

/// Gives a point that can be drawn its pixel position.
void project(l3d_clip_vertex& v, const l3d_dice_view& view) {
    const l3d_snapped s = l3d_snap(v.h[0], v.h[1], v.h[2]);
    v.dice.vertex.x = s.x + view.centre_x();
    v.dice.vertex.y = s.y + view.centre_y();
    v.dice.vertex.inv_w = s.inv_w * static_cast<float>(view.depth_scale);
    v.drawable = true;
}

} // namespace

bool l3d_drawable(const l3d_image_point& h, const l3d_dice_view& view) {
    const double reach = l3d_guard_band * h[2];
    return h[2] > view.near && h[2] < view.far && h[0] >= -reach && h[0] <= reach &&
           h[1] >= -reach && h[1] <= reach;
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
    // What lies in the near or the far plane is not drawn. Slits in it would have long chords, as
    // edges there are left out.
    const auto [nearest, farthest] = std::minmax({a.h[2], b.h[2], c.h[2]});
    if (farthest <= view.near || nearest >= view.far)
        return;
    const double g = l3d_guard_band;
    const std::array<plane, 6> planes{{{{0, 0, 1}, view.near},
                                       {{0, 0, -1}, -view.far},
                                       {{1, 0, g}, 0},
                                       {{-1, 0, g}, 0},
                                       {{0, 1, g}, 0},
                                       {{0, -1, g}, 0}}};
    polygon shape;
    for (const auto* corner : {&a, &b, &c})
        shape.add(*corner);
    for (const plane& cut : planes) {
        shape = cut_by(shape, cut, view);
        if (shape.count < 3)
            return;
    }
    for (std::size_t i = 0; i < shape.count; ++i)
        if (!shape.corners[i].drawable)
            project(shape.corners[i], view);
    for (std::size_t i = 2; i < shape.count; ++i)
        out.add_triangle(shape.corners[0].dice, shape.corners[i - 1].dice, shape.corners[i].dice);
}
