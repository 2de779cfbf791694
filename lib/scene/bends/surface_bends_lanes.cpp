// SPDX-License-Identifier: MIT
// Bounds parts of a patch in lanes, compiled once for each instruction set.
#include "scene/bends/bend_weights_p.h"
#include "scene/bends/surface_bends_p.h"

#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/bends/surface_bends_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "scene/bends/bend_normals-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The Taylor coefficients by u of the rows of a net, about the middles of the eight columns of
/// parts. Coefficients by u are the first step to the parts' coefficients by u and v.
template <std::size_t Degree> class part_columns {
public:
    /// Shape: net[component][row][column].
    HWY_ATTR explicit part_columns(const double (&net)[3][Degree + 1][Degree + 1]) {
        for (std::size_t i = 0; i < part_lanes; i += lanes_at_once())
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t row = 0; row <= Degree; ++row)
                    for (std::size_t power = 0; power <= Degree; ++power) {
                        number sum = same(0);
                        for (std::size_t from = 0; from <= Degree; ++from)
                            sum =
                                sum + same(net[c][row][from]) * loaded(weights.at[power][from] + i);
                        store(sum, at_[power][c][row] + i);
                    }
    }

    /// Writes the Taylor coefficients by u and v of the parts in row `part`.
    HWY_ATTR void put(std::size_t part,
                      double (&out)[Degree + 1][Degree + 1][3][part_lanes]) const {
        for (std::size_t i = 0; i < part_lanes; i += lanes_at_once())
            for (std::size_t k = 0; k <= Degree; ++k)
                for (std::size_t l = 0; l <= Degree; ++l)
                    for (std::size_t c = 0; c < 3; ++c) {
                        number sum = same(0);
                        for (std::size_t from = 0; from <= Degree; ++from)
                            sum =
                                sum + loaded(at_[k][c][from] + i) * same(weights.at[l][from][part]);
                        store(sum, out[k][l][c] + i);
                    }
    }

private:
    static constexpr auto& weights = weights_of_taylor<Degree>;

    /// The coefficients: [power of u][component][row of the net][column of parts].
    alignas(64) double at_[Degree + 1][3][Degree + 1][part_lanes];
};

/// Turns the Taylor coefficients of parts into the coefficients of their quarters, a quarter a
/// lane. A quarter's middle is at 1/2 or -1/2 of each old parameter; Horner's scheme moves the
/// series there. The new parameters run half as far as the old ones.
template <std::size_t Degree>
HWY_ATTR void quarter_net(double (&net)[Degree + 1][Degree + 1][3][part_lanes]) {
    alignas(64) static constexpr double side_u[part_lanes]{-.5, .5, -.5, .5, -.5, .5, -.5, .5};
    alignas(64) static constexpr double side_v[part_lanes]{-.5, -.5, .5, .5, -.5, -.5, .5, .5};
    for (std::size_t i = 0; i < part_lanes; i += lanes_at_once()) {
        const auto add = [&](double* to, const double* from, const double* side) HWY_ATTR {
            store(loaded(to + i) + loaded(from + i) * loaded(side + i), to + i);
        };
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t l = 0; l <= Degree; ++l)
                for (std::size_t k = 0; k < Degree; ++k)
                    for (std::size_t j = Degree; j-- > k;)
                        add(net[j][l][c], net[j + 1][l][c], side_u);
            for (std::size_t k = 0; k <= Degree; ++k)
                for (std::size_t l = 0; l < Degree; ++l)
                    for (std::size_t j = Degree; j-- > l;)
                        add(net[k][j][c], net[k][j + 1][c], side_v);
            for (std::size_t k = 0; k <= Degree; ++k)
                for (std::size_t l = 0; l <= Degree; ++l)
                    store(loaded(net[k][l][c] + i) *
                              same(1 / static_cast<double>(std::size_t{1} << (k + l))),
                          net[k][l][c] + i);
        }
    }
}

template <std::size_t Degree>
HWY_ATTR taylor_net<Degree> net_in_lanes(const double (&net)[Degree + 1][Degree + 1][3][part_lanes],
                                         std::size_t i) {
    taylor_net<Degree> result;
    for (std::size_t k = 0; k <= Degree; ++k)
        for (std::size_t l = 0; l <= Degree; ++l)
            result.at[k][l] = {loaded(net[k][l][0] + i), loaded(net[k][l][1] + i),
                               loaded(net[k][l][2] + i)};
    return result;
}

} // namespace

HWY_ATTR void make_in_lanes(const bend_nets& nets, part_group* rows) {
    const part_columns<5> normals(nets.normals);
    const part_columns<3> points(nets.points);
    for (std::size_t row = 0; row < bend_parts; ++row) {
        normals.put(row, rows[row].normals);
        points.put(row, rows[row].points);
    }
}

HWY_ATTR void quarter_in_lanes(part_group& parts) {
    quarter_net<5>(parts.normals);
    quarter_net<3>(parts.points);
}

HWY_ATTR void bound_in_lanes(const part_group& parts, double size, group_bounds& result) {
    for (std::size_t i = 0; i < part_lanes; i += lanes_at_once())
        take_bounds(net_in_lanes<5>(parts.normals, i), net_in_lanes<3>(parts.points, i), size,
                    result, i);
}

} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(make_in_lanes);
L3D_SIMD_TABLE(quarter_in_lanes);
L3D_SIMD_TABLE(bound_in_lanes);

void make_parts(const bend_nets& nets, part_group* rows) {
    L3D_SIMD_CALL(make_in_lanes)(nets, rows);
}

void quarter_parts(part_group& parts) {
    L3D_SIMD_CALL(quarter_in_lanes)(parts);
}

void bound_parts(const part_group& parts, double size, group_bounds& result) {
    L3D_SIMD_CALL(bound_in_lanes)(parts, size, result);
}

} // namespace l3d_detail
#endif
