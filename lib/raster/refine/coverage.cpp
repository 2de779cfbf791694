// SPDX-License-Identifier: MIT
// coverage: the samples of a row side by side in steps, the rows in lanes.
#include "raster/refine/coverage_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/coverage.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_integers-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

using pattern = sample_pattern;

/// The lanes of a mask as bits from `row` on, added to those of a column.
HWY_INLINE void add_bits(int_mask inside, std::size_t row, std::size_t column, coverage& to) {
    to.word[column / 2] |= bits_of(inside) << (pattern::rows * (column % 2) + row);
}

template <std::size_t Lines> HWY_INLINE coverage covered_by_lines(const pixel_line* lines) {
    const ints d;
    coverage result;
    for (std::size_t row = 0; row < pattern::rows; row += lanes) {
        const auto x = hn::Load(d, pattern::first_x.data() + row);
        const auto y = hn::Load(d, pattern::first_y.data() + row);
        const auto slope = hn::Load(d, pattern::step_y.data() + row);
        hn::Vec<ints> value[Lines], step[Lines];
        for (std::size_t i = 0; i < Lines; ++i) {
            const auto of_x = hn::Set(d, lines[i].of_x), of_y = hn::Set(d, lines[i].of_y);
            value[i] =
                hn::Add(hn::Set(d, lines[i].at), hn::Add(hn::Mul(of_x, x), hn::Mul(of_y, y)));
            step[i] = hn::Add(hn::Set(d, pattern::step_x * lines[i].of_x), hn::Mul(of_y, slope));
        }
        for (std::size_t column = 0; column < pattern::columns; ++column) {
            auto signs = value[0];
            for (std::size_t i = 1; i < Lines; ++i)
                signs = hn::Or(signs, value[i]);
            add_bits(hn::Gt(signs, hn::Set(d, -1)), row, column, result);
            for (std::size_t i = 0; i < Lines; ++i)
                value[i] = hn::Add(value[i], step[i]);
        }
    }
    return result;
}

coverage covered_by(const pixel_line* lines, std::size_t count) {
    switch (count) {
    case 0:
        return coverage::all();
    case 1:
        return covered_by_lines<1>(lines);
    case 2:
        return covered_by_lines<2>(lines);
    case 3:
        return covered_by_lines<3>(lines);
    default:
        return covered_by_lines<4>(lines);
    }
}

coverage above_zero(const pixel_plane& plane) {
    const ints d;
    const floats df;
    const auto of_x = hn::Set(df, static_cast<float>(plane.of_x));
    const auto of_y = hn::Set(df, static_cast<float>(plane.of_y));
    const auto to_float = [&](const std::int32_t* from)
                              HWY_ATTR { return hn::ConvertTo(df, hn::Load(d, from)); };
    coverage result;
    for (std::size_t row = 0; row < pattern::rows; row += lanes) {
        auto value = hn::Add(hn::Set(df, static_cast<float>(plane.at)),
                             hn::Add(hn::Mul(of_x, to_float(pattern::first_x.data() + row)),
                                     hn::Mul(of_y, to_float(pattern::first_y.data() + row))));
        const auto step = hn::Add(hn::Mul(of_x, hn::Set(df, static_cast<float>(pattern::step_x))),
                                  hn::Mul(of_y, to_float(pattern::step_y.data() + row)));
        for (std::size_t column = 0; column < pattern::columns; ++column) {
            add_bits(hn::RebindMask(d, hn::Gt(value, hn::Zero(df))), row, column, result);
            value = hn::Add(value, step);
        }
    }
    return result;
}

coverage_moments moments_of(const coverage& samples) {
    constexpr std::int32_t row_height = pattern::pixel / static_cast<std::int32_t>(pattern::rows);
    // The rows whose number has bit i.
    constexpr std::uint64_t rows_with[] = {0xaaaaaaaaaaaaaaaa, 0xcccccccccccccccc,
                                           0xf0f0f0f0f0f0f0f0, 0xff00ff00ff00ff00,
                                           0xffff0000ffff0000};
    constexpr std::uint64_t low_half = 0xffffffff;
    coverage_moments result;
    std::int32_t row_sum = 0, column_sum = 0;
    for (std::size_t i = 0; i < samples.word.size(); ++i) {
        const std::uint64_t word = samples.word[i];
        const std::int32_t low = std::popcount(word & low_half), both = std::popcount(word);
        result.count += both;
        column_sum += static_cast<std::int32_t>(2 * i) * both + (both - low);
        for (std::size_t bit = 0; bit < std::size(rows_with); ++bit)
            row_sum += std::popcount(word & rows_with[bit]) << bit;
    }
    result.x = pattern::step_x * column_sum + pattern::step_x / 2 * result.count;
    result.y = row_height * row_sum + row_height / 2 * result.count;
    return result;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(covered_by);
L3D_SIMD_TABLE(above_zero);
L3D_SIMD_TABLE(moments_of);

coverage covered_by(const pixel_line* lines, std::size_t count) {
    return L3D_SIMD_CALL(covered_by)(lines, count);
}

coverage above_zero(const pixel_plane& plane) {
    return L3D_SIMD_CALL(above_zero)(plane);
}

coverage_moments moments_of(const coverage& samples) {
    return L3D_SIMD_CALL(moments_of)(samples);
}

namespace {

/// V of places in 1/512 pixel that are exact in 32 bits for |of| <= 2^14: 2^14 (2^15 + 2^9) 2 =
/// 2^30 + 2^24 at most.
constexpr std::int64_t longest = 1 << 14;

} // namespace

pixel_line pixel_line::between(scan_point from, scan_point to, scan_point pixel) {
    // The same numbers for both ways: from the corner that is above, or on the left.
    const bool turned = to.y < from.y || (to.y == from.y && to.x < from.x);
    const scan_point first = turned ? to : from, second = turned ? from : to;
    const std::int64_t dx = std::int64_t{second.x} - first.x, dy = std::int64_t{second.y} - first.y;
    std::int64_t of_x = -dy, of_y = dx;
    std::int64_t at =
        2 * (dy * (std::int64_t{first.x} - pixel.x) - dx * (std::int64_t{first.y} - pixel.y));
    const std::int64_t length = std::max(std::abs(dx), std::abs(dy));
    if (length > longest) {
        // Where the line is far from the pixel, all that counts is the side.
        const auto excess =
            static_cast<int>(std::bit_width(static_cast<std::uint64_t>(length / longest)));
        of_x >>= excess;
        of_y >>= excess;
        at = std::clamp(at >> excess, -(std::int64_t{1} << 28), std::int64_t{1} << 28);
    }
    const auto number = [](std::int64_t n) { return static_cast<std::int32_t>(n); };
    if (turned)
        return {number(-at - 1), number(-of_x), number(-of_y)};
    return {number(at), number(of_x), number(of_y)};
}

} // namespace l3d_detail
#endif
