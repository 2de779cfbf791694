// SPDX-License-Identifier: MIT
// picture_refiner: marks pixels at contours and jumps, and samples them.
#include "raster/refine/picture_refiner_p.h"

#include "raster/refine/depth_steps_p.h"
#include "raster/refine/drawn_depth_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace l3d_detail {

namespace {

/// The number of marked pixels that ends a slice of a band. The slice ends with the row of tiles in
/// which this number is reached. Bands of usual frames have fewer marked pixels. A pixel keeps up
/// to twice the 64 fragments that can be seen, 16 bytes each. So a slice of a picture 1024 pixels
/// wide has up to 2047 + 8 x 1024 pixels and takes 21 MB.
constexpr std::size_t most_in_slice = 2048;

l3d_pixel_box box_of_band(const drawn_frame& frame, int band) {
    const int top = frame.window.top + band * frame.rows;
    return {frame.window.left, top, frame.window.right,
            std::min(top + frame.rows, frame.window.bottom)};
}

/// Whether surfaces in and around an item's box are all nearer than the item.
bool is_hidden(const drawn_frame& frame, const band_item& item) {
    return frame.coarse.hidden(item.box.grown(1).intersected(frame.window),
                               std::nextafter(item.nearest, HUGE_VALF));
}

/// Marks the pixels of a band through which an edge passes, where the edge is not hidden. An edge
/// on the border of two pixels counts for the first of both pixels.
void mark_edge(const contour_edge& edge, const l3d_pixel_box& box, const drawn_depth& depth,
               l3d_pixel_bits& marks) {
    const auto sign = [](std::int32_t n) { return (n > 0 ? 1 : 0) - (n < 0 ? 1 : 0); };
    const std::int32_t to_x = sign(edge.to.y - edge.from.y), to_y = sign(edge.from.x - edge.to.x);
    scan_point high = edge.from, low = edge.to;
    if (high.y > low.y)
        std::swap(high, low);
    const std::int32_t first = std::max((high.y - 1) >> l3d_subpixel_bits, box.top);
    const std::int32_t last = std::min((low.y - 1) >> l3d_subpixel_bits, box.bottom - 1);
    // How far the edge goes to the right for a lattice unit downwards, in units of 2^-32.
    const std::int64_t slope =
        low.y > high.y ? (std::int64_t{low.x - high.x} << 32) / (low.y - high.y) : 0;
    const auto place_at = [&](std::int32_t y) {
        return high.x + static_cast<std::int32_t>(slope * (y - high.y) >> 32);
    };
    for (std::int32_t y = first; y <= last; ++y) {
        const std::int32_t top = y * l3d_subpixel_one, bottom = top + l3d_subpixel_one;
        const std::int32_t a = top > high.y ? place_at(top) : high.x;
        const std::int32_t b = bottom < low.y ? place_at(bottom) : low.x;
        const std::int32_t left = std::max((std::min(a, b) - 1) >> l3d_subpixel_bits, box.left);
        const std::int32_t right =
            std::min((std::max(a, b) - 1) >> l3d_subpixel_bits, box.right - 1);
        for (std::int32_t x = left; x <= right; ++x)
            if (!marks.has(x, y) && !depth.hides(x, y, edge.nearest, to_x, to_y))
                marks.set(x, y);
    }
}

} // namespace

std::int64_t picture_refiner::refine(const drawn_frame& frame, l3d_workers& workers) {
    const int bands = (frame.window.bottom - frame.window.top + frame.rows - 1) / frame.rows;
    each_worker_.resize(static_cast<std::size_t>(workers.count()));
    marks_.resize(frame.target.size());
    const auto of_worker = [&](int worker) -> worker_space& {
        return each_worker_[static_cast<std::size_t>(worker)];
    };
    workers.for_each_beside(
        bands, [&](int band, int worker) { find_edges(frame, band, of_worker(worker)); });
    workers.for_each_beside(
        bands, [&](int band, int worker) { draw_marked(frame, band, of_worker(worker)); });
    std::int64_t refined = 0;
    for (worker_space& space : each_worker_)
        refined += std::exchange(space.refined, 0);
    return refined;
}

/// Finds the contours and jumps of a band. A pixel beside a drawn tile may be partly covered, too.
void picture_refiner::find_edges(const drawn_frame& frame, int band, worker_space& space) {
    const l3d_pixel_box box = box_of_band(frame, band);
    marks_.clear(box.top, box.bottom);
    const l3d_pixel_box drawn = frame.coarse.drawn_in(
        std::max(box.top - 1, frame.window.top), std::min(box.bottom + 1, frame.window.bottom));
    mark_jumps(frame.target,
               {std::max(drawn.left - 1, box.left), std::max(box.top - 1, frame.window.top),
                std::min(drawn.right + 1, box.right), box.bottom},
               box, marks_);

    const drawn_depth depth(frame.depth.data(), frame.depth.pitch(), frame.window, frame.coarse);
    space.borders.begin(box.top, box.bottom);
    for (const std::uint32_t index : frame.list.items(band)) {
        const band_item& item = frame.list.item(index);
        space.borders.add(item);
        if (is_hidden(frame, item))
            continue;
        for (const contour_edge& edge : space.edges.find(frame.list, item, box.top, box.bottom))
            mark_edge(edge, box, depth, marks_);
    }
    for (const contour_edge& edge : space.borders.match())
        mark_edge(edge, box, depth, marks_);
}

void picture_refiner::draw_marked(const drawn_frame& frame, int band, worker_space& space) {
    const l3d_pixel_box box = box_of_band(frame, band);
    const drawn_depth depth(frame.depth.data(), frame.depth.pitch(), frame.window, frame.coarse);
    for (l3d_pixel_box rest = box; !rest.empty();) {
        rest.top = space.fragments.begin(marks_, depth, rest, most_in_slice);
        draw_slice(frame, band, space);
    }
}

/// Draws the marked pixels of the slice with which the worker's fragments were begun.
void picture_refiner::draw_slice(const drawn_frame& frame, int band, worker_space& space) {
    if (space.fragments.pixels().empty())
        return;
    const bool levels = frame.shading.mode == l3d_shade::levels;
    const bool by_material = l3d_sees_patches(frame.shading.mode) ||
                             frame.shading.is_lit(frame.materials) || frame.shading.paints;
    space.fragments.use_colors(frame.colors, by_material);
    const auto add_items = [&](bool hidden_ones) {
        for (const std::uint32_t index : frame.list.items(band)) {
            const band_item& item = frame.list.item(index);
            if (hidden_ones || !is_hidden(frame, item))
                space.fragments.add(frame.list, item, levels);
        }
    };
    add_items(false);
    if (space.fragments.reopen())
        add_items(true);
    light_pixels(space.fragments, frame.shading, frame.materials, !frame.colors.empty(),
                 frame.target);
    space.refined += static_cast<std::int64_t>(space.fragments.pixels().size());
}

} // namespace l3d_detail
