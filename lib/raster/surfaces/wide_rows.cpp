// SPDX-License-Identifier: MIT
// wide_rows: tests the depth of a vector of pixels, and finds their light and words.
#include "raster/surfaces/wide_rows_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/surfaces/wide_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/lane_places-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/parallel/store_where-inl.h"
#include "raster/shaders/normal_code_p.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using row_kind = row_light::kind;

/// The number of values that are interpolated beside inv_w.
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

/// Values of planes at the starts of rows, with a row in each lane. The operations are those of
/// attribute_planes::at.
template <std::size_t Count> struct first_numbers {
    alignas(64) float of[Count][wide_runs::room];

    HWY_INLINE first_numbers(const plane_view& planes, const wide_runs& runs) {
        using some_floats = hn::Rebind<float, eight_doubles>;
        using some_integers = hn::Rebind<std::int32_t, eight_doubles>;
        const auto from_base = [](const std::int32_t* index, double base) HWY_ATTR {
            const number whole{hn::PromoteTo(eight_doubles(), hn::Load(some_integers(), index))};
            return same(l3d_subpixel_one) * (whole + same(0.5)) - same(base);
        };
        for (std::size_t i = 0; i < runs.count; i += lanes_at_once()) {
            const number x = from_base(runs.start.data() + i, planes.base_x);
            const number y = from_base(runs.row.data() + i, planes.base_y);
            for (std::size_t n = 0; n < Count; ++n) {
                const number value = same(planes.base[n]) + same(planes.along_x[n]) * x +
                                     same(planes.along_y[n]) * y;
                hn::Store(hn::DemoteTo(some_floats(), value.v), some_floats(), of[n] + i);
            }
        }
    }
};

/// The level of an intensity from 0 to 1: round(255 intensity).
template <class D>
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> level_of_intensity(D d, hn::Vec<D> intensity) {
    const auto level = hn::Add(hn::Mul(hn::Set(d, 255.0f), intensity), hn::Set(d, 0.5f));
    return hn::BitCast(hn::RebindToUnsigned<D>(), hn::ConvertTo(hn::RebindToSigned<D>(), level));
}

/// Light by the operations of lambert_shader, so that each pixel gets the same bits. The shader
/// changes the sign of a cosine, and this class the sign of a product, which gives the same
/// numbers.
template <class D> class normal_light {
public:
    using vec = hn::Vec<D>;

    HWY_INLINE explicit normal_light(const std::array<float, 3>& light) {
        for (std::size_t i = 0; i < light.size(); ++i)
            light_[i] = hn::Set(D(), light[i]);
    }

    /// The intensity of light for normals. Normals that point `away` from the eye are turned to it.
    HWY_INLINE vec intensity(vec x, vec y, vec z, hn::Mask<D> away) const {
        const D d;
        const vec square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
        const vec product =
            hn::Add(hn::Add(hn::Mul(light_[0], x), hn::Mul(light_[1], y)), hn::Mul(light_[2], z));
        const vec turned = hn::IfThenElse(away, hn::Neg(product), product);
        const vec least = hn::Set(d, FLT_MIN);
        const vec safe = hn::IfThenElse(hn::Gt(square, least), square, least);
        const vec cosine = hn::Div(turned, hn::Sqrt(safe));
        const vec zero = hn::Zero(d), one = hn::Set(d, 1.0f);
        const vec lit = hn::IfThenElse(hn::Gt(cosine, zero), cosine, zero);
        return hn::Add(hn::Set(d, 0.1f),
                       hn::Mul(hn::Set(d, 0.9f), hn::IfThenElse(hn::Lt(lit, one), lit, one)));
    }

private:
    vec light_[3];
};

/// Fills rows by the operations of the shaders, so that each pixel gets the same bits.
template <class D, row_kind Kind> class wide_filler {
public:
    static constexpr std::size_t numbers = 1 + numbers_of(Kind);
    using starts = first_numbers<numbers>;

    HWY_INLINE wide_filler(const fill_band& band, const wide_polygon& of)
        : band_(band), farthest_(hn::Set(D(), of.farthest)), nearest_(hn::Set(D(), of.nearest)),
          last_fit_(band.width - lanes), material_(hn::Set(word_tag(), of.material)),
          unit_(hn::Set(word_tag(), of.unit)), darkest_(hn::Set(D(), of.light.darkest)),
          brightest_(hn::Set(D(), of.light.brightest)), light_(of.light.light) {
        for (std::size_t i = 0; i < numbers; ++i)
            step_[i] = hn::Set(D(), static_cast<float>(of.planes.along_x[i] * l3d_subpixel_one));
        word_ = hn::Set(word_tag(), of.light.word);
    }

    /// Fills a row. Returns how many pixels were written.
    HWY_INLINE std::int64_t fill(const wide_runs& runs, const starts& first,
                                 std::size_t run) const {
        const band_row row(*this, runs, first, run);
        std::int64_t written = 0;
        for (std::int32_t x = runs.begin[run]; x < runs.end[run]; x += lanes)
            written += fill_vector(row, x);
        return written;
    }

    /// Fills a row that fits into one vector. Returns how many pixels were written.
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

    /// A row's place in the band, and its interpolated numbers at its start.
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
            for (std::size_t i = 0; i < numbers; ++i)
                at[i] = hn::Set(D(), first.of[i][run]);
        }
    };

    /// Fills one vector of pixels from column x on. The row's last vector begins where it still
    /// fits into the picture, and does not write the pixels before x.
    HWY_INLINE std::int64_t fill_vector(const band_row& row, std::int32_t x) const {
        const D d;
        const int_tag di;
        const std::int32_t at = std::min(x, last_fit_);
        const auto column = places_from(di, at);
        const vec k = hn::ConvertTo(d, hn::Sub(column, hn::Set(di, row.start)));
        auto seen = hn::RebindMask(
            d, hn::AndNot(hn::Lt(column, hn::Set(di, x)), hn::Lt(column, hn::Set(di, row.end))));
        const vec there = hn::LoadU(d, row.depths + at);
        const vec inv_w = hn::Min(hn::Max(number(row, 0, k), farthest_), nearest_);
        seen = hn::And(seen, hn::Gt(inv_w, there));
        if (hn::AllFalse(d, seen))
            return 0;
        hn::StoreU(hn::IfThenElse(seen, inv_w, there), d, row.depths + at);
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
        return hn::Or(hn::Mul(level, unit_), material_);
    }

    const fill_band& band_;
    vec farthest_, nearest_, step_[numbers];
    /// The last column at which a vector of pixels can begin within the picture.
    std::int32_t last_fit_;
    word_vec word_, material_, unit_;
    vec darkest_, brightest_; ///< the least and the largest intensity
    normal_light<D> light_;
};

/// The rows of a polygon that fit into a short vector, and its longer rows. Rows without columns
/// are in neither list.
struct rows_by_length {
    std::array<std::uint32_t, wide_runs::room> short_ones, long_ones;
    std::size_t shorts, longs;

    HWY_INLINE rows_by_length(const wide_runs& runs, std::int32_t short_length) {
        std::size_t short_count = 0, long_count = 0; // local, so that they stay in registers
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

/// Fills short rows by short vectors, which have fewer idle lanes. Small polygons have only short
/// rows, so longer vectors are not made ready for them.
template <row_kind Kind>
HWY_INLINE std::int64_t fill_rows_of(const fill_band& band, const wide_polygon& of,
                                     const wide_runs& runs) {
    using all = hn::CappedTag<float, 16>;
    using some = hn::CappedTag<float, 8>;
    const rows_by_length rows(runs, static_cast<std::int32_t>(hn::MaxLanes(some())));
    const wide_filler<some, Kind> narrow(band, of);
    const typename decltype(narrow)::starts first(of.planes, runs);
    std::int64_t written = 0;
    for (std::size_t i = 0; i < rows.shorts; ++i)
        written += narrow.fill_short(runs, first, rows.short_ones[i]);
    if (rows.longs == 0)
        return written;
    const wide_filler<all, Kind> wide(band, of);
    for (std::size_t i = 0; i < rows.longs; ++i)
        written += wide.fill(runs, first, rows.long_ones[i]);
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
