// SPDX-License-Identifier: MIT
// coarse_depth: walks over tiles, for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/surfaces/coarse_depth.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/surfaces/coarse_depth_p.h"
#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <bit>

#ifndef L3D_RASTER_COARSE_DEPTH_ONCE
#define L3D_RASTER_COARSE_DEPTH_ONCE
namespace l3d_detail {

/// The box of tiles in which a box of pixels lies.
inline l3d_pixel_box tiles_of(const l3d_pixel_box& pixels) {
    constexpr auto width = depth_tile::width, height = depth_tile::height;
    return {pixels.left / width, pixels.top / height, (pixels.right + width - 1) / width,
            (pixels.bottom + height - 1) / height};
}

inline l3d_pixel_box tiles_of(const fill_band& band) {
    return tiles_of(l3d_pixel_box{0, band.top, band.width, band.bottom});
}

/// The pixels of some tiles side by side, as places in a band. Tiles at the right and lower borders
/// of the picture are smaller.
struct tile_pixels {
    /// Indices of the top left pixel of these tiles, in band.words and band.depths.
    std::ptrdiff_t words_at, depths_at;
    std::int32_t width, height;

    tile_pixels(std::int32_t begin, std::int32_t end, std::int32_t row, const fill_band& band) {
        const std::int32_t left = begin * depth_tile::width, top = row * depth_tile::height;
        words_at = (top - band.top) * band.word_pitch + left;
        depths_at = (top - band.top) * band.depth_pitch + left;
        width = std::min(end * depth_tile::width, band.width) - left;
        height = std::min(depth_tile::height, band.bottom - top);
    }
};

/// Calls visit(word, bits) for all words of a bit table's row that hold bits [begin, end), until a
/// call returns false. Returns whether all calls returned true.
template <class Visit> bool visit_bits(std::int32_t begin, std::int32_t end, const Visit& visit) {
    constexpr std::int32_t bits = 64;
    for (std::int32_t word = begin / bits; word * bits < end; ++word) {
        const std::int32_t from = std::max(begin - word * bits, 0);
        const std::int32_t to = std::min(end - word * bits, bits);
        const std::uint64_t some = (~std::uint64_t{0} >> (bits - (to - from))) << from;
        if (!visit(static_cast<std::size_t>(word), some))
            return false;
    }
    return true;
}

/// Calls visit(tile) for every set bit of a word.
template <class Visit> void visit_set(std::size_t word, std::uint64_t bits, const Visit& visit) {
    for (; bits != 0; bits &= bits - 1)
        visit(static_cast<std::int32_t>(64 * word) + std::countr_zero(bits));
}

inline std::size_t row_at(std::int32_t row, std::size_t pitch) {
    return static_cast<std::size_t>(row) * pitch;
}

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

/// Sets the depths of the pixels `p` to 0.
void clear(const tile_pixels& p, const fill_band& band) {
    float* to = band.depths + p.depths_at;
    if (p.width == depth_tile::width) // the usual case, for which no memset is called
        for (std::int32_t row = 0; row < p.height; ++row, to += band.depth_pitch)
            for (std::int32_t column = 0; column < depth_tile::width; column += lanes())
                hn::StoreU(hn::Zero(floats), floats, to + column);
    else
        for (std::int32_t row = 0; row < p.height; ++row, to += band.depth_pitch)
            std::fill_n(to, p.width, 0.0f);
}

void open(tile_table& table, const l3d_pixel_box& box, const fill_band& band) {
    const l3d_pixel_box tiles = tiles_of(box);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row) {
        std::uint64_t* const drawn = &table.drawn[row_at(row, table.words)];
        std::uint64_t* const newer = &table.newer[row_at(row, table.words)];
        visit_bits(tiles.left, tiles.right, [&](std::size_t word, std::uint64_t bits) {
            visit_set(word, bits & ~drawn[word], [&](std::int32_t column) {
                clear({column, column + 1, row, band}, band);
            });
            drawn[word] |= bits;
            newer[word] |= bits;
            return true;
        });
    }
}

/// Calls visit(pixels) for every run of neighbouring tiles in a row into which something was drawn,
/// or, if `drawn` is false, into which nothing was drawn.
template <class Visit>
void visit_runs(const tile_table& table, const fill_band& band, bool drawn, const Visit& visit) {
    const l3d_pixel_box tiles = tiles_of(band);
    const std::uint64_t flip = drawn ? 0 : ~std::uint64_t{0};
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        visit_bits(0, tiles.right, [&](std::size_t word, std::uint64_t bits) {
            bits &= table.drawn[row_at(row, table.words) + word] ^ flip;
            while (bits != 0) {
                const int first = std::countr_zero(bits);
                const int count = std::countr_one(bits >> first);
                const auto begin = static_cast<std::int32_t>(64 * word) + first;
                visit(tile_pixels(begin, begin + count, row, band));
                bits &= ~(~std::uint64_t{0} >> (64 - count) << first);
            }
            return true;
        });
}

void clear_words(const tile_table& table, const fill_band& band, const l3d_background& background,
                 std::int32_t height) {
    visit_runs(table, band, true, [&](const tile_pixels& p) {
        const auto top = band.top + static_cast<std::int32_t>(p.words_at / band.word_pitch);
        for (std::int32_t y = 0; y < p.height; ++y)
            std::fill_n(band.words + p.words_at + y * band.word_pitch, p.width,
                        background.word(top + y, height));
    });
}

void open_others(const tile_table& table, const fill_band& band) {
    visit_runs(table, band, false, [&](const tile_pixels& p) { clear(p, band); });
}

std::int64_t covered(const tile_table& table, const fill_band& band) {
    const hn::RebindToUnsigned<decltype(floats)> bits;
    const auto one = hn::Set(bits, 1u);
    auto in_lanes = hn::Zero(bits);
    std::int64_t rest = 0;
    visit_runs(table, band, true, [&](const tile_pixels& p) HWY_ATTR {
        for (std::int32_t y = 0; y < p.height; ++y) {
            const float* const depths = band.depths + p.depths_at + y * band.depth_pitch;
            std::int32_t x = 0;
            for (; x + lanes() <= p.width; x += lanes()) // only the float 0 has bits of 0
                in_lanes = hn::Add(in_lanes,
                                   hn::Min(hn::BitCast(bits, hn::LoadU(floats, depths + x)), one));
            for (; x < p.width; ++x)
                rest += depths[x] > 0;
        }
    });
    return rest + static_cast<std::int64_t>(hn::GetLane(hn::SumOfLanes(bits, in_lanes)));
}

/// The farthest depth in a tile. If this is below `limit`, the result may be any depth of the tile
/// below `limit`.
float find(std::int32_t column, std::int32_t row, const fill_band& band, float limit) {
    const tile_pixels p(column, column + 1, row, band);
    const float* depths = band.depths + p.depths_at;
    float farthest = depths[0];
    if (p.width == depth_tile::width) {
        auto all = hn::Set(floats, farthest);
        for (std::int32_t y = 0; y < p.height; ++y, depths += band.depth_pitch) {
            for (std::int32_t x = 0; x < depth_tile::width; x += lanes())
                all = hn::Min(all, hn::LoadU(floats, depths + x));
            if (!hn::AllFalse(floats, hn::Lt(all, hn::Set(floats, limit))))
                break;
        }
        farthest = hn::GetLane(hn::MinOfLanes(floats, all));
    } else {
        for (std::int32_t y = 0; y < p.height; ++y, depths += band.depth_pitch)
            farthest = std::min(farthest, *std::min_element(depths, depths + p.width));
    }
    return farthest;
}

bool hidden(tile_table& table, const l3d_pixel_box& box, float nearest, const fill_band& band) {
    const l3d_pixel_box tiles = tiles_of(box);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row) {
        const std::uint64_t* const drawn = &table.drawn[row_at(row, table.words)];
        if (!visit_bits(tiles.left, tiles.right, [&](std::size_t word, std::uint64_t bits) {
                return (bits & ~drawn[word]) == 0;
            }))
            return false;
    }
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        for (std::int32_t column = tiles.left; column < tiles.right; ++column) {
            float& farthest =
                table.farthest[row_at(row, table.columns) + static_cast<std::size_t>(column)];
            if (nearest <= farthest)
                continue;
            const float found = find(column, row, band, nearest);
            if (nearest > found)
                return false;
            farthest = found;
        }
    return true;
}

void refresh(tile_table& table, const fill_band& band) {
    const l3d_pixel_box tiles = tiles_of(band);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row)
        for (std::size_t word = 0; word < table.words; ++word) {
            std::uint64_t& newer = table.newer[row_at(row, table.words) + word];
            visit_set(word, newer, [&](std::int32_t column) {
                const auto at = row_at(row, table.columns) + static_cast<std::size_t>(column);
                table.farthest[at] = find(column, row, band, 0);
            });
            newer = 0;
        }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(open);
L3D_SIMD_TABLE(clear_words);
L3D_SIMD_TABLE(open_others);
L3D_SIMD_TABLE(hidden);
L3D_SIMD_TABLE(refresh);
L3D_SIMD_TABLE(covered);

void coarse_depth::resize(l3d_size size) {
    const l3d_pixel_box tiles = tiles_of(l3d_whole(size));
    table_.columns = static_cast<std::size_t>(tiles.right);
    table_.words = (table_.columns + 63) / 64;
    const auto rows = static_cast<std::size_t>(tiles.bottom);
    if (table_.farthest.size() < rows * table_.columns)
        table_.farthest.resize(rows * table_.columns);
    if (table_.drawn.size() < rows * table_.words) {
        table_.drawn.resize(rows * table_.words);
        table_.newer.resize(rows * table_.words);
    }
}

void coarse_depth::clear_words(const fill_band& band, const l3d_background& background,
                               std::int32_t height) const {
    L3D_SIMD_CALL(clear_words)(table_, band, background, height);
}

void coarse_depth::forget(std::int32_t top, std::int32_t bottom) {
    const l3d_pixel_box rows = tiles_of(l3d_pixel_box{0, top, 0, bottom});
    const auto forget_rows = [&](auto& numbers, std::size_t pitch) {
        std::fill(numbers.data() + row_at(rows.top, pitch),
                  numbers.data() + row_at(rows.bottom, pitch), 0);
    };
    forget_rows(table_.farthest, table_.columns);
    forget_rows(table_.drawn, table_.words);
    forget_rows(table_.newer, table_.words);
}

void coarse_depth::open(const l3d_pixel_box& box, const fill_band& band) {
    L3D_SIMD_CALL(open)(table_, box, band);
}

void coarse_depth::open_others(const fill_band& band) {
    L3D_SIMD_CALL(open_others)(table_, band);
}

bool coarse_depth::hidden(const l3d_pixel_box& box, float nearest, const fill_band& band) {
    return L3D_SIMD_CALL(hidden)(table_, box, nearest, band);
}

bool coarse_depth::hidden(const l3d_pixel_box& box, float nearest) const {
    const l3d_pixel_box tiles = tiles_of(box);
    for (std::int32_t row = tiles.top; row < tiles.bottom; ++row) {
        const float* const farthest = table_.farthest.data() + row_at(row, table_.columns);
        if (std::any_of(farthest + tiles.left, farthest + tiles.right,
                        [nearest](float tile) { return nearest > tile; }))
            return false;
    }
    return true;
}

void coarse_depth::refresh(const fill_band& band) {
    L3D_SIMD_CALL(refresh)(table_, band);
}

std::int64_t coarse_depth::covered(const fill_band& band) const {
    return L3D_SIMD_CALL(covered)(table_, band);
}

l3d_pixel_box coarse_depth::drawn_in(std::int32_t top, std::int32_t bottom) const {
    const std::int32_t rows_of_tiles = (bottom + depth_tile::height - 1) / depth_tile::height;
    std::int32_t first = static_cast<std::int32_t>(table_.columns), last = 0;
    for (std::int32_t row = top / depth_tile::height; row < rows_of_tiles; ++row)
        for (std::size_t word = 0; word < table_.words; ++word)
            visit_set(word, table_.drawn[row_at(row, table_.words) + word], [&](std::int32_t tile) {
                first = std::min(first, tile);
                last = std::max(last, tile + 1);
            });
    return {first * depth_tile::width, top, last * depth_tile::width, bottom};
}

} // namespace l3d_detail
#endif
