// SPDX-License-Identifier: MIT
// bounds_in_lanes: finds the needs of a patch's sixteen blocks in SIMD lanes.
#include "dice/lanes/lane_bounds_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/lanes/lane_bounds.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "dice/lanes/lane_blocks-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using doubles = hn::CappedTag<double, points>;

/// Bounds what the rounding of floats adds to the norm of a second or mixed difference d. In the
/// image, the norm is |d (x, y) - X0 d w| + r |d w|.
/// Units: the largest w times the reach of the centred box.
///
/// The net is rounded, then summed up twice from four products: 9 roundings of 2^-24, of numbers up
/// to 1 in these units. A difference has 4 of these points and 4 roundings of its own: 40 in all.
/// With X0 d w there are 80 roundings in x and in y, and sqrt(2) times 80 for both together. The
/// error of r |d w| is 40 times r, and r is at most sqrt(2) times the reach: 170 in all. `relative`
/// covers the eight operations of the norm.
constexpr float difference_rounding = 170 * 0x1p-24F, relative = 1 + 8 * 0x1p-23F;

/// The same bound for third and fourth differences of a whole net. These are made in doubles and
/// rounded to floats once. In these units the differences of x and y are at most 16. Since w is
/// positive, differences of w are at most 8. Their rounding is 16 + 8; the rounding of X0 d w is 8,
/// and that of X0 is 8. In the image norm the sum is sqrt(2) (16 + 8 + 8 + 8) = 57.
constexpr float mixed_rounding = 64 * 0x1p-24F;

/// The same bound for second and mixed differences of w alone.
constexpr float depth_rounding = 40 * 0x1p-24F;

/// Bounds the rounding of a projected point, relative to the reach of the centred box. There are 9
/// roundings of x, 9 of w, and two of the quotient.
constexpr float projected_rounding = 20 * 0x1p-24F;

bool section_leaves(const double* net, const l3d_image_section& cut) {
    if (!cut.is_on())
        return true;
    bool all = true;
    for (std::size_t i = 0; i < 3 * points; i += 3)
        all = all && cut.distance({net[i], net[i + 1], net[i + 2]}) > 0;
    return all;
}

/// Measures the box and the depths of the whole net, and sets `ordinary`. For NaN all comparisons
/// are false, so the net is not ordinary.
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
                   out.hull.right < l3d_guard_band && out.hull.bottom < l3d_guard_band &&
                   section_leaves(net, view.section);
}

/// Centres the net on the middle of its visible part.
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

/// Stores lanes as doubles, from out[lane] on.
HWY_ATTR HWY_INLINE void put(float_lanes value, l3d_block_needs::per_block& out, std::size_t lane) {
    alignas(64) float numbers[points];
    hn::Store(value, floats(), numbers);
    for (std::size_t i = 0; i < hn::Lanes(floats()); ++i)
        out[lane + i] = static_cast<double>(numbers[i]);
}

/// The reach: the largest |x' / w| or |y' / w| of the centred net.
double reach_of(const lane_bounds& of) {
    const double x = of.net.x, y = of.net.y;
    return std::max({x - of.hull.left, of.hull.right - x, y - of.hull.top, of.hull.bottom - y});
}

/// The size below which a block needs bounds of depth, too. A block's size is the sum of the width
/// and height of its box in the picture. See l3d_needs_of; 2.83 > 2 sqrt(2).
double depth_matters_below(const l3d_dice_view& view, bool balanced) {
    return (balanced ? 1 / l3d_balance : 8) * 2.83 * view.chord_budget(0);
}

/// All that bounds of blocks depend on, besides the blocks' nets. Places are relative to the net's
/// centre.
struct block_surroundings {
    const l3d_image_box& window; ///< the largest box that may be seen
    float reach;                 ///< largest |x' / w| or |y' / w|
    float grown_by;              ///< how far drawn vertices may lie beyond the net's box
    float deep_below;            ///< see depth_matters_below
    float most_w;
};

/// Finds the needs of one vector of blocks, from block `lane` on.
HWY_ATTR HWY_INLINE void bound_lanes(const block_nets& blocks, std::size_t lane,
                                     const block_surroundings& in, l3d_block_needs& needs) {
    // The visible part of each block.
    const floats d;
    const auto limit = [&](double number)
                           HWY_ATTR { return hn::Set(d, static_cast<float>(number)); };
    const auto zero = hn::Zero(d), half = hn::Set(d, 0.5F);
    const auto slack = hn::Set(d, projected_rounding * in.reach + in.grown_by);
    const lane_boxes box = boxes_of(blocks, lane);
    const auto left = hn::Max(hn::Sub(box.left, slack), limit(in.window.left));
    const auto right = hn::Min(hn::Add(box.right, slack), limit(in.window.right));
    const auto top = hn::Max(hn::Sub(box.top, slack), limit(in.window.top));
    const auto bottom = hn::Min(hn::Add(box.bottom, slack), limit(in.window.bottom));
    const auto width = hn::Sub(right, left), height = hn::Sub(bottom, top);
    const auto visible = hn::And(hn::Ge(width, zero), hn::Ge(height, zero));
    const auto deep = hn::And(visible, hn::Lt(hn::Add(width, height), hn::Set(d, in.deep_below)));
    needs.visible = needs.visible || !hn::AllFalse(d, visible);
    needs.keeps_depth = needs.keeps_depth || !hn::AllFalse(d, deep);

    // The largest second differences, by the norm for the visible part.
    const auto diagonal = hn::Sqrt(hn::Add(hn::Mul(width, width), hn::Mul(height, height)));
    const seen_norm norm{hn::Mul(half, hn::Add(left, right)), hn::Mul(half, hn::Add(top, bottom)),
                         hn::Mul(half, diagonal)};
    largest_of uu{zero, zero}, uv{zero, zero}, vv{zero, zero};
    take_differences(blocks, lane, norm, uu, uv, vv);

    // Bounds of second derivatives in the picture and along the view axis.
    const auto low_w = hn::Mul(box.least_w, hn::Set(d, 1 - projected_rounding));
    const auto per_w = hn::Div(hn::Set(d, relative), low_w);
    const auto six = hn::Mul(hn::Set(d, 6.0F), per_w), nine = hn::Mul(hn::Set(d, 9.0F), per_w);
    const auto image_bound = [&](float_lanes factor, const largest_of& of) HWY_ATTR {
        const auto rounding = hn::Set(d, difference_rounding * in.reach);
        return hn::IfThenElseZero(visible, hn::Mul(factor, hn::Add(of.image, rounding)));
    };
    put(hn::Mul(low_w, hn::Set(d, in.most_w)), needs.least_w, lane);
    put(image_bound(six, uu), needs.uu, lane);
    put(image_bound(nine, uv), needs.uv, lane);
    put(image_bound(six, vv), needs.vv, lane);
    // In front of the near plane, w may be off by an eighth of itself.
    const auto depth_bound = [&](float_lanes factor, const largest_of& of) HWY_ATTR {
        const auto rounded_up = hn::Add(of.depth, hn::Set(d, depth_rounding));
        return hn::IfThenElseZero(deep, hn::Mul(hn::Mul(hn::Set(d, 8.0F), factor), rounded_up));
    };
    put(depth_bound(six, uu), needs.depth_uu, lane);
    put(depth_bound(nine, uv), needs.depth_uv, lane);
    put(depth_bound(six, vv), needs.depth_vv, lane);

    // Fewest steps, by the gaps between control points.
    const auto per_gap = hn::Set(d, static_cast<float>(3 / l3d_largest_quad));
    put(hn::IfThenElseZero(visible, hn::Mul(per_gap, box.gap_u)), needs.least_u, lane);
    put(hn::IfThenElseZero(visible, hn::Mul(per_gap, box.gap_v)), needs.least_v, lane);
}

/// The norm of differences in the picture, for the visible part of a net.
HWY_ATTR seen_norm norm_of(const l3d_image_box& seen, const centred_net& net) {
    const floats d;
    const double width = seen.width(), height = seen.height();
    const double diagonal = std::sqrt(width * width + height * height);
    return {hn::Set(d, static_cast<float>((seen.left + seen.right) / 2 - net.x)),
            hn::Set(d, static_cast<float>((seen.top + seen.bottom) / 2 - net.y)),
            hn::Set(d, static_cast<float>(diagonal / 2))};
}

/// Computes the image norm of each of `Count` differences, stored component by component.
template <std::size_t Count>
HWY_ATTR HWY_INLINE void norms_of(const float (&at)[3][Count], const seen_norm& norm,
                                  float (&image)[Count]) {
    const floats d;
    for (std::size_t i = 0; i < Count; i += hn::Lanes(d)) {
        const auto x = hn::Load(d, at[0] + i), y = hn::Load(d, at[1] + i);
        hn::Store(norm(x, y, hn::Load(d, at[2] + i)), d, image + i);
    }
}

/// The mixed third and fourth differences of a net, side by side.
struct mixed_differences {
    static constexpr std::size_t uuv = 0, uvv = 6, uuvv = 12, end = 16;
    alignas(64) float at[3][end];

    mixed_differences(const centred_net& net, double scale) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double* p = net.points[k];
            double u[2][4], v[2][4]; // second differences along u, by row; along v, by column
            for (std::size_t line = 0; line < 4; ++line)
                for (std::size_t i = 0; i < 2; ++i) {
                    const double *row = p + 4 * line + i, *column = p + 4 * i + line;
                    u[i][line] = (row[0] - 2 * row[1] + row[2]) * scale;
                    v[i][line] = (column[0] - 2 * column[4] + column[8]) * scale;
                }
            for (std::size_t i = 0; i < 2; ++i)
                for (std::size_t j = 0; j < 3; ++j) {
                    at[k][uuv + 3 * i + j] = static_cast<float>(u[i][j + 1] - u[i][j]);
                    at[k][uvv + 3 * i + j] = static_cast<float>(v[i][j + 1] - v[i][j]);
                    if (j < 2)
                        at[k][uuvv + 2 * i + j] =
                            static_cast<float>(u[i][j] - 2 * u[i][j + 1] + u[i][j + 2]);
                }
        }
    }
};

/// Bounds the mixed third and fourth derivatives over the whole net, by the blocks' parameters.
/// These bounds count only where vertices are balanced.
HWY_ATTR void bound_mixed(const l3d_dice_view& view, lane_bounds& out) {
    const l3d_image_box box = view.margin().intersected(view.drawn_box(out.hull));
    out.needs.uuv = out.needs.uvv = out.needs.uuvv = 0;
    if (box.empty())
        return;
    const double scale = 1 / out.most_w;
    using differences = mixed_differences;
    const differences of(out.net, scale);
    alignas(64) float image[differences::end];
    norms_of(of.at, norm_of(box, out.net), image);
    const auto bound = [&](std::size_t from, std::size_t to, double factor) {
        const auto largest = static_cast<double>(*std::max_element(image + from, image + to));
        return factor / (out.least_w * scale) * static_cast<double>(relative) *
               (largest + static_cast<double>(mixed_rounding) * reach_of(out));
    };
    out.needs.uuv = bound(differences::uuv, differences::uvv, 18.0 / 64);
    out.needs.uvv = bound(differences::uvv, differences::uuvv, 18.0 / 64);
    out.needs.uuvv = bound(differences::uuvv, differences::end, 36.0 / 256);
}

/// Finds the needs of sixteen blocks.
HWY_ATTR void bound_blocks(const l3d_dice_view& view, lane_bounds& out) {
    // Homogeneous points may be scaled. With w of at most 1, squares stay in the range of a float.
    const double scale = 1 / out.most_w;
    alignas(64) float net[3][points];
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < points; ++i)
            net[k][i] = static_cast<float>(out.net.points[k][i] * scale);
    block_nets blocks;
    cut(net, blocks);

    const l3d_image_box margin = view.margin();
    const double x = out.net.x, y = out.net.y;
    const l3d_image_box window{margin.left - x, margin.top - y, margin.right - x,
                               margin.bottom - y};
    out.needs.strips = l3d_block_needs::most_strips;
    out.needs.visible = out.needs.keeps_depth = out.needs.keeps_bends = false;
    out.needs.balanced = true;
    const block_surroundings in{.window = window,
                                .reach = static_cast<float>(reach_of(out)),
                                .grown_by = static_cast<float>(view.most_moved()),
                                .deep_below = static_cast<float>(depth_matters_below(view, true)),
                                .most_w = static_cast<float>(out.most_w * (1 - 0x1p-22))};
    for (std::size_t lane = 0; lane < points; lane += hn::Lanes(floats()))
        bound_lanes(blocks, lane, in, out.needs);
    bound_mixed(view, out);
}

/// The differences of a whole net: 8 second differences along u, 8 along v, and 9 mixed
/// differences.
struct net_differences {
    static constexpr std::size_t along_u = 0, along_v = 8, mixed = 16, end = 25, room = 32;
    alignas(64) float at[3][room];

    /// Takes differences of doubles, then scales them and rounds them to floats.
    HWY_ATTR net_differences(const centred_net& net, double scale) {
        const hn::CappedTag<double, 4> d;
        const hn::Rebind<float, decltype(d)> df;
        const auto two = hn::Set(d, 2.0), factor = hn::Set(d, scale);
        for (std::size_t k = 0; k < 3; ++k) {
            alignas(64) double p[points + 4]; // vectors may reach beyond the last row
            std::copy_n(net.points[k], points, p);
            std::fill_n(p + points, 4, 0.0);
            const auto load = [&](std::size_t i) HWY_ATTR { return hn::LoadU(d, p + i); };
            // The next differences overwrite the lanes behind those that are wanted.
            const auto put_at = [&](std::size_t i, auto difference) HWY_ATTR {
                hn::StoreU(hn::DemoteTo(df, hn::Mul(difference, factor)), df, at[k] + i);
            };
            const auto second = [&](std::size_t i, std::size_t step) HWY_ATTR {
                return hn::Add(hn::Sub(load(i), hn::Mul(two, load(i + step))), load(i + 2 * step));
            };
            const auto twist = [&](std::size_t i) HWY_ATTR {
                return hn::Sub(hn::Sub(load(i), load(i + 1)), hn::Sub(load(i + 4), load(i + 5)));
            };
            for (std::size_t line = 0; line < 4; ++line)
                for (std::size_t column = 0; column < 2; column += hn::Lanes(d))
                    put_at(along_u + 2 * line + column, second(4 * line + column, 1));
            for (std::size_t i = 0; i < 8; i += hn::Lanes(d))
                put_at(along_v + i, second(i, 4));
            for (std::size_t row = 0; row < 3; ++row)
                for (std::size_t column = 0; column < 3; column += hn::Lanes(d))
                    put_at(mixed + 3 * row + column, twist(4 * row + column));
            std::fill_n(at[k] + end, room - end, 0.0F);
        }
    }
};

/// Forgets the needs of a former net. Only the needs of the first block are cleared, since no other
/// is read. Clearing all would take as long as finding the needs of one block.
void begin_one_block(l3d_block_needs& needs) {
    needs.strips = 1;
    needs.keeps_depth = needs.keeps_bends = needs.balanced = false;
    needs.uuv = needs.uvv = needs.uuvv = 0;
    for (l3d_block_needs::per_block* of :
         {&needs.uu, &needs.uv, &needs.vv, &needs.depth_uu, &needs.depth_uv, &needs.depth_vv,
          &needs.least_w, &needs.least_u, &needs.least_v})
        (*of)[0] = 0;
}

/// Finds the needs of a net that is one block, with its differences in lanes.
HWY_ATTR void bound_whole(const l3d_dice_view& view, lane_bounds& out) {
    l3d_block_needs& needs = out.needs;
    begin_one_block(needs);
    const l3d_image_box box = view.margin().intersected(out.hull);
    needs.visible = !box.empty();
    if (!needs.visible)
        return;
    needs.least_w[0] = out.least_w;
    const double scale = 1 / out.most_w;
    using differences = net_differences;
    const differences of(out.net, scale);
    alignas(64) float image[differences::room];
    norms_of(of.at, norm_of(box, out.net), image);
    const double low_w = out.least_w * scale;
    const auto bound = [&](const float* numbers, std::size_t from, std::size_t to, double factor,
                           double rounding) {
        const auto largest = static_cast<double>(*std::max_element(numbers + from, numbers + to));
        return factor / low_w * (largest + rounding);
    };
    const double rounding = static_cast<double>(difference_rounding) * reach_of(out);
    const double six = 6 * static_cast<double>(relative), nine = six * 3 / 2;
    needs.uu[0] = bound(image, differences::along_u, differences::along_v, six, rounding);
    needs.vv[0] = bound(image, differences::along_v, differences::mixed, six, rounding);
    needs.uv[0] = bound(image, differences::mixed, differences::end, nine, rounding);
    needs.keeps_depth = box.width() + box.height() < depth_matters_below(view, false);
    if (!needs.keeps_depth)
        return;
    const auto of_w = static_cast<double>(depth_rounding);
    float depth[differences::end];
    std::transform(of.at[2], of.at[2] + differences::end, depth,
                   [](float dw) { return std::abs(dw); });
    needs.depth_uu[0] = bound(depth, differences::along_u, differences::along_v, 8 * six, of_w);
    needs.depth_vv[0] = bound(depth, differences::along_v, differences::mixed, 8 * six, of_w);
    needs.depth_uv[0] = bound(depth, differences::mixed, differences::end, 8 * nine, of_w);
}

/// Sets the fewest steps of a net that is one block although it is not small.
void bound_gaps(const l3d_image_patch& net, l3d_block_needs& needs) {
    const auto [along_u, along_v] = l3d_image_gaps_of(net);
    needs.least_u[0] = 3 / l3d_largest_quad * along_u;
    needs.least_v[0] = 3 / l3d_largest_quad * along_v;
}

HWY_ATTR void bounds(const l3d_image_patch& net, const l3d_dice_view& view, lane_bounds& out) {
    measure(&net.points[0][0], view, out);
    if (!out.ordinary)
        return;
    out.seen = view.margin().intersected(out.hull);
    if (out.seen.empty())
        out.seen = view.margin();
    centre(out);
    if (l3d_is_one_block(net, out.hull, view)) {
        bound_whole(view, out);
        if (!l3d_is_small(out.hull))
            bound_gaps(net, out.needs);
    } else {
        bound_blocks(view, out);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(bounds);

void bounds_in_lanes(const l3d_image_patch& patch, const l3d_dice_view& view, lane_bounds& out) {
    static_assert(sizeof patch == 48 * sizeof(double), "points without gaps");
    L3D_SIMD_CALL(bounds)(patch, view, out);
}

} // namespace l3d_detail
#endif
