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

/// A row of a matrix times (x, y, z, 1). The products are added in the order of l3d_matrix's own
/// product.
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

/// Places the vectors of a normal net, and keeps them as floats, too.
void place_normals(const l3d_matrix<double>& m, const double* from, l3d_normal_polynomial& net,
                   float (&in_floats)[3][6][6]) {
    const hn::CappedTag<double, 4> d;
    const hn::Rebind<float, decltype(d)> df;
    constexpr std::size_t count = 36;
    static_assert(count % hn::MaxLanes(decltype(d)()) == 0);
    alignas(64) double turned[3][count];
    auto most = hn::Zero(d);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        auto x = hn::Zero(d), y = x, z = x;
        hn::LoadInterleaved3(d, from + 3 * i, x, y, z);
        for (int row = 0; row < 3; ++row) {
            const auto at = [&](int column) HWY_ATTR { return hn::Set(d, m(row, column)); };
            const auto sum =
                hn::Add(hn::Add(hn::Mul(at(0), x), hn::Mul(at(1), y)), hn::Mul(at(2), z));
            hn::Store(sum, d, turned[row] + i);
            most = hn::Max(most, hn::Abs(sum));
        }
    }
    const double largest = hn::GetLane(hn::MaxOfLanes(d, most));
    const auto scale = hn::Set(d, largest > 0 ? 1 / largest : 1);
    double* const to = &net.points[0][0];
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const auto put = [&](std::size_t k) HWY_ATTR {
            const auto scaled = hn::Mul(hn::Load(d, turned[k] + i), scale);
            hn::StoreU(hn::DemoteTo(df, scaled), df, &in_floats[k][0][0] + i);
            return scaled;
        };
        const auto x = put(0), y = put(1), z = put(2);
        hn::StoreInterleaved3(x, y, z, d, to + 3 * i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

namespace {

L3D_SIMD_TABLE(place_net);
L3D_SIMD_TABLE(place_normals);

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

l3d_normal_net l3d_placed_normals(const l3d_matrix<double>& by, const l3d_normal_net& normals) {
    using namespace l3d_detail;
    l3d_normal_polynomial net;
    static_assert(sizeof net.points == 108 * sizeof(double));
    l3d_normal_net::float_net in_floats;
    L3D_SIMD_CALL(place_normals)(by, &normals.polynomial().points[0][0], net, in_floats);
    return {net, in_floats};
}
#endif
