// SPDX-License-Identifier: MIT
// span_kernels: for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/span_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/simd_dispatch_p.h"
#include "raster/span_kernels_p.h"

#include <algorithm>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<std::uint32_t, 16> words;
constexpr hn::RebindToSigned<decltype(words)> integers;
constexpr hn::RebindToFloat<decltype(words)> floats;
using word_lanes = hn::Vec<decltype(words)>;
using integer_lanes = hn::Vec<decltype(integers)>;

/// At least one vector: the last one ends where the span does and may overlap the one before.
HWY_INLINE void fill_span(std::uint32_t* at, std::size_t count, word_lanes color) {
    const std::size_t lanes = hn::Lanes(words);
    if (count < lanes)
        return hn::BlendedStore(color, hn::FirstN(words, count), words, at);
    for (std::size_t i = 0; i < count - lanes; i += lanes)
        hn::StoreU(color, words, at + i);
    hn::StoreU(color, words, at + count - lanes);
}

void fill_rows_in_lanes(const l3d_pixels& target, std::int32_t top, std::span<const scan_ends> rows,
                        std::uint32_t color) {
    const word_lanes lanes = hn::Set(words, color);
    std::uint32_t* row = target.words + top * target.stride;
    for (const scan_ends& ends : rows) {
        const std::int32_t first = std::max(ends[0], 0), last = std::min(ends[1], target.width);
        if (first < last)
            fill_span(row + first, static_cast<std::size_t>(last - first), lanes);
        row += target.stride;
    }
}

void fill_spans_in_lanes(const l3d_pixels& target, std::span<const pixel_span> spans,
                         std::uint32_t color) {
    const word_lanes lanes = hn::Set(words, color);
    for (const pixel_span& s : spans)
        fill_span(target.words + s.row * target.stride + s.first,
                  static_cast<std::size_t>(s.last - s.first), lanes);
}

/// A channel of neighbouring columns; no bound is needed, for the numbers leave [0, 255] by less
/// than rounding forgives.
HWY_INLINE word_lanes channel_at(const shaded_span& span, std::size_t channel,
                                 hn::Vec<decltype(floats)> i) {
    const auto value = hn::Add(hn::Set(floats, span.start[channel]),
                               hn::Mul(hn::Set(floats, span.step[channel]), i));
    return hn::BitCast(words, hn::ConvertTo(integers, hn::Add(value, hn::Set(floats, 0.5f))));
}

HWY_INLINE word_lanes colors_at(const shaded_span& span, std::int32_t column) {
    const auto i = hn::ConvertTo(floats, hn::Iota(integers, column - span.anchor));
    return hn::Or(
        hn::Or(hn::ShiftLeft<16>(channel_at(span, 0, i)), hn::ShiftLeft<8>(channel_at(span, 1, i))),
        channel_at(span, 2, i));
}

void shade_spans_in_lanes(const l3d_pixels& target, std::span<const shaded_span> spans) {
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(words));
    for (const shaded_span& s : spans) {
        std::uint32_t* row = target.words + s.row * target.stride;
        std::int32_t x = s.first;
        for (; x + lanes <= s.last; x += lanes)
            hn::StoreU(colors_at(s, x), words, row + x);
        if (x < s.last)
            hn::BlendedStore(colors_at(s, x),
                             hn::FirstN(words, static_cast<std::size_t>(s.last - x)), words,
                             row + x);
    }
}

/// An edge function at a row of pixels, and what it gains from row to row.
struct edge_lanes {
    integer_lanes value, per_row;
};

/// Not below 0 where the sample is inside; on an edge that is neither left nor top it is -1.
HWY_INLINE edge_lanes edge_at(scan_point from, scan_point to, std::int32_t column,
                              std::int32_t row) {
    const std::int32_t dx = to.x - from.x, dy = to.y - from.y;
    const std::int32_t x = l3d_subpixel_one * column + l3d_subpixel_one / 2 - from.x;
    const std::int32_t y = l3d_subpixel_one * row + l3d_subpixel_one / 2 - from.y;
    const bool owns = dy < 0 || (dy == 0 && dx > 0);
    const std::int32_t value = dx * y - dy * x - (owns ? 0 : 1);
    return {hn::Sub(hn::Set(integers, value),
                    hn::Mul(hn::Iota(integers, 0), hn::Set(integers, l3d_subpixel_one * dy))),
            hn::Set(integers, l3d_subpixel_one * dx)};
}

void fill_triangle_in_lanes(const l3d_pixels& target, const std::array<scan_point, 3>& c,
                            const pixel_box& box, std::uint32_t color) {
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(words));
    const word_lanes colors = hn::Set(words, color);
    for (std::int32_t x = box.left; x < box.right; x += lanes) {
        edge_lanes a = edge_at(c[0], c[1], x, box.top), b = edge_at(c[1], c[2], x, box.top),
                   d = edge_at(c[2], c[0], x, box.top);
        std::uint32_t* at = target.words + box.top * target.stride + x;
        for (std::int32_t row = box.top; row < box.bottom; ++row, at += target.stride) {
            const auto inside =
                hn::Gt(hn::Or(hn::Or(a.value, b.value), d.value), hn::Set(integers, -1));
            hn::BlendedStore(colors, hn::RebindMask(words, inside), words, at);
            a.value = hn::Add(a.value, a.per_row);
            b.value = hn::Add(b.value, b.per_row);
            d.value = hn::Add(d.value, d.per_row);
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(fill_rows_in_lanes);
L3D_SIMD_TABLE(fill_spans_in_lanes);
L3D_SIMD_TABLE(shade_spans_in_lanes);
L3D_SIMD_TABLE(fill_triangle_in_lanes);

void fill_rows(const l3d_pixels& target, std::int32_t top, std::span<const scan_ends> rows,
               std::uint32_t color) {
    L3D_SIMD_CALL(fill_rows_in_lanes)(target, top, rows, color);
}

void fill_spans(const l3d_pixels& target, std::span<const pixel_span> spans, std::uint32_t color) {
    L3D_SIMD_CALL(fill_spans_in_lanes)(target, spans, color);
}

void shade_spans(const l3d_pixels& target, std::span<const shaded_span> spans) {
    L3D_SIMD_CALL(shade_spans_in_lanes)(target, spans);
}

void fill_triangle(const l3d_pixels& target, const std::array<scan_point, 3>& corners,
                   const pixel_box& box, std::uint32_t color) {
    L3D_SIMD_CALL(fill_triangle_in_lanes)(target, corners, box, color);
}

} // namespace l3d_detail
#endif
