// SPDX-License-Identifier: MIT
// l3d_polygon_wires: clips by Cohen and Sutherland's algorithm in homogeneous coordinates.
#include "pipeline/polygons/polygon_wires.h"

#include "scene/dice_view.h"
#include "dice/snap.h"

#include <array>
#include <cstddef>

namespace {

/// A clipping plane, whose inner side is n . (x, y, w) >= d. Points that are drawn lie inside all
/// six planes.
struct clip_plane {
    double x, y, w, d;
};
using clip_planes = std::array<clip_plane, 6>;

/// A place (x, y, d, w), as l3d_polygon_view::matrix makes it.
struct homogeneous {
    double x, y, d, w;
};

double inside(const clip_plane& plane, const homogeneous& h) {
    return plane.x * h.x + plane.y * h.y + plane.w * h.w - plane.d;
}

std::uint8_t outcode(const clip_planes& planes, const homogeneous& h) {
    unsigned code = 0;
    for (std::size_t i = 0; i < planes.size(); ++i)
        code |= static_cast<unsigned>(!(inside(planes[i], h) >= 0)) << i;
    return static_cast<std::uint8_t>(code);
}

/// Clips the line from a to b at plane after plane. Returns false if nothing is left. `code_a` has
/// a bit for each plane that a is outside of, and `code_b` likewise for b. A plane cuts off at most
/// one end; the new end's code is computed again.
/// Source:  Cohen and Sutherland, in Newman, Sproull: Principles of Interactive Computer Graphics.
bool clip(const clip_planes& planes, homogeneous& a, homogeneous& b, unsigned code_a,
          unsigned code_b) {
    for (std::size_t i = 0; i < planes.size() && (code_a | code_b) != 0; ++i) {
        if ((code_a & code_b) != 0)
            return false;
        if (!((code_a | code_b) >> i & 1))
            continue;
        const double at_a = inside(planes[i], a), at_b = inside(planes[i], b);
        const double t = at_a / (at_a - at_b);
        const homogeneous cut{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.d + t * (b.d - a.d),
                              a.w + t * (b.w - a.w)};
        // Planes done: rounding may leave the cut outside of one.
        const unsigned done = ~((2u << i) - 1);
        if (code_a >> i & 1) {
            a = cut;
            code_a = outcode(planes, a) & done;
        } else {
            b = cut;
            code_b = outcode(planes, b) & done;
        }
    }
    return (code_a & code_b) == 0;
}

/// The line between two points, rounded as the corners of filled faces are.
l3d_detail::wire line_of(const homogeneous& a, const homogeneous& b, l3d_size size,
                         const l3d_view_depths& depths) {
    const l3d_snapped from = l3d_snap(a.x, a.y, a.w), to = l3d_snap(b.x, b.y, b.w);
    const std::int32_t x = size.width * (l3d_subpixel_one / 2);
    const std::int32_t y = size.height * (l3d_subpixel_one / 2);
    return {from.x + x,
            from.y + y,
            to.x + x,
            to.y + y,
            static_cast<float>(depths.at(a.d, a.w)),
            static_cast<float>(depths.at(b.d, b.w))};
}

} // namespace

std::span<const l3d_detail::wire> l3d_polygon_wires::make(const l3d_polygon_model& model,
                                                          const l3d_polygon_view& view, bool cull) {
    const double g = l3d_guard_band;
    const double near = view.is_parallel() ? 0.5 : view.camera().near_z;
    const double far = view.is_parallel() ? 2.0 : view.camera().far_z;
    const clip_planes planes{{{0, 0, 1, near},
                              {0, 0, -1, -far},
                              {1, 0, g, 0},
                              {-1, 0, g, 0},
                              {0, 1, g, 0},
                              {0, -1, g, 0}}};
    places_.clear();
    for (const auto& v : model.mesh().vertices) {
        const auto h = view.matrix() * l3d_vector<double, 4>(v[0], v[1], v[2], 1.0);
        places_.push_back({h[0], h[1], h[2], h[3], outcode(planes, {h[0], h[1], h[2], h[3]})});
    }
    const l3d_view_depths depths = view.depths(model.centre(), model.radius());
    neighbours_.make(model);
    const std::span<const l3d_model_triangle> triangles = model.triangles();
    seen_.clear();
    for (const l3d_model_triangle& triangle : triangles)
        seen_.push_back(!cull ||
                        view.faces_eye(l3d_converted<double>(model.face_normals()[triangle.face]),
                                       model.mesh().vertices[triangle.corners[0]]) > 0);
    lines_.clear();
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            if (!seen_[i] || !(triangles[i].sides >> k & 1) || is_of_one_before(model, i, k))
                continue;
            const place &from = places_[triangles[i].corners[k]],
                        &to = places_[triangles[i].corners[(k + 1) % 3]];
            homogeneous a{from.x, from.y, from.d, from.w}, b{to.x, to.y, to.d, to.w};
            if (clip(planes, a, b, from.outside, to.outside))
                lines_.push_back(line_of(a, b, view.size(), depths));
        }
    return lines_;
}

/// Whether an earlier triangle of the model has drawn this side already.
bool l3d_polygon_wires::is_of_one_before(const l3d_polygon_model& model, std::size_t triangle,
                                         std::size_t side) const {
    const std::uint32_t other = neighbours_.across(triangle, side);
    if (other == l3d_detail::triangle_neighbours::none || other >= triangle || !seen_[other])
        return false;
    for (std::size_t k = 0; k < 3; ++k)
        if (neighbours_.across(other, k) == triangle && (model.triangles()[other].sides >> k & 1))
            return true;
    return false;
}
