// SPDX-License-Identifier: MIT
// tile_cover: finds the pixels of tiles that a triangle covers.
#ifndef L3D_PIPELINE_ZSORT_TILE_COVER_P_H
#define L3D_PIPELINE_ZSORT_TILE_COVER_P_H

#include "raster/surface_part.h"
#include "raster/zsort/painter.h"

#include <array>
#include <cstdint>

namespace l3d_detail {

/// Tiles of eight by eight pixels, side by side in rows.
struct cover_tiles {
    std::int32_t left, top;     ///< the first pixel of the first tile
    std::int32_t columns, rows; ///< numbers of tiles
};

/// The largest width and height of a triangle for tile_cover. 64 pixels are 2^14 steps of a
/// corner's place, whose products fit into 32 bits. Units: pixels.
inline constexpr std::int32_t tile_cover_reach = 64;

/// Finds the pixels of tiles that a triangle covers, by the fill rule of scan_polygon. Bit 8 r + c
/// of a tile's number is set if the pixel in its row r and column c is covered. The numbers of a
/// row of tiles follow each other in `covers`.
/// Expects: corners at most tile_cover_reach apart, and tiles that hold a pixel of the triangle's
///          box.
void tile_cover(const std::array<l3d_micro_vertex, 3>& v, const cover_tiles& tiles,
                std::uint64_t* covers);

} // namespace l3d_detail

#endif
