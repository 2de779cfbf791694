// SPDX-License-Identifier: MIT
// painter_tiles: lists, for each tile of the picture, the triangles that reach it.
#ifndef L3D_PIPELINE_ZSORT_PAINTER_TILES_P_H
#define L3D_PIPELINE_ZSORT_PAINTER_TILES_P_H

#include "pipeline/zsort/painter_components_p.h"
#include "pipeline/zsort/painter_items_p.h"
#include "pipeline/zsort/tile_cover_p.h"
#include "raster/parallel/workers.h"
#include "tool_2d/pixels.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A triangle (item) in the list of a tile that it reaches.
///
/// Shape: a tile has eight rows of eight cells, a bit each. A cell is a pixel or a square of
///        pixels.
struct painter_entry {
    float farthest, nearest; ///< least and largest 1/w of the triangle
    std::uint64_t cells;     ///< cells in which the triangle may cover pixels
    std::uint32_t number;    ///< number of the triangle's item
    /// Bit 0 is set if the triangle's first column lies in a tile to the left, bit 1 if its first
    /// row lies in a tile above. Both are 0 if the entry is exact.
    std::uint16_t begins_before = 0;
    std::uint16_t is_exact = 0; ///< whether the cells are just the pixels that the triangle covers

    /// Whether two triangles may have a pixel in common in this tile. Without exact entries, it is
    /// true only in the first tile in which two triangles meet, so that each pair is found once.
    /// Pairs with an exact entry may be found in several tiles.
    bool may_meet(const painter_entry& other) const {
        return (cells & other.cells) != 0 && (begins_before & other.begins_before) == 0;
    }
    /// The entry as a node of an order, from far to near. Its key is the bits of a positive float,
    /// which are ordered like the float.
    order_node node() const {
        return order_node_of(std::bit_cast<std::uint32_t>(farthest), number);
    }
};

/// Whether no two members of a tile have a cell in common, as on a surface of one layer.
inline bool are_apart(std::span<const painter_entry> members) {
    std::uint64_t taken = 0;
    for (const painter_entry& member : members) {
        if ((taken & member.cells) != 0)
            return false;
        taken |= member.cells;
    }
    return true;
}

/// Lists, for each tile of the picture, the triangles that reach the tile. So only triangles of the
/// same tile need be compared.
class painter_tiles {
public:
    /// Puts items into tiles that are about twice as wide as the mean box of an item, and at least
    /// eight pixels wide. Smaller tiles would list each triangle often; larger tiles would list
    /// triangles together that do not meet. If sides are not drawn, tiles of 16 or 32 pixels are
    /// made eight pixels wide instead. Then a cell is a pixel, the pixels of most triangles are
    /// known, and most pairs need not be compared.
    /// Lives: borrows the items until the next make.
    void make(const painter_items& items, l3d_size size, l3d_workers& workers);

    int rows() const { return rows_; }
    int columns() const { return columns_; }
    std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    /// The members of a tile: sorted from far to near after rest(), and before that by rising
    /// numbers.
    std::span<const painter_entry> members(std::size_t tile) const {
        return {entries_.data() + begins_[tile], entries_.data() + ends_[tile]};
    }

    /// Whether each cell is one pixel, and triangles are drawn only in the pixels that they cover.
    /// Then most entries are exact.
    bool have_pixels() const { return shift_ == cell_bits && items_->are_pixels_all(); }

    /// Drops the members of a tile for which `keep` is false. Threads may do this for different
    /// tiles at the same time.
    template <class Keep> void keep_if(std::size_t tile, const Keep& keep) {
        std::uint32_t end = begins_[tile];
        for (std::uint32_t i = end; i < ends_[tile]; ++i)
            if (keep(entries_[i]))
                entries_[end++] = entries_[i];
        ends_[tile] = end;
    }

    /// Sorts the tile's members if needed, drops the first ones while `skip` is true, and returns
    /// the rest. Later calls do not return the dropped ones.
    template <class Skip> std::span<const painter_entry> rest(std::size_t tile, const Skip& skip) {
        if (!is_sorted_[tile])
            sort(tile);
        std::uint32_t& head = heads_[tile];
        const std::uint32_t end = ends_[tile];
        while (head < end && skip(entries_[head]))
            ++head;
        return {entries_.data() + head, end - head};
    }

    /// Calls visit(tile, entry) for each tile that an item reaches, with the item's entry in this
    /// tile.
    template <class Visit>
    void for_each(const painter_item& item, std::uint32_t number, const Visit& visit) const {
        if (item.cover != 0 && shift_ == cell_bits)
            return for_each_of_four(item, number, visit);
        if (is_coverable(item))
            return for_each_covered(item, number, visit);
        for (int row = item.top >> shift_; row <= (item.bottom - 1) >> shift_; ++row)
            for (int column = item.left >> shift_; column <= (item.right - 1) >> shift_; ++column)
                visit(at(column, row), box_entry(item, number, column, row));
    }

private:
    static constexpr int cell_bits = 3; ///< 3 bits: a tile has eight cells in a row
    /// The cells of the first column.
    static constexpr std::uint64_t first_column = 0x0101010101010101;

    /// The entries that a worker finds for its share of the items, in the items' order, and their
    /// tiles. The worker writes to its share often. So no two shares lie in one cache line, nor in
    /// one pair of lines, since some processors fetch both lines of a pair.
    struct alignas(128) share_entries {
        std::size_t first_chunk = 0, end_chunk = 0; ///< the share's range of chunks of items
        std::size_t count = 0;                      ///< number of entries
        std::vector<painter_entry> entries; ///< the entries, and some more that are not in use
        std::vector<std::uint32_t> tiles;
        /// For each tile, the index behind the share's last entry in this tile.
        std::vector<std::uint32_t> ends;
    };

    /// Visits the tiles of a small triangle, whose pixels reach at most two columns and two rows of
    /// tiles.
    template <class Visit>
    void for_each_of_four(const painter_item& item, std::uint32_t number,
                          const Visit& visit) const {
        constexpr int side = 1 << cell_bits, cells = side * side;
        const int right = item.left % side, down = item.top % side;
        const std::uint64_t stay = ((0xffU << right) & 0xffU) * first_column;
        // The pixels are moved to the right. Those that leave the tile enter the next one at its
        // left side.
        const std::uint64_t here = item.cover << right & stay;
        const std::uint64_t next = right == 0 ? 0 : item.cover >> (side - right) & ~stay;
        const std::size_t tile = at(item.left >> cell_bits, item.top >> cell_bits);
        const auto put = [&](std::size_t to, std::uint64_t pixels) {
            if (pixels != 0)
                visit(to, painter_entry{item.farthest, item.nearest, pixels, number, 0, 1});
        };
        put(tile, here << side * down);
        put(tile + 1, next << side * down);
        if (down == 0)
            return;
        put(tile + static_cast<std::size_t>(columns_), here >> (cells - side * down));
        put(tile + static_cast<std::size_t>(columns_) + 1, next >> (cells - side * down));
    }

    /// Whether tile_cover() can find the pixels that an item covers.
    bool is_coverable(const painter_item& item) const;

    template <class Visit>
    void for_each_covered(const painter_item& item, std::uint32_t number,
                          const Visit& visit) const {
        // A box of 64 pixels meets at most nine tiles in each direction.
        constexpr std::size_t most = (tile_cover_reach >> cell_bits) + 1;
        std::array<std::uint64_t, most * most> covers;
        const int left = item.left >> cell_bits, top = item.top >> cell_bits;
        const cover_tiles tiles{left << cell_bits, top << cell_bits,
                                ((item.right - 1) >> cell_bits) - left + 1,
                                ((item.bottom - 1) >> cell_bits) - top + 1};
        tile_cover(items_->corners(item), tiles, covers.data());
        const std::uint64_t* next = covers.data();
        for (int row = top; row < top + tiles.rows; ++row)
            for (int column = left; column < left + tiles.columns; ++column)
                if (const std::uint64_t pixels = *next++; pixels != 0)
                    visit(at(column, row),
                          painter_entry{item.farthest, item.nearest, pixels, number, 0, 1});
    }

    painter_entry box_entry(const painter_item& item, std::uint32_t number, int column,
                            int row) const;
    std::size_t tiles_of(const painter_item& item) const;
    void share_out(const painter_items& items, int workers);
    void find_entries(share_entries& to) const;
    void sort(std::size_t tile);

    const painter_items* items_ = nullptr;
    int shift_ = cell_bits, columns_ = 0, rows_ = 0;
    std::vector<std::uint32_t> begins_, ends_, heads_;
    std::vector<painter_entry> entries_;
    std::vector<bool> is_sorted_;
    std::vector<share_entries> shares_;
};

} // namespace l3d_detail

#endif
