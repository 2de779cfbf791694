// SPDX-License-Identifier: MIT
// l3d_polygon_frame: places, culls and clips triangles.
#include "pipeline/polygons/polygon_frame.h"

#include "dice/near_clip.h"
#include "raster/parallel/chunks_p.h"
#include "raster/shapes/scan_edge_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace {

using vector = l3d_polygon_view::vector;
using homogeneous = l3d_vector<double, 4>;
using namespace l3d_detail;

homogeneous placed(const l3d_matrix<double>& m, const vector& v) {
    homogeneous result = m.column(3);
    for (int k = 0; k < 3; ++k)
        result += m.column(k) * v[k];
    return result;
}

/// A direction in the model, turned into the world by a placement.
std::array<float, 3> turned(const l3d_matrix<double>& placement,
                            const l3d_polygon_model::direction& v) {
    std::array<float, 3> result;
    for (int i = 0; i < 3; ++i)
        result[static_cast<std::size_t>(i)] = static_cast<float>(
            placement(i, 0) * v[0] + placement(i, 1) * v[1] + placement(i, 2) * v[2]);
    return result;
}

/// Copies a normal, and reverses the copy if `sign` is the sign bit. The code has no branch, since
/// the processor could not predict a branch.
void turn_round(const placed_vertices::normal& normal, std::uint32_t sign, float* to) {
    for (std::size_t c = 0; c < 3; ++c)
        to[c] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(normal[c]) ^ sign);
}

/// Whether the box of a triangle holds a pixel centre of the window or, if `squares`, reaches into
/// the window at all. It is used for pieces of clipped triangles; choose_triangles tests whole
/// triangles in the same way.
bool may_be_seen(const l3d_micro_vertex& a, const l3d_micro_vertex& b, const l3d_micro_vertex& c,
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
    return std::max(left, 0) < std::min(right, size.width) &&
           std::max(top, 0) < std::min(bottom, size.height);
}

/// The window that triangles are clipped to. In a parallel projection w is 1 everywhere, so the
/// near and far planes cut nothing.
l3d_dice_view window_of(const l3d_polygon_view& view) {
    l3d_dice_view window;
    window.size = view.size();
    window.near = view.is_parallel() ? 0.5 : view.camera().near_z;
    window.far = view.is_parallel() ? 2.0 : view.camera().far_z;
    return window;
}

} // namespace

void l3d_polygon_frame::make(const l3d_polygon_model& model, const l3d_polygon_view& view,
                             const way& how, l3d_workers& workers,
                             std::span<const std::size_t> ends) {
    const std::size_t triangles = model.triangles().size();
    constexpr std::size_t in_block = l3d_facing_block::triangles; // chunks are of whole blocks
    const std::size_t in_chunk =
        std::clamp(triangles / chunks_wanted / in_block * in_block, least_chunk, most_chunk);
    const bool may_hide = how.cull_hidden && !how.cull;
    if (how.antialias || may_hide)
        neighbours_.make(model);
    frame_input& in =
        input_.emplace(frame_input{model, view, window_of(view), how, ends, in_chunk});
    in.how.cull = how.cull || (may_hide && hides_backs(model, view));
    depths_ = view.depths(model.centre(), model.radius());

    const std::size_t vertices = model.mesh().vertices.size();
    const bool of_vertices = has_vertex_normals(in);
    const vertex_placing placing{view, in.window, depths_};
    vertices_.places.resize(vertices);
    if (of_vertices)
        vertices_.normals.resize(vertices);
    for_each_chunk(workers, vertices, in_chunk,
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                       place_vertices(placing, model.mesh().vertices,
                                      of_vertices ? model.vertex_normals()
                                                  : std::span<const l3d_polygon_model::direction>(),
                                      begin, end, vertices_);
                   });
    const std::size_t count = ends.empty() ? chunks_of(triangles, in_chunk) : ends.size();
    if (chunks_.size() < count)
        chunks_.resize(count);
    if (how.antialias)
        turns_.assign(triangles, turn::not_drawn);
    workers.for_each_beside(static_cast<int>(count),
                            [&](int i, int) { place_chunk(in, static_cast<std::size_t>(i)); });
    if (how.antialias)
        workers.for_each(static_cast<int>(count),
                         [&](int i, int) { make_border(chunks_[static_cast<std::size_t>(i)]); });
    count_ = count;
    parts_.clear();
    counts_ = {};
    for (std::size_t i = 0; i < count; ++i) {
        if (how.parts)
            parts_.push_back(&chunks_[i].part);
        counts_.add(chunks_[i].counts);
    }
}

/// Whether no face can be seen from behind, since fronts hide all such faces. The near plane may
/// open a closed body and show its inside, so the ball around the model must lie beyond this plane.
bool l3d_polygon_frame::hides_backs(const l3d_polygon_model& model,
                                    const l3d_polygon_view& view) const {
    const double nearest = placed(view.matrix(), model.centre())[2] - model.radius() * (1 + 1e-9);
    return neighbours_.are_closed() && (view.is_parallel() || nearest > view.camera().near_z);
}

void l3d_polygon_frame::place_chunk(const frame_input& in, std::size_t index) {
    chunk& to = chunks_[index];
    to.part.triangles.clear();
    to.part.border.clear();
    to.part.material = in.how.first_material;
    to.names.clear();
    to.signs.clear();
    to.pieces.clear();
    to.counts = {};
    const auto all = in.model.triangles();
    std::size_t begin = index * in.in_chunk;
    std::size_t end = std::min(begin + in.in_chunk, all.size());
    if (!in.ends.empty()) {
        begin = index > 0 ? in.ends[index - 1] : 0;
        end = in.ends[index];
    }
    const triangle_choice choice{in.model, in.view, vertices_.places, in.how.cull,
                                 in.how.antialias};
    chosen_triangles chosen;
    for (std::size_t t = begin; t < end;) {
        t = choose_triangles(choice, t, end, chosen, to.counts);
        add_whole(in, chosen, to);
        if (chosen.clipped)
            add_clipped(in, chosen.triangle[chosen.count - 1], chosen.sign[chosen.count - 1], to);
    }
}

/// Adds the chosen triangles to a chunk, except the last one if it must be clipped.
void l3d_polygon_frame::add_whole(const frame_input& in, const chosen_triangles& chosen,
                                  chunk& to) {
    const std::size_t count = chosen.count - (chosen.clipped ? 1 : 0);
    const auto last = static_cast<std::ptrdiff_t>(count);
    to.names.insert(to.names.end(), chosen.triangle.begin(), chosen.triangle.begin() + last);
    to.signs.insert(to.signs.end(), chosen.sign.begin(), chosen.sign.begin() + last);
    to.counts.drawn += last;
    if (in.how.parts && count > 0)
        add_to_part(in, chosen, count, to.part.triangles);
    if (in.how.antialias)
        note_turns(count, to);
}

void l3d_polygon_frame::add_to_part(const frame_input& in, const chosen_triangles& chosen,
                                    std::size_t count, l3d_micro_triangles& triangles) const {
    const bool of_vertices = has_vertex_normals(in), of_materials = !in.model.materials().empty();
    const std::size_t first = triangles.count;
    add_triangles(in.model.triangles(), vertices_, of_vertices, chosen, count, triangles);
    if (of_vertices && !of_materials)
        return;
    for (std::size_t i = 0; i < count; ++i) {
        if (of_materials)
            triangles.materials.push_back(material_of(in, chosen.triangle[i]));
        if (of_vertices)
            continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const normal n = normal_of(in, chosen.triangle[i], k, chosen.sign[i] != 0);
            l3d_micro_triangles::corner& corner = triangles.corners(first + i, k);
            for (std::size_t c = 0; c < n.size(); ++c)
                corner.normal[c][(first + i) % l3d_micro_triangles::lanes] = n[c];
        }
    }
}

/// Notes in turns_ the directions in which the corners of the part's last `count` triangles go
/// round in the picture.
void l3d_polygon_frame::note_turns(std::size_t count, const chunk& of) {
    const l3d_micro_triangles& all = of.part.triangles;
    for (std::size_t i = all.count - count; i < all.count; ++i) {
        const std::int64_t twice_area = all.double_area(i);
        turns_[of.names[i]] = twice_area > 0   ? turn::right
                              : twice_area < 0 ? turn::left
                                               : turn::none;
    }
}

/// Notes, as the part's border, the sides of triangles beyond which no triangle's corners go round
/// in the same direction: at such sides the surface may end or fold over. A triangle that covers
/// nothing adds no sides, since its neighbours do.
void l3d_polygon_frame::make_border(chunk& of) const {
    const l3d_micro_triangles& all = of.part.triangles;
    for (std::size_t i = 0; i < all.count; ++i) {
        const std::uint32_t name = of.names[i];
        const turn here = turns_[name];
        if (here == turn::none)
            continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t other = neighbours_.across(name, k);
            if (here != turn::clipped && other != triangle_neighbours::none &&
                turns_[other] == here)
                continue;
            const l3d_micro_vertex from = all.vertex(i, k), to = all.vertex(i, (k + 1) % 3);
            l3d_border_edge edge = l3d_border_edge::between(from, to);
            edge.column = static_cast<int>(i);
            edge.side = static_cast<int>(k);
            of.part.border.push_back(edge);
        }
    }
}

/// The normal of a triangle's face or, if shades are smooth, of its corner. It is reversed if the
/// face is seen from behind.
l3d_polygon_frame::normal l3d_polygon_frame::normal_of(const frame_input& in, std::size_t triangle,
                                                       std::size_t corner, bool from_behind) {
    const auto& of = in.how.smooth ? in.model.corner_normal(triangle, corner)
                                   : in.model.face_normals()[in.model.triangles()[triangle].face];
    normal result = turned(in.view.placement(), of);
    if (from_behind)
        for (float& component : result)
            component = -component;
    return result;
}

void l3d_polygon_frame::add_piece(const frame_input& in, std::size_t number,
                                  const std::array<l3d_micro_vertex, 3>& v, std::uint32_t sides,
                                  chunk& to) {
    const std::uint32_t material = material_of(in, number);
    to.pieces.push_back({v, sides, material});
    to.names.push_back(static_cast<std::uint32_t>(number));
    to.signs.push_back(static_cast<std::uint32_t>(to.pieces.size()));
    if (!in.how.parts)
        return;
    if (in.model.materials().empty())
        to.part.triangles.add(v[0], v[1], v[2]);
    else
        to.part.triangles.add(v[0], v[1], v[2], material);
}

/// Clips a triangle and adds its pieces to a chunk. In a parallel projection, a clipped corner
/// carries its depth in place of its parameter u.
void l3d_polygon_frame::add_clipped(const frame_input& in, std::size_t number, bool from_behind,
                                    chunk& to) {
    const l3d_model_triangle& triangle = in.model.triangles()[number];
    std::array<l3d_clip_vertex, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const homogeneous h =
            placed(in.view.matrix(), in.model.mesh().vertices[triangle.corners[k]]);
        corners[k] = l3d_canonical_vertex({h[0], h[1], h[3]}, in.window);
        corners[k].dice.u = depths_.at(h[2], h[3]);
        std::ranges::copy(normal_of(in, number, k, from_behind), corners[k].dice.vertex.normal);
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
        if (!may_be_seen(p[0], p[1], p[2], in.view.size(), in.how.antialias))
            continue;
        // The pieces are a fan. Its border consists of the middle side of each piece, the first
        // side of the first piece, and the last side of the last piece.
        const bool first = i == 0, last = i + 1 == pieces.count;
        add_piece(in, number, p, static_cast<std::uint32_t>(first | 2 | last << 2), to);
        seen = true;
    }
    if (seen && in.how.antialias)
        turns_[number] = turn::clipped;
    ++(seen ? to.counts.drawn : to.counts.offscreen);
    to.counts.clipped += seen;
}

std::vector<std::size_t> l3d_polygon_frame::ends() const {
    std::vector<std::size_t> ends;
    std::size_t end = 0;
    for (std::size_t part = 0; part < count_; ++part)
        ends.push_back(end += chunks_[part].names.size());
    return ends;
}

void l3d_polygon_frame::list(std::vector<l3d_painter_triangle>& out, l3d_workers& workers) const {
    const std::vector<std::size_t> part_ends = ends();
    out.resize(part_ends.empty() ? 0 : part_ends.back());
    workers.for_each(static_cast<int>(part_ends.size()), [&](int number, int) {
        const auto part = static_cast<std::size_t>(number);
        const std::size_t count = chunks_[part].names.size();
        list_part(part, std::span(out).subspan(part_ends[part] - count, count));
    });
}

void l3d_polygon_frame::list_part(std::size_t part, std::span<l3d_painter_triangle> out) const {
    const chunk& of = chunks_[part];
    const frame_input& in = *input_;
    const bool of_vertices = has_vertex_normals(in);
    const std::span<const l3d_model_triangle> triangles = in.model.triangles();
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::uint32_t sign = of.signs[i];
        if (sign != 0 && sign != chosen_triangles::from_behind) {
            out[i] = of.pieces[sign - 1];
            continue;
        }
        const l3d_model_triangle& triangle = triangles[of.names[i]];
        l3d_painter_triangle& to = out[i];
        for (std::size_t k = 0; k < 3; ++k) {
            const placed_vertices::place& place = vertices_.places[triangle.corners[k]];
            to.v[k].x = place[0];
            to.v[k].y = place[1];
            to.v[k].inv_w = std::bit_cast<float>(place[2]);
            if (of_vertices)
                turn_round(vertices_.normals[triangle.corners[k]], sign, to.v[k].normal);
            else
                std::ranges::copy(normal_of(in, of.names[i], k, sign != 0), to.v[k].normal);
        }
        to.sides = triangle.sides;
        to.material = material_of(in, of.names[i]);
    }
}
