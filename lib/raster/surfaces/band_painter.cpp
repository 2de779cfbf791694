// SPDX-License-Identifier: MIT
// band_painter: what is hidden, what the kernel takes, and what is left for the scalar filler.
#include "raster/surfaces/band_painter_p.h"

#include <algorithm>
#include <utility>

namespace l3d_detail {

void band_painter::reserve_as(const band_painter& other) {
    rest_.quads.reserve(other.rest_.quads.capacity());
    rest_.triangles.reserve(other.rest_.triangles.capacity());
    queue_.pieces.reserve(other.queue_.pieces.capacity());
}

void band_painter::draw(const band_frame& frame, const fill_band& band, const band_list& list,
                        std::span<const std::uint32_t> items, coarse_depth& coarse) {
    const l3d_pixel_box here{0, band.top, band.width, band.bottom};
    scalar_.begin(band, frame.shading, frame.materials, frame.words);
    for (const std::uint32_t index : items) {
        const band_item& item = list.item(index);
        const l3d_pixel_box box = item.box.intersected(here);
        if (frame.leaves_out_hidden && coarse.hidden(box, item.nearest, band))
            continue;
        coarse.open(box, band);
        draw_triangles(frame, band, item);
        draw_cells(frame, band, list, item);
    }
    if (frame.by_lanes)
        draw_rest(frame, band);
    by_scalar_.add(scalar_.counts());
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

/// Leaves out rows of quads that are above or below the band.
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
