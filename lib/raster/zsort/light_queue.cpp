// SPDX-License-Identifier: MIT
// light_queue: normals row by row, light without gaps, words row by row.
#include "raster/zsort/light_queue_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/zsort/light_queue.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_places-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/parallel/store_where-inl.h"
#include "raster/shapes/attribute_plane_p.h"
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

/// attribute_planes of a triangle's normals, all numbers at a time, operation by operation.
class normal_planes {
public:
    HWY_INLINE explicit normal_planes(const unlit_triangle& of)
        : base_x_(of.corners[0].x), base_y_(of.corners[0].y) {
        using doubles = hn::CappedTag<double, unlit_triangle::numbers>;
        using floats = hn::Rebind<float, doubles>;
        const doubles d;
        const scan_point d1 = of.corners[1] - of.corners[0], d2 = of.corners[2] - of.corners[0];
        const double scale = 1.0 / static_cast<double>(cross(d1, d2));
        const auto x1 = hn::Set(d, d1.x * scale), y1 = hn::Set(d, d1.y * scale);
        const auto x2 = hn::Set(d, d2.x * scale), y2 = hn::Set(d, d2.y * scale);
        for (std::size_t i = 0; i < unlit_triangle::numbers; i += hn::MaxLanes(d)) {
            const auto at = [&](std::size_t corner) HWY_ATTR {
                return hn::PromoteTo(d, hn::Load(floats(), of.normals[corner].data() + i));
            };
            const auto base = at(0), first = hn::Sub(at(1), base), second = hn::Sub(at(2), base);
            hn::Store(base, d, base_ + i);
            hn::Store(hn::Sub(hn::Mul(first, y2), hn::Mul(second, y1)), d, along_x_ + i);
            hn::Store(hn::Sub(hn::Mul(second, x1), hn::Mul(first, x2)), d, along_y_ + i);
        }
    }

    HWY_INLINE plane_view view() const { return {base_x_, base_y_, base_, along_x_, along_y_}; }
    HWY_INLINE float per_column(std::size_t i) const {
        return static_cast<float>(along_x_[i] * l3d_subpixel_one);
    }

private:
    double base_x_, base_y_;
    HWY_ALIGN double base_[unlit_triangle::numbers], along_x_[unlit_triangle::numbers],
        along_y_[unlit_triangle::numbers];
};

/// The normals of a triangle, row by row.
class normal_rows {
public:
    HWY_INLINE normal_rows(const normal_planes& planes, const std::array<float, 3>& light)
        : light_(light) {
        for (std::size_t i = 0; i < unlit_triangle::numbers; ++i)
            step_[i] = hn::Set(row_floats(), planes.per_column(i));
    }

    using starts = first_numbers<0, unlit_triangle::numbers>;

    /// Puts `count` pixels, from so many columns behind a row's start on.
    HWY_INLINE void put(const starts& first, std::size_t run, std::int32_t behind,
                        std::int32_t count, float* squares, float* products) const {
        const row_floats d;
        for (std::int32_t i = 0; i < count; i += row_lanes) {
            const auto k = hn::ConvertTo(d, places_from(row_integers(), behind + i));
            const auto at = [&](std::size_t n) HWY_ATTR {
                return hn::Add(hn::Set(d, first.of[n][run]), hn::Mul(step_[n], k));
            };
            const auto both = light_.squares_of(at(0), at(1), at(2), hn::Gt(at(3), hn::Zero(d)));
            hn::StoreU(both.square, d, squares + i);
            hn::StoreU(both.product, d, products + i);
        }
    }

private:
    hn::Vec<row_floats> step_[unlit_triangle::numbers];
    normal_light<row_floats> light_;
};

std::int64_t queue_rows(const fill_band& band, const unlit_triangle& of, const wide_runs& runs,
                        unlit_pixels& waiting) {
    const normal_planes planes(of);
    const normal_rows normals(planes, of.light);
    const normal_rows::starts first(planes.view(), runs);
    std::size_t waiting_count = waiting.count, part_count = waiting.part_count; // in registers
    std::int64_t painted = 0;
    for (std::size_t run = 0; run < runs.count; ++run) {
        const std::int32_t end = runs.end[run];
        std::uint32_t* const words = band.words + (runs.row[run] - band.top) * band.word_pitch;
        std::int32_t count = 0;
        for (std::int32_t x = runs.begin[run]; x < end; x += count) {
            count = std::min(end - x, unlit_pixels::longest_part);
            if (HWY_UNLIKELY(waiting_count + static_cast<std::size_t>(count) > unlit_pixels::room ||
                             part_count == unlit_pixels::most_parts)) {
                waiting.count = waiting_count;
                waiting.part_count = part_count;
                light_all(waiting);
                waiting_count = part_count = 0;
            }
            normals.put(first, run, x - runs.start[run], count,
                        waiting.square.data() + waiting_count,
                        waiting.product.data() + waiting_count);
            waiting.parts[part_count++] = {words + x, count, band.width - x, of.color};
            waiting_count += static_cast<std::size_t>(count);
            painted += count;
        }
    }
    waiting.count = waiting_count;
    waiting.part_count = part_count;
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

std::int64_t light_queue::add(const fill_band& band, const unlit_triangle& of,
                              const wide_runs& runs) {
    return L3D_SIMD_CALL(queue_rows)(band, of, runs, waiting_);
}

void light_queue::finish() {
    L3D_SIMD_CALL(light_all)(waiting_);
}

} // namespace l3d_detail
#endif
