// SPDX-License-Identifier: MIT
// fill_hidden: finds polygons of a queue that are hidden all over their boxes.
#if defined(L3D_RASTER_SURFACES_FILL_HIDDEN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_HIDDEN_INL_H
#undef L3D_RASTER_SURFACES_FILL_HIDDEN_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_HIDDEN_INL_H
#endif

#include "raster/surfaces/fill_setup-inl.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Whether the depths of all pixels in a box are at least as near as `nearest`, an inv_w.
/// Expects: a box that is not empty; `depths` points at its first pixel. Depths are read in runs of
///          16 from the box's left border, and the last run lies inside the picture, too.
HWY_INLINE bool all_nearer(const float* depths, std::ptrdiff_t pitch, std::int32_t columns,
                           std::int32_t rows, float nearest) {
    constexpr hn::CappedTag<float, run / 2> d;
    constexpr hn::RebindToSigned<decltype(d)> di;
    constexpr std::size_t width = hn::MaxLanes(d), vectors = run / width;
    for (; columns > 0; columns -= run, depths += run) {
        hn::Vec<decltype(d)> farthest[vectors];
        for (std::size_t v = 0; v < vectors; ++v)
            farthest[v] = hn::LoadU(d, depths + v * width);
        const float* at = depths;
        for (std::int32_t row = 1; row < rows; ++row) {
            at += pitch;
            for (std::size_t v = 0; v < vectors; ++v)
                farthest[v] = hn::Min(farthest[v], hn::LoadU(d, at + v * width));
        }
        auto seen = hn::FirstN(d, 0);
        for (std::size_t v = 0; v < vectors; ++v) {
            const auto column = hn::Load(di, run_columns + v * width);
            const auto inside = hn::RebindMask(d, hn::Lt(column, hn::Set(di, columns)));
            seen = hn::Or(seen, hn::And(inside, hn::Lt(farthest[v], hn::Set(d, nearest))));
        }
        if (!hn::AllFalse(d, seen))
            return false;
    }
    return true;
}

/// Finds which of a vector of polygons are hidden, since everything drawn in their boxes is nearer.
/// Polygons at the right edge of the picture, where a run does not fit, are not tested.
class hidden_lanes {
public:
    /// Finds the boxes of the polygons.
    /// Expects: room for a vector of polygons in the queue from `at` on, the first `valid` in use.
    HWY_INLINE hidden_lanes(const fill_band& band, const fill_queue& queue, std::size_t at,
                            std::size_t valid)
        : band_(band) {
        const lane_corners corners(queue, at);
        const int_vec left = hn::Max(first_centre_of(ints(), corners.left), set(0));
        const int_vec top = hn::Max(first_centre_of(ints(), corners.top), set(band.top));
        const int_vec right = hn::Min(first_centre_of(ints(), corners.right), set(band.width));
        const int_vec bottom = hn::Min(first_centre_of(ints(), corners.bottom), set(band.bottom));
        columns_ = hn::Sub(right, left);
        rows_ = hn::Sub(bottom, top);
        first_ = hn::Add(left, hn::Mul(hn::Sub(top, set(band.top)), set(pitch())));
        float_vec inv_w[4];
        for (std::size_t i = 0; i < 4; ++i)
            inv_w[i] = load_float(queue.corner[i][2] + at);
        nearest_ = most_of(inv_w);
        const int_mask fits = hn::Lt(right, set(band.width - run + 2));
        const int_mask filled = hn::And(hn::Gt(columns_, set(0)), hn::Gt(rows_, set(0)));
        asked_ = hn::And(hn::FirstN(ints(), valid), hn::And(fits, filled));
    }

    /// Sets the elements of `seen` to 0 whose polygons are hidden. For most polygons, the depth in
    /// the middle of the box shows that they are not hidden. All other polygons are tested one by
    /// one.
    HWY_INLINE void clear(std::int32_t* seen) const {
        const int_vec middle = hn::Add(hn::Add(first_, hn::ShiftRight<1>(columns_)),
                                       hn::Mul(hn::ShiftRight<1>(rows_), set(pitch())));
        const float_vec there =
            hn::GatherIndex(floats(), band_.depths, hn::IfThenElseZero(asked_, middle));
        const int_mask asked = hn::AndNot(mask_of(hn::Lt(there, nearest_)), asked_);
        std::uint64_t left = bits_of(asked);
        if (left == 0)
            return;
        lane_array<std::int32_t> first, columns, rows;
        lane_array<float> nearest;
        hn::Store(first_, ints(), first.of);
        hn::Store(columns_, ints(), columns.of);
        hn::Store(rows_, ints(), rows.of);
        hn::Store(nearest_, floats(), nearest.of);
        for (; left != 0; left &= left - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(left));
            if (all_nearer(band_.depths + first[i], band_.depth_pitch, columns[i], rows[i],
                           nearest[i]))
                seen[i] = 0;
        }
    }

private:
    HWY_INLINE std::int32_t pitch() const { return static_cast<std::int32_t>(band_.depth_pitch); }

    const fill_band& band_;
    /// Each polygon's box: the index of its first pixel in the band's depths, and its size.
    int_vec first_, columns_, rows_;
    float_vec nearest_; ///< upper bound of inv_w in the polygon's pixels
    int_mask asked_;
};

/// Sets the elements of `seen` to 0 for hidden polygons among the first `count` of a queue.
HWY_INLINE void clear_hidden(const fill_band& band, fill_queue& queue, std::size_t count) {
    for (std::size_t at = 0; at < count; at += lanes)
        hidden_lanes(band, queue, at, std::min(lanes, count - at)).clear(queue.seen + at);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
