// SPDX-License-Identifier: MIT
// mean_level: the samples of a pixel in lanes.
#include "raster/refine/mean_level_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/mean_level.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"
#include "raster/refine/linear_light_p.h"
#include "raster/refine/pair_measures_p.h"
#include "raster/refine/polygon_levels-inl.h"

#include <bit>
#include <cstdint>

#ifndef L3D_RASTER_REFINE_MEAN_LEVEL_ONCE
#define L3D_RASTER_REFINE_MEAN_LEVEL_ONCE
namespace l3d_detail {

/// As fine as a float is. The light of 64 samples is 2^30 of them at most, which fits into 31 bits.
constexpr float light_units = 1 << 24;

/// The last level that has a next one: light is on a straight line between whole levels.
constexpr std::int32_t last_below = 254;

} // namespace l3d_detail
#endif

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The sum of the light at samples. Whole numbers, so that their order does not matter.
/// Units: 1 / light_units. Expects: the lights of all levels.
template <bool IsQuad>
HWY_INLINE std::int32_t sum_at(const fragment_polygon& of, scan_point corner, std::uint64_t samples,
                               const float* lights) {
    const floats d;
    polygon_levels levels;
    for (std::size_t i = 0; i < 4; ++i)
        levels.corner[i] = set(of.light[0][i]);
    levels.ab = set(of.light[1][0]);
    levels.ad = set(of.light[2][0]);
    levels.bc = set(of.light[2][1]);
    levels.dc = set(of.light[1][3]);

    const auto number = [](std::int64_t units) { return static_cast<float>(units); };
    const std::int32_t along1_x = of.x[2] - of.x[0], along1_y = of.y[2] - of.y[0];
    const std::int32_t along2_x = of.x[3] - of.x[1], along2_y = of.y[3] - of.y[1];
    const float inverse = 1 / number(of.area2());
    constexpr float quarter = 0.25f;
    const float mean_x = quarter * number(of.x[0] + of.x[1] + of.x[2] + of.x[3] - 4 * corner.x);
    const float mean_y = quarter * number(of.y[0] + of.y[1] + of.y[2] + of.y[3] - 4 * corner.y);
    const float_vec s_x = set(number(along2_y) * inverse), s_y = set(number(along2_x) * inverse);
    const float_vec t_x = set(number(along1_y) * inverse), t_y = set(number(along1_x) * inverse);

    constexpr std::int32_t cell = l3d_subpixel_one / mask_side;
    int_vec sum = hn::Zero(ints());
    for (std::int32_t first = 0; first < mask_side * mask_side; first += std::int32_t{lanes}) {
        constexpr std::uint64_t of_vector = (std::uint64_t{1} << lanes) - 1;
        const std::uint64_t wanted = samples >> first & of_vector;
        if (wanted == 0)
            continue;
        const int_vec index = hn::Iota(ints(), first);
        const auto place_of = [&](int_vec step, float mean) HWY_ATTR {
            const int_vec place = hn::Add(hn::Mul(step, set(cell)), set(cell / 2));
            return hn::Sub(hn::ConvertTo(d, place), set(mean));
        };
        const float_vec x = place_of(hn::And(index, set(mask_side - 1)), mean_x);
        const float_vec y = place_of(hn::ShiftRight<3>(index), mean_y);
        const float_vec s = hn::Sub(hn::Mul(x, s_x), hn::Mul(y, s_y));
        const float_vec t = hn::Sub(hn::Mul(y, t_y), hn::Mul(x, t_x));
        const float_vec lit = IsQuad ? levels.of_quad(s, t) : levels.of_triangle(s, t);
        // A level that is no number counts as dark.
        const float_vec held =
            hn::IfThenElseZero(hn::Gt(lit, set(0.0f)), hn::Min(lit, set(linear_light::most_lit)));
        const float_vec level = hn::Add(held, set(linear_light::ambient));
        const int_vec below = hn::Min(hn::ConvertTo(ints(), level), set(last_below));
        const float_vec low = hn::GatherIndex(d, lights, below);
        const float_vec high = hn::GatherIndex(d, lights + 1, below);
        const float_vec part = hn::Sub(level, hn::ConvertTo(d, below));
        const float_vec light = hn::Add(low, hn::Mul(part, hn::Sub(high, low)));
        const int_vec units = hn::ConvertTo(ints(), hn::Mul(light, set(light_units)));
        sum = hn::Add(sum, hn::IfThenElseZero(lanes_of(wanted), units));
    }
    return hn::GetLane(hn::SumOfLanes(ints(), sum));
}

std::int32_t sum_of_light(const fragment_polygon& of, scan_point corner, std::uint64_t samples,
                          const float* lights) {
    constexpr std::int32_t quad = 4;
    return of.corners == quad ? sum_at<true>(of, corner, samples, lights)
                              : sum_at<false>(of, corner, samples, lights);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(sum_of_light);

float mean_level(const fragment_polygon& polygon, scan_point corner, std::uint64_t samples) {
    const linear_light& tables = linear_light_tables();
    const std::int32_t sum =
        L3D_SIMD_CALL(sum_of_light)(polygon, corner, samples, tables.lights().data());
    const float count = static_cast<float>(std::popcount(samples)) * light_units;
    return tables.level_at_light(static_cast<float>(sum) / count) - linear_light::ambient;
}

} // namespace l3d_detail
#endif
