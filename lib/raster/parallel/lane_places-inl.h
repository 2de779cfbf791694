// SPDX-License-Identifier: MIT
// lane_places: makes vectors of consecutive numbers.
#if defined(L3D_RASTER_PARALLEL_LANE_PLACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_PARALLEL_LANE_PLACES_INL_H
#undef L3D_RASTER_PARALLEL_LANE_PLACES_INL_H
#else
#define L3D_RASTER_PARALLEL_LANE_PLACES_INL_H
#endif

#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

alignas(64) constexpr std::int32_t places_of_lanes[16] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                          8, 9, 10, 11, 12, 13, 14, 15};

/// The numbers first, first + 1, first + 2 ... in at most sixteen lanes. Highway's Iota would write
/// each number to memory, and then wait for all of them.
template <class D> HWY_INLINE hn::Vec<D> places_from(D d, std::int32_t first) {
    return hn::Add(hn::Load(d, places_of_lanes), hn::Set(d, first));
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
