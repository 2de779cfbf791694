// SPDX-License-Identifier: MIT
// Fills a small triangle by its edge functions, at all pixels of its box.
#if defined(L3D_RASTER_SHAPES_SMALL_FILL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SHAPES_SMALL_FILL_INL_H
#undef L3D_RASTER_SHAPES_SMALL_FILL_INL_H
#else
#define L3D_RASTER_SHAPES_SMALL_FILL_INL_H
#endif

#include "raster/parallel/store_where-inl.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Types for vectors of at most `Most` neighbouring pixels.
template <std::size_t Most> struct pixel_lanes {
    static constexpr hn::CappedTag<std::uint32_t, Most> words{};
    static constexpr hn::RebindToSigned<hn::CappedTag<std::uint32_t, Most>> integers{};
    static constexpr hn::RebindToFloat<hn::CappedTag<std::uint32_t, Most>> floats{};
    using word_vec = hn::Vec<hn::CappedTag<std::uint32_t, Most>>;
    using integer_vec = hn::Vec<hn::RebindToSigned<hn::CappedTag<std::uint32_t, Most>>>;
    using float_vec = hn::Vec<hn::RebindToFloat<hn::CappedTag<std::uint32_t, Most>>>;
};

/// A box of pixels in the picture.
struct small_box {
    std::int32_t left, top, columns, rows;
};

/// An edge function: its value at the first sample of the box, and its increments to the right and
/// downwards. A sample is inside of the edge if its value is at least 0. On an edge that is neither
/// left nor top, a sample's value is -1.
struct small_edge {
    std::int32_t first, per_column, per_row;
};

/// The values of an edge function in a row of samples.
template <class Lanes> struct edge_lanes {
    typename Lanes::integer_vec value, per_row;
    std::int32_t per_column;

    HWY_INLINE explicit edge_lanes(const small_edge& of) : per_column(of.per_column) {
        constexpr auto d = Lanes::integers;
        value = hn::Add(hn::Set(d, of.first), hn::Mul(hn::Iota(d, 0), hn::Set(d, per_column)));
        per_row = hn::Set(d, of.per_row);
    }

    /// Steps to the next vector of columns.
    HWY_INLINE void step_right() {
        const auto lanes = static_cast<std::int32_t>(hn::Lanes(Lanes::words));
        value = hn::Add(value, hn::Set(Lanes::integers, lanes * per_column));
    }
};

/// Fills the part of a box on the inner side of three edges. `colors` gives the words: after
/// begin_block(column), each call of next_row() gives the words of the next row from this column
/// on.
/// Expects: the box lies in the picture.
template <class Lanes, class Colors>
HWY_INLINE void fill_box(const l3d_pixels& target, const small_box& box,
                         const std::array<small_edge, 3>& edges, Colors& colors) {
    constexpr auto words = Lanes::words;
    edge_lanes<Lanes> pq(edges[0]), qr(edges[1]), rp(edges[2]);
    const auto lanes = static_cast<std::int32_t>(hn::Lanes(words));
    const std::ptrdiff_t stride = target.stride;
    std::uint32_t* block = target.words + box.top * stride + box.left;
    std::int32_t room = target.width - box.left;
    for (std::int32_t columns = box.columns; columns > 0; columns -= lanes, block += lanes) {
        auto u = pq.value, v = qr.value, w = rp.value;
        std::uint32_t* at = block;
        colors.begin_block(box.columns - columns);
        for (std::int32_t rows = box.rows; rows > 0; --rows, at += stride) {
            const auto word = colors.next_row();
            const auto inside = hn::Gt(hn::Or(hn::Or(u, v), w), hn::Set(Lanes::integers, -1));
            if (HWY_LIKELY(room >= lanes))
                store_where(hn::RebindMask(Lanes::floats, inside), word, words, at);
            else
                hn::BlendedStore(word, hn::RebindMask(words, inside), words, at);
            u = hn::Add(u, pq.per_row);
            v = hn::Add(v, qr.per_row);
            w = hn::Add(w, rp.per_row);
        }
        room -= lanes;
        if (columns > lanes) {
            pq.step_right();
            qr.step_right();
            rp.step_right();
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
