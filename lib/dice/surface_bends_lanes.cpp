// SPDX-License-Identifier: MIT
// bound_bends, once for each instruction set: the parts of a row of them in lanes.
#include "dice/bend_weights_p.h"
#include "dice/surface_bends_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/surface_bends_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "dice/bend_normals-inl.h"
#include "raster/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Taylor's coefficients by u of a net's rows, about the middles of the columns of parts.
template <std::size_t Degree> class part_columns {
public:
    /// Shape: net[component][row][column].
    HWY_ATTR explicit part_columns(const double (&net)[3][Degree + 1][Degree + 1]) {
        for (std::size_t i = 0; i < bend_parts; i += lanes_at_once())
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

    /// Of parts i on in a row of parts.
    HWY_ATTR taylor_net<Degree> get(std::size_t part, std::size_t i) const {
        taylor_net<Degree> result;
        for (std::size_t k = 0; k <= Degree; ++k)
            for (std::size_t l = 0; l <= Degree; ++l) {
                vector sum{same(0), same(0), same(0)};
                for (std::size_t from = 0; from <= Degree; ++from)
                    sum = sum + vector{loaded(at_[k][0][from] + i), loaded(at_[k][1][from] + i),
                                       loaded(at_[k][2][from] + i)} *
                                    same(weights.at[l][from][part]);
                result.at[k][l] = sum;
            }
        return result;
    }

private:
    static constexpr auto& weights = weights_of_taylor<Degree>;

    /// [power][component][row][column of parts]
    alignas(64) double at_[Degree + 1][3][Degree + 1][bend_parts];
};

} // namespace

HWY_ATTR void bound_in_lanes(const bend_nets& nets, bends_of_parts& result) {
    const part_columns<5> normals(nets.normals);
    const part_columns<3> points(nets.points);
    for (std::size_t row = 0; row < bend_parts; ++row)
        for (std::size_t i = 0; i < bend_parts; i += lanes_at_once()) {
            const part_bounds of = bounds_of(normals.get(row, i), points.get(row, i), nets.size);
            for (std::size_t n = 0; n < bend_numbers; ++n)
                store(of.at[n], result.at[n][row] + i);
        }
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
