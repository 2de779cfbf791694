// SPDX-License-Identifier: MIT
// l3d_shared_polyline, l3d_add_strip: an edge is halved until its chords are near and short.
#include "dice/edges/shared_polylines.h"

#include "dice/grid_light.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

/// A control point: x w, y w and w in the picture, all times its weight, and the weight.
using control_point = l3d_vector<double, 4>;

/// The control points of a part of an edge.
struct image_curve {
    std::array<control_point, l3d_bpt_largest_degree + 1> points;
    std::size_t count = 0;

    /// Only points that count are written: most edges have two or three of the sixteen.
    void halve(image_curve& low, image_curve& high) const {
        low.count = high.count = count;
        std::copy_n(points.begin(), count, high.points.begin());
        low.points[0] = points[0];
        for (std::size_t left = count - 1; left > 0; --left) {
            for (std::size_t i = 0; i < left; ++i)
                high.points[i] = (high.points[i] + high.points[i + 1]) * 0.5;
            low.points[count - left] = high.points[0];
        }
    }
};

using vector = l3d_vector<double, 3>;

class flattener {
public:
    flattener(const l3d_shared_edge& edge, const l3d_matrix<double>& to_image,
              const l3d_dice_view& view, l3d_shared_polyline& to)
        : view_(view), to_(to), wanted_(l3d_shared_chord_error(view)),
          box_(view.margin().grown(view.edge_reach)), off_(edge.off) {
        for (const int row : {0, 1, 3}) {
            double square = 0;
            for (int k = 0; k < 3; ++k)
                square += to_image(row, k) * to_image(row, k);
            (row == 3 ? by_w_ : by_place_) += square;
        }
        by_w_ = std::sqrt(by_w_);
        by_place_ = std::sqrt(by_place_);
    }

    /// Halves of what is seen wholly are seen wholly, too.
    void add(const image_curve& of, double from, double to, int halvings, bool is_seen) {
        constexpr int most_halvings = 24;
        is_seen = is_seen || all_is_seen(of);
        if (halvings < most_halvings && (is_seen || may_be_seen(of)) && !is_flat(of, is_seen)) {
            image_curve low, high;
            of.halve(low, high);
            const double middle = (from + to) / 2;
            add(low, from, middle, halvings + 1, is_seen);
            add(high, middle, to, halvings + 1, is_seen);
            return;
        }
        const control_point& end = of.points[of.count - 1];
        put({end[0] / end[3], end[1] / end[3], end[2] / end[3]}, to);
    }

    void put(const l3d_image_point& h, double t) {
        to_.t.push_back(t);
        const l3d_clip_vertex& v = to_.points.emplace_back(l3d_canonical_vertex(h, view_));
        if (!v.drawable || off_ == 0)
            return;
        // A way of length 1 moves x, y by by_place_ at most, and w by by_w_.
        const double x = h[0] / h[2], y = h[1] / h[2];
        if (x >= box_.left && x <= box_.right && y >= box_.top && y <= box_.bottom)
            to_.off_px = std::max(to_.off_px, off_ * (by_place_ + std::hypot(x, y) * by_w_) / h[2]);
    }

private:
    bool all_is_seen(const image_curve& of) const {
        return std::all_of(of.points.begin(),
                           of.points.begin() + static_cast<std::ptrdiff_t>(of.count),
                           [&](const control_point& p) {
                               return p[2] > view_.near * p[3] && p[2] < view_.far * p[3] &&
                                      p[0] >= box_.left * p[2] && p[0] <= box_.right * p[2] &&
                                      p[1] >= box_.top * p[2] && p[1] <= box_.bottom * p[2];
                           });
    }

    bool may_be_seen(const image_curve& of) const {
        const auto all = [&](const auto& is_out) {
            return std::all_of(of.points.begin(),
                               of.points.begin() + static_cast<std::ptrdiff_t>(of.count), is_out);
        };
        using point = control_point;
        return !all([&](const point& p) { return p[2] <= view_.near * p[3]; }) &&
               !all([&](const point& p) { return p[2] >= view_.far * p[3]; }) &&
               !all([&](const point& p) { return p[0] < box_.left * p[2]; }) &&
               !all([&](const point& p) { return p[0] > box_.right * p[2]; }) &&
               !all([&](const point& p) { return p[1] < box_.top * p[2]; }) &&
               !all([&](const point& p) { return p[1] > box_.bottom * p[2]; });
    }

    bool is_flat(const image_curve& of, bool is_seen) const {
        const control_point &a = of.points[0], &b = of.points[of.count - 1];
        for (std::size_t i = 0; !is_seen && i < of.count; ++i)
            if (of.points[i][2] <= view_.near * of.points[i][3])
                return false;
        const double ax = a[0] / a[2], ay = a[1] / a[2];
        const double dx = b[0] / b[2] - ax, dy = b[1] / b[2] - ay, square = dx * dx + dy * dy;
        if (square > l3d_longest_shared_chord * l3d_longest_shared_chord)
            return false;
        for (std::size_t i = 1; i + 1 < of.count; ++i) {
            const double x = of.points[i][0] / of.points[i][2] - ax;
            const double y = of.points[i][1] / of.points[i][2] - ay;
            const double part = square > 0 ? std::clamp((x * dx + y * dy) / square, 0.0, 1.0) : 0;
            const double off_x = x - part * dx, off_y = y - part * dy;
            if (off_x * off_x + off_y * off_y > wanted_ * wanted_)
                return false;
            // 1 / w is linear along chords. A change of w by by_w_ is as long as by_place_ / w
            // pixels.
            const double depth = of.points[i][3] / of.points[i][2];
            const double on_chord = (1 - part) * a[3] / a[2] + part * b[3] / b[2];
            if (std::abs(depth - on_chord) * by_place_ > wanted_ * by_w_ * depth)
                return false;
        }
        return true;
    }

    const l3d_dice_view& view_;
    l3d_shared_polyline& to_;
    double wanted_;
    l3d_image_box box_;
    double off_, by_place_ = 0, by_w_ = 0;
};

} // namespace

void l3d_shared_polyline::make(const l3d_shared_edge& edge, const l3d_matrix<double>& to_image,
                               const l3d_dice_view& view) {
    t.clear();
    points.clear();
    off_px = 0;
    flattener flat(edge, to_image, view, *this);
    const auto placed = [&](double x, double y, double z, double w) {
        const l3d_vector<double, 4> q = to_image * l3d_vector<double, 4>{x, y, z, w};
        return control_point{q[0], q[1], q[3], w};
    };
    const auto end = [&](std::size_t side) {
        const vector& at = edge.ends[side];
        const control_point p = placed(at[0], at[1], at[2], 1);
        return l3d_image_point{p[0], p[1], p[2]};
    };
    flat.put(end(0), edge.spans.front().from);
    for (const l3d_shared_edge::span& span : edge.spans) {
        image_curve curve{};
        for (const l3d_vector<double, 4>& p : span.points)
            curve.points[curve.count++] = placed(p[0], p[1], p[2], p[3]);
        flat.add(curve, span.from, span.to, 0, false);
    }
    points.back() = l3d_canonical_vertex(end(1), view);
}

l3d_border_point l3d_border_point_of(const l3d_dice_vertex& at, double t,
                                     const l3d_dice_view& view) {
    l3d_border_point result{.at = {}, .t = t};
    result.at.dice = at;
    const double w = view.w_at(at.vertex.inv_w);
    result.at.h = {(at.vertex.x - view.centre_x()) * w / l3d_subpixel_one,
                   (at.vertex.y - view.centre_y()) * w / l3d_subpixel_one, w};
    result.at.drawable = true;
    return result;
}

void l3d_add_strip(const l3d_shared_polyline& line, const l3d_border_point& from,
                   const l3d_border_point& to, const l3d_dice_view& view, l3d_diced_piece& piece) {
    if (to.t < from.t)
        return l3d_add_strip(line, to, from, view, piece);
    const auto lit = [&](std::size_t i) {
        l3d_clip_vertex result = line.points[i];
        const double part = to.t > from.t ? (line.t[i] - from.t) / (to.t - from.t) : 0;
        const auto share = static_cast<float>(std::clamp(part, 0.0, 1.0));
        const l3d_dice_vertex &a = from.at.dice, &b = to.at.dice;
        result.dice.u = a.u + (b.u - a.u) * double{share};
        result.dice.v = a.v + (b.v - a.v) * double{share};
        float(&normal)[3] = result.dice.vertex.normal;
        for (std::size_t k = 0; k < 3; ++k)
            normal[k] = a.vertex.normal[k] + share * (b.vertex.normal[k] - a.vertex.normal[k]);
        if (!view.makes_levels())
            l3d_make_unit(normal);
        return result;
    };
    const auto above = std::ranges::upper_bound(line.t, from.t);
    std::size_t i =
        above == line.t.begin() ? 0 : static_cast<std::size_t>(above - line.t.begin()) - 1;
    l3d_clip_vertex last = lit(i);
    for (; i + 1 < line.t.size() && line.t[i + 1] <= to.t; ++i) {
        l3d_clip_vertex next = lit(i + 1);
        l3d_clip_triangle(from.at, last, next, view, piece);
        l3d_clip_vertex a = last, b = next;
        if (view.shading.antialias && piece.part.triangles.count > 0 &&
            l3d_clip_segment(a, b, view)) {
            l3d_border_edge edge = l3d_border_edge::between(a.dice.vertex, b.dice.vertex);
            edge.column = static_cast<int>(piece.part.triangles.count) - 1;
            edge.always = true;
            piece.part.border.push_back(edge);
        }
        last = next;
    }
    l3d_clip_triangle(from.at, to.at, last, view, piece);
}
