// SPDX-License-Identifier: MIT
// painter_tiles: each worker finds entries of its share of items, which are then sorted by tile.
#include "pipeline/zsort/painter_tiles_p.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace l3d_detail {

/// The entry of an item in a tile, if the pixels of the item are not known. The entry's cells are
/// the cells that the item's box meets.
painter_entry painter_tiles::box_entry(const painter_item& item, std::uint32_t number, int column,
                                       int row) const {
    constexpr int side = 1 << cell_bits;
    const int to_cell = shift_ - cell_bits;
    const int left = item.left - (column << shift_), top = item.top - (row << shift_);
    const auto first = [&](int begin) { return std::max(begin, 0) >> to_cell; };
    const auto behind = [&](int end, int tile) {
        return std::min((end - 1 - (tile << shift_)) >> to_cell, side - 1) + 1;
    };
    const int columns = behind(item.right, column) - first(left);
    const int rows = behind(item.bottom, row) - first(top);
    const std::uint64_t in_row = (0xffU >> (side - columns)) << first(left);
    const std::uint64_t in_rows = ~std::uint64_t{0} >> side * (side - rows) << side * first(top);
    return {item.farthest, item.nearest, in_row * first_column & in_rows, number,
            static_cast<std::uint16_t>((left < 0 ? 1 : 0) | (top < 0 ? 2 : 0))};
}

bool painter_tiles::is_coverable(const painter_item& item) const {
    if (!have_pixels())
        return false;
    const auto& v = items_->corners(item);
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    constexpr std::int32_t reach = tile_cover_reach << l3d_subpixel_bits;
    return right - left <= reach && bottom - top <= reach;
}

/// The number of tiles that an item's box meets.
std::size_t painter_tiles::tiles_of(const painter_item& item) const {
    const int columns = ((item.right - 1) >> shift_) - (item.left >> shift_) + 1;
    const int rows = ((item.bottom - 1) >> shift_) - (item.top >> shift_) + 1;
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
}

/// Divides the items into one share for each worker. Shares consist of whole chunks, and are as
/// equal as chunks allow.
void painter_tiles::share_out(const painter_items& items, int workers) {
    shares_.resize(static_cast<std::size_t>(workers));
    std::size_t chunk = 0, count = 0;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
        shares_[i].first_chunk = chunk;
        for (const std::size_t wanted = items.count() * (i + 1) / shares_.size();
             chunk < items.chunks() && count < wanted; ++chunk)
            count += items.of_chunk(chunk).size();
        shares_[i].end_chunk = chunk;
    }
}

void painter_tiles::find_entries(share_entries& to) const {
    const painter_items& items = *items_;
    to.ends.assign(begins_.size(), 0);
    std::size_t count = 0; // a local stays in a register
    for (std::size_t chunk = to.first_chunk; chunk < to.end_chunk; ++chunk) {
        auto number = static_cast<std::uint32_t>(items.first(chunk));
        for (const painter_item& item : items.of_chunk(chunk)) {
            if (const std::size_t most = count + tiles_of(item); most > to.entries.size()) {
                to.entries.resize(most + most / 2);
                to.tiles.resize(to.entries.size());
            }
            for_each(item, number++, [&](std::size_t tile, const painter_entry& entry) {
                to.entries[count] = entry;
                to.tiles[count++] = static_cast<std::uint32_t>(tile);
                ++to.ends[tile];
            });
        }
    }
    to.count = count;
}

void painter_tiles::make(const painter_items& items, l3d_size size, l3d_workers& workers) {
    const double side = 2 * std::sqrt(items.mean_box());
    constexpr int most = 7;            // 128 pixels
    constexpr int most_for_pixels = 5; // 32 pixels
    shift_ =
        std::clamp(static_cast<int>(std::lround(std::log2(std::max(side, 1.0)))), cell_bits, most);
    if (items.are_pixels_all() && shift_ <= most_for_pixels)
        shift_ = cell_bits;
    items_ = &items;
    columns_ = ((size.width - 1) >> shift_) + 1;
    rows_ = ((size.height - 1) >> shift_) + 1;
    const std::size_t tiles = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    begins_.resize(tiles);
    ends_.resize(tiles);
    is_sorted_.assign(tiles, false);

    // A share's members of a tile follow those of the share before.
    share_out(items, workers.count());
    const auto for_each_share = [&](const auto& work) {
        workers.for_each_beside(workers.count(), [&](int number, int) {
            work(shares_[static_cast<std::size_t>(number)]);
        });
    };
    for_each_share([&](share_entries& of) { find_entries(of); });
    std::uint32_t sum = 0;
    for (std::size_t t = 0; t < tiles; ++t) {
        begins_[t] = sum;
        for (share_entries& of : shares_)
            sum += std::exchange(of.ends[t], sum);
        ends_[t] = sum;
    }
    entries_.resize(sum);
    for_each_share([&](share_entries& of) {
        for (std::size_t i = 0; i < of.count; ++i)
            entries_[of.ends[of.tiles[i]]++] = of.entries[i];
    });
    heads_ = begins_;
}

void painter_tiles::sort(std::size_t tile) {
    std::sort(entries_.begin() + begins_[tile], entries_.begin() + ends_[tile],
              [](const painter_entry& a, const painter_entry& b) { return a.node() < b.node(); });
    is_sorted_[tile] = true;
}

} // namespace l3d_detail
