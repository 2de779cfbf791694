// SPDX-License-Identifier: MIT
// Bounds of the sixteen blocks of a patch in SIMD lanes.
#include "pipeline/lane_bounds_p.h"
#include "pipeline/lane_weights_p.h"

#include <cmath>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/lane_bounds.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t points = 16;

using doubles = hn::CappedTag<double, points>;
using floats = hn::CappedTag<float, points>;
using float_lanes = hn::Vec<floats>;

/// What the rounding of floats can add to a second or mixed difference d as it is seen in the
/// image, |d (x, y) - X0 d w| + r |d w|, in units of the largest w times the reach of the centred
/// box: the net is rounded, then summed up twice from four products, 9 roundings of 2^-24, of
/// numbers up to 1 in these units; a difference has 4 of these points and 4 roundings of its own,
/// 40 in all; with that of d w times X0 80 in x and in y, sqrt(2) times 80 in both, and with that
/// of r |d w| 160, r being at most sqrt(2) times the reach, 170. What the norm's own eight
/// operations add relative to it is in `relative`.
constexpr float difference_rounding = 170 * 0x1p-24F, relative = 1 + 8 * 0x1p-23F;

/// The same of w alone.
constexpr float depth_rounding = 40 * 0x1p-24F;

/// Rounding of a projected point, relative to the reach of the centred box: 9 roundings in x
/// and in w, and two of the quotient.
constexpr float projected_rounding = 20 * 0x1p-24F;

/// Box and depths of the whole net; whether it is ordinary. The comparisons fail for NaN.
HWY_ATTR void measure(const double* net, const l3d_dice_view& view, lane_bounds& out) {
    const doubles d;
    auto left = hn::Set(d, HUGE_VAL), top = left, nearest = left;
    auto right = hn::Neg(left), bottom = right, farthest = right;
    for (std::size_t i = 0; i < points; i += hn::Lanes(d)) {
        auto x = hn::Zero(d), y = x, w = x;
        hn::LoadInterleaved3(d, net + 3 * i, x, y, w);
        hn::Store(x, d, out.net.points[0] + i);
        hn::Store(y, d, out.net.points[1] + i);
        hn::Store(w, d, out.net.points[2] + i);
        const auto inverse = hn::Div(hn::Set(d, 1.0), w);
        const auto px = hn::Mul(x, inverse), py = hn::Mul(y, inverse);
        left = hn::Min(left, px);
        right = hn::Max(right, px);
        top = hn::Min(top, py);
        bottom = hn::Max(bottom, py);
        nearest = hn::Min(nearest, w);
        farthest = hn::Max(farthest, w);
    }
    out.least_w = hn::GetLane(hn::MinOfLanes(d, nearest));
    out.most_w = hn::GetLane(hn::MaxOfLanes(d, farthest));
    out.hull = {hn::GetLane(hn::MinOfLanes(d, left)), hn::GetLane(hn::MinOfLanes(d, top)),
                hn::GetLane(hn::MaxOfLanes(d, right)), hn::GetLane(hn::MaxOfLanes(d, bottom))};
    // Min and Max may lose a NaN; a sum does not.
    double sum = 0;
    for (const auto& component : out.net.points)
        for (const double number : component)
            sum += number;
    out.ordinary = sum - sum == 0 && out.least_w > view.near && out.most_w < view.far &&
                   -out.hull.left < l3d_guard_band && -out.hull.top < l3d_guard_band &&
                   out.hull.right < l3d_guard_band && out.hull.bottom < l3d_guard_band;
}

/// Moves the net to the middle of what is seen of it.
HWY_ATTR void centre(lane_bounds& out) {
    centred_net& net = out.net;
    net.x = static_cast<std::int32_t>((out.seen.left + out.seen.right) / 2);
    net.y = static_cast<std::int32_t>((out.seen.top + out.seen.bottom) / 2);
    const doubles d;
    const auto x = hn::Set(d, static_cast<double>(net.x));
    const auto y = hn::Set(d, static_cast<double>(net.y));
    auto largest = hn::Zero(d);
    for (std::size_t i = 0; i < points; i += hn::Lanes(d)) {
        const auto w = hn::Load(d, net.points[2] + i);
        const auto px = hn::Sub(hn::Load(d, net.points[0] + i), hn::Mul(x, w));
        const auto py = hn::Sub(hn::Load(d, net.points[1] + i), hn::Mul(y, w));
        hn::Store(px, d, net.points[0] + i);
        hn::Store(py, d, net.points[1] + i);
        largest = hn::Max(largest, hn::Max(hn::Abs(px), hn::Abs(py)));
    }
    net.largest_xy = hn::GetLane(hn::MaxOfLanes(d, largest));
}

/// The norm of seen_in in step_bound.cpp, for a block a lane.
struct seen_norm {
    float_lanes x, y, radius;

    HWY_ATTR HWY_INLINE float_lanes operator()(float_lanes dx, float_lanes dy,
                                               float_lanes dw) const {
        const auto ex = hn::Sub(dx, hn::Mul(x, dw)), ey = hn::Sub(dy, hn::Mul(y, dw));
        return hn::Add(hn::Sqrt(hn::Add(hn::Mul(ex, ex), hn::Mul(ey, ey))),
                       hn::Mul(radius, hn::Abs(dw)));
    }
};

/// Largest norms of differences of one kind, in the image and of w.
struct largest_of {
    float_lanes image, depth;

    HWY_ATTR HWY_INLINE void take(const seen_norm& norm, float_lanes dx, float_lanes dy,
                                  float_lanes dw) {
        image = hn::Max(image, norm(dx, dy, dw));
        depth = hn::Max(depth, hn::Abs(dw));
    }
};

/// Lanes i on of an array of which each group of four lanes is all one element: `of` in its group.
template <int of> HWY_ATTR HWY_INLINE float_lanes one_of_four(const float* p, std::size_t i) {
#if HWY_TARGET == HWY_SCALAR
    return hn::Load(floats(), p + i / 4 * 4 + of);
#else
    return hn::Broadcast<of>(hn::Load(floats(), p + i));
#endif
}

/// Lanes i on of an array that repeats the four elements at p.
HWY_ATTR HWY_INLINE float_lanes repeated(const float* p, [[maybe_unused]] std::size_t i) {
#if HWY_TARGET == HWY_SCALAR
    return hn::Load(floats(), p + i % 4);
#else
    return hn::LoadDup128(floats(), p);
#endif
}

/// The nets of the blocks: [component][row][column][lane].
struct block_nets {
    alignas(64) float at[3][4][4][points];
};

/// The blocks' nets, first along u in lanes that stand for rows of the net and u-strips, then
/// along v. Shape of net: [component][4 * row + column].
HWY_ATTR void cut(const float (&net)[3][points], block_nets& blocks) {
    const floats d;
    const std::size_t lanes = hn::Lanes(d);
    alignas(64) float strips[3][4][points];
    for (std::size_t i = 0; i < points; i += lanes)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto p0 = one_of_four<0>(net[k], i), p1 = one_of_four<1>(net[k], i);
            const auto p2 = one_of_four<2>(net[k], i), p3 = one_of_four<3>(net[k], i);
            for (std::size_t to = 0; to < 4; ++to) {
                const auto& weight = in_quarters.u[to];
                const auto low = hn::Add(hn::Mul(p0, repeated(weight[0], i)),
                                         hn::Mul(p1, repeated(weight[1], i)));
                const auto high = hn::Add(hn::Mul(p2, repeated(weight[2], i)),
                                          hn::Mul(p3, repeated(weight[3], i)));
                hn::Store(hn::Add(low, high), d, strips[k][to] + i);
            }
        }
    for (std::size_t i = 0; i < points; i += lanes)
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t column = 0; column < 4; ++column) {
                const float* p = strips[k][column];
                const auto p0 = repeated(p, i), p1 = repeated(p + 4, i);
                const auto p2 = repeated(p + 8, i), p3 = repeated(p + 12, i);
                for (std::size_t to = 0; to < 4; ++to) {
                    const auto& weight = in_quarters.v[to];
                    const auto low = hn::Add(hn::Mul(p0, hn::Load(d, weight[0] + i)),
                                             hn::Mul(p1, hn::Load(d, weight[1] + i)));
                    const auto high = hn::Add(hn::Mul(p2, hn::Load(d, weight[2] + i)),
                                              hn::Mul(p3, hn::Load(d, weight[3] + i)));
                    hn::Store(hn::Add(low, high), d, blocks.at[k][to][column] + i);
                }
            }
}

/// Boxes of the blocks from here on, relative to the net's centre.
struct lane_boxes {
    float_lanes left, top, right, bottom, least_w, gap_u, gap_v;
};

HWY_ATTR HWY_INLINE float_lanes larger_gap(float_lanes gap, float_lanes x, float_lanes y,
                                           float_lanes x1, float_lanes y1) {
    return hn::Max(gap, hn::Max(hn::Abs(hn::Sub(x, x1)), hn::Abs(hn::Sub(y, y1))));
}

HWY_ATTR HWY_INLINE lane_boxes boxes_of(const block_nets& blocks, std::size_t lane) {
    const floats d;
    const auto one = hn::Set(d, 1.0F);
    lane_boxes box;
    box.left = box.top = box.least_w = hn::Set(d, HUGE_VALF);
    box.right = box.bottom = hn::Neg(box.left);
    box.gap_u = box.gap_v = hn::Zero(d);
    alignas(64) float above[4][2][points];
    for (std::size_t r = 0; r < 4; ++r) {
        auto x_before = one, y_before = one;
        for (std::size_t c = 0; c < 4; ++c) {
            const auto w = hn::Load(d, blocks.at[2][r][c] + lane);
            const auto inverse = hn::Div(one, w);
            const auto x = hn::Mul(hn::Load(d, blocks.at[0][r][c] + lane), inverse);
            const auto y = hn::Mul(hn::Load(d, blocks.at[1][r][c] + lane), inverse);
            box.left = hn::Min(box.left, x);
            box.right = hn::Max(box.right, x);
            box.top = hn::Min(box.top, y);
            box.bottom = hn::Max(box.bottom, y);
            box.least_w = hn::Min(box.least_w, w);
            if (c > 0)
                box.gap_u = larger_gap(box.gap_u, x, y, x_before, y_before);
            if (r > 0)
                box.gap_v =
                    larger_gap(box.gap_v, x, y, hn::Load(d, above[c][0]), hn::Load(d, above[c][1]));
            hn::Store(x, d, above[c][0]);
            hn::Store(y, d, above[c][1]);
            x_before = x;
            y_before = y;
        }
    }
    return box;
}

/// Second differences of all lines of the blocks, and the mixed ones.
HWY_ATTR HWY_INLINE void take_differences(const block_nets& blocks, std::size_t lane,
                                          const seen_norm& norm, largest_of& uu, largest_of& uv,
                                          largest_of& vv) {
    const floats d;
    const auto at = [&](std::size_t k, std::size_t r, std::size_t c)
                        HWY_ATTR { return hn::Load(d, blocks.at[k][r][c] + lane); };
    for (std::size_t line = 0; line < 4; ++line)
        for (std::size_t i = 0; i < 2; ++i) {
            const auto along_u = [&](std::size_t k) HWY_ATTR {
                const auto middle = at(k, line, i + 1);
                return hn::Sub(hn::Sub(at(k, line, i), middle),
                               hn::Sub(middle, at(k, line, i + 2)));
            };
            const auto along_v = [&](std::size_t k) HWY_ATTR {
                const auto middle = at(k, i + 1, line);
                return hn::Sub(hn::Sub(at(k, i, line), middle),
                               hn::Sub(middle, at(k, i + 2, line)));
            };
            uu.take(norm, along_u(0), along_u(1), along_u(2));
            vv.take(norm, along_v(0), along_v(1), along_v(2));
        }
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto mixed = [&](std::size_t k) HWY_ATTR {
                return hn::Sub(hn::Sub(at(k, r, c), at(k, r, c + 1)),
                               hn::Sub(at(k, r + 1, c), at(k, r + 1, c + 1)));
            };
            uv.take(norm, mixed(0), mixed(1), mixed(2));
        }
}

/// A number a lane, as doubles.
HWY_ATTR HWY_INLINE void put(float_lanes value, l3d_block_needs::per_block& out, std::size_t lane) {
    alignas(64) float numbers[points];
    hn::Store(value, floats(), numbers);
    for (std::size_t i = 0; i < hn::Lanes(floats()); ++i)
        out[lane + i] = static_cast<double>(numbers[i]);
}

/// Needs of sixteen blocks.
HWY_ATTR void bound_blocks(const l3d_dice_view& view, lane_bounds& out) {
    const floats d;
    // Homogeneous points may be scaled: w to at most 1, so that squares stay in a float's range.
    const double scale = 1 / out.most_w;
    alignas(64) float net[3][points];
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < points; ++i)
            net[k][i] = static_cast<float>(out.net.points[k][i] * scale);
    block_nets blocks;
    cut(net, blocks);

    const l3d_image_box margin = view.margin();
    const double x = out.net.x, y = out.net.y;
    const auto reach = static_cast<float>(
        std::max({x - out.hull.left, out.hull.right - x, y - out.hull.top, out.hull.bottom - y}));
    const auto slack = hn::Set(d, projected_rounding * reach);
    const auto rounding = hn::Set(d, difference_rounding * reach);
    const auto zero = hn::Zero(d), half = hn::Set(d, 0.5F);
    l3d_block_needs& needs = out.needs;
    needs.strips = l3d_block_needs::most_strips;
    needs.visible = needs.keeps_depth = false;
    for (std::size_t lane = 0; lane < points; lane += hn::Lanes(d)) {
        const lane_boxes box = boxes_of(blocks, lane);
        const auto left =
            hn::Max(hn::Sub(box.left, slack), hn::Set(d, static_cast<float>(margin.left - x)));
        const auto right =
            hn::Min(hn::Add(box.right, slack), hn::Set(d, static_cast<float>(margin.right - x)));
        const auto top =
            hn::Max(hn::Sub(box.top, slack), hn::Set(d, static_cast<float>(margin.top - y)));
        const auto bottom =
            hn::Min(hn::Add(box.bottom, slack), hn::Set(d, static_cast<float>(margin.bottom - y)));
        const auto width = hn::Sub(right, left), height = hn::Sub(bottom, top);
        const auto visible = hn::And(hn::Ge(width, zero), hn::Ge(height, zero));
        needs.visible = needs.visible || !hn::AllFalse(d, visible);

        seen_norm norm;
        norm.x = hn::Mul(half, hn::Add(left, right));
        norm.y = hn::Mul(half, hn::Add(top, bottom));
        norm.radius =
            hn::Mul(half, hn::Sqrt(hn::Add(hn::Mul(width, width), hn::Mul(height, height))));
        largest_of uu{zero, zero}, uv{zero, zero}, vv{zero, zero};
        take_differences(blocks, lane, norm, uu, uv, vv);

        const auto low_w = hn::Mul(box.least_w, hn::Set(d, 1 - projected_rounding));
        const auto per_w = hn::Div(hn::Set(d, relative), low_w);
        const auto six = hn::Mul(hn::Set(d, 6.0F), per_w), nine = hn::Mul(hn::Set(d, 9.0F), per_w);
        const auto shown = [&](float_lanes value)
                               HWY_ATTR { return hn::IfThenElseZero(visible, value); };
        put(shown(hn::Mul(six, hn::Add(uu.image, rounding))), needs.uu, lane);
        put(shown(hn::Mul(nine, hn::Add(uv.image, rounding))), needs.uv, lane);
        put(shown(hn::Mul(six, hn::Add(vv.image, rounding))), needs.vv, lane);

        const auto gaps = hn::Set(d, static_cast<float>(3 / l3d_largest_quad));
        put(shown(hn::Mul(gaps, box.gap_u)), needs.least_u, lane);
        put(shown(hn::Mul(gaps, box.gap_v)), needs.least_v, lane);

        // See l3d_needs_of; a budget is at most the tolerance, and depths are bounded by an eighth
        // of w in front of the near plane.
        const auto small =
            hn::And(visible, hn::Lt(hn::Add(width, height),
                                    hn::Set(d, static_cast<float>(8 * 2.83 * view.tolerance))));
        if (hn::AllFalse(d, small) && !needs.keeps_depth && lane + hn::Lanes(d) == points)
            continue;
        needs.keeps_depth = needs.keeps_depth || !hn::AllFalse(d, small);
        const auto eighth = hn::Set(d, 8.0F), depth_slack = hn::Set(d, depth_rounding);
        const auto kept = [&](float_lanes factor, float_lanes value) HWY_ATTR {
            return hn::IfThenElseZero(
                small, hn::Mul(hn::Mul(eighth, factor), hn::Add(value, depth_slack)));
        };
        put(kept(six, uu.depth), needs.depth_uu, lane);
        put(kept(nine, uv.depth), needs.depth_uv, lane);
        put(kept(six, vv.depth), needs.depth_vv, lane);
    }
}

/// Needs of a small net, which is one block: the slow twin's sums, its differences in lanes.
HWY_ATTR void bound_whole(const l3d_dice_view& view, lane_bounds& out) {
    // Second differences along u, along v, mixed ones, of 8 + 8 + 9 places; the rest stays zero.
    constexpr std::size_t mixed = 16, count = 32;
    alignas(64) float difference[3][count] = {};
    const double scale = 1 / out.most_w;
    for (std::size_t k = 0; k < 3; ++k) {
        const double* p = out.net.points[k];
        for (std::size_t line = 0; line < 4; ++line)
            for (std::size_t i = 0; i < 2; ++i) {
                const double *u = p + 4 * line + i, *v = p + 4 * i + line;
                difference[k][2 * line + i] = static_cast<float>((u[0] - 2 * u[1] + u[2]) * scale);
                difference[k][8 + 2 * line + i] =
                    static_cast<float>((v[0] - 2 * v[4] + v[8]) * scale);
            }
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c) {
                const double* q = p + 4 * r + c;
                difference[k][mixed + 3 * r + c] =
                    static_cast<float>(((q[0] - q[1]) - (q[4] - q[5])) * scale);
            }
    }
    const floats d;
    const l3d_image_box box = view.margin().intersected(out.hull);
    l3d_block_needs& needs = out.needs;
    needs = {};
    needs.visible = !box.empty();
    if (!needs.visible)
        return;
    const double width = box.width(), height = box.height();
    seen_norm norm;
    norm.x = hn::Set(d, static_cast<float>((box.left + box.right) / 2 - out.net.x));
    norm.y = hn::Set(d, static_cast<float>((box.top + box.bottom) / 2 - out.net.y));
    norm.radius = hn::Set(d, static_cast<float>(std::sqrt(width * width + height * height) / 2));
    alignas(64) float image[count], depth[count];
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto dw = hn::Load(d, difference[2] + i);
        hn::Store(norm(hn::Load(d, difference[0] + i), hn::Load(d, difference[1] + i), dw), d,
                  image + i);
        hn::Store(hn::Abs(dw), d, depth + i);
    }
    const auto largest = [](const float* numbers, std::size_t n) {
        float result = 0;
        for (std::size_t i = 0; i < n; ++i)
            result = std::max(result, numbers[i]);
        return static_cast<double>(result);
    };
    const double reach = std::max({out.net.x - out.hull.left, out.hull.right - out.net.x,
                                   out.net.y - out.hull.top, out.hull.bottom - out.net.y});
    const double low_w = out.least_w * scale;
    const auto image_bound = [&](double factor, const float* numbers, std::size_t n) {
        return factor * static_cast<double>(relative) / low_w *
               (largest(numbers, n) + static_cast<double>(difference_rounding) * reach);
    };
    const auto depth_bound = [&](double factor, const float* numbers, std::size_t n) {
        return 8 * factor / low_w * (largest(numbers, n) + static_cast<double>(depth_rounding));
    };
    needs.uu[0] = image_bound(6, image, 8);
    needs.vv[0] = image_bound(6, image + 8, 8);
    needs.uv[0] = image_bound(9, image + mixed, 9);
    needs.keeps_depth = width + height < 8 * 2.83 * view.tolerance;
    if (needs.keeps_depth) {
        needs.depth_uu[0] = depth_bound(6, depth, 8);
        needs.depth_vv[0] = depth_bound(6, depth + 8, 8);
        needs.depth_uv[0] = depth_bound(9, depth + mixed, 9);
    }
}

HWY_ATTR void bounds(const double* net, const l3d_dice_view& view, lane_bounds& out) {
    measure(net, view, out);
    if (!out.ordinary)
        return;
    out.seen = view.margin().intersected(out.hull);
    if (out.seen.empty())
        out.seen = view.margin();
    centre(out);
    if (out.hull.width() < l3d_small_net && out.hull.height() < l3d_small_net)
        bound_whole(view, out);
    else
        bound_blocks(view, out);
}

} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(bounds);

void bounds_in_lanes(const l3d_image_patch& patch, const l3d_dice_view& view, lane_bounds& out) {
    static_assert(sizeof patch == 48 * sizeof(double), "points without gaps");
    L3D_SIMD_CALL(bounds)(&patch.points[0][0], view, out);
}

} // namespace l3d_detail
#endif
