// SPDX-License-Identifier: MIT
// Holds whole numbers of 32 bits in lanes, at most sixteen, and floats beside them.
#if defined(L3D_RASTER_PARALLEL_LANE_INTEGERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_PARALLEL_LANE_INTEGERS_INL_H
#undef L3D_RASTER_PARALLEL_LANE_INTEGERS_INL_H
#else
#define L3D_RASTER_PARALLEL_LANE_INTEGERS_INL_H
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using ints = hn::CappedTag<std::int32_t, 16>;
using floats = hn::RebindToFloat<ints>;
using int_vec = hn::Vec<ints>;
using float_vec = hn::Vec<floats>;
using int_mask = hn::Mask<ints>;
constexpr std::size_t lanes = hn::MaxLanes(ints());

HWY_ATTR HWY_INLINE int_vec set(std::int32_t value) {
    return hn::Set(ints(), value);
}

HWY_ATTR HWY_INLINE float_vec set(float value) {
    return hn::Set(floats(), value);
}

/// Loads numbers from `at` on. Lanes after the last number are undefined.
HWY_ATTR HWY_INLINE int_vec load_from(std::span<const std::int32_t> of, std::size_t at) {
    if (HWY_LIKELY(at + lanes <= of.size()))
        return hn::LoadU(ints(), of.data() + at);
    std::int32_t copy[lanes] = {};
    std::copy(of.begin() + static_cast<std::ptrdiff_t>(std::min(at, of.size())), of.end(), copy);
    return hn::LoadU(ints(), copy);
}

/// A mask of lanes from bits: lane i is set if bit i is 1.
HWY_ATTR HWY_INLINE int_mask lanes_of(std::uint64_t bits) {
    return hn::TestBit(set(static_cast<std::int32_t>(bits)), hn::Shl(set(1), hn::Iota(ints(), 0)));
}

/// A bit for each lane that is set in a mask. The bits are read byte by byte, since a wider load
/// would wait for the stores.
HWY_ATTR HWY_INLINE std::uint64_t bits_of(int_mask mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(ints(), mask, bytes);
    return lanes > 8 ? bytes[0] | std::uint64_t{bytes[1]} << 8 : bytes[0];
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
