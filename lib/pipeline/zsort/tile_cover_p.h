// SPDX-License-Identifier: MIT
// tile_cover: finds the pixels of tiles that a triangle covers.
#ifndef L3D_PIPELINE_ZSORT_TILE_COVER_P_H
#define L3D_PIPELINE_ZSORT_TILE_COVER_P_H

#include "raster/surface_part.h"
#include "raster/zsort/painter.h"

#include <array>
#include <cstdint>

namespace l3d_detail {

/// A rectangle of tiles of eight by eight pixels each.
struct cover_tiles {
    std::int32_t left, top;     ///< top left pixel of the first tile
    std::int32_t columns, rows; ///< numbers of tiles in a row and in a column
};

/// The largest width and height of a triangle that tile_cover takes. It is 64 pixels, or 2^14 steps
/// of a corner's coordinate, so that products of two lengths fit into 32 bits. Units: pixels.
inline constexpr std::int32_t tile_cover_reach = 64;

/// Finds the pixels that a triangle covers, by the fill rule of scan_polygon. `covers` gets a
/// number for each tile, row by row. Bit 8 r + c of a tile's number is set if the triangle covers
/// the pixel in the tile's row r and column c.
/// Expects: the corners are at most tile_cover_reach apart in x and y, and the rows and columns of
///          tiles all reach the triangle's box.
void tile_cover(const std::array<l3d_micro_vertex, 3>& v, const cover_tiles& tiles,
                std::uint64_t* covers);

} // namespace l3d_detail

#endif
