// SPDX-License-Identifier: MIT
// Makes the sixteen blocks of a net, one a lane: their control points, boxes and differences.
#if defined(L3D_DICE_LANES_LANE_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_DICE_LANES_LANE_BLOCKS_INL_H
#undef L3D_DICE_LANES_LANE_BLOCKS_INL_H
#else
#define L3D_DICE_LANES_LANE_BLOCKS_INL_H
#endif

#include "dice/lanes/lane_weights_p.h"

#include <cmath>
#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// The number of control points of a net; a net has as many blocks.
constexpr std::size_t points = 16;

using floats = hn::CappedTag<float, points>;
using float_lanes = hn::Vec<floats>;

/// The length of a difference of homogeneous points as the picture shows it, for one block a lane.
/// Its result is that of seen_in in step_bound.cpp.
struct seen_norm {
    float_lanes x, y, radius;

    HWY_ATTR HWY_INLINE float_lanes operator()(float_lanes dx, float_lanes dy,
                                               float_lanes dw) const {
        const auto ex = hn::Sub(dx, hn::Mul(x, dw)), ey = hn::Sub(dy, hn::Mul(y, dw));
        return hn::Add(hn::Sqrt(hn::Add(hn::Mul(ex, ex), hn::Mul(ey, ey))),
                       hn::Mul(radius, hn::Abs(dw)));
    }
};

/// The largest norms of one kind of differences, for one block a lane: in the picture, and of w.
struct largest_of {
    float_lanes image, depth;

    HWY_ATTR HWY_INLINE void take(const seen_norm& norm, float_lanes dx, float_lanes dy,
                                  float_lanes dw) {
        image = hn::Max(image, norm(dx, dy, dw));
        depth = hn::Max(depth, hn::Abs(dw));
    }
};

/// Loads lanes from p + i, then copies element `of` of each group of four lanes to the whole group.
template <int of> HWY_ATTR HWY_INLINE float_lanes one_of_four(const float* p, std::size_t i) {
#if HWY_TARGET == HWY_SCALAR
    return hn::Load(floats(), p + i / 4 * 4 + of);
#else
    return hn::Broadcast<of>(hn::Load(floats(), p + i));
#endif
}

/// Loads lanes from element i on of an array that repeats the four elements at p.
HWY_ATTR HWY_INLINE float_lanes repeated(const float* p, [[maybe_unused]] std::size_t i) {
#if HWY_TARGET == HWY_SCALAR
    return hn::Load(floats(), p + i % 4);
#else
    return hn::LoadDup128(floats(), p);
#endif
}

/// The control nets of a net's sixteen blocks, a block a lane: [component][row][column][lane].
struct block_nets {
    alignas(64) float at[3][4][4][points];
};

/// Cuts a net into the nets of its blocks. The first cuts are along u, with a row of the net and a
/// u-strip in each lane. The remaining cuts are along v.
/// Shape: net is [component][4 * row + column].
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

/// The boxes of blocks in the picture, from some lane on, relative to the net's centre. gap_u and
/// gap_v are the largest distances of neighbouring control points along u and v, in x or in y.
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

/// Raises `uu`, `vv` and `uv` to the largest norms of each block's second differences along u and
/// along v, and of its mixed differences.
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

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
