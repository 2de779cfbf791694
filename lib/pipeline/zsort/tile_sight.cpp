// SPDX-License-Identifier: MIT
// tile_sight: looks at all cells of a tile in a few vectors.
#include "pipeline/zsort/tile_sight_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/zsort/tile_sight.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_integers-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The bits of a float that is not negative, in all lanes; they are ordered like the float.
HWY_INLINE int_vec order_of(float value) {
    return set(std::bit_cast<std::int32_t>(value));
}

/// Finds, for each cell of a tile, the member that the sort paints last there.
class front_cells {
public:
    HWY_INLINE explicit front_cells(std::span<const painter_entry> members) {
        for (std::size_t v = 0; v < vectors; ++v) {
            farthest_[v] = set(0);
            front_[v] = set(-1);
        }
        for (std::size_t i = 0; i < members.size(); ++i) {
            const int_vec own = order_of(members[i].farthest);
            for (std::size_t v = 0; v < vectors; ++v) {
                // Among members that are equally far, the one of the greater number is painted
                // later.
                const int_mask last =
                    hn::AndNot(hn::Lt(own, farthest_[v]), lanes_of(members[i].cells >> lanes * v));
                farthest_[v] = hn::IfThenElse(last, own, farthest_[v]);
                front_[v] = hn::IfThenElse(last, set(static_cast<std::int32_t>(i)), front_[v]);
            }
        }
    }

    HWY_INLINE void store(tile_fronts& fronts) const {
        for (std::size_t v = 0; v < vectors; ++v)
            hn::StoreU(front_[v], ints(), fronts.data() + lanes * v);
    }

    /// The cells in which this member is painted last.
    HWY_INLINE std::uint64_t of(std::size_t member) const {
        std::uint64_t bits = 0;
        for (std::size_t v = 0; v < vectors; ++v)
            bits |= bits_of(hn::Eq(front_[v], set(static_cast<std::int32_t>(member)))) << lanes * v;
        return bits;
    }

    /// The farthest depth of all members that are painted last in some cell; infinite if no cell
    /// has a member.
    HWY_INLINE float farthest_of_all() const {
        constexpr float none = std::numeric_limits<float>::infinity();
        int_vec least = order_of(none);
        for (std::size_t v = 0; v < vectors; ++v)
            least = hn::Min(
                least, hn::IfThenElse(hn::Lt(front_[v], set(0)), order_of(none), farthest_[v]));
        return std::bit_cast<float>(hn::GetLane(hn::MinOfLanes(ints(), least)));
    }

    /// The cells in which the member painted last is not wholly in front of the depth `nearest`.
    HWY_INLINE std::uint64_t not_before(float nearest) const {
        std::uint64_t bits = 0;
        for (std::size_t v = 0; v < vectors; ++v)
            bits |= bits_of(hn::Lt(farthest_[v], order_of(nearest))) << lanes * v;
        return bits;
    }

private:
    static constexpr std::size_t vectors = std::tuple_size_v<tile_fronts> / lanes;

    int_vec farthest_[vectors], front_[vectors];
};

void find_sight(std::span<const painter_entry> members, tile_fronts& fronts, cell_sight* of) {
    const front_cells cells(members);
    cells.store(fronts);
    // To find the cells of one member takes as long as to read some cells.
    constexpr std::size_t few = std::tuple_size_v<tile_fronts> / 4;
    if (members.size() <= few) {
        for (std::size_t i = 0; i < members.size(); ++i)
            of[i] = {cells.of(i), 0};
    } else {
        std::fill_n(of, members.size(), cell_sight{0, 0});
        for (std::size_t cell = 0; cell < fronts.size(); ++cell)
            if (fronts[cell] >= 0)
                of[fronts[cell]].shown |= std::uint64_t{1} << cell;
    }
    const float farthest = cells.farthest_of_all(); // most hidden members lie behind it
    for (std::size_t i = 0; i < members.size(); ++i) {
        const std::uint64_t hidden = members[i].cells & ~of[i].shown;
        if (hidden != 0 && members[i].nearest > farthest)
            of[i].doubtful = hidden & cells.not_before(members[i].nearest);
    }
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
