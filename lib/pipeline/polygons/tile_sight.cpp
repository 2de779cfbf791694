// SPDX-License-Identifier: MIT
// tile_sight: all cells of a tile in some vectors.
#include "pipeline/polygons/tile_sight_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/polygons/tile_sight.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

#include <bit>
#include <tuple>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t cells = std::tuple_size_v<tile_fronts>;

using ints = hn::CappedTag<std::int32_t, 16>;
using int_vec = hn::Vec<ints>;
using int_mask = hn::Mask<ints>;
constexpr std::size_t lanes = hn::MaxLanes(ints());

HWY_INLINE int_vec set(std::int32_t value) {
    return hn::Set(ints(), value);
}
/// Floats that are not negative are ordered like their bits.
HWY_INLINE int_vec set(float value) {
    return set(std::bit_cast<std::int32_t>(value));
}

/// Which of a vector's cells are wanted: lane i stands for bit i.
HWY_INLINE int_mask lanes_of(std::uint64_t wanted) {
    return hn::TestBit(set(static_cast<std::int32_t>(wanted)),
                       hn::Shl(set(1), hn::Iota(ints(), 0)));
}

HWY_INLINE std::uint64_t bits_of(int_mask mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(ints(), mask, bits);
    return bits[0] | std::uint64_t{bits[1]} << 8;
}

void find_sight(std::span<const painter_entry> members, tile_fronts& fronts, cell_sight* of) {
    int_vec farthest[cells / lanes], front[cells / lanes];
    for (std::size_t v = 0; v < cells / lanes; ++v) {
        farthest[v] = set(0);
        front[v] = set(-1);
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
        const int_vec own = set(members[i].farthest);
        for (std::size_t v = 0; v < cells / lanes; ++v) {
            // Of equals, the one of the greater number is painted later.
            const int_mask last =
                hn::AndNot(hn::Lt(own, farthest[v]), lanes_of(members[i].cells >> lanes * v));
            farthest[v] = hn::IfThenElse(last, own, farthest[v]);
            front[v] = hn::IfThenElse(last, set(static_cast<std::int32_t>(i)), front[v]);
        }
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
        cell_sight sight{0, 0};
        for (std::size_t v = 0; v < cells / lanes; ++v) {
            const int_mask shown = hn::Eq(front[v], set(static_cast<std::int32_t>(i)));
            const int_mask near = hn::Lt(farthest[v], set(members[i].nearest));
            sight.shown |= bits_of(shown) << lanes * v;
            sight.doubtful |= bits_of(near) << lanes * v;
        }
        sight.doubtful &= members[i].cells & ~sight.shown;
        of[i] = sight;
    }
    for (std::size_t v = 0; v < cells / lanes; ++v)
        hn::StoreU(front[v], ints(), fronts.data() + lanes * v);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(find_sight);

void find_sight(std::span<const painter_entry> members, tile_fronts& fronts, cell_sight* of) {
    L3D_SIMD_CALL(find_sight)(members, fronts, of);
}

} // namespace l3d_detail
#endif
