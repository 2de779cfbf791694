// SPDX-License-Identifier: MIT
// span_kernels: fills and blends spans, for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shapes/span_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"
#include "raster/shapes/blend_p.h"
#include "raster/shapes/span_kernels_p.h"
#include "raster/parallel/store_where-inl.h"

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

/// Fills a span that is shorter than a vector by two halves, which may overlap.
/// Expects: 1 <= count < Lanes, or count and Lanes both 1.
template <std::size_t Lanes>
HWY_INLINE void fill_short_span(std::uint32_t* at, std::size_t count, std::uint32_t color) {
    if constexpr (Lanes == 1) {
        *at = color;
    } else {
        const hn::CappedTag<std::uint32_t, Lanes / 2> half;
        if (count < Lanes / 2)
            return fill_short_span<Lanes / 2>(at, count, color);
        hn::StoreU(hn::Set(half, color), half, at);
        hn::StoreU(hn::Set(half, color), half, at + count - Lanes / 2);
    }
}

/// Fills a span by vectors. The last vector ends with the span and may overlap the vector before
/// it.
/// Expects: count >= 1.
HWY_INLINE void fill_span(std::uint32_t* at, std::size_t count, std::uint32_t color) {
    constexpr std::size_t lanes = hn::MaxLanes(words);
    const word_lanes colors = hn::Set(words, color);
    if (count < lanes) {
        if constexpr (masked_stores_are_cheap)
            return hn::BlendedStore(colors, hn::FirstN(words, count), words, at);
        else
            return fill_short_span<lanes>(at, count, color);
    }
    // A store across two cache lines costs twice as much, so all but the first and the last are
    // aligned.
    hn::StoreU(colors, words, at);
    const std::size_t beyond = reinterpret_cast<std::uintptr_t>(at) / sizeof(std::uint32_t) % lanes;
    for (std::size_t i = lanes - beyond; i < count - lanes; i += lanes)
        hn::StoreU(colors, words, at + i);
    hn::StoreU(colors, words, at + count - lanes);
}

void fill_rows_in_lanes(const l3d_pixels& target, std::int32_t top, std::span<const scan_ends> rows,
                        std::uint32_t color) {
    std::uint32_t* row = target.words + top * target.stride;
    for (const scan_ends& ends : rows) {
        const std::int32_t first = std::max(ends[0], 0), last = std::min(ends[1], target.width);
        if (first < last)
            fill_span(row + first, static_cast<std::size_t>(last - first), color);
        row += target.stride;
    }
}

void fill_spans_in_lanes(const l3d_pixels& target, std::span<const pixel_span> spans,
                         std::uint32_t color) {
    for (const pixel_span& s : spans)
        fill_span(target.words + s.row * target.stride + s.first,
                  static_cast<std::size_t>(s.last - s.first), color);
}

/// Moves words towards a colour by shares of 255, and rounds each channel to the nearest level. Two
/// channels share a lane, 16 bits each, and sums stay below 2^16. Up to t = 255^2, t / 255 to the
/// nearest is (u + u / 256) / 256 with u = t + 128, where each quotient is rounded down.
/// Expects: the highest eight bits of words and of the colour are 0.
template <class D>
HWY_INLINE hn::Vec<D> blended_lanes(D d, hn::Vec<D> word, hn::Vec<D> color, hn::Vec<D> share) {
    const auto low = hn::Set(d, 0x00ff00ff), rest = hn::Sub(hn::Set(d, 255), share);
    const auto mix = [&](hn::Vec<D> from, hn::Vec<D> to) {
        const auto sum =
            hn::Add(hn::Add(hn::Mul(from, rest), hn::Mul(to, share)), hn::Set(d, 0x00800080));
        return hn::Add(sum, hn::And(hn::ShiftRight<8>(sum), low));
    };
    const auto even = mix(hn::And(word, low), hn::And(color, low));
    const auto odd =
        mix(hn::And(hn::ShiftRight<8>(word), low), hn::And(hn::ShiftRight<8>(color), low));
    return hn::Or(hn::And(hn::ShiftRight<8>(even), low), hn::AndNot(low, odd));
}

/// Blends a vector of words. Does nothing and returns false if one of these words may be
/// transparent.
template <class D, class Shares>
HWY_INLINE bool cover_vector(D d, std::uint32_t* at, std::uint32_t color, const Shares& shares,
                             std::size_t i) {
    const auto word = hn::LoadU(d, at + i);
    if (!hn::AllTrue(d, hn::Lt(word, hn::Set(d, 0x01000000))))
        return false;
    hn::StoreU(blended_lanes(d, word, hn::Set(d, color), shares.lanes(d, i)), d, at + i);
    return true;
}

/// Blends the words from index i on, one by one. It serves vectors in which a word may be
/// transparent.
template <class Shares>
HWY_NOINLINE void cover_each(std::uint32_t* at, std::size_t count, std::uint32_t color,
                             const Shares& shares, std::size_t i) {
    for (; i < count; ++i)
        if (shares.one(i) > 0)
            at[i] = blended_over_gap(at[i], color, shares.one(i));
}

/// Blends neighbouring words with a colour, by their shares.
template <class Shares>
HWY_INLINE void cover_run(std::uint32_t* at, std::size_t count, std::uint32_t color,
                          const Shares& shares) {
    constexpr std::size_t lanes = hn::MaxLanes(words);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        if (!cover_vector(words, at, color, shares, i))
            return cover_each(at, count, color, shares, i);
    // A straight side of a path often has four values.
    if (constexpr hn::CappedTag<std::uint32_t, 4> four;
        count - i == hn::MaxLanes(four) && cover_vector(four, at, color, shares, i))
        return;
    // A mask keeps words beyond the last from being read. Where masks are not cheap, they only pay
    // for more than three words.
    constexpr std::size_t few = masked_stores_are_cheap ? 0 : 3;
    if (count - i > few) {
        const auto mask = hn::FirstN(words, count - i);
        const word_lanes word = hn::MaskedLoad(mask, words, at + i);
        if (hn::AllTrue(words, hn::Lt(word, hn::Set(words, 0x01000000))))
            return hn::BlendedStore(
                blended_lanes(words, word, hn::Set(words, color), shares.lanes(words, i)), mask,
                words, at + i);
    }
    if (i < count)
        cover_each(at, count, color, shares, i);
}

struct equal_shares {
    std::uint8_t value;
    template <class D> HWY_INLINE hn::Vec<D> lanes(D d, std::size_t) const {
        return hn::Set(d, value);
    }
    int one(std::size_t) const { return value; }
};

struct listed_shares {
    const std::uint8_t* values;
    template <class D> HWY_INLINE hn::Vec<D> lanes(D d, std::size_t i) const {
        return hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint8_t, D>(), values + i));
    }
    int one(std::size_t i) const { return values[i]; }
};

#if HWY_MAX_BYTES >= 32
/// Blends the four columns before a span's middle and the four after it. Does nothing and returns
/// false if a word may be transparent.
HWY_INLINE bool cover_ends(std::uint32_t* first, std::uint32_t* second, const std::uint8_t* values,
                           std::uint32_t color) {
    constexpr hn::CappedTag<std::uint32_t, 4> four;
    constexpr hn::CappedTag<std::uint32_t, 8> eight;
    const auto word = hn::Combine(eight, hn::LoadU(four, second), hn::LoadU(four, first));
    if (!hn::AllTrue(eight, hn::Lt(word, hn::Set(eight, 0x01000000))))
        return false;
    const auto shares = listed_shares{values}.lanes(eight, 0);
    const auto result = blended_lanes(eight, word, hn::Set(eight, color), shares);
    hn::StoreU(hn::LowerHalf(four, result), four, first);
    hn::StoreU(hn::UpperHalf(four, result), four, second);
    return true;
}
#else
/// Does nothing and returns false, as both groups of four columns do not fit into a vector of this
/// instruction set.
bool cover_ends(std::uint32_t*, std::uint32_t*, const std::uint8_t*, std::uint32_t) {
    return false;
}
#endif

void cover_spans_in_lanes(const l3d_pixels& target, std::span<const covered_span> spans,
                          const std::uint8_t* all_values, std::uint32_t color) {
    // Other rows are on other pages of memory, which no processor prefetches by itself. If the
    // distance of rows is a power of two, all cache lines of a shape's side fall into one set of
    // the first cache. Most processors have eight or more lines in a set, and two of them may be in
    // use.
    constexpr std::size_t ahead = 6;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const covered_span& s = spans[i];
        if (const covered_span& later = spans[std::min(i + ahead, spans.size() - 1)];
            later.row != s.row) {
            const std::uint32_t* const row = target.words + later.row * target.stride;
            hwy::Prefetch(row + later.first);
            hwy::Prefetch(row + later.beyond);
        }
        std::uint32_t* const row = target.words + s.row * target.stride;
        const std::uint8_t* const values = all_values + s.values;
        const auto before = static_cast<std::size_t>(s.between - s.first);
        const auto behind = static_cast<std::size_t>(s.last - s.beyond);
        if (before != 4 || behind != 4 ||
            !cover_ends(row + s.first, row + s.beyond, values, color)) {
            if (before > 0)
                cover_run(row + s.first, before, color, listed_shares{values});
            if (behind > 0)
                cover_run(row + s.beyond, behind, color, listed_shares{values + before});
        }
        if (s.between == s.beyond)
            continue;
        std::uint32_t* const at = row + s.between;
        const auto count = static_cast<std::size_t>(s.beyond - s.between);
        if (s.value == 255)
            fill_span(at, count, color);
        else
            cover_run(at, count, color, equal_shares{static_cast<std::uint8_t>(s.value)});
    }
}

/// The values of one colour channel in neighbouring columns. The values need no clamping, as
/// rounding brings them into [0, 255].
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
        const std::int32_t last_begin = s.last - lanes;
        for (std::int32_t x = s.first; x < last_begin; x += lanes)
            hn::StoreU(colors_at(s, x), words, row + x);
        if (s.first <= last_begin)
            hn::StoreU(colors_at(s, last_begin), words, row + last_begin);
        else
            hn::BlendedStore(colors_at(s, s.first),
                             hn::FirstN(words, static_cast<std::size_t>(s.last - s.first)), words,
                             row + s.first);
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
L3D_SIMD_TABLE(cover_spans_in_lanes);
L3D_SIMD_TABLE(shade_spans_in_lanes);

void fill_rows(const l3d_pixels& target, std::int32_t top, std::span<const scan_ends> rows,
               std::uint32_t color) {
    L3D_SIMD_CALL(fill_rows_in_lanes)(target, top, rows, color);
}

void fill_spans(const l3d_pixels& target, std::span<const pixel_span> spans, std::uint32_t color) {
    L3D_SIMD_CALL(fill_spans_in_lanes)(target, spans, color);
}

void cover_spans(const l3d_pixels& target, std::span<const covered_span> spans,
                 const std::uint8_t* values, std::uint32_t color) {
    L3D_SIMD_CALL(cover_spans_in_lanes)(target, spans, values, color);
}

void shade_spans(const l3d_pixels& target, std::span<const shaded_span> spans) {
    L3D_SIMD_CALL(shade_spans_in_lanes)(target, spans);
}

} // namespace l3d_detail
#endif
