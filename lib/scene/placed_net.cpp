// SPDX-License-Identifier: MIT
// l3d_placed_net: places control points, compiled once for each instruction set.
#include "scene/placed_net.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/placed_net.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Adds the products in the order of l3d_matrix's own product.
template <class D, class V>
V row_times_point(D d, const l3d_matrix<double>& m, int row, V x, V y, V z) {
    const auto at = [&](int column) HWY_ATTR { return hn::Set(d, m(row, column)); };
    return hn::Add(hn::Add(hn::Mul(at(0), x), hn::Mul(at(1), y)),
                   hn::Add(hn::Mul(at(2), z), at(3)));
}

void place_net(const l3d_matrix<double>& m, const double* from, double* to) {
    // At most eight lanes, so that their number divides the number of points.
    const hn::CappedTag<double, 8> d;
    for (std::size_t i = 0; i < 16; i += hn::Lanes(d)) {
        auto x = hn::Zero(d), y = x, z = x;
        hn::LoadInterleaved3(d, from + 3 * i, x, y, z);
        hn::StoreInterleaved3(row_times_point(d, m, 0, x, y, z), row_times_point(d, m, 1, x, y, z),
                              row_times_point(d, m, 3, x, y, z), d, to + 3 * i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

namespace {

L3D_SIMD_TABLE(place_net);

void place(const l3d_matrix<double>& to_image, const double* from, double* to) {
    L3D_SIMD_CALL(place_net)(to_image, from, to);
}

} // namespace
} // namespace l3d_detail

l3d_image_patch l3d_placed_net(const l3d_matrix<double>& to_image,
                               const l3d_bezier_patch<double, 3>& patch) {
    static_assert(sizeof patch.points == 48 * sizeof(double));
    l3d_image_patch result;
    l3d_detail::place(to_image, &patch.points[0][0], &result.points[0][0]);
    return result;
}
#endif
