// SPDX-License-Identifier: MIT
// area_values: turns winding numbers into values, for every instruction set that the processor may
// have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/paths/area_values.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/paths/area_values_p.h"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

void find_values_in_lanes(const double* sums, std::size_t count, bool is_nonzero, double full,
                          std::uint8_t* values) {
    const eight_doubles d;
    const hn::Rebind<std::int32_t, eight_doubles> di;
    const hn::Rebind<std::uint8_t, eight_doubles> db;
    for (std::size_t i = 0; i < count; i += lanes_at_once()) {
        const number sum = {hn::LoadU(d, sums + i)};
        const number area = is_nonzero
                                ? number{hn::Min(magnitude(sum).v, hn::Set(d, 1))}
                                : magnitude(sum - same(2) * number{hn::Round((sum * same(0.5)).v)});
        const auto level = hn::DemoteTo(di, (area * same(full) + same(0.5)).v);
        hn::StoreU(hn::DemoteTo(db, level), db, values + i);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(find_values_in_lanes);

void find_values(const double* sums, std::size_t count, bool is_nonzero, double full,
                 std::uint8_t* values) {
    L3D_SIMD_CALL(find_values_in_lanes)(sums, count, is_nonzero, full, values);
}

} // namespace l3d_detail
#endif
