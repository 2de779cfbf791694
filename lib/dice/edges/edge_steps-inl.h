// SPDX-License-Identifier: MIT
// Finds the steps of the strips of edges, from bounds of their chords' errors, a strip a lane.
#if defined(L3D_DICE_EDGES_EDGE_STEPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_DICE_EDGES_EDGE_STEPS_INL_H
#undef L3D_DICE_EDGES_EDGE_STEPS_INL_H
#else
#define L3D_DICE_EDGES_EDGE_STEPS_INL_H
#endif

#include "dice/edges/edge_strips_p.h"
#include "raster/parallel/lane_doubles-inl.h"

#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

constexpr std::size_t most_strips = l3d_block_starts::most_blocks;
constexpr std::size_t lanes = edges_at_once * most_strips;

/// One number for each strip of four edges: element 4 s + e is for strip s of edge e.
struct alignas(64) row {
    double at[lanes];
};

/// One coordinate of the cubics of all strips: four control values, or four coefficients of powers
/// of t.
using cubic = std::array<row, 4>;

/// The strips' control points: [coordinate][control point].
using strip_nets = std::array<cubic, 3>;

template <class V> V length(V x, V y) {
    return hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
}
template <class V> V greatest_of(V a, V b, V c, V d) {
    return hn::Max(hn::Max(a, b), hn::Max(c, d));
}
template <class V> V least_of(V a, V b, V c, V d) {
    return hn::Min(hn::Min(a, b), hn::Min(c, d));
}

/// Computes the bound of l3d_space_bound_of for the strips from lane l on. The result is not yet
/// divided by w, and lacks the factor 6.
HWY_ATTR number space_bend(const strip_nets& nets, std::size_t l, double focal) {
    const eight_doubles d;
    const number zero = same(0), one = same(1), scale = same(focal);
    const auto at = [&](std::size_t i) HWY_ATTR {
        return vector{loaded(&nets[0][i].at[l]), loaded(&nets[1][i].at[l]),
                      scale * loaded(&nets[2][i].at[l])};
    };
    const auto size_of = [](const vector& a) HWY_ATTR { return root(squared(a)); };
    // The length of the part of a across b, times the length of b.
    const auto across = [&](const vector& a, const vector& b) HWY_ATTR {
        return size_of(vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x});
    };
    const vector p[4] = {at(0), at(1), at(2), at(3)};
    const vector sides[3] = {p[1] - p[0], p[2] - p[1], p[3] - p[2]};
    const vector chord = p[3] - p[0];
    const number length = size_of(chord);
    const auto is_point = hn::Le(length.v, zero.v);
    const number over_length = one / number{hn::IfThenElse(is_point, one.v, length.v)};
    number sine = zero;
    for (const vector& side : sides) {
        const number size = size_of(side);
        const auto none = hn::Le(size.v, zero.v);
        const number of_side =
            across(side, chord) / number{hn::IfThenElse(none, one.v, size.v)} * over_length;
        const auto ahead = hn::Gt(dot(side, chord).v, zero.v);
        const auto turned = hn::IfThenElse(ahead, of_side.v, one.v);
        sine = largest(sine, number{hn::IfThenElse(none, zero.v, turned)});
    }
    sine = number{hn::IfThenElse(is_point, hn::Set(d, 1), sine.v)};
    number most = zero;
    for (std::size_t i = 0; i < 2; ++i) {
        const vector bend = sides[i + 1] - sides[i];
        const number size = size_of(bend);
        const number off = across(bend, chord) * over_length + sine * size;
        most = largest(most, number{hn::Min(off.v, size.v)});
    }
    return most;
}

/// The numbers on which the choice of each strip's steps depends.
struct strip_wishes {
    /// 1 / (4 budget), times the factor for finer outlines (l3d_dice_view::finer_outlines). An edge
    /// gets half the budget, as each direction of a quad does. So an edge and the boundary row of a
    /// patch mostly have the same steps, and the slit between them is empty.
    row per_budget;
    /// The factor by which balancing changes the square of the number of steps: 8 l3d_balance, or 1
    /// without balance.
    row balance;
    row grown_by; ///< the largest distance by which balancing moves vertices
};

/// Finds the number of steps and the chord errors of all strips, by the bounds of
/// l3d_second_bound_of and l3d_depth_bound_of. The errors are those of unbalanced chords, since
/// chords in slits are not balanced. Only the first `used` lanes count, but whole vectors are
/// written.
void plan_strips(const strip_nets& nets, std::size_t used, const l3d_image_box& window,
                 double focal, const strip_wishes& wishes, row& steps, row& chord_error) {
    const hn::CappedTag<double, lanes> d;
    using vec = hn::Vec<decltype(d)>;
    const vec zero = hn::Zero(d), one = hn::Set(d, 1), two = hn::Set(d, 2), six = hn::Set(d, 6),
              half = hn::Set(d, 0.5);
    for (std::size_t l = 0; l < used; l += hn::Lanes(d)) {
        const auto at = [&](int k, std::size_t i) {
            return hn::Load(d, &nets[static_cast<std::size_t>(k)][i].at[l]);
        };
        vec over_w[4], x[4], y[4];
        for (std::size_t i = 0; i < 4; ++i) {
            over_w[i] = hn::Div(one, at(2, i));
            x[i] = hn::Mul(at(0, i), over_w[i]);
            y[i] = hn::Mul(at(1, i), over_w[i]);
        }
        const vec grown_by = hn::Load(d, &wishes.grown_by.at[l]);
        const auto least = [&](const vec(&v)[4], double limit) {
            return hn::Max(hn::Set(d, limit), hn::Sub(least_of(v[0], v[1], v[2], v[3]), grown_by));
        };
        const auto greatest = [&](const vec(&v)[4], double limit) {
            return hn::Min(hn::Set(d, limit),
                           hn::Add(greatest_of(v[0], v[1], v[2], v[3]), grown_by));
        };
        const vec left = least(x, window.left), right = greatest(x, window.right);
        const vec top = least(y, window.top), bottom = greatest(y, window.bottom);
        const vec width = hn::Sub(right, left), height = hn::Sub(bottom, top);
        const auto visible = hn::And(hn::Ge(width, zero), hn::Ge(height, zero));
        const vec centre_x = hn::Mul(hn::Add(left, right), half);
        const vec centre_y = hn::Mul(hn::Add(top, bottom), half);
        const vec radius = hn::Mul(length(width, height), half);

        vec bound = zero, depth_bound = zero;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto second = [&](int k) {
                return hn::Add(hn::Sub(at(k, i), hn::Mul(two, at(k, i + 1))), at(k, i + 2));
            };
            const vec dw = second(2);
            const vec dx = hn::Sub(second(0), hn::Mul(centre_x, dw));
            const vec dy = hn::Sub(second(1), hn::Mul(centre_y, dw));
            const vec change = hn::Abs(dw);
            bound = hn::Max(bound, hn::Add(length(dx, dy), hn::Mul(radius, change)));
            depth_bound = hn::Max(depth_bound, change);
        }
        const vec six_over_w =
            hn::Mul(six, greatest_of(over_w[0], over_w[1], over_w[2], over_w[3]));
        if (focal > 0)
            bound = hn::Max(bound, space_bend(nets, l, focal).v);
        bound = hn::Mul(bound, six_over_w);
        // More than 32 steps are too many, however many.
        const vec most = hn::Set(d, 4.0 * l3d_most_steps_whole * l3d_most_steps_whole);
        const vec in_image = hn::Min(hn::Mul(bound, hn::Load(d, &wishes.per_budget.at[l])), most);
        const vec balanced = hn::Mul(in_image, hn::Load(d, &wishes.balance.at[l]));
        // w may be off by an eighth, l3d_dice_view::depth_budget.
        const vec in_depth = hn::Min(hn::Mul(depth_bound, six_over_w), most);
        const vec wanted = hn::Ceil(hn::Sqrt(hn::Max(balanced, in_depth)));
        const vec least_steps = hn::IfThenElse(hn::Le(in_image, one), one, two);
        const vec n = hn::IfThenElse(visible, hn::Max(least_steps, wanted), one);
        const vec error = hn::Div(bound, hn::Mul(hn::Set(d, 8), hn::Mul(n, n)));
        hn::Store(n, d, &steps.at[l]);
        hn::Store(hn::IfThenElseZero(visible, error), d, &chord_error.at[l]);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
