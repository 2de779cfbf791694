// SPDX-License-Identifier: MIT
// hidden_test: which items need no order, as they are seen wholly or not at all.
#ifndef L3D_PIPELINE_ZSORT_HIDDEN_TEST_P_H
#define L3D_PIPELINE_ZSORT_HIDDEN_TEST_P_H

#include "pipeline/zsort/painter_pairs_p.h"
#include "pipeline/zsort/painter_tiles_p.h"
#include "pipeline/zsort/tile_sight_p.h"
#include "raster/parallel/workers.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// How much of each item is seen.
///
/// Those that are seen in all of their pixels share none with each other. So they may be painted in
/// any order, after all others. Those that are seen nowhere need not be painted. Only the rest is
/// in want of an order.
class hidden_test {
public:
    /// Nothing is known: each item needs an order.
    void forget() { parts_.clear(); }

    /// Finds it for the members of tiles, if these know pixels. In each pixel it looks for the item
    /// that is sorted last, and compares the others with it. Where the sort is wrong, all members
    /// of the tile are said to need an order. Returns: how many pairs were compared. Expects: items
    /// of lesser numbers than that.
    std::int64_t find(const painter_tiles& tiles, const painter_pairs& pairs, std::size_t numbers,
                      l3d_workers& workers);

    bool needs_order(std::uint32_t number) const {
        return parts_.empty() || (parts_[number].seen & parts_[number].hidden) != 0;
    }
    bool is_whole(std::uint32_t number) const {
        return !parts_.empty() && parts_[number].seen != 0 && parts_[number].hidden == 0;
    }
    /// How many are, of those with numbers [begin, end).
    std::size_t count_whole(std::size_t begin, std::size_t end) const;

private:
    /// 1 if some of the item's pixels are.
    struct parts {
        std::uint8_t seen = 0, hidden = 0;
    };

    /// A worker's: what is found of a tile's members. No two share lines of the caches.
    struct alignas(128) found {
        tile_fronts fronts;
        std::vector<cell_sight> of_members;
        std::int64_t pairs = 0; ///< compared, in all tiles
    };

    void look(std::span<const painter_entry> members, const painter_pairs& pairs, found& room);
    static bool is_sort_right(std::span<const painter_entry> members, const painter_pairs& pairs,
                              found& of);
    void note(const painter_entry& member, bool is_seen, bool is_hidden);

    std::vector<parts> parts_; ///< by number
    std::vector<found> of_workers_;
};

} // namespace l3d_detail

#endif
