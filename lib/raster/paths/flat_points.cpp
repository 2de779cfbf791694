// SPDX-License-Identifier: MIT
// flat_points: finds a point in each lane, for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/paths/flat_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/paths/flat_curve_p.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// A coordinate of points beside a curve. The coordinate is a cubic, too: the curve's coordinate,
/// reduced by h^2 / 16 times its second derivative, where h is the step.
struct moved_cubic {
    double a, b, c, d;

    moved_cubic(const l3d_curve_2d& curve, int k, double h)
        : a(curve.points[0][k]), b(curve.points[1][k]), c(curve.points[2][k]),
          d(curve.points[3][k]) {
        l3d_to_powers(a, b, c, d);
        const double share = h * h / 16;
        a -= share * (2 * c);
        b -= share * (6 * d);
    }
    HWY_ATTR HWY_INLINE number at(number t) const {
        return same(a) + t * (same(b) + t * (same(c) + t * same(d)));
    }
};

void find_flat_points_in_lanes(const l3d_curve_2d& curve, std::size_t steps, l3d_point_2d* points) {
    static_assert(hn::MaxLanes(eight_doubles()) <= flat_points_at_once);
    const eight_doubles d;
    const bool plain = is_plain(curve);
    const double h = flat_step(steps);
    const moved_cubic x(curve, 0, h), y(curve, 1, h), w(curve, 2, h);
    for (std::size_t i = 0; i + 1 < steps; i += lanes_at_once()) {
        const number place = {hn::Iota(d, static_cast<double>(i) + flat_step_at_ends)};
        const number t = place * same(h);
        number at_x = x.at(t), at_y = y.at(t);
        if (!plain) {
            const number inverse = same(1) / w.at(t);
            at_x = at_x * inverse;
            at_y = at_y * inverse;
        }
        hn::StoreInterleaved2(at_x.v, at_y.v, d, &points[i].x);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(find_flat_points_in_lanes);

void find_flat_points(const l3d_curve_2d& curve, std::size_t steps, l3d_point_2d* points) {
    L3D_SIMD_CALL(find_flat_points_in_lanes)(curve, steps, points);
}

} // namespace l3d_detail
#endif
