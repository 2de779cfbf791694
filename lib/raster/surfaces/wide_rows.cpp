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

#include <algorithm>
#include <cfloat>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using row_kind = row_light::kind;

/// Operation by operation what the shaders do, so that each pixel gets the same bits.
template <class D, row_kind Kind> class wide_filler {
public:
    HWY_INLINE explicit wide_filler(const wide_polygon& of) : of_(of) {}

    HWY_INLINE std::int64_t fill(const wide_row& row) const {
        return row.depths == nullptr ? fill_as<false>(row) : fill_as<true>(row);
    }

private:
    using vec = hn::Vec<D>;
    using int_tag = hn::RebindToSigned<D>;
    using word_tag = hn::RebindToUnsigned<D>;
    using word_vec = hn::Vec<word_tag>;
    static constexpr std::int32_t lanes = static_cast<std::int32_t>(hn::MaxLanes(D()));

    /// The last vector begins where it still fits the picture, and leaves what is done already.
    template <bool TestsDepth> HWY_INLINE std::int64_t fill_as(const wide_row& row) const {
        const D d;
        const int_tag di;
        const auto end = hn::Set(di, row.end), start = hn::Set(di, row.start);
        std::int64_t written = 0;
        for (std::int32_t x = row.begin; x < row.end; x += lanes) {
            const std::int32_t at = std::min(x, of_.width - lanes);
            const auto column = hn::Iota(di, at);
            const vec k = hn::ConvertTo(d, hn::Sub(column, start));
            auto seen =
                hn::RebindMask(d, hn::AndNot(hn::Lt(column, hn::Set(di, x)), hn::Lt(column, end)));
            if constexpr (TestsDepth) {
                float* const depths = row.depths + at;
                const vec there = hn::LoadU(d, depths);
                const vec inv_w = hn::Min(hn::Max(number(row, 0, k), hn::Set(d, of_.farthest)),
                                          hn::Set(d, of_.nearest));
                seen = hn::And(seen, hn::Gt(inv_w, there));
                if (hn::AllFalse(d, seen))
                    continue;
                hn::StoreU(hn::IfThenElse(seen, inv_w, there), d, depths);
            }
            put(row, at, k, seen);
            written += static_cast<std::int64_t>(hn::CountTrue(d, seen));
        }
        return written;
    }

    HWY_INLINE vec number(const wide_row& row, std::size_t i, vec k) const {
        const D d;
        return hn::Add(hn::Set(d, row.value[i]), hn::Mul(hn::Set(d, of_.step[i]), k));
    }

    HWY_INLINE void put(const wide_row& row, std::int32_t at, vec k, hn::Mask<D> seen) const {
        const D d;
        const word_tag dw;
        if constexpr (Kind == row_kind::code) {
            const word_vec z = hn::ShiftLeft<16>(rounded(number(row, 3, k)));
            const word_vec x = hn::And(rounded(number(row, 1, k)), hn::Set(dw, 0xffffu));
            const word_vec y = hn::ShiftLeft<16>(rounded(number(row, 2, k)));
            store_where(seen, hn::Or(z, hn::Set(dw, of_.material)), dw, row.words + at);
            store_where(seen, hn::Or(x, y), dw, row.normals + at);
        } else if constexpr (Kind == row_kind::word) {
            store_where(seen, hn::Set(dw, of_.light.word), dw, row.words + at);
        } else {
            vec intensity;
            if constexpr (Kind == row_kind::held) {
                const vec darkest = hn::Set(d, of_.light.darkest);
                const vec brightest = hn::Set(d, of_.light.brightest);
                const vec value = number(row, 1, k);
                const vec least = hn::IfThenElse(hn::Gt(value, darkest), value, darkest);
                intensity = hn::IfThenElse(hn::Lt(least, brightest), least, brightest);
            } else {
                intensity = intensity_of(row, k);
            }
            const vec level = hn::Add(hn::Mul(hn::Set(d, 255.0f), intensity), hn::Set(d, 0.5f));
            store_where(seen, word_of(hn::BitCast(dw, hn::ConvertTo(int_tag(), level))), dw,
                        row.words + at);
        }
    }

    HWY_INLINE static word_vec rounded(vec number) {
        const D d;
        const vec sum = hn::Add(hn::Mul(number, hn::Set(d, normal_code::scale)),
                                hn::Set(d, normal_code::whole_numbers));
        return hn::BitCast(word_tag(), sum);
    }

    /// That of lambert_shader.
    HWY_INLINE vec intensity_of(const wide_row& row, vec k) const {
        const D d;
        const auto& light = of_.light.light;
        const vec x = number(row, 1, k), y = number(row, 2, k), z = number(row, 3, k);
        const vec square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
        const vec least = hn::Set(d, FLT_MIN);
        const vec safe = hn::IfThenElse(hn::Gt(square, least), square, least);
        const vec product =
            hn::Add(hn::Add(hn::Mul(hn::Set(d, light[0]), x), hn::Mul(hn::Set(d, light[1]), y)),
                    hn::Mul(hn::Set(d, light[2]), z));
        const vec cosine = hn::Div(product, hn::Sqrt(safe));
        const vec zero = hn::Zero(d), one = hn::Set(d, 1.0f);
        const vec turned = hn::IfThenElse(hn::Gt(number(row, 4, k), zero), hn::Neg(cosine), cosine);
        const vec lit = hn::IfThenElse(hn::Gt(turned, zero), turned, zero);
        return hn::Add(hn::Set(d, 0.1f),
                       hn::Mul(hn::Set(d, 0.9f), hn::IfThenElse(hn::Lt(lit, one), lit, one)));
    }

    HWY_INLINE word_vec word_of(word_vec level) const {
        const word_tag dw;
        if (HWY_LIKELY(of_.color == wide_polygon::white))
            return hn::Or(hn::Mul(level, hn::Set(dw, of_.unit)), hn::Set(dw, of_.material));
        return hn::Or(hn::ShiftLeft<16>(product(of_.color >> 16 & 255, level)),
                      hn::Or(hn::ShiftLeft<8>(product(of_.color >> 8 & 255, level)),
                             product(of_.color & 255, level)));
    }

    /// l3d_product_of_colors of a channel. A number n < 2^16 - 1 divided by 255 is
    /// (n + 1 + n / 256) / 256, both rounded down.
    HWY_INLINE static word_vec product(std::uint32_t channel, word_vec level) {
        const word_tag dw;
        const word_vec n = hn::Add(hn::Mul(hn::Set(dw, channel), level), hn::Set(dw, 127u));
        return hn::ShiftRight<8>(hn::Add(hn::Add(n, hn::Set(dw, 1u)), hn::ShiftRight<8>(n)));
    }

    const wide_polygon& of_;
};

/// Short rows leave fewer lanes idle in short vectors.
template <row_kind Kind>
HWY_INLINE std::int64_t fill_rows_of(const wide_polygon& of, std::span<const wide_row> rows) {
    using all = hn::CappedTag<float, 16>;
    using some = hn::CappedTag<float, 8>;
    const wide_filler<all, Kind> wide(of);
    const wide_filler<some, Kind> narrow(of);
    std::int64_t written = 0;
    for (const wide_row& row : rows)
        written += row.end - row.begin <= static_cast<std::int32_t>(hn::MaxLanes(some()))
                       ? narrow.fill(row)
                       : wide.fill(row);
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
