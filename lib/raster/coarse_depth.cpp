// SPDX-License-Identifier: MIT
// coarse_depth: the walks over tiles.
#include "raster/coarse_depth_p.h"

#include "raster/band_lanes_p.h"

#include <algorithm>

namespace l3d_detail {

namespace {

/// The tiles that pixels lie in.
pixel_box tiles_of(const pixel_box& pixels) {
    constexpr auto width = coarse_depth::tile_width, height = coarse_depth::tile_height;
    return {pixels.left / width, pixels.top / height, (pixels.right + width - 1) / width,
            (pixels.bottom + height - 1) / height};
}

pixel_box whole(const fill_band& band) {
    return {0, band.top, band.width, band.bottom};
}

/// The depths of a tile; at the right and lower end of the picture it is smaller.
depth_block depths_of(std::int32_t column, std::int32_t row, const fill_band& band) {
    const std::int32_t left = column * coarse_depth::tile_width;
    const std::int32_t top = row * coarse_depth::tile_height;
    return {band.depths + (top - band.top) * band.depth_pitch + left, band.depth_pitch,
            std::min(coarse_depth::tile_width, band.width - left),
            std::min(coarse_depth::tile_height, band.bottom - top)};
}

} // namespace

void coarse_depth::resize(l3d_size size) {
    const pixel_box tiles = tiles_of(l3d_detail::whole(size));
    columns_ = static_cast<std::size_t>(tiles.right);
    const std::size_t count = columns_ * static_cast<std::size_t>(tiles.bottom);
    if (tiles_.size() < count)
        tiles_.resize(count);
}

void coarse_depth::clear(std::int32_t top, std::int32_t bottom) {
    const pixel_box rows = tiles_of({0, top, 0, bottom});
    std::fill(&at(0, rows.top), &at(0, rows.top) + (rows.bottom - rows.top) * columns_,
              tile{0, false, false});
}

void coarse_depth::touch(const pixel_box& box) {
    const pixel_box tiles = tiles_of(box);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        for (std::int32_t column = tiles.left; column < tiles.right; ++column) {
            tile& t = at(column, row);
            t.touched = true;
            t.stale = true;
        }
}

void coarse_depth::find(tile& t, std::int32_t column, std::int32_t row, const fill_band& band) {
    t.farthest = farthest_of(depths_of(column, row, band));
    t.stale = false;
}

bool coarse_depth::hidden(const pixel_box& box, float nearest, const fill_band& band) {
    const pixel_box tiles = tiles_of(box);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        for (std::int32_t column = tiles.left; column < tiles.right; ++column) {
            tile& t = at(column, row);
            if (nearest <= t.farthest)
                continue;
            if (!t.stale)
                return false;
            find(t, column, row, band);
            if (nearest > t.farthest)
                return false;
        }
    return true;
}

bool coarse_depth::hidden(const pixel_box& box, float nearest) const {
    const pixel_box tiles = tiles_of(box);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        for (std::int32_t column = tiles.left; column < tiles.right; ++column)
            if (!(nearest <= at(column, row).farthest))
                return false;
    return true;
}

void coarse_depth::refresh(const fill_band& band) {
    const pixel_box tiles = tiles_of(whole(band));
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        for (std::int32_t column = tiles.left; column < tiles.right; ++column)
            if (tile& t = at(column, row); t.stale)
                find(t, column, row, band);
}

std::int64_t coarse_depth::covered(const fill_band& band) const {
    std::int64_t covered = 0;
    const pixel_box tiles = tiles_of(whole(band));
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        for (std::int32_t column = tiles.left; column < tiles.right; ++column)
            if (at(column, row).touched)
                covered += covered_of(depths_of(column, row, band));
    return covered;
}

} // namespace l3d_detail
