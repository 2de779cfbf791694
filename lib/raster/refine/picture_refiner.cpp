// SPDX-License-Identifier: MIT
// picture_refiner: bands are marked, then resolved.
#include "raster/refine/picture_refiner_p.h"

#include "raster/refine/mark_jumps_p.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace l3d_detail {

namespace {

l3d_pixel_box box_of_band(const drawn_frame& frame, int band) {
    const int top = frame.window.top + band * frame.rows;
    return {frame.window.left, top, frame.window.right,
            std::min(top + frame.rows, frame.window.bottom)};
}

} // namespace

std::int64_t picture_refiner::refine(const drawn_frame& frame, l3d_workers& workers) {
    const int bands = (frame.window.bottom - frame.window.top + frame.rows - 1) / frame.rows;
    each_worker_.resize(static_cast<std::size_t>(workers.count()));
    bits_.resize(frame.target.size());
    workers.for_each_beside(bands, [&](int band, int) { mark(frame, band); });
    workers.for_each_beside(bands, [&](int band, int worker) {
        resolve(frame, band, static_cast<std::size_t>(worker));
    });
    std::int64_t refined = 0;
    for (worker_space& space : each_worker_)
        refined += std::exchange(space.refined, 0);
    return refined;
}

/// A pixel beside a drawn tile may be partly covered, too.
void picture_refiner::mark(const drawn_frame& frame, int band) {
    const l3d_pixel_box box = box_of_band(frame, band);
    bits_.clear(box.top, box.bottom);
    const l3d_pixel_box drawn = frame.coarse.drawn_in(
        std::max(box.top - 1, frame.window.top), std::min(box.bottom + 1, frame.window.bottom));
    const l3d_pixel_box reached{drawn.left - 1, box.top, drawn.right + 1, box.bottom};
    mark_jumps(frame.target, reached.intersected(box), bits_);
}

void picture_refiner::resolve(const drawn_frame& frame, int band, std::size_t worker) {
    const l3d_pixel_box box = box_of_band(frame, band);
    worker_space& space = each_worker_[worker];
    space.fragments.begin(bits_, frame.target.width, box.top, box.bottom);
    if (space.fragments.pixels().empty())
        return;
    const bool levels = frame.shading.mode == l3d_shade::levels;
    for (const std::uint32_t index : frame.list.items(band)) {
        const band_item& item = frame.list.item(index);
        if (!bits_.any(item.box.intersected(box)))
            continue;
        if (item.triangle_begin < item.triangle_end)
            space.fragments.add(*item.part, item.triangle_begin, item.triangle_end);
        space.fragments.add(*item.part, item.cells, levels);
    }
    space.fragments.sort();
    space.mixer.draw(space.fragments, frame.shading, frame.target);
    space.refined += static_cast<std::int64_t>(space.fragments.pixels().size());
}

} // namespace l3d_detail
