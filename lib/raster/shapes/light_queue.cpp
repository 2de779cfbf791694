// SPDX-License-Identifier: MIT
// light_queue: normals row by row, light without gaps, words row by row.
#include "raster/shapes/light_queue_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shapes/light_queue.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_places-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/parallel/store_where-inl.h"
#include "raster/shaders/normal_light-inl.h"
#include "raster/surfaces/first_numbers-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Most rows are no longer than a vector of eight.
using row_floats = hn::CappedTag<float, 8>;
using row_integers = hn::RebindToSigned<row_floats>;
using row_words = hn::RebindToUnsigned<row_floats>;
constexpr auto row_lanes = static_cast<std::int32_t>(hn::MaxLanes(row_floats()));

HWY_INLINE void put_words(const unlit_pixels::part& of, const std::uint32_t* from) {
    const row_words d;
    for (std::int32_t i = 0; i < of.count; i += row_lanes) {
        hn::Vec<row_words> word = hn::LoadU(d, from + i);
        if (HWY_UNLIKELY(of.color != wide_polygon::white))
            word = colored(d, of.color, hn::And(word, hn::Set(d, 255u)));
        if (HWY_LIKELY(i + row_lanes <= of.fit)) {
            const auto wanted =
                hn::Lt(places_from(row_integers(), i), hn::Set(row_integers(), of.count));
            store_where(hn::RebindMask(row_floats(), wanted), word, d, of.to + i);
        } else {
            HWY_ALIGN std::uint32_t words[row_lanes];
            hn::Store(word, d, words);
            std::copy_n(words, std::min(of.count - i, row_lanes), of.to + i);
        }
    }
}

void light_all(unlit_pixels& waiting) {
    using all_floats = hn::CappedTag<float, unlit_pixels::widest_vector>;
    const all_floats d;
    const hn::RebindToUnsigned<all_floats> dw;
    using light = normal_light<all_floats>;
    for (std::size_t i = 0; i < waiting.count; i += hn::MaxLanes(d)) {
        const auto intensity = light::intensity(
            {hn::Load(d, waiting.square.data() + i), hn::Load(d, waiting.product.data() + i)});
        hn::Store(hn::Mul(level_of_intensity(d, intensity), hn::Set(dw, 0x010101u)), dw,
                  waiting.word.data() + i);
    }
    const std::uint32_t* from = waiting.word.data();
    for (std::size_t i = 0; i < waiting.part_count; ++i) {
        put_words(waiting.parts[i], from);
        from += waiting.parts[i].count;
    }
    waiting.count = waiting.part_count = 0;
}

/// The normals of a polygon, row by row.
class normal_rows {
public:
    HWY_INLINE explicit normal_rows(const wide_polygon& of) : light_(of.light.light) {
        for (std::size_t i = 1; i < numbers; ++i)
            step_[i] =
                hn::Set(row_floats(), static_cast<float>(of.planes.along_x[i] * l3d_subpixel_one));
    }

    static constexpr std::size_t numbers = 5; ///< inv_w, a normal, and how far it points away
    using starts = first_numbers<1, numbers>;

    /// Puts `count` pixels, from so many columns behind a row's start on.
    HWY_INLINE void put(const starts& first, std::size_t run, std::int32_t behind,
                        std::int32_t count, float* squares, float* products) const {
        const row_floats d;
        for (std::int32_t i = 0; i < count; i += row_lanes) {
            const auto k = hn::ConvertTo(d, places_from(row_integers(), behind + i));
            const auto at = [&](std::size_t n) HWY_ATTR {
                return hn::Add(hn::Set(d, first.of[n][run]), hn::Mul(step_[n], k));
            };
            const auto both = light_.squares_of(at(1), at(2), at(3), hn::Gt(at(4), hn::Zero(d)));
            hn::StoreU(both.square, d, squares + i);
            hn::StoreU(both.product, d, products + i);
        }
    }

private:
    hn::Vec<row_floats> step_[numbers];
    normal_light<row_floats> light_;
};

std::int64_t queue_rows(const fill_band& band, const wide_polygon& of, const wide_runs& runs,
                        unlit_pixels& waiting) {
    const normal_rows normals(of);
    const normal_rows::starts first(of.planes, runs);
    std::int64_t painted = 0;
    for (std::size_t run = 0; run < runs.count; ++run) {
        const std::int32_t end = runs.end[run];
        std::uint32_t* const words = band.words + (runs.row[run] - band.top) * band.word_pitch;
        std::int32_t count = 0;
        for (std::int32_t x = runs.begin[run]; x < end; x += count) {
            count = std::min(end - x, unlit_pixels::longest_part);
            if (waiting.count + static_cast<std::size_t>(count) > unlit_pixels::room ||
                waiting.part_count == unlit_pixels::most_parts)
                light_all(waiting);
            normals.put(first, run, x - runs.start[run], count,
                        waiting.square.data() + waiting.count,
                        waiting.product.data() + waiting.count);
            waiting.parts[waiting.part_count++] = {words + x, count, band.width - x, of.color};
            waiting.count += static_cast<std::size_t>(count);
            painted += count;
        }
    }
    return painted;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(light_all);
L3D_SIMD_TABLE(queue_rows);

std::int64_t light_queue::add(const fill_band& band, const wide_polygon& of,
                              const wide_runs& runs) {
    return L3D_SIMD_CALL(queue_rows)(band, of, runs, waiting_);
}

void light_queue::finish() {
    L3D_SIMD_CALL(light_all)(waiting_);
}

} // namespace l3d_detail
#endif
