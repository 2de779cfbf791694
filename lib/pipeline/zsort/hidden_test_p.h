// SPDX-License-Identifier: MIT
// hidden_test: finds items that need no order, as they are seen wholly or not at all.
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

/// Finds the triangles (items) that need no place in the painting order, since they are seen wholly
/// or not at all.
///
/// Items that are seen in all of their pixels share no pixel with each other. So such items may be
/// painted in any order, after all other items. Items that are seen nowhere need not be painted.
/// Only items that are seen in a part of their pixels need an order.
class hidden_test {
public:
    /// Forgets the results of find(): each item needs an order again.
    void forget() { parts_.clear(); }

    /// Tests the members of all tiles, if each cell of a tile is a pixel. In each pixel it finds
    /// the item that the sort paints last, and compares all further items of the pixel with this
    /// item. If the sort is wrong in a tile, all members of the tile need an order.
    /// Expects: the numbers of all items are less than `numbers`.
    /// Returns: the number of pairs that were compared.
    std::int64_t find(const painter_tiles& tiles, const painter_pairs& pairs, std::size_t numbers,
                      l3d_workers& workers);

    bool needs_order(std::uint32_t number) const {
        return parts_.empty() || (parts_[number].seen & parts_[number].hidden) != 0;
    }
    bool is_whole(std::uint32_t number) const {
        return !parts_.empty() && parts_[number].seen != 0 && parts_[number].hidden == 0;
    }
    /// The number of items that are seen wholly, among those with numbers from `begin` to before
    /// `end`.
    std::size_t count_whole(std::size_t begin, std::size_t end) const;

private:
    /// Whether any pixel of an item is seen, and whether any pixel is hidden. 1 stands for yes, 0
    /// for no.
    struct parts {
        std::uint8_t seen = 0, hidden = 0;
    };

    /// A worker's results for the members of one tile. No two share a cache line.
    struct alignas(128) found {
        tile_fronts fronts;
        std::vector<cell_sight> of_members;
        std::int64_t pairs = 0; ///< number of pairs that the worker compared, in all tiles
    };

    void look(std::span<const painter_entry> members, const painter_pairs& pairs, found& room);
    static bool is_sort_right(std::span<const painter_entry> members, const painter_pairs& pairs,
                              found& of);
    void note(const painter_entry& member, bool is_seen, bool is_hidden);

    std::vector<parts> parts_; ///< for each item's number, whether parts of it are seen and hidden
    std::vector<found> of_workers_;
};

} // namespace l3d_detail

#endif
