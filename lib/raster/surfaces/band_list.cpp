// SPDX-License-Identifier: MIT
// band_list: finds boxes of all items, sorts items by radix, and finds the bands that they touch.
#include "raster/surfaces/band_list_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

namespace l3d_detail {

namespace {

[[maybe_unused]] bool covers(const l3d_block_starts& starts, int quads) {
    return quads == 0 || starts.first[static_cast<std::size_t>(starts.blocks)] == quads;
}

/// Rows or columns of blocks, `count` of them from `first` on.
struct block_range {
    int first, count;

    int end() const { return first + count; }
    int cells_begin(const l3d_block_starts& of) const {
        return of.first[static_cast<std::size_t>(first)];
    }
    int cells_end(const l3d_block_starts& of) const {
        return of.first[static_cast<std::size_t>(end())];
    }
};

/// The blocks in a range of rows and columns, as bits of l3d_surface_part::unseen.
unsigned bits_of(block_range rows, block_range columns) {
    const unsigned in_row = ((1u << columns.count) - 1) << columns.first;
    unsigned bits = 0;
    for (int row = rows.first; row < rows.end(); ++row)
        bits |= in_row << l3d_block_starts::most_blocks * row;
    return bits;
}

/// Divides a grid among items, and calls visit(cells) with the quads of each item. A grid of fewer
/// than 32 x 32 quads is one item, since blocks of its rows would leave lanes idle. In larger
/// grids, an item is a block, or up to 2 x 2 blocks as long as these have fewer than 128 quads
/// together. The fill kernel leaves out hidden quads one by one; testing items first only makes
/// this cheaper. Blocks that nobody sees are left out, and their neighbours are then items of their
/// own.
template <class Visit> void visit_blocks(const l3d_surface_part& part, const Visit& visit) {
    constexpr int few = 128, few_in_all = 32 * 32;
    const l3d_block_starts &rows = part.block_rows, &columns = part.block_columns;
    const grid_cells all = all_cells(part.grid);
    const int quads = all.row_end * all.column_end;
    if (quads > 0 && quads < few_in_all && part.unseen == 0)
        return visit(all);
    const int pair_c = quads < few * rows.blocks * columns.blocks ? 2 : 1;
    const int pair_r = quads < few * rows.blocks * ((columns.blocks + pair_c - 1) / pair_c) ? 2 : 1;
    const auto visit_range = [&](block_range r, block_range c) {
        const grid_cells cells{r.cells_begin(rows), std::min(r.cells_end(rows), all.row_end),
                               c.cells_begin(columns),
                               std::min(c.cells_end(columns), all.column_end)};
        if (cells.row_begin < cells.row_end && cells.column_begin < cells.column_end)
            visit(cells);
    };
    for (int r = 0; r < rows.blocks; r += pair_r)
        for (int c = 0; c < columns.blocks; c += pair_c) {
            const block_range some_rows{r, std::min(pair_r, rows.blocks - r)};
            const block_range some_columns{c, std::min(pair_c, columns.blocks - c)};
            if ((part.unseen & bits_of(some_rows, some_columns)) == 0) {
                visit_range(some_rows, some_columns);
                continue;
            }
            for (int row = r; row < r + some_rows.count; ++row)
                for (int column = c; column < c + some_columns.count; ++column)
                    if ((part.unseen & bits_of({row, 1}, {column, 1})) == 0)
                        visit_range({row, 1}, {column, 1});
        }
}

void place_item(band_item& item, const polygon_bounds& bounds, const band_list::frame& of) {
    item.box = of.pixels(bounds.box);
    item.nearest = item.order = bounds.nearest;
}

} // namespace

void band_list::make(std::span<const l3d_surface_part* const> parts, const frame& of,
                     const l3d_shading* vertex_light, l3d_workers& workers) {
    lay_out(parts, vertex_light != nullptr);
    by_height_.sort_for(workers);
    workers.for_each_beside(static_cast<int>(parts.size()), [&](int i, int) {
        const std::size_t at = by_height_[i];
        list_part(*parts[at], places_[at], of, vertex_light);
    });
    sort();
    share_out(of);
}

/// Finds where each part's items, pixel rows and grey levels begin in the lists, so that threads
/// can make the items in any order. A vertex in the middle of a grid stands for the part's height.
void band_list::lay_out(std::span<const l3d_surface_part* const> parts, bool with_levels) {
    places_.clear();
    by_height_.clear();
    polygons_ = 0;
    place next{0, 0, 0};
    for (const l3d_surface_part* part : parts) {
        assert(covers(part->block_rows, all_cells(part->grid).row_end) &&
               covers(part->block_columns, all_cells(part->grid).column_end));
        places_.push_back(next);
        const auto& y = part->grid.y;
        by_height_.add(y.empty() ? 0 : y[y.size() / 2]);
        visit_blocks(*part, [&](const grid_cells& cells) {
            ++next.items;
            next.rows += static_cast<std::uint32_t>(cells.row_end - cells.row_begin);
        });
        const auto triangles = static_cast<std::uint32_t>(part->triangles.count);
        next.items += (triangles + triangles_in_item - 1) / triangles_in_item;
        if (with_levels)
            next.levels += static_cast<std::uint32_t>(part->grid.x.size());
        polygons_ += l3d_detail::polygons(*part);
    }
    items_.resize(next.items);
    rows_.resize(next.rows);
    if (levels_.size() < next.levels)
        levels_.resize(next.levels);
}

void band_list::list_part(const l3d_surface_part& part, place at, const frame& of,
                          const l3d_shading* vertex_light) {
    if (vertex_light)
        light_vertices(*vertex_light, part.grid, levels_.data() + at.levels);
    float of_grid = 0;
    visit_blocks(part, [&](const grid_cells& cells) {
        band_item& item = items_[at.items++];
        item = {.part = &part, .cells = cells, .rows_at = at.rows, .levels_at = at.levels};
        place_item(item, bounds_of(part.grid, cells, rows_.data() + at.rows), of);
        of_grid = std::max(of_grid, item.order);
        at.rows += static_cast<std::uint32_t>(cells.row_end - cells.row_begin);
    });
    const auto triangles = static_cast<std::uint32_t>(part.triangles.count);
    for (std::uint32_t i = 0; i < triangles; i += triangles_in_item) {
        band_item& item = items_[at.items++];
        item = {.part = &part,
                .triangle_begin = i,
                .triangle_end = std::min(i + triangles_in_item, triangles)};
        place_item(item, bounds_of(part.triangles, item.triangle_begin, item.triangle_end), of);
        if (of_grid > 0 && !of.squares)
            item.order = of_grid;
    }
}

/// Orders the items that are in the window, nearest first.
///
/// Positive floats are ordered like their bits. Two passes by 8 bits sort by the 8 bits of the
/// exponent and 8 of the mantissa. Each pass keeps the order of items with equal bits, so equally
/// near items stay in the order of the parts.
void band_list::sort() {
    order_.clear();
    for (std::uint32_t i = 0; i < items_.size(); ++i)
        if (!items_[i].box.empty())
            order_.push_back({~std::bit_cast<std::uint32_t>(items_[i].order), i});
    other_order_.resize(order_.size());
    constexpr int digit = 8;
    for (const int shift : {15, 15 + digit}) {
        const auto digit_of = [shift](const sort_key& key) {
            return key.distance >> shift & ((1u << digit) - 1);
        };
        std::array<std::uint32_t, 1 << digit> begins{};
        for (const sort_key& key : order_)
            ++begins[digit_of(key)];
        std::uint32_t sum = 0;
        for (std::uint32_t& begin : begins) {
            const std::uint32_t count = begin;
            begin = sum;
            sum += count;
        }
        for (const sort_key& key : order_)
            other_order_[begins[digit_of(key)]++] = key;
        order_.swap(other_order_);
    }
}

void band_list::share_out(const frame& of) {
    const int top = of.window.top, bands = (of.window.bottom - top + of.rows - 1) / of.rows;
    const auto first_band = [&](const band_item& item) {
        return static_cast<std::size_t>((item.box.top - top) / of.rows);
    };
    const auto last_band = [&](const band_item& item) {
        return static_cast<std::size_t>((item.box.bottom - 1 - top) / of.rows);
    };
    // Each band's count is stored one place too far, so that the loop below moves each begin to the
    // right place.
    band_begins_.assign(static_cast<std::size_t>(bands) + 2, 0);
    for (const sort_key& key : order_)
        for (std::size_t b = first_band(items_[key.item]); b <= last_band(items_[key.item]); ++b)
            ++band_begins_[b + 2];
    for (std::size_t b = 2; b < band_begins_.size(); ++b)
        band_begins_[b] += band_begins_[b - 1];
    in_bands_.resize(band_begins_.back());
    for (const sort_key& key : order_)
        for (std::size_t b = first_band(items_[key.item]); b <= last_band(items_[key.item]); ++b)
            in_bands_[band_begins_[b + 1]++] = key.item;
}

} // namespace l3d_detail
