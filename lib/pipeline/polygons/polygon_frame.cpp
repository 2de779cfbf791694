// SPDX-License-Identifier: MIT
// l3d_polygon_frame: place, cull, clip.
#include "pipeline/polygons/polygon_frame.h"

#include "dice/near_clip.h"
#include "dice/snap.h"
#include "raster/parallel/chunks_p.h"
#include "raster/shapes/scan_edge_p.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using vector = l3d_polygon_view::vector;
using point = l3d_vector<double, 4>;
using l3d_detail::chunks_of;
using l3d_detail::first_centre;
using l3d_detail::for_each_chunk;

point placed(const l3d_matrix<double>& m, const vector& v) {
    point result = m.column(3);
    for (int k = 0; k < 3; ++k)
        result += m.column(k) * v[k];
    return result;
}

/// A direction turned by a placement.
void turn(const l3d_matrix<double>& placement, const l3d_polygon_model::direction& v,
          float (&out)[3]) {
    for (int i = 0; i < 3; ++i)
        out[i] = static_cast<float>(placement(i, 0) * v[0] + placement(i, 1) * v[1] +
                                    placement(i, 2) * v[2]);
}

enum class reach { outside, subpixel, seen };

/// Whether the box of a triangle holds a pixel centre of the window or, if `squares`, reaches into
/// the window at all.
reach reach_of(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c,
               l3d_size size, bool squares) {
    const auto first = [squares](std::int32_t least) {
        return squares ? least >> l3d_subpixel_bits : first_centre(least);
    };
    const auto end = [squares](std::int32_t most) {
        return squares ? (most >> l3d_subpixel_bits) + 1 : first_centre(most);
    };
    const std::int32_t left = first(std::min({a.x, b.x, c.x}));
    const std::int32_t right = end(std::max({a.x, b.x, c.x}));
    const std::int32_t top = first(std::min({a.y, b.y, c.y}));
    const std::int32_t bottom = end(std::max({a.y, b.y, c.y}));
    if (right <= 0 || bottom <= 0 || left >= size.width || top >= size.height)
        return reach::outside;
    return left >= right || top >= bottom ? reach::subpixel : reach::seen;
}

/// In a parallel projection w is 1 everywhere, so near and far cut nothing.
l3d_dice_view window_of(const l3d_polygon_view& view) {
    l3d_dice_view window;
    window.size = view.size();
    window.near = view.is_parallel() ? 0.5 : view.camera().near;
    window.far = view.is_parallel() ? 2.0 : view.camera().far;
    return window;
}

} // namespace

void l3d_polygon_frame::make(const l3d_polygon_model& model, const l3d_polygon_view& view,
                             const way& how, l3d_workers& workers,
                             std::span<const std::size_t> ends) {
    const frame_input in{model, view, window_of(view), how, ends};
    const double middle = placed(view.matrix(), model.centre())[2];
    const double radius = std::max(model.radius(), 1e-300) * (1 + 1e-9);
    depth_step_ = -0.5 / radius;
    depth_base_ = 1.5 - depth_step_ * middle;

    const std::size_t vertices = model.mesh().vertices.size();
    const std::size_t triangles = model.triangles().size();
    vertices_.resize(vertices);
    for_each_chunk(
        workers, vertices, chunk_triangles,
        [&](std::size_t begin, std::size_t end, std::size_t) { place_vertices(in, begin, end); });
    const std::size_t count = ends.empty() ? chunks_of(triangles, chunk_triangles) : ends.size();
    if (chunks_.size() < count)
        chunks_.resize(count);
    workers.for_each(static_cast<int>(count),
                     [&](int i, int) { place_chunk(in, static_cast<std::size_t>(i)); });
    parts_.clear();
    counts_ = {};
    for (std::size_t i = 0; i < count; ++i) {
        parts_.push_back(&chunks_[i].part);
        counts_.add(chunks_[i].counts);
    }
}

void l3d_polygon_frame::place_vertices(const frame_input& in, std::size_t begin, std::size_t end) {
    const bool parallel = in.view.is_parallel();
    for (std::size_t i = begin; i < end; ++i) {
        const point h = placed(in.view.matrix(), in.model.mesh().vertices[i]);
        l3d_micro_vertex& v = vertices_[i];
        v.inv_w = 0;
        if (!l3d_drawable({h[0], h[1], h[3]}, in.window))
            continue;
        const l3d_snapped s = l3d_snap(h[0], h[1], h[3]);
        v.x = s.x + in.window.centre_x();
        v.y = s.y + in.window.centre_y();
        v.inv_w = parallel ? static_cast<float>(depth_value(h[2])) : s.inv_w;
        if (in.how.smooth)
            turn(in.view.placement(), in.model.vertex_normals()[i], v.normal);
    }
}

void l3d_polygon_frame::place_chunk(const frame_input& in, std::size_t index) {
    chunk& to = chunks_[index];
    to.part.triangles.clear();
    to.sides.clear();
    to.counts = {};
    const auto all = in.model.triangles();
    std::size_t begin = index * chunk_triangles;
    std::size_t end = std::min(begin + chunk_triangles, all.size());
    if (!in.ends.empty()) {
        begin = index > 0 ? in.ends[index - 1] : 0;
        end = in.ends[index];
    }
    for (std::size_t t = begin; t < end; ++t) {
        const l3d_model_triangle& triangle = all[t];
        const auto& face = in.model.face_normals()[triangle.face];
        const bool from_behind =
            !(in.view.faces_eye(l3d_converted<double>(face),
                                in.model.mesh().vertices[triangle.corners[0]]) > 0);
        if (in.how.cull && from_behind) {
            ++to.counts.back;
            continue;
        }
        std::array<l3d_micro_vertex, 3> v;
        for (std::size_t k = 0; k < 3; ++k)
            v[k] = vertices_[triangle.corners[k]];
        const bool whole = v[0].inv_w > 0 && v[1].inv_w > 0 && v[2].inv_w > 0;
        if (whole) {
            const reach seen = reach_of(v[0], v[1], v[2], in.view.size(), in.how.squares);
            if (seen != reach::seen) {
                ++(seen == reach::outside ? to.counts.offscreen : to.counts.subpixel);
                continue;
            }
        }
        set_normals(in, t, from_behind, whole, v);
        if (whole) {
            ++to.counts.drawn;
            add(in, triangle, v, to);
            to.sides.push_back(static_cast<std::uint8_t>(triangle.sides));
        } else {
            add_clipped(in, triangle, v, to);
        }
    }
}

/// Those of the face or of its corners (`placed` has those of vertices already if it could be
/// drawn), turned round on the face's other side.
void l3d_polygon_frame::set_normals(const frame_input& in, std::size_t triangle, bool from_behind,
                                    bool placed, std::array<l3d_micro_vertex, 3>& v) const {
    const std::size_t face = in.model.triangles()[triangle].face;
    const bool at_hand = placed && !in.model.has_creases();
    for (std::size_t k = 0; k < v.size(); ++k) {
        if (!in.how.smooth)
            turn(in.view.placement(), in.model.face_normals()[face], v[k].normal);
        else if (!at_hand)
            turn(in.view.placement(), in.model.corner_normal(triangle, k), v[k].normal);
        if (from_behind)
            for (float& component : v[k].normal)
                component = -component;
    }
}

void l3d_polygon_frame::add(const frame_input& in, const l3d_model_triangle& triangle,
                            const std::array<l3d_micro_vertex, 3>& v, chunk& to) {
    if (in.model.materials().empty())
        to.part.triangles.add(v[0], v[1], v[2]);
    else
        to.part.triangles.add(v[0], v[1], v[2], in.model.material_of(triangle.face));
}

/// In a parallel projection, a clipped corner carries its depth as its parameter u.
void l3d_polygon_frame::add_clipped(const frame_input& in, const l3d_model_triangle& triangle,
                                    const std::array<l3d_micro_vertex, 3>& v, chunk& to) const {
    std::array<l3d_clip_vertex, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const point h = placed(in.view.matrix(), in.model.mesh().vertices[triangle.corners[k]]);
        corners[k] = l3d_canonical_vertex({h[0], h[1], h[3]}, in.window);
        corners[k].dice.u = depth_value(h[2]);
        std::ranges::copy(v[k].normal, corners[k].dice.vertex.normal);
    }
    to.clipped.clear();
    to.clipped.keep_parameters = true;
    l3d_clip_triangle(corners[0], corners[1], corners[2], in.window, to.clipped);
    const l3d_micro_triangles& pieces = to.clipped.part.triangles;
    bool seen = false;
    for (std::size_t i = 0; i < pieces.count; ++i) {
        std::array<l3d_micro_vertex, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = pieces.vertex(i, k);
            if (in.view.is_parallel())
                p[k].inv_w = static_cast<float>(to.clipped.triangle_uv[k][i].u);
        }
        if (reach_of(p[0], p[1], p[2], in.view.size(), in.how.squares) != reach::seen)
            continue;
        add(in, triangle, p, to);
        // The pieces are a fan: the first side of the first and the last of the last are outside.
        const bool first = i == 0, last = i + 1 == pieces.count;
        to.sides.push_back(static_cast<std::uint8_t>(first | 2 | last << 2));
        seen = true;
    }
    ++(seen ? to.counts.drawn : to.counts.offscreen);
    to.counts.clipped += seen;
}

void l3d_polygon_frame::list(std::vector<l3d_painter_triangle>& out, l3d_workers& workers) const {
    std::vector<std::size_t> begins{0};
    for (const l3d_surface_part* part : parts_)
        begins.push_back(begins.back() + part->triangles.count);
    out.resize(begins.back());
    workers.for_each(static_cast<int>(parts_.size()), [&](int number, int) {
        const auto c = static_cast<std::size_t>(number);
        const l3d_micro_triangles& triangles = parts_[c]->triangles;
        for (std::size_t i = 0; i < triangles.count; ++i)
            out[begins[c] + i] = {
                {triangles.vertex(i, 0), triangles.vertex(i, 1), triangles.vertex(i, 2)},
                0,
                chunks_[c].sides[i],
                parts_[c]->material_of(i)};
    });
}
