// SPDX-License-Identifier: MIT
// l3d_patch_dicer: cutting, bounding and walking pieces. Slits along edges are in slit_filler.
#include "pipeline/patch_dicer.h"

#include "pipeline/drawn_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

namespace {

/// Steps per strip above which a piece is cut: the bound of halves is tighter, and 32 steps keep
/// round-off of a strip small in every number type. Pieces that need clipping are drawn slowly,
/// so they are kept finer.
constexpr int most_steps_whole = 32;
constexpr int most_steps_clipped = 8;

/// Cuts per patch at most; then pieces are drawn with the steps that are allowed, and the frame
/// reports the larger bound. 4096 pieces of (4 * 32)^2 quads are 67 million quads.
constexpr int most_pieces = 4096;

/// As deep as halving a parameter stays exact in doubles, with room for the strips' quarters.
constexpr int deepest = 48;

/// Pieces smaller than this in the image are not cut into blocks for the bound: a quarter of
/// 24 pixels is a few quads, and the blocks would cost more than they save.
constexpr double small_size = 24;

/// Whether a box (pixels from the picture's corner) holds no pixel centre k + 1/2, even when
/// snapping moves its points by half a sub-pixel.
bool holds_no_centre(const l3d_image_box& box) {
    constexpr double slack = 1.0 / l3d_subpixel_one;
    const auto none = [](double low, double high) {
        return std::floor(high + slack - 0.5) < std::ceil(low - slack - 0.5);
    };
    return none(box.left, box.right) || none(box.top, box.bottom);
}

template <class Wide> l3d_image_patch in_double(const l3d_bezier_patch<Wide, 3>& net) {
    return l3d_converted<double>(net);
}

/// Largest coordinates, and largest first, second and third differences along v.
struct magnitudes {
    std::array<double, 4> xy{}, w{};

    explicit magnitudes(const l3d_image_patch& net) {
        for (int c = 0; c < 4; ++c) {
            std::array<l3d_image_point, 4> d = net.column(c).points;
            for (std::size_t order = 0; order < 4; ++order) {
                for (std::size_t i = 0; i + order < 4; ++i) {
                    xy[order] = std::max({xy[order], std::abs(d[i][0]), std::abs(d[i][1])});
                    w[order] = std::max(w[order], std::abs(d[i][2]));
                }
                for (std::size_t i = 0; i + order + 1 < 4; ++i)
                    d[i] = d[i + 1] - d[i];
            }
        }
    }
};

/// Error of walking n steps in T along one of `strips` equal parts of [0, 1]: differences of
/// order k shrink by strips^k.
template <class T> double walking_error(const std::array<double, 4>& size, int n, int strips) {
    const double s = strips;
    return l3d_forward_difference_error<T>(n, size[0], size[1] / s, size[2] / (s * s),
                                           size[3] / (s * s * s));
}

} // namespace

/// The piece as the bounds see it.
template <class T> struct l3d_patch_dicer<T>::blocks {
    l3d_image_patch net;
    std::array<l3d_image_patch, 16> block;
    std::size_t count = 1;
    bool whole = false;  ///< needs no clipping
    bool walked = false; ///< by forward differences in T; else each vertex is evaluated
    double vertex_error = 0;

    blocks(const image_net& wide_net, const l3d_dice_view& view, std::vector<image_net>& strips)
        : net(in_double(wide_net)) {
        const l3d_depth_range depth = l3d_depth_range_of(net.points);
        l3d_image_box seen = view.margin();
        l3d_vertex_accuracy accuracy;
        accuracy.w_low = std::max(depth.least, view.near / 2);
        accuracy.reach = l3d_guard_band;
        bool small = false;
        if (depth.least > view.near) {
            const l3d_image_box hull = l3d_image_box_of(net.points);
            whole = hull.reach() < l3d_guard_band;
            if (whole) {
                accuracy.reach = hull.reach();
                small = hull.width() < small_size && hull.height() < small_size;
                if (!seen.intersected(hull).empty())
                    seen = seen.intersected(hull);
            }
        }
        accuracy.seen_reach = seen.reach();
        cut(wide_net, small, strips);
        judge(accuracy, view, small ? 1 : l3d_step_plan::most_strips);
    }

private:
    /// Walks in T unless that errs more than evaluation by a quarter of the tolerance.
    void judge(l3d_vertex_accuracy accuracy, const l3d_dice_view& view, int n_strips) {
        const magnitudes size(net);
        accuracy.error_xy = view.error_xy + l3d_evaluation_error<wide>(size.xy[0]);
        accuracy.error_w = view.error_w + l3d_evaluation_error<wide>(size.w[0]);
        accuracy.snap_error = l3d_snap_error<wide>(accuracy.reach);
        // The centre of a folded quad is rounded to sub-pixels once more.
        if (whole)
            accuracy.snap_error += l3d_snap_error<wide>(0);
        const double w_ratio =
            whole ? l3d_vertex_accuracy::in_front : l3d_vertex_accuracy::crossing;
        vertex_error = accuracy.drawn_error(w_ratio);
        if (!whole)
            return;
        accuracy.error_xy += walking_error<T>(size.xy, most_steps_whole, n_strips);
        accuracy.error_w += walking_error<T>(size.w, most_steps_whole, n_strips);
        accuracy.snap_error += l3d_snap_error<T>(accuracy.reach) - l3d_snap_error<T>(0);
        const double walking = accuracy.drawn_error(w_ratio);
        walked = walking - vertex_error <= view.tolerance / 4;
        if (walked)
            vertex_error = walking;
    }

    void cut(const image_net& wide_net, bool small, std::vector<image_net>& strips) {
        if (small) {
            strips.assign(1, wide_net);
        } else {
            strips.resize(16);
            const auto [low, high] = wide_net.split_v();
            const std::array<std::pair<image_net, image_net>, 2> rows{low.split_v(),
                                                                      high.split_v()};
            for (std::size_t b = 0; b < 4; ++b) {
                const image_net& row = b % 2 == 0 ? rows[b / 2].first : rows[b / 2].second;
                const auto [left, right] = row.split_u();
                std::tie(strips[4 * b], strips[4 * b + 1]) = left.split_u();
                std::tie(strips[4 * b + 2], strips[4 * b + 3]) = right.split_u();
            }
        }
        count = strips.size();
        for (std::size_t i = 0; i < count; ++i)
            block[i] = in_double(strips[i]);
    }
};

template <class T> void l3d_patch_dicer<T>::begin(const l3d_dice_view& view) {
    view_ = view;
    counts_ = {};
}

template <class T>
void l3d_patch_dicer<T>::dice(const image_net& net, const l3d_normal_net& normals,
                              l3d_dice_sink& sink) {
    const l3d_image_patch hull = in_double(net);
    if (!view_.keep_all) {
        const l3d_depth_range depth = l3d_depth_range_of(hull.points);
        if (depth.most <= view_.near) {
            ++counts_.behind;
            return;
        }
        if (l3d_outside(hull.points, view_.margin(), view_.near)) {
            ++counts_.offscreen;
            return;
        }
        if (depth.least > view_.near) {
            const l3d_image_box window = view_.window();
            const l3d_image_box box = l3d_image_box_of(hull.points);
            if (holds_no_centre({box.left - window.left, box.top - window.top,
                                 box.right - window.left, box.bottom - window.top})) {
                ++counts_.subpixel;
                return;
            }
        }
    }
    ++counts_.drawn;
    normals_ = &normals;
    sink_ = &sink;
    pieces_left_ = most_pieces;
    edges_used_ = 0;
    piece whole{net, 0, 1, 0, 1, {}, 0};
    whole.sides[0].edge = new_edge(net.row(0));
    whole.sides[1].edge = new_edge(net.row(3));
    whole.sides[2].edge = new_edge(net.column(0));
    whole.sides[3].edge = new_edge(net.column(3));
    dice_piece(whole);
}

template <class T>
std::size_t l3d_patch_dicer<T>::new_edge(const l3d_bezier_curve<wide, 3>& curve) {
    if (edges_used_ == edges_.size())
        edges_.emplace_back();
    edges_[edges_used_].build(curve, view_);
    counts_.bound_px = std::max(counts_.bound_px, edges_[edges_used_].bound());
    counts_.samples += static_cast<std::int64_t>(edges_[edges_used_].points().size());
    return edges_used_++;
}

template <class T> void l3d_patch_dicer<T>::dice_piece(const piece& p) {
    const blocks b(p.net, view_, strip_nets_);
    if (!view_.keep_all || p.depth > 0)
        if (l3d_outside(b.net.points, view_.margin(), view_.near))
            return close_hidden(p);

    double chord_error = 0, vertex_error = b.vertex_error;
    for (const side& s : p.sides) {
        chord_error = std::max(chord_error, edges_[s.edge].chord_error());
        vertex_error = std::max(vertex_error, edges_[s.edge].vertex_error());
    }
    const double budget = std::max(view_.tolerance - vertex_error, view_.tolerance / 2);
    const auto kind = b.whole ? l3d_quad_kind::whole : l3d_quad_kind::triangles;
    l3d_step_plan plan = l3d_plan_steps(std::span(b.block).first(b.count), view_, budget, kind);

    const int most = b.whole ? most_steps_whole : most_steps_clipped;
    const int wanted = std::max(plan.most_u(), plan.most_v());
    if (wanted > most && p.depth < deepest && pieces_left_ > 0)
        return cut(p, plan.most_u() >= plan.most_v());

    if (wanted > most_steps_whole) {
        // Errors fall with the square of the steps, at the least.
        const double ratio = static_cast<double>(wanted) / most_steps_whole;
        plan.chord_error *= b.whole ? ratio * ratio : std::numeric_limits<double>::infinity();
        for (auto* steps : {&plan.nu, &plan.nv})
            for (int& n : *steps)
                n = std::min(n, most_steps_whole);
    }
    const double bound = plan.visible ? plan.chord_error + vertex_error : 0;
    ++counts_.pieces;
    // Slits lie between vertices of the piece and of its sides, each off by its own error.
    counts_.bound_px = std::max({counts_.bound_px, bound, chord_error + vertex_error});
    fill_parameters(p, plan);
    if (b.whole)
        draw_whole(p, b, plan, bound);
    else
        draw_clipped(p, b, plan);
}

template <class T> void l3d_patch_dicer<T>::cut(const piece& p, bool along_u) {
    --pieces_left_;
    piece low = p, high = p;
    low.depth = high.depth = p.depth + 1;
    if (along_u) {
        std::tie(low.net, high.net) = p.net.split_u();
        low.u1 = high.u0 = (p.u0 + p.u1) / 2;
    } else {
        std::tie(low.net, high.net) = p.net.split_v();
        low.v1 = high.v0 = (p.v0 + p.v1) / 2;
    }
    // The sides across the cut are halved; the cut itself is a new edge, whole for both.
    for (const std::size_t across : {along_u ? std::size_t{0} : 2, along_u ? std::size_t{1} : 3}) {
        const double middle = (p.sides[across].t0 + p.sides[across].t1) / 2;
        low.sides[across].t1 = high.sides[across].t0 = middle;
    }
    const std::size_t edge = new_edge(along_u ? low.net.column(3) : low.net.row(3));
    low.sides[along_u ? 3 : 1] = high.sides[along_u ? 2 : 0] = side{edge, 0, 1};
    dice_piece(low);
    dice_piece(high);
}

template <class T>
void l3d_patch_dicer<T>::fill_parameters(const piece& p, const l3d_step_plan& plan) {
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
    counts_.samples += static_cast<std::int64_t>(u_.size() * v_.size());
    normal_columns_.resize(u_.size());
    for (std::size_t c = 0; c < u_.size(); ++c)
        normal_columns_.set(c, *normals_, u_[c]);
}

/// Calls visit(column, u-strip, local u) for each column; the last lies at the last strip's end.
template <class Visit> static void for_columns(const l3d_step_plan& plan, Visit visit) {
    std::size_t column = 0;
    for (int a = 0; a < plan.strips; ++a) {
        const int n = plan.nu[static_cast<std::size_t>(a)];
        for (int i = 0; i < n; ++i)
            visit(column++, static_cast<std::size_t>(a), static_cast<double>(i) / n);
    }
    visit(column, static_cast<std::size_t>(plan.strips - 1), 1.0);
}

template <class T> void l3d_patch_dicer<T>::walk_rows(const l3d_step_plan& plan) {
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
            walker_.start(c, strip_nets_[strips * b + a].curve_at_u(l3d_from_double<wide>(u)), n);
        });
        for (int i = 0; i < n; ++i) {
            emit();
            walker_.step();
        }
    }
    for_columns(plan, [&](std::size_t c, std::size_t a, double u) {
        const auto last = strip_nets_[strips * (strips - 1) + a].row(3);
        walker_.place(c, last.evaluate(l3d_from_double<wide>(u)));
    });
    emit();
}

template <class T>
l3d_clip_vertex l3d_patch_dicer<T>::corner(const piece& p, bool high_u, bool high_v) const {
    const auto& h = p.net.at(high_v ? 3 : 0, high_u ? 3 : 0);
    l3d_clip_vertex result = l3d_canonical_vertex<wide>(h, view_);
    result.dice.u = high_u ? p.u1 : p.u0;
    result.dice.v = high_v ? p.v1 : p.v0;
    return result;
}

/// A corner is shared with pieces that walk it in other ways; all use its canonical place.
template <class T> void l3d_patch_dicer<T>::set_corners(const piece& p) {
    for (const bool high_v : {false, true})
        for (const bool high_u : {false, true}) {
            const l3d_micro_vertex exact = corner(p, high_u, high_v).dice.vertex;
            const std::size_t at =
                grid_.index(high_v ? grid_.rows - 1 : 0, high_u ? grid_.columns - 1 : 0);
            grid_.x[at] = exact.x;
            grid_.y[at] = exact.y;
            grid_.inv_w[at] = exact.inv_w;
        }
}

template <class T>
void l3d_patch_dicer<T>::draw_whole(const piece& p, const blocks& nets, const l3d_step_plan& plan,
                                    double bound) {
    grid_.resize(static_cast<int>(u_.size()), static_cast<int>(v_.size()));
    if (nets.walked)
        walk_rows(plan);
    else
        evaluate_whole(nets, plan);
    set_corners(p);
    sink_->grid({grid_, u_, v_, bound});
    const auto vertex_at = [&](int row, int column) {
        l3d_clip_vertex v;
        v.dice.vertex = grid_.vertex(row, column);
        const double w = view_.depth_scale / static_cast<double>(v.dice.vertex.inv_w);
        v.h = {(v.dice.vertex.x - view_.centre_x()) * w / l3d_subpixel_one,
               (v.dice.vertex.y - view_.centre_y()) * w / l3d_subpixel_one, w};
        // A neighbour that is clipped cuts the edges of a corner they share at the same place.
        if (row % (grid_.rows - 1) == 0 && column % (grid_.columns - 1) == 0)
            v.h = corner(p, column > 0, row > 0).h;
        v.drawable = true;
        return v;
    };
    const auto facing_at = [&](int row, int column) {
        const std::size_t a = grid_.index(row, column), c = grid_.index(row + 1, column + 1);
        const std::size_t b = a + 1, d = c - 1;
        const std::int64_t area =
            std::int64_t{grid_.x[c] - grid_.x[a]} * (grid_.y[d] - grid_.y[b]) -
            std::int64_t{grid_.y[c] - grid_.y[a]} * (grid_.x[d] - grid_.x[b]);
        return (area > 0) - (area < 0);
    };
    fill_slits(p, vertex_at, facing_at);
}

/// Every vertex by itself, as it may lie anywhere, even behind the eye.
template <class T>
void l3d_patch_dicer<T>::evaluate_grid(const blocks& nets, const l3d_step_plan& plan) {
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
            vertex =
                l3d_canonical_vertex<double>(nets.block[strips * strip + a].evaluate(u, v), view_);
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

/// The same for a piece that needs no clipping.
template <class T>
void l3d_patch_dicer<T>::evaluate_whole(const blocks& nets, const l3d_step_plan& plan) {
    evaluate_grid(nets, plan);
    for (int row = 0; row < grid_.rows; ++row)
        for (int column = 0; column < grid_.columns; ++column) {
            const l3d_clip_vertex& from =
                clip_grid_[static_cast<std::size_t>(row * grid_.columns + column)];
            const l3d_snapped s = l3d_snap(from.h[0], from.h[1], from.h[2]);
            const std::size_t at = grid_.index(row, column);
            grid_.x[at] = s.x + view_.centre_x();
            grid_.y[at] = s.y + view_.centre_y();
            grid_.inv_w[at] = s.inv_w * static_cast<float>(view_.depth_scale);
            for (std::size_t k = 0; k < 3; ++k)
                grid_.normal[k][at] = from.dice.vertex.normal[k];
        }
}

template <class T>
void l3d_patch_dicer<T>::draw_clipped(const piece& p, const blocks& nets,
                                      const l3d_step_plan& plan) {
    ++counts_.clipped;
    evaluate_grid(nets, plan);
    const auto columns = static_cast<int>(u_.size()), rows = static_cast<int>(v_.size());
    const auto vertex_at = [&](int row, int column) -> l3d_clip_vertex& {
        return clip_grid_[static_cast<std::size_t>(row * columns + column)];
    };
    for (const bool high_v : {false, true})
        for (const bool high_u : {false, true}) {
            l3d_clip_vertex& v = vertex_at(high_v ? rows - 1 : 0, high_u ? columns - 1 : 0);
            const l3d_clip_vertex exact = corner(p, high_u, high_v);
            v.h = exact.h;
            v.drawable = exact.drawable;
            v.dice.vertex.x = exact.dice.vertex.x;
            v.dice.vertex.y = exact.dice.vertex.y;
            v.dice.vertex.inv_w = exact.dice.vertex.inv_w;
        }
    triangles_.clear();
    for (int r = 0; r + 1 < rows; ++r)
        for (int c = 0; c + 1 < columns; ++c) {
            const l3d_clip_vertex &a = vertex_at(r, c), &b = vertex_at(r, c + 1);
            const l3d_clip_vertex &d = vertex_at(r + 1, c), &e = vertex_at(r + 1, c + 1);
            l3d_clip_triangle(a, b, e, view_, triangles_);
            l3d_clip_triangle(a, e, d, view_, triangles_);
        }
    sink_->triangles(triangles_, counts_.bound_px);
    fill_slits(p, vertex_at, [&](int r, int c) {
        const double area =
            l3d_dot(vertex_at(r, c).h, l3d_cross(vertex_at(r, c + 1).h, vertex_at(r + 1, c).h));
        return (area > 0) - (area < 0);
    });
}

/// Fills the slits along all four sides of a grid given by its vertices and quads.
template <class T>
template <class VertexAt, class FacingAt>
void l3d_patch_dicer<T>::fill_slits(const piece& p, VertexAt vertex_at, FacingAt facing_at) {
    const auto columns = static_cast<int>(u_.size()), rows = static_cast<int>(v_.size());
    triangles_.clear();
    for (std::size_t s = 0; s < 4; ++s) {
        const bool along_u = s < 2;
        const int line = s % 2 == 0 ? 0 : (along_u ? rows : columns) - 1;
        const int quad_line = line == 0 ? 0 : line - 1;
        const std::vector<double>& parameters = along_u ? u_ : v_;
        const double low = parameters.front(), high = parameters.back();
        const side& along = p.sides[s];
        boundary_.clear();
        for (int i = 0; i < (along_u ? columns : rows); ++i) {
            const int quad = std::min(i, (along_u ? columns : rows) - 2);
            const double fraction = (parameters[static_cast<std::size_t>(i)] - low) / (high - low);
            l3d_boundary_point point;
            point.t = along.t0 + (along.t1 - along.t0) * fraction;
            point.vertex = along_u ? vertex_at(line, i) : vertex_at(i, line);
            point.vertex.dice.u = along_u ? parameters[static_cast<std::size_t>(i)]
                                          : u_[static_cast<std::size_t>(line)];
            point.vertex.dice.v = along_u ? v_[static_cast<std::size_t>(line)]
                                          : parameters[static_cast<std::size_t>(i)];
            point.facing = along_u ? facing_at(quad_line, quad) : facing_at(quad, quad_line);
            boundary_.push_back(point);
        }
        fill_slit(along);
    }
    if (!triangles_.empty())
        sink_->triangles(triangles_, counts_.bound_px);
}

template <class T> void l3d_patch_dicer<T>::fill_slit(const side& along) {
    l3d_fill_slit(boundary_, edges_[along.edge], view_, triangles_);
}

/// A piece outside the window is not diced, but the slits that start along its sides may reach
/// inside: they are filled up to its corners.
template <class T> void l3d_patch_dicer<T>::close_hidden(const piece& p) {
    triangles_.clear();
    for (std::size_t s = 0; s < 4; ++s) {
        const bool along_u = s < 2, high = s % 2 == 1;
        boundary_.clear();
        for (const bool end : {false, true}) {
            l3d_boundary_point point;
            point.t = end ? p.sides[s].t1 : p.sides[s].t0;
            point.vertex = along_u ? corner(p, end, high) : corner(p, high, end);
            const auto normal = normals_->evaluate(point.vertex.dice.u, point.vertex.dice.v);
            for (int k = 0; k < 3; ++k)
                point.vertex.dice.vertex.normal[k] = static_cast<float>(normal[k]);
            boundary_.push_back(point);
        }
        fill_slit(p.sides[s]);
    }
    if (!triangles_.empty())
        sink_->triangles(triangles_, counts_.bound_px);
}

template class l3d_patch_dicer<float>;
template class l3d_patch_dicer<double>;
template class l3d_patch_dicer<l3d_fixed<std::int64_t, 32>>;
