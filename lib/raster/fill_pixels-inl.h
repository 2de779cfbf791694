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

/// A vector of pixels; a run is several of them where vectors are short.
constexpr std::int32_t vector_pixels = static_cast<std::int32_t>(lanes);
constexpr std::int32_t run_vectors = run / vector_pixels;

/// A grey level of less than 256 in each word, 26 more, as a word of three equal bytes.
HWY_INLINE hn::Vec<words> grey_words(int_vec level) {
#if HWY_TARGET == HWY_SCALAR // has no bytes to shuffle
    const int_vec grey = hn::Min(hn::Add(level, hn::Set(ints(), 26)), hn::Set(ints(), 255));
    return hn::BitCast(words(), hn::Mul(grey, hn::Set(ints(), 0x010101)));
#else
    const hn::Repartition<std::uint8_t, ints> bytes;
    alignas(16) static constexpr std::uint8_t lowest[16] = {0, 0, 0, 0x80, 4,  4,  4,  0x80,
                                                            8, 8, 8, 0x80, 12, 12, 12, 0x80};
    const auto spread =
        hn::TableLookupBytesOr0(hn::BitCast(bytes, level), hn::LoadDup128(bytes, lowest));
    const auto ambient = hn::BitCast(bytes, hn::Set(words(), 0x001a1a1au));
    return hn::BitCast(words(), hn::SaturatedAdd(spread, ambient));
#endif
}

/// Fills the polygons of a table, one after the other.
template <bool Curved> class fill_pixels {
public:
    HWY_INLINE fill_pixels(const fill_band& band, const fill_table& table)
        : band_(band), table_(table) {}

    /// Returns how many pixels were written.
    HWY_INLINE std::int64_t fill() {
        for (std::size_t i = 0; i < lanes; ++i) {
            if (table_.height[i] == 0)
                continue;
            begin(i);
            if (table_.width[i] > run)
                wide(i);
            else
                narrow(i);
        }
        return written_;
    }

private:
    HWY_INLINE void begin(std::size_t i) {
        const floats d;
        farthest_ = hn::Set(d, table_.farthest[i]);
        nearest_ = hn::Set(d, table_.nearest[i]);
        for (std::int32_t v = 0; v < run_vectors; ++v) {
            const float_vec x = hn::Load(d, run_columns + v * vector_pixels);
            inv_w_x_[v] = hn::Mul(hn::Set(d, table_.inv_w_x[i]), x);
            lit_x_[v] = hn::Mul(hn::Set(d, table_.lit_x[i]), x);
            if constexpr (Curved) {
                x_[v] = x;
                square_xx_[v] = hn::Mul(hn::Set(d, table_.square_xx[i]), hn::Mul(x, x));
                facing_x_[v] = hn::Mul(hn::Set(d, table_.facing_x[i]), x);
            }
        }
        if constexpr (Curved) {
            unit0_ = hn::Set(d, table_.unit0[i]);
            unit1_ = hn::Set(d, table_.unit1[i]);
            unit2_ = hn::Set(d, table_.unit2[i]);
        }
    }

    HWY_INLINE void narrow(std::size_t i) {
        const std::size_t end = i + lanes * static_cast<std::size_t>(table_.height[i]);
        for (std::size_t at = i; at < end; at += lanes)
            one_run(at, 0, 0.0f, static_cast<std::uint32_t>(table_.mask[at]));
    }

    /// The last run ends where the row does, so that it fits the picture if the row does.
    HWY_INLINE void wide(std::size_t i) {
        const std::size_t end = i + lanes * static_cast<std::size_t>(table_.height[i]);
        for (std::size_t at = i; at < end; at += lanes) {
            one_run(at, 0, 0.0f, static_cast<std::uint32_t>(table_.mask[at]));
            const std::int32_t last = table_.last[at];
            for (std::int32_t done = run; done < last; done += run) {
                const std::int32_t start = std::min(done, last - run);
                const std::uint32_t mask =
                    ((1u << std::min(run, last - start)) - 1) & ~((1u << (done - start)) - 1);
                one_run(at, start, static_cast<float>(start), mask);
            }
        }
    }

    /// Pixels `start` ... of a row.
    HWY_INLINE void one_run(std::size_t at, std::int32_t start, float x, std::uint32_t bits) {
        std::uint32_t* const to_words = band_.words + (table_.word_at[at] + start);
        float* const to_depths = band_.depths + (table_.depth_at[at] + start);
        for (std::int32_t v = 0; v < run_vectors; ++v) {
            const std::uint32_t mask = bits >> (v * vector_pixels);
            if (run_vectors > 1 && (mask & ((1u << vector_pixels) - 1)) == 0)
                continue;
            one_vector(at, static_cast<std::size_t>(v), start > 0 ? x : 0.0f, mask,
                       to_words + v * vector_pixels, to_depths + v * vector_pixels);
        }
    }

    HWY_INLINE void one_vector(std::size_t at, std::size_t v, float x, std::uint32_t bits,
                               std::uint32_t* to_words, float* to_depths) {
        const floats d;
        const std::size_t i = at % lanes;
        const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                       static_cast<std::uint8_t>(bits >> 8)};
        const auto covered = hn::LoadMaskBits(d, bytes);
        const float_vec inv_w = hn::Min(
            hn::Max(hn::Add(hn::Set(d, table_.inv_w[at] + table_.inv_w_x[i] * x), inv_w_x_[v]),
                    farthest_),
            nearest_);
        const auto seen = hn::And(covered, hn::Gt(inv_w, hn::LoadU(d, to_depths)));
        hn::BlendedStore(inv_w, seen, d, to_depths);
        float_vec lit = hn::Add(hn::Set(d, table_.lit[at] + table_.lit_x[i] * x), lit_x_[v]);
        if constexpr (Curved) {
            // square + x square_x + x^2 square_xx, from x on
            const float xx = table_.square_xx[i] * x;
            const float square_x = table_.square_x[at] + 2.0f * xx;
            const float square0 = table_.square[at] + (table_.square_x[at] + xx) * x;
            const float_vec square = hn::Add(
                hn::Set(d, square0), hn::Add(hn::Mul(hn::Set(d, square_x), x_[v]), square_xx_[v]));
            const float_vec unit =
                hn::Add(unit0_, hn::Mul(square, hn::Add(unit1_, hn::Mul(unit2_, square))));
            const float_vec facing =
                hn::Add(hn::Set(d, table_.facing[at] + table_.facing_x[i] * x), facing_x_[v]);
            lit = hn::Xor(hn::Mul(lit, unit), hn::And(facing, hn::SignBit(d)));
        }
        const int_vec level = hn::ConvertTo(ints(), hn::Max(lit, hn::Zero(d)));
        hn::BlendedStore(grey_words(level), hn::RebindMask(words(), seen), words(), to_words);
        written_ += static_cast<std::int64_t>(hn::CountTrue(d, seen));
    }

    const fill_band& band_;
    const fill_table& table_;
    std::int64_t written_ = 0;
    float_vec inv_w_x_[run_vectors], lit_x_[run_vectors], farthest_, nearest_;
    float_vec x_[run_vectors], square_xx_[run_vectors], facing_x_[run_vectors];
    float_vec unit0_, unit1_, unit2_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
