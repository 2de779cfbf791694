// SPDX-License-Identifier: MIT
// mesh_dicer: finds the places of corners and their colours, in lanes of double.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/paths/mesh_dicer.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/paths/mesh_dicer_p.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

static_assert(mesh_row::room >= hn::MaxLanes(eight_doubles()));

/// The sum of four products. If the order of both arrays is reversed, the sum has the same bits.
HWY_ATTR HWY_INLINE number mixed(const std::array<double, 4>& p, const std::array<number, 4>& w) {
    return (same(p[0]) * w[0] + same(p[3]) * w[3]) + (same(p[1]) * w[1] + same(p[2]) * w[2]);
}

void set_row_in_lanes(const mesh_knots& knots, const mesh_curve& curve, mesh_row& row) {
    const eight_doubles d;
    for (std::size_t i = 0; i < row.size; i += lanes_at_once()) {
        const auto from = [i](const std::vector<double>& of) HWY_ATTR {
            return number{hn::LoadU(eight_doubles(), of.data() + i)};
        };
        const std::array<number, 4> weights{from(knots.weights[0]), from(knots.weights[1]),
                                            from(knots.weights[2]), from(knots.weights[3])};
        hn::StoreU(mixed(curve.x, weights).v, d, row.x.data() + i);
        hn::StoreU(mixed(curve.y, weights).v, d, row.y.data() + i);
        const number u = from(knots.at), rest = same(1) - u;
        for (std::size_t k = 0; k < 3; ++k)
            hn::StoreU((same(curve.ends[0][k]) * rest + same(curve.ends[1][k]) * u).v, d,
                       row.color[k].data() + i);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(set_row_in_lanes);

namespace {

std::array<double, 3> mixed_colors(std::uint32_t a, std::uint32_t b, double t) {
    const auto level = [](std::uint32_t of, int shift) {
        return static_cast<double>(of >> shift & 255);
    };
    std::array<double, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
        const int shift = 16 - 8 * static_cast<int>(k);
        result[k] = level(a, shift) * (1 - t) + level(b, shift) * t;
    }
    return result;
}

} // namespace

void mesh_row::resize(std::size_t count) {
    size = count;
    for (std::vector<double>* of : {&x, &y, &color[0], &color[1], &color[2]})
        of->resize(count + room);
}

void mesh_dicer::begin(std::size_t patch) {
    along_.set(dicings_[patch].along);
    down_.set(dicings_[patch].down);
    above_.resize(along_.size);
    below_.resize(along_.size);
    rises_.resize(along_.size + mesh_row::room);
}

void mesh_dicer::set_diagonals(const mesh_dicing& dicing, std::size_t row_of_quarters) {
    for (std::size_t u = 1; u < along_.size; ++u)
        rises_[u - 1] = dicing.rises(row_of_quarters, along_.quarter[u]) ? 1 : 0;
}

void mesh_dicer::set_row(const l3d_mesh_patch& patch, std::size_t row) {
    mesh_curve curve;
    for (std::size_t c = 0; c < 4; ++c) {
        const auto mixed = [&](double l3d_point_2d::*of) {
            const auto term = [&](std::size_t r) {
                return patch.points[r][c].*of * down_.weights[r][row];
            };
            return (term(0) + term(3)) + (term(1) + term(2));
        };
        curve.x[c] = mixed(&l3d_point_2d::x);
        curve.y[c] = mixed(&l3d_point_2d::y);
    }
    const double v = down_.at[row];
    curve.ends = {mixed_colors(patch.colors[0], patch.colors[2], v),
                  mixed_colors(patch.colors[1], patch.colors[3], v)};
    L3D_SIMD_CALL(set_row_in_lanes)(along_, curve, below_);
}

} // namespace l3d_detail
#endif
