// SPDX-License-Identifier: MIT
// l3d_shared_polyline, l3d_add_strip: halve an edge until its chords are near and short, and join
// borders to it.
#include "dice/edges/shared_polylines.h"

#include "dice/grid_light.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {

/// A control point of a rational curve in the picture: x w, y w, w and 1, all times the point's
/// weight.
using control_point = l3d_vector<double, 4>;

/// The control points in the picture of a part of an edge.
struct image_curve {
    std::array<control_point, l3d_bpt_largest_degree + 1> points;
    std::size_t count = 0;

    /// Halves the curve. Only the curve's own control points are written. There is room for
    /// sixteen, but most edges have two or three.
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

    /// Adds a part of an edge: as one chord, or by its halves. `is_seen` says that all of the part
    /// may be seen; then its halves need no test.
    void add(const image_curve& of, double from, double to, int halvings, bool is_seen) {
        constexpr int most_halvings = 24;
        is_seen = is_seen || all_is_seen(of);
        const bool may_be = is_seen || may_be_seen(of);
        l3d_drawn_distance off = off_chord(of, is_seen);
        const bool is_near = off.places <= wanted_ && off.depth <= wanted_;
        if (!may_be && !is_near)
            off.places = off.depth = std::numeric_limits<double>::infinity();
        if (halvings < most_halvings && may_be && !is_near) {
            image_curve low, high;
            of.halve(low, high);
            const double middle = (from + to) / 2;
            add(low, from, middle, halvings + 1, is_seen);
            add(high, middle, to, halvings + 1, is_seen);
            return;
        }
        const control_point& end = of.points[of.count - 1];
        put({end[0] / end[3], end[1] / end[3], end[2] / end[3]}, to, off);
    }

    void put(const l3d_image_point& h, double t, const l3d_drawn_distance& off) {
        to_.t.push_back(t);
        to_.chords.push_back(off);
        const l3d_clip_vertex& v = to_.points.emplace_back(l3d_canonical_vertex(h, view_));
        if (!v.drawable || off_ == 0)
            return;
        // A move of length 1 in space changes x and y by at most by_place_, and w by at most by_w_.
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

    /// Whether faces may be seen at a part of the edge between the near and the far plane. Faces
    /// end within off_ of the edge, in space. Parts farther beside the picture than `farthest`, 256
    /// of the longest chords, count as unseen. Otherwise loose edges near the eye would get chords
    /// without end.
    bool may_be_seen(const image_curve& of) const {
        constexpr double farthest = 256 * l3d_longest_shared_chord;
        const auto all = [&](const auto& is_out) {
            return std::all_of(of.points.begin(),
                               of.points.begin() + static_cast<std::ptrdiff_t>(of.count), is_out);
        };
        using point = control_point;
        // A move of length `off` in space changes x - side w and y - side w by at most this, times
        // the weight.
        const auto is_beside = [&](const l3d_image_box& box, double off) {
            const auto slack = [&](double side) {
                return off * (by_place_ + std::abs(side) * by_w_);
            };
            const double left = slack(box.left), right = slack(box.right);
            const double top = slack(box.top), bottom = slack(box.bottom);
            return all([&](const point& p) { return p[0] < box.left * p[2] - left * p[3]; }) ||
                   all([&](const point& p) { return p[0] > box.right * p[2] + right * p[3]; }) ||
                   all([&](const point& p) { return p[1] < box.top * p[2] - top * p[3]; }) ||
                   all([&](const point& p) { return p[1] > box.bottom * p[2] + bottom * p[3]; });
        };
        return !all([&](const point& p) { return p[2] <= view_.near * p[3]; }) &&
               !all([&](const point& p) { return p[2] >= view_.far * p[3]; }) &&
               !is_beside(box_, off_) && (off_ == 0 || !is_beside(box_.grown(farthest), 0));
    }

    /// Bounds how far a part is from its chord. The result is infinite if the chord is too long or
    /// the part is not in front of the eye. Each point of the part has a place and a 1 / w. Both
    /// are means over the part's control points, with weights in proportion to w. Chords are linear
    /// in both.
    l3d_drawn_distance off_chord(const image_curve& of, bool is_seen) const {
        constexpr double infinite = std::numeric_limits<double>::infinity();
        const control_point &a = of.points[0], &b = of.points[of.count - 1];
        double heaviest = 0; // the weights of points between
        for (std::size_t i = 0; i < of.count; ++i) {
            if (!is_seen && of.points[i][2] <= l3d_measured_near(view_) * of.points[i][3])
                return {infinite, infinite};
            if (i > 0 && i + 1 < of.count)
                heaviest = std::max(heaviest, of.points[i][2]);
        }
        const double ax = a[0] / a[2], ay = a[1] / a[2];
        const double dx = b[0] / b[2] - ax, dy = b[1] / b[2] - ay, square = dx * dx + dy * dy;
        if (square > l3d_longest_shared_chord * l3d_longest_shared_chord)
            return {infinite, infinite};
        const double near_a = a[3] / a[2], near_b = b[3] / b[2]; // 1 / w
        double least = std::min(near_a, near_b);
        double off = 0, reach = 0; // squares
        double off_w = 0;          // a difference of 1 / w
        for (std::size_t i = 1; i + 1 < of.count; ++i) {
            const double x = of.points[i][0] / of.points[i][2];
            const double y = of.points[i][1] / of.points[i][2];
            const double along = (x - ax) * dx + (y - ay) * dy;
            const double part = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
            const double off_x = x - ax - part * dx, off_y = y - ay - part * dy;
            off = std::max(off, off_x * off_x + off_y * off_y);
            const double here = of.points[i][3] / of.points[i][2];
            const double on_chord = (1 - part) * near_a + part * near_b;
            off_w = std::max(off_w, std::abs(here - on_chord));
            least = std::min({least, here, on_chord});
            reach = std::max(reach, x * x + y * y);
        }
        const auto [far, near] = std::minmax(near_a, near_b);
        const double share =
            l3d_share_between(of.count, std::min(a[2], b[2]) * far, heaviest * near);
        const double places = share * std::sqrt(off), part_of_w = off_w / least;
        const double ray = std::sqrt(reach + view_.focal * view_.focal);
        return {places, places * (1 + part_of_w) + share * part_of_w * ray};
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
    corners.clear();
    chords.clear();
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
    flat.put(end(0), edge.spans.front().from, {});
    for (const l3d_shared_edge::span& span : edge.spans) {
        image_curve curve{};
        for (const l3d_vector<double, 4>& p : span.points)
            curve.points[curve.count++] = placed(p[0], p[1], p[2], p[3]);
        flat.add(curve, span.from, span.to, 0, false);
    }
    points.back() = l3d_canonical_vertex(end(1), view);
    // An end that edges have in common may differ from the edge's own end. Then its first or last
    // chord is farther off.
    const auto own_end = [&](const l3d_vector<double, 4>& p) {
        const control_point q = placed(p[0], p[1], p[2], p[3]);
        return l3d_image_point{q[0], q[1], q[2]} / q[3];
    };
    const auto add_move = [&](const l3d_image_point& from, const l3d_image_point& to,
                              l3d_drawn_distance& chord) {
        const double nearest = std::min(from[2], to[2]);
        if (nearest <= l3d_measured_near(view))
            return;
        const double x = from[0] / from[2] - to[0] / to[2], y = from[1] / from[2] - to[1] / to[2];
        chord.places += std::hypot(x, y);
        chord.depth +=
            std::hypot(from[0] - to[0], from[1] - to[1], view.focal * (from[2] - to[2])) / nearest;
    };
    add_move(own_end(edge.spans.front().points.front()), end(0), chords[1]);
    add_move(own_end(edge.spans.back().points.back()), end(1), chords.back());
    for (const l3d_clip_vertex& point : points)
        corners.emplace_back(point, view);
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

namespace {

/// Whether a triangle has no area when it is drawn. Where a border has the same points as the edge,
/// every second triangle of the strip has no area.
bool covers_nothing(const l3d_clip_vertex& a, const l3d_clip_vertex& b, const l3d_clip_vertex& c) {
    return a.drawable && b.drawable && c.drawable &&
           l3d_detail::twice_area(a.dice.vertex, b.dice.vertex, c.dice.vertex) == 0;
}

/// Gives a point of a strip the parameters and the light of the border, at a share of the way along
/// the border.
void light(const l3d_border_point& from, const l3d_border_point& to, double share, bool has_levels,
           l3d_dice_vertex& at) {
    const l3d_dice_vertex &a = from.at.dice, &b = to.at.dice;
    at.u = a.u + (b.u - a.u) * share;
    at.v = a.v + (b.v - a.v) * share;
    float(&normal)[3] = at.vertex.normal;
    for (std::size_t k = 0; k < 3; ++k)
        normal[k] = a.vertex.normal[k] +
                    static_cast<float>(share) * (b.vertex.normal[k] - a.vertex.normal[k]);
    if (!has_levels)
        l3d_make_unit(normal);
}

/// The share of the way along a border that is beside the edge's point of parameter t.
double share_at(double t, const l3d_border_point& from, const l3d_border_point& to) {
    const double part = to.t > from.t ? (t - from.t) / (to.t - from.t) : 0;
    return double{static_cast<float>(std::clamp(part, 0.0, 1.0))};
}

/// Adds a strip that need not be cut, since its chords are near the edge or it lies outside of the
/// picture.
void add_uncut(const l3d_shared_polyline& line, const l3d_border_point& from,
               const l3d_border_point& to, const l3d_dice_view& view, l3d_diced_piece& piece) {
    const auto above = std::ranges::upper_bound(line.t, from.t);
    const std::size_t first =
        above == line.t.begin() ? 0 : static_cast<std::size_t>(above - line.t.begin()) - 1;
    const auto lit = [&](std::size_t i) {
        l3d_clip_vertex result = line.points[i];
        light(from, to, share_at(line.t[i], from, to), view.makes_levels(), result.dice);
        return result;
    };
    bool covers = false;
    const auto add = [&](const l3d_clip_vertex& a, const l3d_clip_vertex& b) {
        if (covers_nothing(from.at, a, b))
            return;
        l3d_clip_triangle(from.at, a, b, view, piece);
        covers = true;
    };
    const bool has_inner = first + 1 < line.t.size() && line.t[first + 1] <= to.t;
    if (!has_inner && covers_nothing(from.at, to.at, line.points[first]))
        return;
    std::size_t i = first;
    l3d_clip_vertex last = lit(i);
    for (; i + 1 < line.t.size() && line.t[i + 1] <= to.t; ++i) {
        l3d_clip_vertex next = lit(i + 1);
        add(last, next);
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
    add(to.at, last);
    if (covers)
        piece.strips.add(l3d_strip_error(line, first, i, from.at, to.at, view));
}

} // namespace

void l3d_add_strip(const l3d_shared_polyline& line, const l3d_border_point& from,
                   const l3d_border_point& to, const l3d_dice_view& view, l3d_diced_piece& piece) {
    if (to.t < from.t)
        return l3d_add_strip(line, to, from, view, piece);
    // Where the edge leaves the picture, the strip is cut: its border gets a corner, which nobody
    // sees.
    const auto is_known = [&](std::size_t i) { return std::isfinite(line.chords[i].places); };
    const auto above = std::ranges::upper_bound(line.t, from.t);
    l3d_border_point begin = from;
    for (auto i = static_cast<std::size_t>(above - line.t.begin());
         i + 1 < line.t.size() && line.t[i] < to.t; ++i) {
        if ((is_known(i) && is_known(i + 1)) || !(line.t[i] > begin.t))
            continue;
        const double share = share_at(line.t[i], begin, to);
        l3d_border_point middle{
            l3d_canonical_vertex(begin.at.h + (to.at.h - begin.at.h) * share, view), line.t[i]};
        light(begin, to, share, view.makes_levels(), middle.at.dice);
        add_uncut(line, begin, middle, view, piece);
        begin = middle;
    }
    add_uncut(line, begin, to, view, piece);
}
