// SPDX-License-Identifier: MIT
// store_where: stores some lanes of a vector.
#if defined(L3D_RASTER_PARALLEL_STORE_WHERE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_PARALLEL_STORE_WHERE_INL_H
#undef L3D_RASTER_PARALLEL_STORE_WHERE_INL_H
#else
#define L3D_RASTER_PARALLEL_STORE_WHERE_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Whether storing some lanes costs no more than storing all, on every processor with these
/// instructions. SSE has no masked store, and AVX2's takes 18 or more micro-operations on AMD's
/// processors.
#if HWY_TARGET <= HWY_AVX3
constexpr bool masked_stores_are_cheap = true;
#else
constexpr bool masked_stores_are_cheap = false;
#endif

/// Stores the lanes of a vector that are in `mask`. The memory of other lanes may be read and
/// written back.
template <class D>
HWY_INLINE void store_where(hn::Mask<hn::RebindToFloat<D>> mask, hn::Vec<D> value, D d,
                            hn::TFromD<D>* to) {
    if constexpr (masked_stores_are_cheap) {
        hn::BlendedStore(value, hn::RebindMask(d, mask), d, to);
    } else {
        // Selects as floats: for integers, g++ 12 puts a comparison before the selection.
        const hn::RebindToFloat<D> df;
        const auto there = hn::BitCast(df, hn::LoadU(d, to));
        hn::StoreU(hn::BitCast(d, hn::IfThenElse(mask, hn::BitCast(df, value), there)), d, to);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
