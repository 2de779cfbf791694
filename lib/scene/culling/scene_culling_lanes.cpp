// SPDX-License-Identifier: MIT
// cull_boxes, compiled for each instruction set: plain loops, which the compiler turns into lanes.
#include "scene/culling/scene_culling_p.h"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/culling/scene_culling_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {

constexpr std::size_t lanes = l3d_box_lanes::lanes;
using row = culled_boxes::row;

/// One homogeneous coordinate of a row of boxes: its value in the centre, and its change along each
/// axis.
struct coordinate {
    row centre;
    std::array<row, 3> axes;
};

/// Computes m . (x, y, z, 1) + more for each box. The sums are in a row of their own, so the
/// compiler knows that no other data overlap it.
row sums(const l3d_vector<double, 4>& m, const double* x, const double* y, const double* z,
         double more) {
    row result;
    for (std::size_t i = 0; i < lanes; ++i)
        result[i] = m[0] * x[i] + m[1] * y[i] + (m[2] * z[i] + more);
    return result;
}

coordinate placed(const l3d_box_lanes& boxes, std::size_t first, const l3d_vector<double, 4>& m) {
    const auto axis = [&](std::size_t k) HWY_ATTR {
        return sums(m, boxes.axis(k, 0, first), boxes.axis(k, 1, first), boxes.axis(k, 2, first),
                    0);
    };
    return {sums(m, boxes.centre(0, first), boxes.centre(1, first), boxes.centre(2, first), m[3]),
            {axis(0), axis(1), axis(2)}};
}

/// Lowers `inside` to the boxes' largest value of sign (x - at w): how far they reach into a
/// half-space.
void keep_inside(const coordinate& x, const coordinate& w, double at, double sign, const row& share,
                 const l3d_dice_view& view, row& inside) {
    const double error = view.error_xy + std::abs(at) * view.error_w;
    for (std::size_t i = 0; i < lanes; ++i) {
        double reach = error * share[i];
        for (std::size_t k = 0; k < 3; ++k)
            reach += std::abs(x.axes[k][i] - at * w.axes[k][i]);
        const double most = sign * (x.centre[i] - at * w.centre[i]) + reach;
        inside[i] = most < inside[i] ? most : inside[i];
    }
}

/// Finds the range of x / w in each box, where w is at least `least`. With X = x / w of the box'
/// centre, x' / w' - X = (x' - X w') / w' for any point. The numerator is 0 in the centre. So the
/// range is narrow where w varies little.
void project(const coordinate& x, const coordinate& w, const row& least, const row& share,
             const l3d_dice_view& view, row& low, row& high) {
    for (std::size_t i = 0; i < lanes; ++i) {
        const double centre = x.centre[i] / w.centre[i];
        double reach = (view.error_xy + std::abs(centre) * view.error_w) * share[i];
        for (std::size_t k = 0; k < 3; ++k)
            reach += std::abs(x.axes[k][i] - centre * w.axes[k][i]);
        reach = reach / least[i];
        low[i] = centre - reach;
        high[i] = centre + reach;
    }
}

/// Computes the boxes' share of the errors and their near planes, in rows of their own.
void judge_terms(const l3d_box_lanes& boxes, std::size_t first, const placing_terms& terms,
                 const l3d_dice_view& view, row& share, row& near) {
    const double* const reach = boxes.reach(first);
    row sum;
    for (std::size_t i = 0; i < lanes; ++i)
        sum[i] = reach[i] + terms.shift;
    for (std::size_t c = 0; c < 3; ++c) {
        const double* const centre = boxes.centre(c, first);
        const std::array<const double*, 3> axes{boxes.axis(0, c, first), boxes.axis(1, c, first),
                                                boxes.axis(2, c, first)};
        const double column = terms.columns[static_cast<int>(c)];
        for (std::size_t i = 0; i < lanes; ++i)
            sum[i] += column * (std::abs(centre[i]) + std::abs(axes[0][i]) + std::abs(axes[1][i]) +
                                std::abs(axes[2][i]));
    }
    for (std::size_t i = 0; i < lanes; ++i) {
        share[i] = view.share_of(sum[i]);
        near[i] = view.near_of(share[i]);
    }
}

void cull_lanes(const l3d_box_lanes& boxes, std::size_t first, const box_placing& placing,
                culled_boxes& result) {
    const auto& [to_image, terms, view, margin] = placing;
    row share, near;
    judge_terms(boxes, first, terms, view, share, near);
    result.share = share;
    result.near = near;
    const coordinate x = placed(boxes, first, to_image.row(0));
    const coordinate y = placed(boxes, first, to_image.row(1));
    const coordinate w = placed(boxes, first, to_image.row(3));
    for (std::size_t i = 0; i < lanes; ++i) {
        const double reach = std::abs(w.axes[0][i]) + std::abs(w.axes[1][i]) +
                             std::abs(w.axes[2][i]) + view.error_w * share[i];
        result.least[i] = w.centre[i] - reach;
        result.most[i] = w.centre[i] + reach;
    }
    result.inside.fill(std::numeric_limits<double>::infinity());
    keep_inside(x, w, margin.left, 1, share, view, result.inside);
    keep_inside(x, w, margin.right, -1, share, view, result.inside);
    keep_inside(y, w, margin.top, 1, share, view, result.inside);
    keep_inside(y, w, margin.bottom, -1, share, view, result.inside);
    bool any = false;
    for (std::size_t i = 0; i < lanes; ++i)
        any |= !(result.inside[i] < 0) && result.least[i] > near[i];
    if (!any)
        return;
    project(x, w, result.least, share, view, result.left, result.right);
    project(y, w, result.least, share, view, result.top, result.bottom);
}

} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(cull_lanes);

void cull_boxes(const l3d_box_lanes& boxes, std::size_t first, const box_placing& placing,
                culled_boxes& result) {
    L3D_SIMD_CALL(cull_lanes)(boxes, first, placing, result);
}

} // namespace l3d_detail
#endif
