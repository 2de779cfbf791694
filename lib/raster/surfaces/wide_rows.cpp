// SPDX-License-Identifier: MIT
// wide_rows: depth test, light and words of a vector of pixels.
#include "raster/surfaces/wide_rows_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/surfaces/wide_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
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

/// The numbers of a polygon where its rows begin, of some rows side by side: attribute_planes::at,
/// operation by operation.
template <std::size_t Count> struct first_numbers {
    alignas(64) float of[Count][wide_runs::room]; ///< inv_w only with a depth buffer

    HWY_INLINE first_numbers(const plane_view& planes, const wide_runs& runs, bool with_depth) {
        using some_floats = hn::Rebind<float, eight_doubles>;
        using some_integers = hn::Rebind<std::int32_t, eight_doubles>;
        const auto from_base = [](const std::int32_t* index, double base) HWY_ATTR {
            const number whole{hn::PromoteTo(eight_doubles(), hn::Load(some_integers(), index))};
            return same(l3d_subpixel_one) * (whole + same(0.5)) - same(base);
        };
        for (std::size_t i = 0; i < runs.count; i += lanes_at_once()) {
            const number x = from_base(runs.start.data() + i, planes.base_x);
            const number y = from_base(runs.row.data() + i, planes.base_y);
            for (std::size_t n = with_depth ? 0 : 1; n < Count; ++n) {
                const number value = same(planes.base[n]) + same(planes.along_x[n]) * x +
                                     same(planes.along_y[n]) * y;
                hn::Store(hn::DemoteTo(some_floats(), value.v), some_floats(), of[n] + i);
            }
        }
    }
};

/// Operation by operation what the shaders do, so that each pixel gets the same bits.
template <class D, row_kind Kind> class wide_filler {
public:
    static constexpr std::size_t numbers = 1 + numbers_of(Kind);

    HWY_INLINE wide_filler(const fill_band& band, const wide_polygon& of)
        : band_(band), farthest_(hn::Set(D(), of.farthest)), nearest_(hn::Set(D(), of.nearest)),
          last_fit_(band.width - lanes), material_(hn::Set(word_tag(), of.material)),
          unit_(hn::Set(word_tag(), of.unit)), color_(of.color),
          darkest_(hn::Set(D(), of.light.darkest)), brightest_(hn::Set(D(), of.light.brightest)),
          light_(of.light.light) {
        for (std::size_t i = 0; i < numbers; ++i)
            step_[i] = hn::Set(D(), static_cast<float>(of.planes.along_x[i] * l3d_subpixel_one));
        word_ = hn::Set(word_tag(), of.light.word);
    }

    HWY_INLINE std::int64_t fill(const wide_runs& runs, const first_numbers<numbers>& first,
                                 std::size_t run) const {
        return band_.depths == nullptr ? fill_as<false>(runs, first, run)
                                       : fill_as<true>(runs, first, run);
    }

private:
    using vec = hn::Vec<D>;
    using int_tag = hn::RebindToSigned<D>;
    using word_tag = hn::RebindToUnsigned<D>;
    using word_vec = hn::Vec<word_tag>;
    static constexpr std::int32_t lanes = static_cast<std::int32_t>(hn::MaxLanes(D()));

    /// The numbers of a row at its start.
    struct row_values {
        vec at[numbers];
    };

    /// The last vector begins where it still fits the picture, and leaves what is done already.
    template <bool TestsDepth>
    HWY_INLINE std::int64_t fill_as(const wide_runs& runs, const first_numbers<numbers>& first,
                                    std::size_t run) const {
        const D d;
        const int_tag di;
        row_values values;
        for (std::size_t i = TestsDepth ? 0 : 1; i < numbers; ++i)
            values.at[i] = hn::Set(d, first.of[i][run]);
        const std::ptrdiff_t row = runs.row[run] - band_.top;
        std::uint32_t* const words = band_.words + row * band_.word_pitch;
        float* const depths = band_.depths + row * band_.depth_pitch;
        std::uint32_t* const normals = band_.normals + row * band_.depth_pitch;
        const std::int32_t last = runs.end[run];
        const auto end = hn::Set(di, last), start = hn::Set(di, runs.start[run]);
        std::int64_t written = 0;
        for (std::int32_t x = runs.begin[run]; x < last; x += lanes) {
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

    const fill_band& band_;
    vec farthest_, nearest_, step_[numbers];
    std::int32_t last_fit_; ///< the last column where a vector fits the picture
    word_vec word_, material_, unit_;
    std::uint32_t color_;
    vec darkest_, brightest_; ///< intensities
    normal_light<D> light_;
};

/// Short rows leave fewer lanes idle in short vectors. Small polygons have no others, so the longer
/// vectors are not even made ready for them.
template <row_kind Kind>
HWY_INLINE std::int64_t fill_rows_of(const fill_band& band, const wide_polygon& of,
                                     const wide_runs& runs) {
    using all = hn::CappedTag<float, 16>;
    using some = hn::CappedTag<float, 8>;
    const auto is_short = [&](std::size_t run) {
        return runs.end[run] - runs.begin[run] <= static_cast<std::int32_t>(hn::MaxLanes(some()));
    };
    const wide_filler<some, Kind> narrow(band, of);
    const first_numbers<narrow.numbers> first(of.planes, runs, band.depths != nullptr);
    std::int64_t written = 0;
    bool any_long = false;
    for (std::size_t run = 0; run < runs.count; ++run)
        if (is_short(run))
            written += narrow.fill(runs, first, run);
        else
            any_long = true;
    if (!any_long)
        return written;
    const wide_filler<all, Kind> wide(band, of);
    for (std::size_t run = 0; run < runs.count; ++run)
        if (!is_short(run))
            written += wide.fill(runs, first, run);
    return written;
}

std::int64_t fill_wide_rows(const fill_band& band, const wide_polygon& of, const wide_runs& runs) {
    switch (of.light.by) {
    case row_kind::word:
        return fill_rows_of<row_kind::word>(band, of, runs);
    case row_kind::held:
        return fill_rows_of<row_kind::held>(band, of, runs);
    case row_kind::normal:
        return fill_rows_of<row_kind::normal>(band, of, runs);
    default:
        return fill_rows_of<row_kind::code>(band, of, runs);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(fill_wide_rows);

std::int64_t fill_wide_rows(const fill_band& band, const wide_polygon& of, const wide_runs& runs) {
    return L3D_SIMD_CALL(fill_wide_rows)(band, of, runs);
}

} // namespace l3d_detail
#endif
