// SPDX-License-Identifier: MIT
// l3d_piece_drawer: walking, evaluating, clipping.
#include "pipeline/piece_drawer.h"

#include "pipeline/snap.h"

#include <algorithm>
#include <cstddef>

namespace {

/// Calls visit(column, u-strip, local u) for each column; the last lies at the last strip's end.
template <class Visit> void for_columns(const l3d_step_plan& plan, Visit visit) {
    std::size_t column = 0;
    for (int a = 0; a < plan.strips; ++a) {
        const int n = plan.nu[static_cast<std::size_t>(a)];
        for (int i = 0; i < n; ++i)
            visit(column++, static_cast<std::size_t>(a), static_cast<double>(i) / n);
    }
    visit(column, static_cast<std::size_t>(plan.strips - 1), 1.0);
}

int sign(auto value) {
    return (value > 0) - (value < 0);
}

} // namespace

template <class T>
void l3d_piece_drawer<T>::begin(const l3d_dice_view& view, const l3d_normal_net& normals,
                                l3d_dice_sink& sink) {
    view_ = view;
    normals_ = &normals;
    sink_ = &sink;
}

template <class T>
void l3d_piece_drawer<T>::draw(const piece& p, const l3d_piece_nets<T>& nets,
                               const l3d_step_plan& plan, double bound, double frame_bound,
                               std::span<const l3d_edge_polyline> edges) {
    fill_parameters(p, plan);
    triangles_.clear();
    if (nets.whole()) {
        grid_.resize(columns(), rows());
        if (nets.walked()) {
            walk_rows(nets, plan);
        } else {
            evaluate_grid(nets, plan);
            copy_evaluated();
        }
        set_grid_corners(p);
        sink_->grid({grid_, u_, v_, bound});
        fill_slits(
            p, edges, [&](int r, int c) { return grid_vertex(p, r, c); },
            [&](int r, int c) { return grid_facing(r, c); });
    } else {
        evaluate_grid(nets, plan);
        set_clip_corners(p);
        add_clipped_quads();
        fill_slits(
            p, edges, [&](int r, int c) { return clip_vertex(r, c); },
            [&](int r, int c) { return clip_facing(r, c); });
    }
    hand_over_triangles(frame_bound);
}

template <class T> void l3d_piece_drawer<T>::hand_over_triangles(double bound) {
    if (!triangles_.empty())
        sink_->triangles(triangles_, bound);
}

template <class T>
void l3d_piece_drawer<T>::fill_parameters(const piece& p, const l3d_step_plan& plan) {
    const auto fill = [&](std::vector<double>& out, const auto& steps, double low, double high) {
        out.clear();
        for (int s = 0; s < plan.strips; ++s) {
            const int n = steps[static_cast<std::size_t>(s)];
            for (int i = 0; i < n; ++i)
                out.push_back(low + (high - low) * (s + static_cast<double>(i) / n) / plan.strips);
        }
        out.push_back(high);
    };
    fill(u_, plan.nu, p.u0, p.u1);
    fill(v_, plan.nv, p.v0, p.v1);
    normal_columns_.resize(u_.size());
    for (std::size_t c = 0; c < u_.size(); ++c)
        normal_columns_.set(c, *normals_, u_[c]);
}

template <class T>
void l3d_piece_drawer<T>::walk_rows(const l3d_piece_nets<T>& nets, const l3d_step_plan& plan) {
    const auto strips = static_cast<std::size_t>(plan.strips);
    walker_.resize(u_.size());
    int row = 0;
    const auto emit = [&] {
        const std::size_t at = grid_.index(row, 0);
        walker_.emit(view_, &grid_.x[at], &grid_.y[at], &grid_.inv_w[at]);
        normal_columns_.emit(v_[static_cast<std::size_t>(row)], &grid_.normal[0][at],
                             &grid_.normal[1][at], &grid_.normal[2][at]);
        ++row;
    };
    for (std::size_t b = 0; b < strips; ++b) {
        const int n = plan.nv[b];
        for_columns(plan, [&](std::size_t c, std::size_t a, double u) {
            walker_.start(
                c, nets.wide_blocks()[strips * b + a].curve_at_u(l3d_from_double<wide>(u)), n);
        });
        for (int i = 0; i < n; ++i) {
            emit();
            walker_.step();
        }
    }
    for_columns(plan, [&](std::size_t c, std::size_t a, double u) {
        const auto last = nets.wide_blocks()[strips * (strips - 1) + a].row(3);
        walker_.place(c, last.evaluate(l3d_from_double<wide>(u)));
    });
    emit();
}

/// Every vertex by itself, as it may lie anywhere, even behind the eye.
template <class T>
void l3d_piece_drawer<T>::evaluate_grid(const l3d_piece_nets<T>& nets, const l3d_step_plan& plan) {
    const std::size_t columns = u_.size();
    clip_grid_.resize(columns * v_.size());
    for (auto& component : normal_row_)
        component.resize(columns);
    const auto strips = static_cast<std::size_t>(plan.strips);
    std::size_t row = 0;
    const auto emit = [&](std::size_t strip, double v) {
        normal_columns_.emit(v_[row], normal_row_[0].data(), normal_row_[1].data(),
                             normal_row_[2].data());
        for_columns(plan, [&](std::size_t c, std::size_t a, double u) {
            l3d_clip_vertex& vertex = clip_grid_[row * columns + c];
            vertex = l3d_canonical_vertex<double>(nets.blocks()[strips * strip + a].evaluate(u, v),
                                                  view_);
            vertex.dice.u = u_[c];
            vertex.dice.v = v_[row];
            for (std::size_t k = 0; k < 3; ++k)
                vertex.dice.vertex.normal[k] = normal_row_[k][c];
        });
        ++row;
    };
    for (std::size_t strip = 0; strip < strips; ++strip)
        for (int i = 0; i < plan.nv[strip]; ++i)
            emit(strip, static_cast<double>(i) / plan.nv[strip]);
    emit(strips - 1, 1);
}

/// What was evaluated, as the grid of a piece that needs no clipping.
template <class T> void l3d_piece_drawer<T>::copy_evaluated() {
    for (int row = 0; row < rows(); ++row)
        for (int column = 0; column < columns(); ++column) {
            const l3d_clip_vertex& from = clip_vertex(row, column);
            const l3d_snapped s = l3d_snap(from.h[0], from.h[1], from.h[2]);
            const std::size_t at = grid_.index(row, column);
            grid_.x[at] = s.x + view_.centre_x();
            grid_.y[at] = s.y + view_.centre_y();
            grid_.inv_w[at] = s.inv_w * static_cast<float>(view_.depth_scale);
            for (std::size_t k = 0; k < 3; ++k)
                grid_.normal[k][at] = from.dice.vertex.normal[k];
        }
}

/// A corner is shared with pieces that walk it in other ways; all use its canonical place.
template <class T> void l3d_piece_drawer<T>::set_grid_corners(const piece& p) {
    for (const bool high_v : {false, true})
        for (const bool high_u : {false, true}) {
            const l3d_micro_vertex exact = p.corner(high_u, high_v, view_).dice.vertex;
            const std::size_t at = grid_.index(high_v ? rows() - 1 : 0, high_u ? columns() - 1 : 0);
            grid_.x[at] = exact.x;
            grid_.y[at] = exact.y;
            grid_.inv_w[at] = exact.inv_w;
        }
}

template <class T> void l3d_piece_drawer<T>::set_clip_corners(const piece& p) {
    for (const bool high_v : {false, true})
        for (const bool high_u : {false, true}) {
            l3d_clip_vertex& v = clip_vertex(high_v ? rows() - 1 : 0, high_u ? columns() - 1 : 0);
            l3d_clip_vertex exact = p.corner(high_u, high_v, view_);
            std::copy_n(v.dice.vertex.normal, 3, exact.dice.vertex.normal);
            v = exact;
        }
}

template <class T> void l3d_piece_drawer<T>::add_clipped_quads() {
    for (int r = 0; r + 1 < rows(); ++r)
        for (int c = 0; c + 1 < columns(); ++c) {
            const l3d_clip_vertex &a = clip_vertex(r, c), &b = clip_vertex(r, c + 1);
            const l3d_clip_vertex &d = clip_vertex(r + 1, c), &e = clip_vertex(r + 1, c + 1);
            l3d_clip_triangle(a, b, e, view_, triangles_);
            l3d_clip_triangle(a, e, d, view_, triangles_);
        }
}

template <class T>
l3d_clip_vertex l3d_piece_drawer<T>::grid_vertex(const piece& p, int row, int column) const {
    l3d_clip_vertex v;
    v.dice.vertex = grid_.vertex(row, column);
    const double w = view_.depth_scale / static_cast<double>(v.dice.vertex.inv_w);
    v.h = {(v.dice.vertex.x - view_.centre_x()) * w / l3d_subpixel_one,
           (v.dice.vertex.y - view_.centre_y()) * w / l3d_subpixel_one, w};
    // A neighbour that is clipped cuts the edges of a corner they share at the same place.
    if (row % (rows() - 1) == 0 && column % (columns() - 1) == 0)
        v.h = p.corner(column > 0, row > 0, view_).h;
    v.drawable = true;
    return v;
}

template <class T> int l3d_piece_drawer<T>::grid_facing(int row, int column) const {
    const std::size_t a = grid_.index(row, column), c = grid_.index(row + 1, column + 1);
    const std::size_t b = a + 1, d = c - 1;
    return sign(std::int64_t{grid_.x[c] - grid_.x[a]} * (grid_.y[d] - grid_.y[b]) -
                std::int64_t{grid_.y[c] - grid_.y[a]} * (grid_.x[d] - grid_.x[b]));
}

template <class T> int l3d_piece_drawer<T>::clip_facing(int row, int column) const {
    return sign(l3d_dot(clip_vertex(row, column).h,
                        l3d_cross(clip_vertex(row, column + 1).h, clip_vertex(row + 1, column).h)));
}

/// Fills the slits along all four sides of a grid given by its vertices and quads.
template <class T>
template <class VertexAt, class FacingAt>
void l3d_piece_drawer<T>::fill_slits(const piece& p, std::span<const l3d_edge_polyline> edges,
                                     VertexAt vertex_at, FacingAt facing_at) {
    for (std::size_t s = 0; s < 4; ++s) {
        const bool along_u = s < 2;
        const int line = s % 2 == 0 ? 0 : (along_u ? rows() : columns()) - 1;
        const int quad_line = line == 0 ? 0 : line - 1;
        const std::vector<double>& parameters = along_u ? u_ : v_;
        const double low = parameters.front(), high = parameters.back();
        const l3d_piece_side& along = p.sides[s];
        boundary_.clear();
        for (std::size_t k = 0; k < parameters.size(); ++k) {
            const auto i = static_cast<int>(k);
            const int quad = std::min(i, static_cast<int>(parameters.size()) - 2);
            const double fraction = (parameters[k] - low) / (high - low);
            l3d_boundary_point& point = boundary_.emplace_back();
            point.t = along.t0 + (along.t1 - along.t0) * fraction;
            point.vertex = along_u ? vertex_at(line, i) : vertex_at(i, line);
            point.vertex.dice.u = along_u ? parameters[k] : u_[static_cast<std::size_t>(line)];
            point.vertex.dice.v = along_u ? v_[static_cast<std::size_t>(line)] : parameters[k];
            point.facing = along_u ? facing_at(quad_line, quad) : facing_at(quad, quad_line);
        }
        l3d_fill_slit(boundary_, edges[along.edge], view_, triangles_);
    }
}

template <class T>
void l3d_piece_drawer<T>::close_hidden(const piece& p, double frame_bound,
                                       std::span<const l3d_edge_polyline> edges) {
    triangles_.clear();
    for (std::size_t s = 0; s < 4; ++s) {
        const bool along_u = s < 2, high = s % 2 == 1;
        boundary_.clear();
        for (const bool end : {false, true}) {
            l3d_boundary_point& point = boundary_.emplace_back();
            point.t = end ? p.sides[s].t1 : p.sides[s].t0;
            point.vertex = along_u ? p.corner(end, high, view_) : p.corner(high, end, view_);
            const auto normal = normals_->evaluate(point.vertex.dice.u, point.vertex.dice.v);
            for (int k = 0; k < 3; ++k)
                point.vertex.dice.vertex.normal[k] = static_cast<float>(normal[k]);
        }
        l3d_fill_slit(boundary_, edges[p.sides[s].edge], view_, triangles_);
    }
    hand_over_triangles(frame_bound);
}

template class l3d_piece_drawer<float>;
template class l3d_piece_drawer<double>;
template class l3d_piece_drawer<l3d_fixed<std::int64_t, 32>>;
