// SPDX-License-Identifier: MIT
// Makes edges in lanes: bounds and steps of all strips side by side, then the points of each.
#include "dice/edges/edge_strips_p.h"

#include "geom/bezier_patch.h"
#include "dice/drawn_error.h"
#include "dice/near_clip.h"
#include "dice/step_plan.h"

#include <algorithm>
#include <cmath>
#include <functional>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/edges/edge_strips.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "dice/edges/edge_steps-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Halves the curves in all lanes as l3d_bezier_curve::split does.
void split(const cubic& p, cubic& HWY_RESTRICT low, cubic& HWY_RESTRICT high) {
    for (std::size_t l = 0; l < lanes; ++l) {
        const double a = (p[0].at[l] + p[1].at[l]) / 2, b = (p[1].at[l] + p[2].at[l]) / 2,
                     c = (p[2].at[l] + p[3].at[l]) / 2;
        const double ab = (a + b) / 2, bc = (b + c) / 2;
        const double middle = (ab + bc) / 2;
        low[0].at[l] = p[0].at[l];
        low[1].at[l] = a;
        low[2].at[l] = ab;
        low[3].at[l] = middle;
        high[0].at[l] = middle;
        high[1].at[l] = bc;
        high[2].at[l] = c;
        high[3].at[l] = p[3].at[l];
    }
}

/// Cuts each edge into four strips. `edges` has coordinate k of edge e in lane 4 k + e.
void cut_in_four(const cubic& edges, strip_nets& out) {
    std::array<cubic, 2> halves;
    std::array<cubic, most_strips> strips;
    split(edges, halves[0], halves[1]);
    split(halves[0], strips[0], strips[1]);
    split(halves[1], strips[2], strips[3]);
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t s = 0; s < most_strips; ++s)
                for (std::size_t e = 0; e < edges_at_once; ++e)
                    out[k][i].at[4 * s + e] = strips[s][i].at[4 * k + e];
}

/// Converts control values p to coefficients c of powers of t, in the first `used` lanes. Then p(t)
/// = c0 + t (c1 + t (c2 + t c3)).
void to_powers(const cubic& p, std::size_t used, cubic& HWY_RESTRICT c) {
    for (std::size_t l = 0; l < used; ++l) {
        double a0 = p[0].at[l], a1 = p[1].at[l], a2 = p[2].at[l], a3 = p[3].at[l];
        l3d_to_powers(a0, a1, a2, a3);
        c[0].at[l] = a0;
        c[1].at[l] = a1;
        c[2].at[l] = a2;
        c[3].at[l] = a3;
    }
}

/// Writes the points of an edge to its arrays, one strip after the other.
class point_writer {
public:
    point_writer(const l3d_dice_view& view, const edge_strips& out)
        : centre_x_(view.centre_x()), centre_y_(view.centre_y()),
          depth_scale_(static_cast<float>(view.depth_scale)), is_parallel_(view.is_parallel()),
          w_middle_(view.w_middle), depth_slope_(is_parallel_ ? view.depth_slope() : 0), t_(out.t),
          x_(out.x), y_(out.y), inv_w_(out.inv_w) {}

    /// Writes points 0 to n - 1 of a strip of n steps, or in opposite order if `backwards`. Point i
    /// has the parameter t_first + i t_step of the edge as it was given. All points but point 0 are
    /// moved by `balance` times the second derivative.
    void strip(const strip_nets& powers, std::size_t lane, int n, double balance, bool backwards,
               double t_first, double t_step) {
        const hn::ScalableTag<double> d;
        const hn::Rebind<std::int32_t, decltype(d)> di;
        const hn::Rebind<float, decltype(d)> df;
        const auto last = hn::Set(d, n - 1), steps = hn::Set(d, n);
        const auto first = hn::Set(d, backwards ? n - 1 : 0);
        const auto direction = hn::Set(d, backwards ? -1 : 1), one = hn::Set(d, 1);
        const auto count = static_cast<std::size_t>(n);
        for (std::size_t at = 0; at < count; at += hn::Lanes(d)) {
            // Lanes beyond the last point repeat it.
            const auto rising = hn::Min(hn::Iota(d, static_cast<double>(at)), last);
            const auto i = hn::Add(first, hn::Mul(rising, direction));
            const auto t = hn::Div(i, steps);
            const auto moved = hn::IfThenElseZero(hn::Gt(i, hn::Zero(d)), hn::Set(d, balance));
            const auto distance = value(d, powers[2], lane, t, moved);
            const auto w = hn::Div(one, distance);
            const auto x = hn::Mul(value(d, powers[0], lane, t, moved), w);
            const auto y = hn::Mul(value(d, powers[1], lane, t, moved), w);
            hn::StoreU(hn::Add(hn::Set(d, t_first), hn::Mul(i, hn::Set(d, t_step))), d, t_ + at);
            hn::StoreU(hn::Add(snapped(d, di, x), hn::Set(di, centre_x_)), di, x_ + at);
            hn::StoreU(hn::Add(snapped(d, di, y), hn::Set(di, centre_y_)), di, y_ + at);
            const auto depth = is_parallel_
                                   ? hn::DemoteTo(df, depth_of(d, distance))
                                   : hn::Mul(hn::DemoteTo(df, w), hn::Set(df, depth_scale_));
            hn::StoreU(depth, df, inv_w_ + at);
        }
        advance(n);
    }

    /// Writes an end of the edge, which is a corner of all patches at the edge.
    void corner(const l3d_image_point& h, double t, const l3d_dice_view& view) {
        const l3d_micro_vertex vertex = l3d_canonical_vertex(h, view).dice.vertex;
        *t_ = t;
        *x_ = vertex.x;
        *y_ = vertex.y;
        *inv_w_ = vertex.inv_w;
        advance(1);
    }

private:
    /// The value at t of a cubic, less `moved` times its second derivative.
    template <class D>
    static hn::Vec<D> value(D d, const cubic& c, std::size_t lane, hn::Vec<D> t, hn::Vec<D> moved) {
        auto sum = hn::Set(d, c[3].at[lane]);
        for (std::size_t power = 3; power-- > 0;)
            sum = hn::Add(hn::Mul(sum, t), hn::Set(d, c[power].at[lane]));
        const auto second =
            hn::Add(hn::Mul(hn::Set(d, 6 * c[3].at[lane]), t), hn::Set(d, 2 * c[2].at[lane]));
        return hn::Sub(sum, hn::Mul(moved, second));
    }

    /// Rounds to sub-pixels as l3d_snap does: to nearest, ties away from zero.
    template <class D, class I> static hn::Vec<I> snapped(D d, I di, hn::Vec<D> pixels) {
        const auto scaled = hn::Mul(pixels, hn::Set(d, double{l3d_subpixel_one}));
        const auto half = hn::CopySign(hn::Set(d, 0.5), scaled);
        return hn::DemoteTo(di, hn::Add(scaled, half));
    }

    /// l3d_dice_view::depth_at in a parallel projection.
    template <class D> hn::Vec<D> depth_of(D d, hn::Vec<D> w) const {
        return hn::Add(hn::Set(d, l3d_dice_view::middle_depth),
                       hn::Mul(hn::Set(d, depth_slope_), hn::Sub(w, hn::Set(d, w_middle_))));
    }

    void advance(int by) {
        t_ += by;
        x_ += by;
        y_ += by;
        inv_w_ += by;
    }

    std::int32_t centre_x_, centre_y_;
    float depth_scale_;
    bool is_parallel_;
    double w_middle_, depth_slope_;
    double* t_;
    std::int32_t *x_, *y_;
    float* inv_w_;
};

/// The facts about some whole edges that are found before their strips are planned.
struct edge_views {
    std::array<bool, edges_at_once> drawable, one_strip, backwards;
    std::array<double, edges_at_once> vertex_error{};
};

using edge_tag = hn::CappedTag<double, edges_at_once>;
using edge_lanes = hn::Vec<edge_tag>;
using edge_mask = hn::Mask<edge_tag>;

/// A control point of some edges, an edge a lane.
struct edge_points {
    edge_lanes x, y, w;
};

/// Whether a control point certainly can be drawn, and points beside it, too, whatever their
/// rounding. Sections are not looked at; see safely_left.
edge_mask safely_before(const edge_points& h, edge_lanes near, const l3d_dice_view& view) {
    const edge_tag d;
    constexpr double slack = 0x1p-30;
    const auto reach = hn::Mul(hn::Set(d, l3d_guard_band * (1 - slack)), h.w);
    return hn::And(hn::And(hn::Gt(h.w, hn::Mul(near, hn::Set(d, 1 + slack))),
                           hn::Lt(h.w, hn::Set(d, view.far * (1 - slack)))),
                   hn::And(hn::Le(hn::Abs(h.x), reach), hn::Le(hn::Abs(h.y), reach)));
}

/// Whether a section certainly leaves a point, and points beside it, too, whatever their rounding.
bool safely_left(const l3d_image_point& h, const l3d_image_section& cut) {
    constexpr double slack = 0x1p-30;
    const double terms = std::abs(cut.normal[0] * h[0]) + std::abs(cut.normal[1] * h[1]) +
                         std::abs(cut.normal[2] * h[2]) + std::abs(cut.d);
    return cut.distance(h) > slack * terms;
}

/// The answers of runs_backwards for some edges, in lanes.
edge_mask backwards_of(const edge_points (&p)[4]) {
    edge_mask result = hn::Lt(p[3].x, p[0].x), same = hn::Eq(p[3].x, p[0].x);
    const auto take = [&](edge_lanes from, edge_lanes to) HWY_ATTR {
        result = hn::Or(result, hn::And(same, hn::Lt(to, from)));
        same = hn::And(same, hn::Eq(to, from));
    };
    take(p[0].y, p[3].y);
    take(p[0].w, p[3].w);
    take(p[1].x, p[2].x);
    take(p[1].y, p[2].y);
    take(p[1].w, p[2].w);
    return result;
}

/// A number for each edge.
struct alignas(64) edge_numbers {
    double of[edges_at_once];
};

/// The boxes of some edges in the picture, and the sizes of their coordinates.
struct edge_extents {
    edge_numbers left, right, top, bottom, largest_xy, largest_w, least_w;

    void take(const edge_points (&p)[4], std::size_t e) {
        const edge_tag d;
        edge_lanes x[4], y[4];
        auto most = hn::Zero(d);
        for (std::size_t i = 0; i < 4; ++i) {
            x[i] = hn::Div(p[i].x, p[i].w);
            y[i] = hn::Div(p[i].y, p[i].w);
            most = hn::Max(most, hn::Max(hn::Abs(p[i].x), hn::Abs(p[i].y)));
        }
        hn::Store(least_of(x[0], x[1], x[2], x[3]), d, left.of + e);
        hn::Store(greatest_of(x[0], x[1], x[2], x[3]), d, right.of + e);
        hn::Store(least_of(y[0], y[1], y[2], y[3]), d, top.of + e);
        hn::Store(greatest_of(y[0], y[1], y[2], y[3]), d, bottom.of + e);
        hn::Store(most, d, largest_xy.of + e);
        hn::Store(greatest_of(p[0].w, p[1].w, p[2].w, p[3].w), d, largest_w.of + e);
        hn::Store(least_of(p[0].w, p[1].w, p[2].w, p[3].w), d, least_w.of + e);
    }

    l3d_image_box box(std::size_t e) const {
        return {left.of[e], top.of[e], right.of[e], bottom.of[e]};
    }

    /// Bounds the error of an edge's vertices in its visible part.
    double vertex_error(std::size_t e, const l3d_image_box& seen, double share,
                        const l3d_dice_view& view) const {
        l3d_vertex_accuracy accuracy;
        accuracy.error_xy = view.error_xy * share + l3d_power_form_error(largest_xy.of[e]);
        accuracy.error_w = view.error_w * share + l3d_power_form_error(largest_w.of[e]);
        accuracy.w_low = least_w.of[e];
        accuracy.seen_reach = seen.reach();
        accuracy.reach = box(e).reach();
        accuracy.snap_error = l3d_snap_error<double>(accuracy.reach);
        return accuracy.drawn_error(l3d_vertex_accuracy::in_front);
    }
};

/// Finds the facts about some edges. Reverses the control points in `whole` of edges that run
/// backwards.
/// Shape: `whole` has coordinate k of edge e in lane 4 k + e.
edge_views view_edges(const std::array<l3d_image_curve, edges_at_once>& edges,
                      const std::array<double, edges_at_once>& shares, const l3d_dice_view& view,
                      cubic& whole) {
    const edge_tag d;
    edge_views result;
    edge_extents extents;
    edge_numbers nears;
    for (std::size_t e = 0; e < edges_at_once; ++e)
        nears.of[e] = view.near_of(shares[e]);
    for (std::size_t e = 0; e < edges_at_once; e += hn::Lanes(d)) {
        const auto at = [&](std::size_t i, std::size_t k) { return &whole[i].at[4 * k + e]; };
        edge_points p[4];
        for (std::size_t i = 0; i < 4; ++i)
            p[i] = {hn::Load(d, at(i, 0)), hn::Load(d, at(i, 1)), hn::Load(d, at(i, 2))};
        const auto near = hn::Load(d, nears.of + e);
        const auto drawable =
            hn::And(hn::And(safely_before(p[0], near, view), safely_before(p[1], near, view)),
                    hn::And(safely_before(p[2], near, view), safely_before(p[3], near, view)));
        const auto backwards = backwards_of(p);
        extents.take(p, e);
        for (std::size_t i = 0; i < 4; ++i) {
            const edge_points& other = p[3 - i];
            hn::Store(hn::IfThenElse(backwards, other.x, p[i].x), d, at(i, 0));
            hn::Store(hn::IfThenElse(backwards, other.y, p[i].y), d, at(i, 1));
            hn::Store(hn::IfThenElse(backwards, other.w, p[i].w), d, at(i, 2));
        }
        std::uint8_t drawable_bits[8] = {}, backwards_bits[8] = {};
        hn::StoreMaskBits(d, drawable, drawable_bits);
        hn::StoreMaskBits(d, backwards, backwards_bits);
        for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
            result.drawable[e + lane] = (drawable_bits[0] >> lane & 1) != 0;
            result.backwards[e + lane] = (backwards_bits[0] >> lane & 1) != 0;
        }
    }
    const l3d_image_box margin = view.margin();
    for (std::size_t e = 0; e < edges_at_once; ++e) {
        if (view.section.is_on())
            for (const l3d_image_point& p : edges[e].points)
                result.drawable[e] = result.drawable[e] && safely_left(p, view.section);
        const l3d_image_box box = extents.box(e), seen = box.intersected(margin);
        result.one_strip[e] =
            result.drawable[e] && (seen.empty() || l3d_is_one_strip(edges[e], box, view));
        if (result.drawable[e] && !seen.empty())
            result.vertex_error[e] = extents.vertex_error(e, seen, shares[e], view);
    }
    return result;
}

/// The numbers on which the steps of some edges' strips depend.
strip_wishes wishes_of(const edge_views& seen, const l3d_dice_view& view) {
    strip_wishes wishes;
    for (std::size_t e = 0; e < edges_at_once; ++e) {
        const double per_budget =
            view.finer_outlines() / (4 * view.chord_budget(seen.vertex_error[e]));
        for (std::size_t lane = e; lane < lanes; lane += edges_at_once) {
            wishes.per_budget.at[lane] = per_budget;
            wishes.balance.at[lane] = seen.one_strip[e] ? 1 : 8 * l3d_balance;
            wishes.grown_by.at[lane] = seen.one_strip[e] ? 0 : view.most_moved();
        }
    }
    return wishes;
}

/// The steps, errors and polynomials of some edges' strips. Shape: strip s of edge e in lane 4 s +
/// e.
struct planned_strips {
    row steps, chord_error;
    strip_nets powers;
};

/// Writes the points of edge number e.
void write_edge(const l3d_image_curve& edge, std::size_t e, const edge_views& seen,
                const planned_strips& plan, const l3d_dice_view& view, edge_strips& out) {
    out.strips = {0, {}};
    out.too_long = false;
    if (!seen.drawable[e])
        return;
    const std::size_t strips = seen.one_strip[e] ? 1 : most_strips;
    const bool backwards = seen.backwards[e];
    std::array<int, most_strips> n{};
    int most = 0;
    out.chord_error = 0;
    for (std::size_t s = 0; s < strips; ++s) {
        const std::size_t lane = 4 * s + e;
        n[s] = static_cast<int>(plan.steps.at[lane]);
        most = std::max(most, n[s]);
        out.chord_error = std::max(out.chord_error, plan.chord_error.at[lane]);
    }
    out.too_long = most > l3d_most_steps_whole;
    if (out.too_long)
        return;
    out.vertex_error = seen.vertex_error[e];
    out.strips.blocks = static_cast<int>(strips);
    point_writer writer(view, out);
    if (backwards)
        writer.corner(edge.points[0], 0, view);
    for (std::size_t s = 0; s < strips; ++s) {
        const std::size_t of = backwards ? strips - 1 - s : s;
        const double t_start = static_cast<double>(of) / static_cast<double>(strips);
        const double t_step = 1.0 / (static_cast<double>(strips) * n[of]);
        const double balance = strips > 1 && n[of] > 1 ? l3d_balanced_error(n[of]) : 0.0;
        writer.strip(plan.powers, 4 * of + e, n[of], balance, backwards,
                     backwards ? 1 - t_start : t_start, backwards ? -t_step : t_step);
        out.strips.first[s + 1] = out.strips.first[s] + n[of];
    }
    if (!backwards)
        writer.corner(edge.points[3], 1, view);
}

} // namespace

void make_edge_strips(const std::array<l3d_image_curve, edges_at_once>& edges,
                      const l3d_dice_view& view, const std::array<double, edges_at_once>& shares,
                      std::array<edge_strips, edges_at_once>& results) {
    cubic whole{};
    for (std::size_t e = 0; e < edges_at_once; ++e)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                whole[i].at[4 * k + e] = edges[e].points[i][static_cast<int>(k)];
    const edge_views seen = view_edges(edges, shares, view, whole);
    const bool has_strips = !std::ranges::all_of(seen.one_strip, std::identity());
    const std::size_t used = has_strips ? lanes : edges_at_once;
    strip_nets nets;
    if (has_strips) {
        cut_in_four(whole, nets);
        for (std::size_t e = 0; e < edges_at_once; ++e)
            if (seen.one_strip[e])
                for (std::size_t k = 0; k < 3; ++k)
                    for (std::size_t i = 0; i < 4; ++i)
                        nets[k][i].at[e] = whole[i].at[4 * k + e];
    } else {
        // Vectors may be wider than the lanes in use. Lanes behind get 0, since chance numbers may
        // be denormal, which is slow.
        const std::size_t wide = std::max(used, hn::Lanes(hn::CappedTag<double, lanes>()));
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 4; ++i) {
                std::copy_n(whole[i].at + 4 * k, used, nets[k][i].at);
                std::fill_n(nets[k][i].at + used, wide - used, 0.0);
            }
    }
    planned_strips plan;
    plan_strips(nets, used, view.margin(), view.focal, wishes_of(seen, view), plan.steps,
                plan.chord_error);
    for (std::size_t k = 0; k < 3; ++k)
        to_powers(nets[k], used, plan.powers[k]);
    for (std::size_t e = 0; e < edges_at_once; ++e)
        write_edge(edges[e], e, seen, plan, view, results[e]);
}

} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(make_edge_strips);

void make_edge_strips(const std::array<l3d_image_curve, edges_at_once>& edges,
                      const l3d_dice_view& view, const std::array<double, edges_at_once>& shares,
                      std::array<edge_strips, edges_at_once>& results) {
    L3D_SIMD_CALL(make_edge_strips)(edges, view, shares, results);
}

} // namespace l3d_detail
#endif
