// SPDX-License-Identifier: MIT
// first_numbers: the numbers of a polygon where its rows begin.
#if defined(L3D_RASTER_SURFACES_FIRST_NUMBERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FIRST_NUMBERS_INL_H
#undef L3D_RASTER_SURFACES_FIRST_NUMBERS_INL_H
#else
#define L3D_RASTER_SURFACES_FIRST_NUMBERS_INL_H
#endif

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/surfaces/wide_rows_p.h"

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// attribute_planes::at of the planes [First, Behind) at the starts of some rows, a row a lane,
/// operation by operation.
template <std::size_t First, std::size_t Behind> struct first_numbers {
    alignas(64) float of[Behind][wide_runs::room];

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
            for (std::size_t n = First; n < Behind; ++n) {
                const number value = same(planes.base[n]) + same(planes.along_x[n]) * x +
                                     same(planes.along_y[n]) * y;
                hn::Store(hn::DemoteTo(some_floats(), value.v), some_floats(), of[n] + i);
            }
        }
    }
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
