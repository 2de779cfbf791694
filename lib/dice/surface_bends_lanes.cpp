// SPDX-License-Identifier: MIT
// bound_bends, once for each instruction set: exact values on a lattice, and what lies between.
//
// A part's bound is the largest exact value on its 3 x 3 lattice points plus 1/32 of bounds of two
// second derivatives: 1/8 of the squared distance of lattice points, 1/2. These may be coarse. They
// come from sizes of coefficients, in a frame whose z is along the normal in the part's middle.
#include "dice/bend_weights_p.h"
#include "dice/surface_bends_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/surface_bends_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "dice/lane_doubles-inl.h"
#include "dice/bend_sizes-inl.h"
#include "raster/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// A net's derivatives by u on the lattice: [order][component][row of the net][lane].
template <int Degree> struct lattice_columns {
    alignas(64) double at[4][3][Degree + 1][lattice_lanes];

    /// Shape: net[component][row][column].
    HWY_ATTR explicit lattice_columns(const double (&net)[3][Degree + 1][Degree + 1]) {
        constexpr auto& weights = weights_of_bends<Degree>.along_u;
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t i = 0; i < lattice_lanes; i += lanes_at_once())
                for (std::size_t c = 0; c < 3; ++c)
                    for (std::size_t row = 0; row <= Degree; ++row) {
                        number sum = same(net[c][row][0]) * loaded(weights[k][0] + i);
                        for (std::size_t from = 1; from <= Degree; ++from)
                            sum = sum + same(net[c][row][from]) * loaded(weights[k][from] + i);
                        store(sum, at[k][c][row] + i);
                    }
    }

    /// The derivative of orders k by u and l by v, in lanes i on of a row of the lattice.
    HWY_ATTR HWY_INLINE vector get(std::size_t k, std::size_t l, std::size_t row,
                                   std::size_t i) const {
        constexpr auto& weights = weights_of_bends<Degree>.along_v;
        vector sum{same(0), same(0), same(0)};
        for (std::size_t from = 0; from <= Degree; ++from) {
            const number weight = same(weights[l][from][row]);
            sum = sum + vector{loaded(at[k][0][from] + i), loaded(at[k][1][from] + i),
                               loaded(at[k][2][from] + i)} *
                            weight;
        }
        return sum;
    }
};

/// What is exact at the lattice's points. The largest of each part's three points in its row, and
/// the normal in the middle of them.
struct lattice_values {
    alignas(64) double at[lattice_points][bend_numbers][bend_parts];
    alignas(64) double axis[lattice_points][3][bend_parts];
};

/// Derivatives of the unit normal N from those of M = r N, m being those of M over r, and p those
/// of r over r: from N . N = 1 and the products' derivatives.
HWY_ATTR HWY_INLINE vector take_normals(const lattice_columns<5>& of, std::size_t row,
                                        std::size_t i, number (&out)[bend_numbers]) {
    const vector m = of.get(0, 0, row, i);
    const number inverse = same(1) / root(dot(m, m));
    const vector n = m * inverse;
    const auto get = [&](std::size_t k, std::size_t l)
                         HWY_ATTR { return of.get(k, l, row, i) * inverse; };
    const auto twice = [](number x) HWY_ATTR { return x + x; };
    const auto thrice = [](number x) HWY_ATTR { return x * same(3); };
    const auto size = [](const vector& a) HWY_ATTR { return root(dot(a, a)); };
    const vector mu = get(1, 0), mv = get(0, 1);
    const number pu = dot(n, mu), pv = dot(n, mv);
    const vector nu = mu - n * pu, nv = mv - n * pv;
    const number uu = dot(nu, nu), uv = dot(nu, nv), vv = dot(nv, nv);
    const vector muu = get(2, 0), muv = get(1, 1), mvv = get(0, 2);
    const number puu = dot(n, muu) + uu, puv = dot(n, muv) + uv, pvv = dot(n, mvv) + vv;
    const vector nuu = muu - n * puu - nu * twice(pu);
    const vector nuv = muv - n * puv - nv * pu - nu * pv;
    const vector nvv = mvv - n * pvv - nv * twice(pv);
    out[turn_u] = root(uu);
    out[turn_v] = root(vv);
    out[turn_uu] = size(nuu);
    out[turn_uv] = size(nuv);
    out[turn_vv] = size(nvv);
    const vector muuu = get(3, 0), muuv = get(2, 1), muvv = get(1, 2), mvvv = get(0, 3);
    const number puuu = dot(n, muuu) + thrice(pu * uu + dot(nu, nuu));
    const number pvvv = dot(n, mvvv) + thrice(pv * vv + dot(nv, nvv));
    const number puuv = dot(n, muuv) + twice(pu * uv + dot(nu, nuv)) + pv * uu + dot(nv, nuu);
    const number puvv = dot(n, muvv) + twice(pv * uv + dot(nv, nuv)) + pu * vv + dot(nu, nvv);
    out[turn_uuu] = size(muuu - n * puuu - (nu * puu + nuu * pu) * same(3));
    out[turn_vvv] = size(mvvv - n * pvvv - (nv * pvv + nvv * pv) * same(3));
    out[turn_uuv] = size(muuv - n * puuv - (nu * puv + nuv * pu) * same(2) - nv * puu - nuu * pv);
    out[turn_uvv] = size(muvv - n * puvv - (nv * puv + nuv * pv) * same(2) - nu * pvv - nvv * pu);
    return n;
}

HWY_ATTR void take_row(const lattice_columns<5>& normals, const lattice_columns<3>& points,
                       std::size_t row, lattice_values& out) {
    const std::size_t step = lanes_at_once();
    for (std::size_t i = 0; i < bend_parts; i += step) {
        number most[bend_numbers];
        for (number& m : most)
            m = same(0);
        for (std::size_t group = 0; group < 3; ++group) {
            const std::size_t lane = bend_parts * group + i;
            number here[bend_numbers];
            const vector n = take_normals(normals, row, lane, here);
            constexpr std::size_t orders[][2]{{2, 0}, {1, 1}, {0, 2}, {3, 0},
                                              {2, 1}, {1, 2}, {0, 3}};
            for (std::size_t b = 0; b < bend_uuvv; ++b)
                here[b] = magnitude(dot(n, points.get(orders[b][0], orders[b][1], row, lane)));
            here[bend_uuvv] = same(0);
            for (std::size_t b = 0; b < bend_numbers; ++b)
                most[b] = largest(most[b], here[b]);
            if (group == 1) {
                store(n.x, out.axis[row][0] + i);
                store(n.y, out.axis[row][1] + i);
                store(n.z, out.axis[row][2] + i);
            }
        }
        for (std::size_t b = 0; b < bend_numbers; ++b)
            store(most[b], out.at[row][b] + i);
    }
}

/// Bounds of parts i on of a row of parts.
HWY_ATTR void bound_parts(const part_columns<5>& normals, const part_columns<3>& points,
                          const lattice_values& exact, double size, std::size_t row, std::size_t i,
                          bends_of_parts& result) {
    const std::size_t first = 2 * row;
    const auto& axis = exact.axis[first + 1];
    const vector z{loaded(axis[0] + i), loaded(axis[1] + i), loaded(axis[2] + i)};
    normal_sizes n(normals, row, i, z);
    const point_sizes s(points, row, i, z, size);
    number bound[bend_numbers];
    for (std::size_t b = 0; b < bend_numbers; ++b)
        bound[b] =
            largest(loaded(exact.at[first][b] + i), largest(loaded(exact.at[first + 1][b] + i),
                                                            loaded(exact.at[first + 2][b] + i)));
    n.add_what_lies_between(bound);
    s.add_what_lies_between(n, bound);
    for (std::size_t b = 0; b < bend_numbers; ++b) {
        const number infinite = same(HUGE_VAL);
        const auto known = b == bend_uuvv ? hn::Eq(infinite.v, infinite.v) : n.known();
        store({hn::IfThenElse(known, bound[b].v, infinite.v)}, result.at[b][row] + i);
    }
}

} // namespace

HWY_ATTR void bound_in_lanes(const bend_nets& nets, bends_of_parts& result) {
    const lattice_columns<5> normals(nets.normals);
    const lattice_columns<3> points(nets.points);
    lattice_values exact;
    for (std::size_t row = 0; row < lattice_points; ++row)
        take_row(normals, points, row, exact);
    const part_columns<5> normal_parts(nets.normals);
    const part_columns<3> point_parts(nets.points);
    for (std::size_t row = 0; row < bend_parts; ++row)
        for (std::size_t i = 0; i < bend_parts; i += lanes_at_once())
            bound_parts(normal_parts, point_parts, exact, nets.size, row, i, result);
}

} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(bound_in_lanes);

void bound_bends(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals,
                 bends_of_parts& result) {
    bend_nets nets;
    nets.size = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const int component = static_cast<int>(c);
        for (int row = 0; row < 6; ++row)
            for (int column = 0; column < 6; ++column)
                nets.normals[c][row][column] = normals.at(row, column)[component];
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) {
                const double from_first =
                    patch.at(row, column)[component] - patch.at(0, 0)[component];
                nets.points[c][row][column] = from_first;
                nets.size = std::max(nets.size, std::abs(from_first));
            }
    }
    L3D_SIMD_CALL(bound_in_lanes)(nets, result);
}

} // namespace l3d_detail
#endif
