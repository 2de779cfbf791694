// SPDX-License-Identifier: MIT
// fill_pixels: the rows of a table into picture and depth. The product's inner loop.
#if defined(L3D_RASTER_FILL_PIXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_FILL_PIXELS_INL_H
#undef L3D_RASTER_FILL_PIXELS_INL_H
#else
#define L3D_RASTER_FILL_PIXELS_INL_H
#endif

#include "raster/fill_table-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// 0, 1, 2 ... 15: the columns of a run.
alignas(64) constexpr float run_columns[run] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                8, 9, 10, 11, 12, 13, 14, 15};

/// Three bytes like the lowest one of each sum.
template <class D> HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> three_bytes(D, hn::Vec<D> sum) {
    const hn::RebindToUnsigned<D> dw;
#if HWY_TARGET == HWY_SCALAR // has no bytes to shuffle
    return hn::Mul(hn::And(hn::BitCast(dw, sum), hn::Set(dw, 0xffu)), hn::Set(dw, 0x010101u));
#else
    const hn::Repartition<std::uint8_t, D> bytes;
    alignas(16) static constexpr std::uint8_t lowest[16] = {0, 0, 0, 0x80, 4,  4,  4,  0x80,
                                                            8, 8, 8, 0x80, 12, 12, 12, 0x80};
    return hn::BitCast(
        dw, hn::TableLookupBytesOr0(hn::BitCast(bytes, sum), hn::LoadDup128(bytes, lowest)));
#endif
}

/// Where this is added to a number below it, the last bits of the sum are the nearest integer.
constexpr float whole_numbers = 8388608.0f; // 2^23

/// Words from grey levels. Expects: levels in [0, 255].
template <class D> HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> level_words(D d, hn::Vec<D> level) {
    return three_bytes(d, hn::Add(level, hn::Set(d, whole_numbers)));
}

/// Words of the levels 26 + floor(max(0, lit)), at most 255. Expects: lit < 256.
template <class D> HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> cosine_words(D d, hn::Vec<D> lit) {
    const hn::RebindToUnsigned<D> dw;
    const auto sum =
        hn::Max(hn::Add(lit, hn::Set(d, whole_numbers - 0.5f)), hn::Set(d, whole_numbers));
#if HWY_TARGET == HWY_SCALAR
    const auto level = hn::And(hn::BitCast(dw, sum), hn::Set(dw, 0xffu));
    const auto grey = hn::Min(hn::Add(level, hn::Set(dw, 26u)), hn::Set(dw, 255u));
    return hn::Mul(grey, hn::Set(dw, 0x010101u));
#else
    const hn::Repartition<std::uint8_t, D> bytes;
    const auto ambient = hn::BitCast(bytes, hn::Set(dw, 0x001a1a1au));
    return hn::BitCast(dw, hn::SaturatedAdd(hn::BitCast(bytes, three_bytes(d, sum)), ambient));
#endif
}

/// 1 / sqrt(q) over [0.75, 1.02] by a parabola through its Chebyshev points: within 3e-4, that is
/// 0.07 grey levels.
constexpr float unit_parabola[3] = {2.0041274f, -1.5196685f, 0.5155188f};

/// One polygon of a table, `Pixels` of a row at a time.
template <class D, std::int32_t Pixels, fill_shape Shape> class fill_polygon {
public:
    /// Pixels written, by lanes; and words.
    using count_vec = hn::Vec<hn::RebindToUnsigned<D>>;

    HWY_INLINE fill_polygon(const fill_band& band, const fill_table& table, std::size_t i)
        : words_(band.words), depths_(band.depths), table_(table), i_(i) {
        const D d;
        farthest_ = hn::Set(d, table.farthest[i]);
        nearest_ = hn::Set(d, table.nearest[i]);
        if constexpr (is_grey) {
            darkest_ = hn::Set(d, table.darkest[i]);
            brightest_ = hn::Set(d, table.brightest[i]);
        }
        for (std::size_t v = 0; v < vectors; ++v) {
            const vec x = hn::Load(d, run_columns + v * width);
            inv_w_x_[v] = hn::Mul(hn::Set(d, table.inv_w_x[i]), x);
            lit_x_[v] = hn::Mul(hn::Set(d, table.lit_x[i]), x);
            if constexpr (is_twisted) {
                x_[v] = x;
                bend_xx_[v] = hn::Mul(hn::Set(d, table.bend_xx[i]), hn::Mul(x, x));
                facing_x_[v] = hn::Mul(hn::Set(d, table.facing_x[i]), x);
            }
        }
    }

    /// The first run of each row.
    HWY_INLINE void fill(count_vec& written) const {
        const fill_row* const end = table_.rows + table_.height[i_];
        for (const fill_row* row = table_.rows; row != end; ++row)
            first_run(*row, written);
    }

    /// All runs of each row.
    HWY_INLINE void fill_wide(count_vec& written) const {
        const fill_row* const end = table_.rows + table_.height[i_];
        for (const fill_row* row = table_.rows; row != end; ++row) {
            first_run(*row, written);
            for (std::int32_t done = Pixels; done < row->last[i_]; done += Pixels)
                later_run(*row, done, written);
        }
    }

private:
    using vec = hn::Vec<D>;
    static constexpr bool is_grey = Shape == fill_shape::grey;
    static constexpr bool is_twisted = Shape == fill_shape::twisted;
    static constexpr std::size_t width = hn::MaxLanes(D()), vectors = Pixels / width;

    /// Numbers at a run's first pixel, in all lanes.
    struct run_start {
        vec inv_w, lit, bend, bend_x, facing;
    };

    HWY_INLINE void first_run(const fill_row& row, count_vec& written) const {
        const D d;
        run_start start{hn::Set(d, row.inv_w[i_]), hn::Set(d, row.lit[i_]), {}, {}, {}};
        if constexpr (is_twisted) {
            start.bend = hn::Set(d, row.bend[i_]);
            start.bend_x = hn::Set(d, row.bend_x[i_]);
            start.facing = hn::Set(d, row.facing[i_]);
        }
        one_run(start, row.mask[i_], words_ + row.word_at[i_], depths_ + row.depth_at[i_], written);
    }

    /// The last run ends where the row does, so that it fits the picture if the row does.
    HWY_INLINE void later_run(const fill_row& row, std::int32_t done, count_vec& written) const {
        const D d;
        const std::int32_t start = std::min(done, row.last[i_] - Pixels);
        const auto x = static_cast<float>(start);
        run_start there;
        there.inv_w = hn::Set(d, row.inv_w[i_] + x * table_.inv_w_x[i_]);
        there.lit = hn::Set(d, row.lit[i_] + x * table_.lit_x[i_]);
        if constexpr (is_twisted) {
            const float xx = x * table_.bend_xx[i_];
            there.bend = hn::Set(d, row.bend[i_] + x * (row.bend_x[i_] + xx));
            there.bend_x = hn::Set(d, row.bend_x[i_] + 2.0f * xx);
            there.facing = hn::Set(d, row.facing[i_] + x * table_.facing_x[i_]);
        }
        const std::int32_t mask = ((1 << Pixels) - 1) & ~((1 << (done - start)) - 1);
        one_run(there, mask, words_ + row.word_at[i_] + start, depths_ + row.depth_at[i_] + start,
                written);
    }

    HWY_INLINE void one_run(const run_start& start, std::int32_t mask, std::uint32_t* to_words,
                            float* to_depths, count_vec& written) const {
        for (std::size_t v = 0; v < vectors; ++v)
            one_vector(start, v, static_cast<std::uint32_t>(mask) >> v * width,
                       to_words + v * width, to_depths + v * width, written);
    }

    HWY_INLINE void one_vector(const run_start& start, std::size_t v, std::uint32_t bits,
                               std::uint32_t* to_words, float* to_depths,
                               count_vec& written) const {
        const D d;
        const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                       static_cast<std::uint8_t>(bits >> 8)};
        const auto covered = hn::LoadMaskBits(d, bytes);
        const vec inv_w = hn::IfThenElseZero(
            covered, hn::Min(hn::Max(hn::Add(start.inv_w, inv_w_x_[v]), farthest_), nearest_));
        const auto seen = hn::Gt(inv_w, hn::LoadU(d, to_depths));
        hn::BlendedStore(inv_w, seen, d, to_depths);
        const hn::RebindToUnsigned<D> dw;
        hn::BlendedStore(words_of(start, v), hn::RebindMask(dw, seen), dw, to_words);
        const auto seen_words = hn::RebindMask(dw, seen);
        written = hn::IfThenElse(seen_words, hn::Add(written, hn::Set(dw, 1u)), written);
    }

    HWY_INLINE count_vec words_of(const run_start& start, std::size_t v) const {
        const D d;
        vec lit = hn::Add(start.lit, lit_x_[v]);
        if constexpr (is_grey)
            return level_words(d, hn::Min(hn::Max(lit, darkest_), brightest_));
        if constexpr (is_twisted) {
            const vec bend =
                hn::Add(start.bend, hn::Add(hn::Mul(start.bend_x, x_[v]), bend_xx_[v]));
            const vec line =
                hn::Add(hn::Set(d, unit_parabola[1]), hn::Mul(hn::Set(d, unit_parabola[2]), bend));
            lit = hn::Mul(lit, hn::Add(hn::Set(d, unit_parabola[0]), hn::Mul(bend, line)));
            lit = hn::Xor(lit, hn::And(hn::Add(start.facing, facing_x_[v]), hn::SignBit(d)));
        }
        return cosine_words(d, lit);
    }

    std::uint32_t* words_;
    float* depths_;
    const fill_table& table_;
    std::size_t i_;
    vec inv_w_x_[vectors], lit_x_[vectors], farthest_, nearest_;
    vec darkest_, brightest_;
    vec x_[vectors], bend_xx_[vectors], facing_x_[vectors];
};

/// Fills polygons of a table, and counts the pixels that were written.
///
/// Most rows are short, and short vectors do: more of them fit the processor's ports.
class fill_polygons {
public:
    HWY_INLINE fill_polygons(const fill_band& band, const fill_table& table)
        : band_(band), table_(table), written_(hn::Zero(words())),
          half_written_(hn::Zero(half_words())) {}

    template <fill_shape Shape> HWY_INLINE void fill(std::size_t i) {
        if (table_.longest[i] <= half)
            fill_polygon<half_floats, half, Shape>(band_, table_, i).fill(half_written_);
        else if (table_.longest[i] <= run)
            fill_polygon<floats, run, Shape>(band_, table_, i).fill(written_);
        else
            fill_polygon<floats, run, Shape>(band_, table_, i).fill_wide(written_);
    }

    HWY_INLINE std::int64_t written() const {
        return std::int64_t{hn::GetLane(hn::SumOfLanes(words(), written_))} +
               hn::GetLane(hn::SumOfLanes(half_words(), half_written_));
    }

private:
    static constexpr std::int32_t half = run / 2;
    using half_floats = hn::CappedTag<float, half>;
    using half_words = hn::RebindToUnsigned<half_floats>;

    const fill_band& band_;
    const fill_table& table_;
    hn::Vec<words> written_;
    hn::Vec<half_words> half_written_;
};

/// Fills the polygons of a table, in their order. Returns how many pixels were written.
/// Shape: `Shape` is that of all of them, but among twisted ones there may be flat ones.
template <fill_shape Shape>
HWY_INLINE std::int64_t fill_pixels(const fill_band& band, const fill_table& table) {
    fill_polygons polygons(band, table);
    for (std::size_t i = 0; i < lanes; ++i) {
        if (table.height[i] == 0)
            continue;
        if (Shape == fill_shape::twisted && table.twisted[i] == 0)
            polygons.fill<fill_shape::flat>(i);
        else
            polygons.fill<Shape>(i);
    }
    return polygons.written();
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
