// SPDX-License-Identifier: MIT
// coarse_depth: the walks over tiles, for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/coarse_depth.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/simd_dispatch_p.h"

#include "raster/coarse_depth_p.h"

#include <algorithm>

#ifndef L3D_RASTER_COARSE_DEPTH_ONCE
#define L3D_RASTER_COARSE_DEPTH_ONCE
namespace l3d_detail {

/// Tiles in rows of `columns`.
struct tile_rows {
    depth_tile* tiles;
    std::size_t columns;

    depth_tile* row(std::int32_t index) const {
        return tiles + static_cast<std::size_t>(index) * columns;
    }
};

/// The tiles that pixels lie in.
inline pixel_box tiles_of(const pixel_box& pixels) {
    constexpr auto width = depth_tile::width, height = depth_tile::height;
    return {pixels.left / width, pixels.top / height, (pixels.right + width - 1) / width,
            (pixels.bottom + height - 1) / height};
}

inline pixel_box tiles_of(const fill_band& band) {
    return tiles_of(pixel_box{0, band.top, band.width, band.bottom});
}

/// The depths of some tiles in a row; at the right and lower end of the picture they are smaller.
struct tile_depths {
    std::ptrdiff_t at; ///< of the first, in the band
    std::int32_t width, height;

    tile_depths(std::int32_t begin, std::int32_t end, std::int32_t row, const fill_band& band) {
        const std::int32_t left = begin * depth_tile::width, top = row * depth_tile::height;
        at = (top - band.top) * band.depth_pitch + left;
        width = std::min(end * depth_tile::width, band.width) - left;
        height = std::min(depth_tile::height, band.bottom - top);
    }
};

} // namespace l3d_detail
#endif

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<float, depth_tile::width> floats;

std::int32_t lanes() {
    return static_cast<std::int32_t>(hn::Lanes(floats));
}

/// Sets depths to 0.
void clear(const tile_depths& p, const fill_band& band) {
    float* to = band.depths + p.at;
    if (p.width == depth_tile::width) // most often; the compiler then calls no memset
        for (std::int32_t row = 0; row < p.height; ++row, to += band.depth_pitch)
            for (std::int32_t column = 0; column < depth_tile::width; column += lanes())
                hn::StoreU(hn::Zero(floats), floats, to + column);
    else
        for (std::int32_t row = 0; row < p.height; ++row, to += band.depth_pitch)
            std::fill_n(to, p.width, 0.0f);
}

void open(const tile_rows& all, const pixel_box& box, const fill_band& band) {
    const pixel_box tiles = tiles_of(box);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        for (std::int32_t column = tiles.left; column < tiles.right; ++column) {
            depth_tile& tile = all.row(row)[column];
            tile.stale = true;
            if (tile.drawn)
                continue;
            tile.drawn = true;
            clear({column, column + 1, row, band}, band);
        }
}

/// Calls visit(begin, end, row) for every run of tiles side by side that have been drawn to, or of
/// those that have not.
template <class Visit>
void visit_runs(const tile_rows& all, const fill_band& band, bool drawn, const Visit& visit) {
    const pixel_box tiles = tiles_of(band);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row) {
        const depth_tile* const here = all.row(row);
        for (std::int32_t end = 0; end < tiles.right;) {
            std::int32_t begin = end;
            while (begin < tiles.right && here[begin].drawn != drawn)
                ++begin;
            end = begin;
            while (end < tiles.right && here[end].drawn == drawn)
                ++end;
            if (begin < end)
                visit(begin, end, row);
        }
    }
}

void open_others(const tile_rows& all, const fill_band& band) {
    visit_runs(all, band, false, [&](std::int32_t begin, std::int32_t end, std::int32_t row) {
        clear({begin, end, row, band}, band);
    });
}

std::int64_t covered(const tile_rows& all, const fill_band& band) {
    std::size_t count = 0;
    visit_runs(all, band, true, [&](std::int32_t begin, std::int32_t end, std::int32_t row) {
        const tile_depths p(begin, end, row, band);
        for (std::int32_t y = 0; y < p.height; ++y) {
            const float* const depths = band.depths + p.at + y * band.depth_pitch;
            std::int32_t x = 0;
            for (; x + lanes() <= p.width; x += lanes())
                count +=
                    hn::CountTrue(floats, hn::Gt(hn::LoadU(floats, depths + x), hn::Zero(floats)));
            for (; x < p.width; ++x)
                count += depths[x] > 0;
        }
    });
    return static_cast<std::int64_t>(count);
}

/// Finds a tile's farthest depth, unless a depth is below `least`: then there is no need to know.
void find(depth_tile& tile, std::int32_t column, std::int32_t row, const fill_band& band,
          float least) {
    const tile_depths p(column, column + 1, row, band);
    const float* depths = band.depths + p.at;
    float farthest = depths[0];
    if (p.width == depth_tile::width) {
        auto all = hn::Set(floats, farthest);
        const auto limit = hn::Set(floats, least);
        for (std::int32_t y = 0; y < p.height; ++y, depths += band.depth_pitch) {
            for (std::int32_t x = 0; x < depth_tile::width; x += lanes())
                all = hn::Min(all, hn::LoadU(floats, depths + x));
            if (!hn::AllFalse(floats, hn::Lt(all, limit)))
                return;
        }
        farthest = hn::GetLane(hn::MinOfLanes(floats, all));
    } else {
        for (std::int32_t y = 0; y < p.height; ++y, depths += band.depth_pitch)
            farthest = std::min(farthest, *std::min_element(depths, depths + p.width));
    }
    tile.farthest = farthest;
    tile.stale = false;
}

bool hidden(const tile_rows& all, const pixel_box& box, float nearest, const fill_band& band) {
    const pixel_box tiles = tiles_of(box);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        for (std::int32_t column = tiles.left; column < tiles.right; ++column) {
            depth_tile& tile = all.row(row)[column];
            if (nearest <= tile.farthest)
                continue;
            if (!tile.stale)
                return false;
            find(tile, column, row, band, nearest);
            if (nearest > tile.farthest)
                return false;
        }
    return true;
}

void refresh(const tile_rows& all, const fill_band& band) {
    const pixel_box tiles = tiles_of(band);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        for (std::int32_t column = tiles.left; column < tiles.right; ++column)
            if (depth_tile& tile = all.row(row)[column]; tile.stale)
                find(tile, column, row, band, 0);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(open);
L3D_SIMD_TABLE(open_others);
L3D_SIMD_TABLE(hidden);
L3D_SIMD_TABLE(refresh);
L3D_SIMD_TABLE(covered);

void coarse_depth::resize(l3d_size size) {
    const pixel_box tiles = tiles_of(whole(size));
    columns_ = static_cast<std::size_t>(tiles.right);
    const std::size_t count = columns_ * static_cast<std::size_t>(tiles.bottom);
    if (tiles_.size() < count)
        tiles_.resize(count);
}

void coarse_depth::forget(std::int32_t top, std::int32_t bottom) {
    const pixel_box rows = tiles_of(pixel_box{0, top, 0, bottom});
    const tile_rows all{tiles_.data(), columns_};
    std::fill(all.row(rows.top), all.row(rows.bottom), depth_tile{0, false, false});
}

void coarse_depth::open(const pixel_box& box, const fill_band& band) {
    L3D_SIMD_CALL(open)({tiles_.data(), columns_}, box, band);
}

void coarse_depth::open_others(const fill_band& band) {
    L3D_SIMD_CALL(open_others)({tiles_.data(), columns_}, band);
}

bool coarse_depth::hidden(const pixel_box& box, float nearest, const fill_band& band) {
    return L3D_SIMD_CALL(hidden)({tiles_.data(), columns_}, box, nearest, band);
}

bool coarse_depth::hidden(const pixel_box& box, float nearest) const {
    const pixel_box tiles = tiles_of(box);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row) {
        const depth_tile* const here = tiles_.data() + static_cast<std::size_t>(row) * columns_;
        if (std::any_of(here + tiles.left, here + tiles.right,
                        [nearest](const depth_tile& tile) { return nearest > tile.farthest; }))
            return false;
    }
    return true;
}

void coarse_depth::refresh(const fill_band& band) {
    L3D_SIMD_CALL(refresh)({tiles_.data(), columns_}, band);
}

std::int64_t coarse_depth::covered(const fill_band& band) const {
    // Nothing is changed; the walks over tiles have but one kind of rows.
    const tile_rows all{const_cast<depth_tile*>(tiles_.data()), columns_};
    return L3D_SIMD_CALL(covered)(all, band);
}

} // namespace l3d_detail
#endif
