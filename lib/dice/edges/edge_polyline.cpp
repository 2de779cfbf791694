// SPDX-License-Identifier: MIT
// l3d_edge_polyline: chooses direction, strips and steps of an edge, by the edge's own bound.
#include "dice/edges/edge_polyline.h"

#include "dice/drawn_error.h"
#include "dice/step_plan.h"
#include "dice/edges/edge_strips_p.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace {

/// The largest number of halvings of an edge. The 2^24 strips are more than any picture has pixels
/// along an edge.
constexpr int deepest = 24;

/// The number of halvings of edges that are not small. Two halvings make four strips, as in
/// patches.
constexpr int usual_level = 2;

double largest_of(const l3d_image_curve& curve, bool depth) {
    double largest = 0;
    for (const auto& p : curve.points)
        largest =
            std::max(largest, depth ? std::abs(p[2]) : std::max(std::abs(p[0]), std::abs(p[1])));
    return largest;
}

double points_error(const l3d_image_curve& curve, const l3d_image_box& seen, bool in_front,
                    double w_low, const l3d_dice_view& view) {
    l3d_vertex_accuracy accuracy;
    accuracy.error_xy = view.error_xy + l3d_evaluation_error(largest_of(curve, false));
    accuracy.error_w = view.error_w + l3d_evaluation_error(largest_of(curve, true));
    accuracy.w_low = w_low;
    accuracy.seen_reach = seen.reach();
    accuracy.reach = in_front ? std::min(l3d_image_box_of(curve.points).reach(), l3d_guard_band)
                              : l3d_guard_band;
    accuracy.snap_error = l3d_snap_error<double>(accuracy.reach);
    return accuracy.drawn_error(in_front ? l3d_vertex_accuracy::in_front
                                         : l3d_vertex_accuracy::crossing);
}

/// The number of points of strips, both ends included.
std::size_t points_of(const l3d_block_starts& strips) {
    return static_cast<std::size_t>(strips.first[static_cast<std::size_t>(strips.blocks)]) + 1;
}

} // namespace

l3d_clip_vertex l3d_edge_polyline::clip_vertex(std::size_t i, const l3d_dice_view& view) const {
    l3d_clip_vertex result;
    if (strips_[0].blocks > 0) {
        // The segment is drawn as it is. It is clipped only at a corner that rounding put out of
        // range.
        const double w = view.w_at(inv_w_[i]);
        result.h = {(x_[i] - view.centre_x()) * w / l3d_subpixel_one,
                    (y_[i] - view.centre_y()) * w / l3d_subpixel_one, w};
        result.drawable = true;
    } else {
        result.h = h_[i];
        result.drawable = drawable_[i] != 0;
    }
    result.dice.vertex.x = x_[i];
    result.dice.vertex.y = y_[i];
    result.dice.vertex.inv_w = inv_w_[i];
    return result;
}

void l3d_edge_polyline::add_point(const l3d_image_point& h, double t, const l3d_dice_view& view) {
    const l3d_clip_vertex vertex = l3d_canonical_vertex(h, view);
    t_.push_back(t);
    x_.push_back(vertex.dice.vertex.x);
    y_.push_back(vertex.dice.vertex.y);
    inv_w_.push_back(vertex.dice.vertex.inv_w);
    h_.push_back(h);
    drawable_.push_back(vertex.drawable);
}

void l3d_edge_polyline::reverse() {
    std::reverse(t_.begin(), t_.end());
    std::reverse(x_.begin(), x_.end());
    std::reverse(y_.begin(), y_.end());
    std::reverse(inv_w_.begin(), inv_w_.end());
    std::reverse(h_.begin(), h_.end());
    std::reverse(drawable_.begin(), drawable_.end());
    for (double& t : t_)
        t = 1 - t;
}

void l3d_edge_polyline::build(std::span<l3d_edge_polyline, 4> lines,
                              const std::array<l3d_image_curve, 4>& edges,
                              const l3d_dice_view& view, const std::array<double, 4>& shares) {
    std::array<l3d_detail::edge_strips, 4> strips;
    for (std::size_t e = 0; e < lines.size(); ++e)
        lines[e].give_room(strips[e]);
    l3d_detail::make_edge_strips(edges, view, shares, strips);
    for (std::size_t e = 0; e < lines.size(); ++e)
        lines[e].take(strips[e], edges[e], view, shares[e]);
}

void l3d_edge_polyline::build(const l3d_image_curve& edge, const l3d_dice_view& view) {
    // All four lanes write the same numbers to the same places.
    std::array<l3d_detail::edge_strips, 4> strips;
    for (l3d_detail::edge_strips& one : strips)
        give_room(one);
    l3d_detail::make_edge_strips({edge, edge, edge, edge}, view, {1, 1, 1, 1}, strips);
    take(strips[0], edge, view, 1);
}

void l3d_edge_polyline::give_room(l3d_detail::edge_strips& to, std::size_t part) {
    const std::size_t from = part * l3d_detail::edge_strips::room;
    const std::size_t end = from + l3d_detail::edge_strips::room;
    if (t_.size() < end) {
        t_.resize(end);
        x_.resize(end);
        y_.resize(end);
        inv_w_.resize(end);
    }
    to.t = t_.data() + from;
    to.x = x_.data() + from;
    to.y = y_.data() + from;
    to.inv_w = inv_w_.data() + from;
}

void l3d_edge_polyline::reserve_as(const l3d_edge_polyline& other) {
    t_.reserve(other.t_.capacity());
    x_.reserve(other.x_.capacity());
    y_.reserve(other.y_.capacity());
    inv_w_.reserve(other.inv_w_.capacity());
    h_.reserve(other.h_.capacity());
    drawable_.reserve(other.drawable_.capacity());
}

void l3d_edge_polyline::take(const l3d_detail::edge_strips& strips, const l3d_image_curve& edge,
                             const l3d_dice_view& view, double share) {
    parts_ = 1;
    strips_[0] = strips.strips;
    if (strips.strips.blocks == 0) {
        const l3d_dice_view own = view.of_share(share);
        if (!strips.too_long || !take_parts(edge, own))
            cut(edge, own);
        return;
    }
    size_ = points_of(strips.strips);
    chord_error_ = strips.chord_error;
    vertex_error_ = strips.vertex_error;
}

/// Makes the edge of as few equal parts as possible, each of which needs at most 32 steps a strip.
/// Returns false if most_parts parts are not enough.
bool l3d_edge_polyline::take_parts(const l3d_image_curve& edge, const l3d_dice_view& view) {
    std::array<l3d_image_curve, most_parts> parts{edge};
    for (std::size_t count = 2; count <= most_parts; count *= 2) {
        for (std::size_t k = count / 2; k-- > 0;)
            std::tie(parts[2 * k], parts[2 * k + 1]) = parts[k].split();
        if (join(std::span(parts).first(count), view))
            return true;
    }
    return false;
}

/// Makes the polyline of an edge from the edge's parts. Each part is made like an edge by itself.
/// Returns false if any part needs too many steps.
bool l3d_edge_polyline::join(std::span<const l3d_image_curve> parts, const l3d_dice_view& view) {
    constexpr std::size_t at_once = l3d_detail::edges_at_once;
    std::array<l3d_detail::edge_strips, most_parts> strips;
    l3d_detail::edge_strips last;
    give_room(last, parts.size() - 1);
    for (std::size_t part = 0; part < parts.size(); part += at_once) {
        std::array<l3d_image_curve, at_once> some;
        std::array<l3d_detail::edge_strips, at_once> of_some;
        for (std::size_t k = 0; k < at_once; ++k) {
            // If there are only two parts, both are made twice.
            const std::size_t which = std::min(part + k, parts.size() - 1);
            some[k] = parts[which];
            give_room(of_some[k], which);
        }
        l3d_detail::make_edge_strips(some, view, {1, 1, 1, 1}, of_some);
        for (std::size_t k = 0; k < at_once && part + k < parts.size(); ++k) {
            if (of_some[k].strips.blocks == 0)
                return false;
            strips[part + k] = of_some[k];
        }
    }
    parts_ = parts.size();
    size_ = 1;
    chord_error_ = vertex_error_ = 0;
    for (std::size_t part = 0; part < parts_; ++part) {
        const l3d_detail::edge_strips& from = strips[part];
        // A part begins with the end of the one before, bit for bit.
        const std::size_t to = size_ - 1, count = points_of(from.strips);
        for (std::size_t i = 0; i < count; ++i)
            t_[to + i] = (static_cast<double>(part) + from.t[i]) / static_cast<double>(parts_);
        std::copy_n(from.x, count, x_.data() + to);
        std::copy_n(from.y, count, y_.data() + to);
        std::copy_n(from.inv_w, count, inv_w_.data() + to);
        strips_[part] = from.strips;
        for (int& first : strips_[part].first)
            first += static_cast<int>(to);
        size_ = to + count;
        chord_error_ = std::max(chord_error_, from.chord_error);
        vertex_error_ = std::max(vertex_error_, from.vertex_error);
    }
    return true;
}

void l3d_edge_polyline::join(const l3d_edge_polyline& first, const l3d_edge_polyline& second,
                             const l3d_dice_view& view) {
    const bool has_strips = first.strips().blocks > 0 && second.strips().blocks > 0;
    const std::size_t middle = first.size_ - 1;
    size_ = middle + second.size_;
    t_.resize(std::max(t_.size(), size_));
    x_.resize(t_.size());
    y_.resize(t_.size());
    inv_w_.resize(t_.size());
    h_.resize(has_strips ? 0 : size_);
    drawable_.resize(h_.size());
    for (std::size_t i = 0; i < size_; ++i) {
        const bool is_first = i < middle;
        const l3d_edge_polyline& from = is_first ? first : second;
        const std::size_t at = is_first ? i : i - middle;
        t_[i] = (from.t_[at] + (is_first ? 0 : 1)) / 2;
        x_[i] = from.x_[at];
        y_[i] = from.y_[at];
        inv_w_[i] = from.inv_w_[at];
        if (has_strips)
            continue;
        const l3d_clip_vertex vertex = from.clip_vertex(at, view);
        h_[i] = {vertex.h[0], vertex.h[1], vertex.h[2]};
        drawable_[i] = vertex.drawable;
    }
    // With three parts, none has the parameters of a piece's side. So all pieces close their slits
    // point by point.
    parts_ = 3;
    strips_[0] = has_strips ? first.strips() : l3d_block_starts{.blocks = 0, .first = {}};
    chord_error_ = std::max(first.chord_error_, second.chord_error_);
    vertex_error_ = std::max(first.vertex_error_, second.vertex_error_);
}

/// Makes any edge, also an edge that has to be clipped, of as many strips as are needed.
void l3d_edge_polyline::cut(const l3d_image_curve& edge, const l3d_dice_view& view) {
    t_.clear();
    x_.clear();
    y_.clear();
    inv_w_.clear();
    h_.clear();
    drawable_.clear();
    chord_error_ = vertex_error_ = 0;
    const bool backwards = l3d_detail::runs_backwards(edge);
    const l3d_image_curve canonical = backwards ? edge.reversed() : edge;
    add_point(canonical.points[0], 0, view);
    add_strip(canonical, 0, 1, 0, view);
    size_ = t_.size();
    if (backwards)
        reverse();
}

void l3d_edge_polyline::add_strip(const l3d_image_curve& strip, double t0, double t1, int level,
                                  const l3d_dice_view& view) {
    const l3d_depth_range depth = l3d_depth_range_of(strip.points);
    const bool in_front = depth.least > view.near;
    l3d_image_box box = view.margin();
    bool visible = !view.section.cuts_off(strip.points) &&
                   !l3d_outside(strip.points, box, view.near, view.far);
    bool small = false;
    if (visible && in_front) {
        const l3d_image_box whole = l3d_image_box_of(strip.points);
        small = l3d_is_one_strip(strip, whole, view);
        box = box.intersected(whole);
        visible = !box.empty();
    }
    if (!visible)
        return add_point(strip.points[3], t1, view);

    const double w_low = view.drawn_w(depth.least);
    const double vertex = points_error(strip, box, in_front, w_low, view);
    const double budget = view.chord_budget(vertex);
    const double depth_budget = view.depth_budget(depth.least);
    double second = l3d_second_bound_of(strip, box, w_low);
    if (view.focal > 0)
        second = std::max(second, l3d_space_bound_of(strip, view.focal, w_low));
    const double depth_second = l3d_depth_bound_of(strip);
    // An edge gets half the budget, as each direction of a quad does. So an edge and the boundary
    // row of a patch mostly have the same steps, and the slit between them is empty. Where things
    // are clipped, neither is finer for outlines.
    const double wanted = std::max({1.0, std::ceil(std::sqrt(second / (4 * budget))),
                                    std::ceil(std::sqrt(depth_second / (8 * depth_budget)))});

    if ((level < usual_level && !small) || (wanted > l3d_most_steps_whole && level < deepest)) {
        const auto [low, high] = strip.split();
        const double middle = (t0 + t1) / 2;
        add_strip(low, t0, middle, level + 1, view);
        add_strip(high, middle, t1, level + 1, view);
        return;
    }
    const int n = static_cast<int>(std::min<double>(wanted, l3d_most_steps_whole));
    for (int i = 1; i < n; ++i) {
        const double t = static_cast<double>(i) / n;
        add_point(strip.evaluate(t), t0 + t * (t1 - t0), view);
    }
    add_point(strip.points[3], t1, view);
    const bool depth_kept = depth_second <= 8.0 * n * n * depth_budget;
    chord_error_ = std::max(chord_error_, depth_kept ? second / (8.0 * n * n)
                                                     : std::numeric_limits<double>::infinity());
    vertex_error_ = std::max(vertex_error_, vertex);
}
