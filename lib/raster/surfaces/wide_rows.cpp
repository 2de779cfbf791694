// SPDX-License-Identifier: MIT
// wide_rows: depth test, light and words of a vector of pixels.
#include "raster/surfaces/wide_rows_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/surfaces/wide_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_places-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/parallel/store_where-inl.h"
#include "raster/shaders/normal_code_p.h"
#include "raster/shaders/normal_light-inl.h"
#include "raster/surfaces/first_numbers-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using row_kind = row_light::kind;

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
template <class D, row_kind Kind, bool TestsDepth> class wide_filler {
public:
    static constexpr std::size_t numbers = 1 + numbers_of(Kind), first_used = TestsDepth ? 0 : 1;
    using starts = first_numbers<first_used, numbers>;

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

    /// Returns how many pixels were written.
    HWY_INLINE std::int64_t fill(const wide_runs& runs, const starts& first,
                                 std::size_t run) const {
        const band_row row(*this, runs, first, run);
        std::int64_t written = 0;
        for (std::int32_t x = runs.begin[run]; x < runs.end[run]; x += lanes)
            written += fill_vector(row, x);
        return written;
    }

    /// The same of a row that a vector holds.
    HWY_INLINE std::int64_t fill_short(const wide_runs& runs, const starts& first,
                                       std::size_t run) const {
        return fill_vector(band_row(*this, runs, first, run), runs.begin[run]);
    }

private:
    using vec = hn::Vec<D>;
    using int_tag = hn::RebindToSigned<D>;
    using word_tag = hn::RebindToUnsigned<D>;
    using word_vec = hn::Vec<word_tag>;
    static constexpr std::int32_t lanes = static_cast<std::int32_t>(hn::MaxLanes(D()));

    /// A row, where it is in the band, and its numbers at its start.
    struct band_row {
        std::uint32_t* words;
        float* depths;
        std::uint32_t* normals = nullptr;
        std::int32_t start, end;
        vec at[numbers];

        HWY_INLINE band_row(const wide_filler& by, const wide_runs& runs, const starts& first,
                            std::size_t run)
            : start(runs.start[run]), end(runs.end[run]) {
            const fill_band& band = by.band_;
            const std::ptrdiff_t row = runs.row[run] - band.top;
            words = band.words + row * band.word_pitch;
            depths = band.depths + row * band.depth_pitch;
            if constexpr (Kind == row_kind::code)
                normals = band.normals + row * band.depth_pitch;
            for (std::size_t i = first_used; i < numbers; ++i)
                at[i] = hn::Set(D(), first.of[i][run]);
        }
    };

    /// Fills from a column on. The last vector begins where it still fits the picture, and leaves
    /// what is done already.
    HWY_INLINE std::int64_t fill_vector(const band_row& row, std::int32_t x) const {
        const D d;
        const int_tag di;
        const std::int32_t at = std::min(x, last_fit_);
        const auto column = places_from(di, at);
        const vec k = hn::ConvertTo(d, hn::Sub(column, hn::Set(di, row.start)));
        auto seen = hn::RebindMask(
            d, hn::AndNot(hn::Lt(column, hn::Set(di, x)), hn::Lt(column, hn::Set(di, row.end))));
        if constexpr (TestsDepth) {
            const vec there = hn::LoadU(d, row.depths + at);
            const vec inv_w = hn::Min(hn::Max(number(row, 0, k), farthest_), nearest_);
            seen = hn::And(seen, hn::Gt(inv_w, there));
            if (hn::AllFalse(d, seen))
                return 0;
            hn::StoreU(hn::IfThenElse(seen, inv_w, there), d, row.depths + at);
        }
        if constexpr (Kind == row_kind::code)
            put_code(row, k, seen, row.words + at, row.normals + at);
        else
            store_where(seen, word_at(row, k), word_tag(), row.words + at);
        return static_cast<std::int64_t>(hn::CountTrue(d, seen));
    }

    HWY_INLINE vec number(const band_row& row, std::size_t i, vec k) const {
        return hn::Add(row.at[i], hn::Mul(step_[i], k));
    }

    HWY_INLINE void put_code(const band_row& row, vec k, hn::Mask<D> seen, std::uint32_t* words,
                             std::uint32_t* normals) const {
        const word_tag dw;
        const word_vec z = hn::ShiftLeft<16>(rounded(number(row, 3, k)));
        const word_vec x = hn::And(rounded(number(row, 1, k)), hn::Set(dw, 0xffffu));
        const word_vec y = hn::ShiftLeft<16>(rounded(number(row, 2, k)));
        store_where(seen, hn::Or(z, material_), dw, words);
        store_where(seen, hn::Or(x, y), dw, normals);
    }

    HWY_INLINE word_vec word_at(const band_row& row, vec k) const {
        if constexpr (Kind == row_kind::word) {
            return word_;
        } else {
            return word_of(level_of_intensity(D(), intensity_at(row, k)));
        }
    }

    HWY_INLINE vec intensity_at(const band_row& row, vec k) const {
        if constexpr (Kind == row_kind::normal) {
            return light_.intensity(number(row, 1, k), number(row, 2, k), number(row, 3, k),
                                    hn::Gt(number(row, 4, k), hn::Zero(D())));
        } else {
            const vec value = number(row, 1, k);
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
        return colored(word_tag(), color_, level);
    }

    const fill_band& band_;
    vec farthest_, nearest_, step_[numbers];
    std::int32_t last_fit_; ///< the last column where a vector fits the picture
    word_vec word_, material_, unit_;
    std::uint32_t color_;
    vec darkest_, brightest_; ///< intensities
    normal_light<D> light_;
};

/// Rows that a vector holds, and others. Rows of no columns are in neither list.
struct rows_by_length {
    std::array<std::uint32_t, wide_runs::room> short_ones, long_ones;
    std::size_t shorts, longs;

    HWY_INLINE rows_by_length(const wide_runs& runs, std::int32_t short_length) {
        std::size_t short_count = 0, long_count = 0; // in registers
        for (std::size_t i = 0; i < runs.count; ++i) {
            const std::int32_t length = runs.end[i] - runs.begin[i];
            short_ones[short_count] = long_ones[long_count] = static_cast<std::uint32_t>(i);
            short_count += length > 0 && length <= short_length;
            long_count += length > short_length;
        }
        shorts = short_count;
        longs = long_count;
    }
};

/// Short rows leave fewer lanes idle in short vectors. Small polygons have no others, so the longer
/// vectors are not even made ready for them.
template <row_kind Kind, bool TestsDepth>
HWY_INLINE std::int64_t fill_rows_of(const fill_band& band, const wide_polygon& of,
                                     const wide_runs& runs) {
    using all = hn::CappedTag<float, 16>;
    using some = hn::CappedTag<float, 8>;
    const rows_by_length rows(runs, static_cast<std::int32_t>(hn::MaxLanes(some())));
    const wide_filler<some, Kind, TestsDepth> narrow(band, of);
    const typename decltype(narrow)::starts first(of.planes, runs);
    std::int64_t written = 0;
    for (std::size_t i = 0; i < rows.shorts; ++i)
        written += narrow.fill_short(runs, first, rows.short_ones[i]);
    if (rows.longs == 0)
        return written;
    const wide_filler<all, Kind, TestsDepth> wide(band, of);
    for (std::size_t i = 0; i < rows.longs; ++i)
        written += wide.fill(runs, first, rows.long_ones[i]);
    return written;
}

template <bool TestsDepth>
HWY_INLINE std::int64_t fill_rows(const fill_band& band, const wide_polygon& of,
                                  const wide_runs& runs) {
    switch (of.light.by) {
    case row_kind::word:
        return fill_rows_of<row_kind::word, TestsDepth>(band, of, runs);
    case row_kind::held:
        return fill_rows_of<row_kind::held, TestsDepth>(band, of, runs);
    case row_kind::normal:
        return fill_rows_of<row_kind::normal, TestsDepth>(band, of, runs);
    default:
        return fill_rows_of<row_kind::code, TestsDepth>(band, of, runs);
    }
}

std::int64_t fill_wide_rows(const fill_band& band, const wide_polygon& of, const wide_runs& runs) {
    return band.depths == nullptr ? fill_rows<false>(band, of, runs)
                                  : fill_rows<true>(band, of, runs);
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
