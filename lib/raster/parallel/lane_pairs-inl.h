// SPDX-License-Identifier: MIT
// lane_pairs: gathers elements of an array together with those after them.
#if defined(L3D_RASTER_PARALLEL_LANE_PAIRS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_PARALLEL_LANE_PAIRS_INL_H
#undef L3D_RASTER_PARALLEL_LANE_PAIRS_INL_H
#else
#define L3D_RASTER_PARALLEL_LANE_PAIRS_INL_H
#endif

#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Gathers pairs of neighbours from an array of 32-bit elements: some elements, and the element
/// after each of these.
///
/// Cost: processors that gather take about as long for an element of 64 bits as for one of 32.
template <class D> struct lane_pairs {
    hn::Vec<D> first, second;

    HWY_INLINE lane_pairs(D d, const hn::TFromD<D>* from, hn::Vec<hn::RebindToSigned<D>> place) {
        static_assert(sizeof(hn::TFromD<D>) == sizeof(std::int32_t));
        constexpr hn::RebindToSigned<D> places;
#if HWY_TARGET <= HWY_AVX2
        constexpr hn::Repartition<std::int64_t, D> pairs;
        constexpr hn::Half<decltype(places)> half;
        const auto some = [&](hn::Vec<decltype(half)> of) HWY_ATTR {
            const auto bytes = hn::ShiftLeft<2>(hn::PromoteTo(pairs, of));
            return hn::BitCast(
                d, hn::GatherOffset(pairs, reinterpret_cast<const std::int64_t*>(from), bytes));
        };
        const auto lower = some(hn::LowerHalf(half, place));
        const auto upper = some(hn::UpperHalf(half, place));
        first = hn::ConcatEven(d, upper, lower);
        second = hn::ConcatOdd(d, upper, lower);
#else
        first = hn::GatherIndex(d, from, place);
        second = hn::GatherIndex(d, from, hn::Add(place, hn::Set(places, 1)));
#endif
    }
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
