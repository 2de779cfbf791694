// SPDX-License-Identifier: MIT
// band_painter: sorts out hidden items, fills by the kernel, and leaves the rest to the scalar
// filler.
#include "raster/surfaces/band_painter_p.h"

#include <algorithm>
#include <array>
#include <utility>

namespace l3d_detail {

namespace {

l3d_pixel_box box_in(const fill_band& band, const band_item& item) {
    return item.box.intersected({0, band.top, band.width, band.bottom});
}

} // namespace

void band_painter::reserve_as(const band_painter& other) {
    rest_.quads.reserve(other.rest_.quads.capacity());
    rest_.triangles.reserve(other.rest_.triangles.capacity());
    queue_.pieces.reserve(other.queue_.pieces.capacity());
}

/// An item waits for some turns after its memory is prefetched. The item is tested again before it
/// is drawn, as other items may hide it by then.
void band_painter::draw(const band_frame& frame, const fill_band& band, const band_list& list,
                        std::span<const std::uint32_t> items, coarse_depth& coarse) {
    scalar_.begin(band, frame.shading, frame.materials, frame.words);
    std::array<const band_item*, items_waiting> waiting{};
    std::size_t turn = 0;
    const auto put = [&](const band_item* item) {
        const band_item* const next = std::exchange(waiting[turn++ % waiting.size()], item);
        if (next && !is_hidden(frame, band, *next, coarse))
            draw_item(frame, band, list, *next, coarse);
    };
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i + items_ahead < items.size())
            __builtin_prefetch(&list.item(items[i + items_ahead]));
        const band_item& item = list.item(items[i]);
        if (is_hidden(frame, band, item, coarse))
            continue;
        fetch(item);
        put(&item);
    }
    for (std::size_t i = 0; i < waiting.size(); ++i)
        put(nullptr);
    if (frame.by_lanes)
        draw_rest(frame, band);
    by_scalar_.add(scalar_.counts());
}

void band_painter::draw(const band_frame& frame, const fill_band& band,
                        std::span<const cut_triangle> triangles, std::span<const plane_cut> cuts,
                        coarse_depth& coarse) {
    scalar_.begin(band, frame.shading, frame.materials, frame.words);
    for (const cut_triangle& of : triangles) {
        const auto [left, right] = std::minmax({of.v[0].x, of.v[1].x, of.v[2].x});
        const auto [top, bottom] = std::minmax({of.v[0].y, of.v[1].y, of.v[2].y});
        const l3d_pixel_box box = pixels_in({left, top, right, bottom})
                                      .intersected({0, band.top, band.width, band.bottom});
        if (box.empty())
            continue;
        coarse.open(box, band);
        scalar_.fill(of, cuts.subspan(of.first_cut, of.behind_cut - of.first_cut));
    }
    by_scalar_.add(scalar_.counts());
}

bool band_painter::is_hidden(const band_frame& frame, const fill_band& band, const band_item& item,
                             coarse_depth& coarse) {
    return frame.leaves_out_hidden && coarse.hidden(box_in(band, item), item.nearest, band);
}

void band_painter::draw_item(const band_frame& frame, const fill_band& band, const band_list& list,
                             const band_item& item, coarse_depth& coarse) {
    coarse.open(box_in(band, item), band);
    draw_triangles(frame, band, item);
    draw_cells(frame, band, list, item);
}

/// Prefetches the memory of an item's triangles. Items come from front to back, so their triangles
/// are scattered in memory.
void band_painter::fetch(const band_item& item) {
    constexpr std::size_t cache_line = 64;
    if (item.triangle_begin >= item.triangle_end)
        return;
    const l3d_micro_triangles::block& block =
        item.part->triangles.blocks[item.triangle_begin / l3d_micro_triangles::lanes];
    const auto* const from = reinterpret_cast<const char*>(block.data());
    for (std::size_t byte = 0; byte < sizeof(block); byte += cache_line)
        __builtin_prefetch(from + byte);
}

void band_painter::draw_triangles(const band_frame& frame, const fill_band& band,
                                  const band_item& item) {
    if (item.triangle_begin >= item.triangle_end)
        return;
    if (frame.by_lanes)
        fill_triangles(by_lanes(frame, band), item.part->triangles,
                       frame.words.of_material(item.part->material), item.triangle_begin,
                       item.triangle_end);
    else
        scalar_.fill(*item.part, item.triangle_begin, item.triangle_end);
}

/// Draws an item's quads in the band. Rows of quads above or below the band are left out.
void band_painter::draw_cells(const band_frame& frame, const fill_band& band, const band_list& list,
                              const band_item& item) {
    const band_rows* const rows = list.rows(item) - item.cells.row_begin;
    grid_cells run = item.cells;
    for (int row = run.row_begin; row < item.cells.row_end; row = run.row_end + 1) {
        const auto outside = [&](int r) {
            return std::max(rows[r].top, band.top) >= std::min(rows[r].bottom, band.bottom);
        };
        run.row_begin = row;
        run.row_end = row;
        while (run.row_end < item.cells.row_end && !outside(run.row_end))
            ++run.row_end;
        if (run.row_begin < run.row_end)
            draw_run(frame, band, list, item, run);
    }
}

void band_painter::draw_run(const band_frame& frame, const fill_band& band, const band_list& list,
                            const band_item& item, const grid_cells& cells) {
    if (frame.by_lanes)
        fill_quads(by_lanes(frame, band), list.grid(item, frame.words), cells.row_begin,
                   cells.row_end, cells.column_begin, cells.column_end);
    else
        scalar_.fill(*item.part, cells);
}

void band_painter::draw_rest(const band_frame& frame, const fill_band& band) {
    fill_finish(by_lanes(frame, band));
    scalar_.fill(rest_);
    rest_.clear();
}

fill_counts band_painter::take_counts() {
    fill_counts all = std::exchange(by_lanes_, {});
    all.add(std::exchange(by_scalar_, {}));
    return all;
}

} // namespace l3d_detail
