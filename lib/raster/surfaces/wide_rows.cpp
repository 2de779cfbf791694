// SPDX-License-Identifier: MIT
// wide_rows: depth test, light and words of a vector of pixels.
#include "raster/surfaces/wide_rows_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/surfaces/wide_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"
#include "raster/parallel/store_where-inl.h"
#include "raster/shaders/normal_code_p.h"
#include "raster/shaders/normal_light-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using row_kind = row_light::kind;

/// 0, 1, 2 ... 15: the columns of a vector.
alignas(64) constexpr std::int32_t columns[16] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                  8, 9, 10, 11, 12, 13, 14, 15};

/// How many numbers lie behind inv_w.
constexpr std::size_t numbers_of(row_kind kind) {
    switch (kind) {
    case row_kind::held:
        return 1;
    case row_kind::normal:
        return 4;
    case row_kind::code:
        return 3;
    default:
        return 0;
    }
}

/// Operation by operation what the shaders do, so that each pixel gets the same bits.
template <class D, row_kind Kind> class wide_filler {
public:
    HWY_INLINE explicit wide_filler(const wide_polygon& of)
        : farthest_(hn::Set(D(), of.farthest)), nearest_(hn::Set(D(), of.nearest)),
          last_fit_(of.width - lanes), material_(hn::Set(word_tag(), of.material)),
          unit_(hn::Set(word_tag(), of.unit)), color_(of.color),
          darkest_(hn::Set(D(), of.light.darkest)), brightest_(hn::Set(D(), of.light.brightest)),
          light_(of.light.light) {
        for (std::size_t i = 0; i <= numbers; ++i)
            step_[i] = hn::Set(D(), of.step[i]);
        word_ = hn::Set(word_tag(), of.light.word);
    }

    HWY_INLINE std::int64_t fill(const wide_row& row) const {
        return row.depths == nullptr ? fill_as<false>(row) : fill_as<true>(row);
    }

private:
    using vec = hn::Vec<D>;
    using int_tag = hn::RebindToSigned<D>;
    using word_tag = hn::RebindToUnsigned<D>;
    using word_vec = hn::Vec<word_tag>;
    static constexpr std::size_t numbers = numbers_of(Kind);
    static constexpr std::int32_t lanes = static_cast<std::int32_t>(hn::MaxLanes(D()));

    /// The numbers of a row at its start.
    struct row_values {
        vec at[numbers + 1];
    };

    /// The last vector begins where it still fits the picture, and leaves what is done already.
    template <bool TestsDepth> HWY_INLINE std::int64_t fill_as(const wide_row& row) const {
        const D d;
        const int_tag di;
        row_values values;
        for (std::size_t i = 0; i <= numbers; ++i)
            values.at[i] = hn::Set(d, row.value[i]);
        std::uint32_t* const words = row.words;
        float* const depths = row.depths;
        std::uint32_t* const normals = row.normals;
        const std::int32_t last = row.end;
        const auto end = hn::Set(di, last), start = hn::Set(di, row.start);
        std::int64_t written = 0;
        for (std::int32_t x = row.begin; x < last; x += lanes) {
            const std::int32_t at = std::min(x, last_fit_);
            const auto column = hn::Add(hn::Load(di, columns), hn::Set(di, at));
            const vec k = hn::ConvertTo(d, hn::Sub(column, start));
            auto seen =
                hn::RebindMask(d, hn::AndNot(hn::Lt(column, hn::Set(di, x)), hn::Lt(column, end)));
            if constexpr (TestsDepth) {
                const vec there = hn::LoadU(d, depths + at);
                const vec inv_w = hn::Min(hn::Max(number(values, 0, k), farthest_), nearest_);
                seen = hn::And(seen, hn::Gt(inv_w, there));
                if (hn::AllFalse(d, seen))
                    continue;
                hn::StoreU(hn::IfThenElse(seen, inv_w, there), d, depths + at);
            }
            if constexpr (Kind == row_kind::code)
                put_code(values, k, seen, words + at, normals + at);
            else
                store_where(seen, word_at(values, k), word_tag(), words + at);
            written += static_cast<std::int64_t>(hn::CountTrue(d, seen));
        }
        return written;
    }

    HWY_INLINE vec number(const row_values& values, std::size_t i, vec k) const {
        return hn::Add(values.at[i], hn::Mul(step_[i], k));
    }

    HWY_INLINE void put_code(const row_values& values, vec k, hn::Mask<D> seen,
                             std::uint32_t* words, std::uint32_t* normals) const {
        const word_tag dw;
        const word_vec z = hn::ShiftLeft<16>(rounded(number(values, 3, k)));
        const word_vec x = hn::And(rounded(number(values, 1, k)), hn::Set(dw, 0xffffu));
        const word_vec y = hn::ShiftLeft<16>(rounded(number(values, 2, k)));
        store_where(seen, hn::Or(z, material_), dw, words);
        store_where(seen, hn::Or(x, y), dw, normals);
    }

    HWY_INLINE word_vec word_at(const row_values& values, vec k) const {
        if constexpr (Kind == row_kind::word) {
            return word_;
        } else {
            return word_of(level_of_intensity(D(), intensity_at(values, k)));
        }
    }

    HWY_INLINE vec intensity_at(const row_values& values, vec k) const {
        if constexpr (Kind == row_kind::normal) {
            return light_.intensity(number(values, 1, k), number(values, 2, k),
                                    number(values, 3, k),
                                    hn::Gt(number(values, 4, k), hn::Zero(D())));
        } else {
            const vec value = number(values, 1, k);
            const vec least = hn::IfThenElse(hn::Gt(value, darkest_), value, darkest_);
            return hn::IfThenElse(hn::Lt(least, brightest_), least, brightest_);
        }
    }

    HWY_INLINE static word_vec rounded(vec number) {
        const D d;
        const vec sum = hn::Add(hn::Mul(number, hn::Set(d, normal_code::scale)),
                                hn::Set(d, normal_code::whole_numbers));
        return hn::BitCast(word_tag(), sum);
    }

    HWY_INLINE word_vec word_of(word_vec level) const {
        if (HWY_LIKELY(color_ == wide_polygon::white))
            return hn::Or(hn::Mul(level, unit_), material_);
        return hn::Or(hn::ShiftLeft<16>(product(color_ >> 16 & 255, level)),
                      hn::Or(hn::ShiftLeft<8>(product(color_ >> 8 & 255, level)),
                             product(color_ & 255, level)));
    }

    /// l3d_product_of_colors of a channel. A number n < 2^16 - 1 divided by 255 is
    /// (n + 1 + n / 256) / 256, both rounded down.
    HWY_INLINE static word_vec product(std::uint32_t channel, word_vec level) {
        const word_tag dw;
        const word_vec n = hn::Add(hn::Mul(hn::Set(dw, channel), level), hn::Set(dw, 127u));
        return hn::ShiftRight<8>(hn::Add(hn::Add(n, hn::Set(dw, 1u)), hn::ShiftRight<8>(n)));
    }

    vec farthest_, nearest_, step_[numbers + 1];
    std::int32_t last_fit_; ///< the last column where a vector fits the picture
    word_vec word_, material_, unit_;
    std::uint32_t color_;
    vec darkest_, brightest_; ///< intensities
    normal_light<D> light_;
};

/// Short rows leave fewer lanes idle in short vectors. Small polygons have no others, so the longer
/// vectors are not even made ready for them.
template <row_kind Kind>
HWY_INLINE std::int64_t fill_rows_of(const wide_polygon& of, std::span<const wide_row> rows) {
    using all = hn::CappedTag<float, 16>;
    using some = hn::CappedTag<float, 8>;
    const auto is_short = [](const wide_row& row) {
        return row.end - row.begin <= static_cast<std::int32_t>(hn::MaxLanes(some()));
    };
    const wide_filler<some, Kind> narrow(of);
    std::int64_t written = 0;
    bool any_long = false;
    for (const wide_row& row : rows)
        if (is_short(row))
            written += narrow.fill(row);
        else
            any_long = true;
    if (!any_long)
        return written;
    const wide_filler<all, Kind> wide(of);
    for (const wide_row& row : rows)
        if (!is_short(row))
            written += wide.fill(row);
    return written;
}

std::int64_t fill_wide_rows(const wide_polygon& of, std::span<const wide_row> rows) {
    switch (of.light.by) {
    case row_kind::word:
        return fill_rows_of<row_kind::word>(of, rows);
    case row_kind::held:
        return fill_rows_of<row_kind::held>(of, rows);
    case row_kind::normal:
        return fill_rows_of<row_kind::normal>(of, rows);
    default:
        return fill_rows_of<row_kind::code>(of, rows);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(fill_wide_rows);

std::int64_t fill_wide_rows(const wide_polygon& of, std::span<const wide_row> rows) {
    return L3D_SIMD_CALL(fill_wide_rows)(of, rows);
}

} // namespace l3d_detail
#endif
