// SPDX-License-Identifier: MIT
// tile_sight: the cells of a tile that each triangle would show if the sort alone decided.
#ifndef L3D_PIPELINE_ZSORT_TILE_SIGHT_P_H
#define L3D_PIPELINE_ZSORT_TILE_SIGHT_P_H

#include "pipeline/zsort/painter_tiles_p.h"

#include <array>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Which cells of a triangle in a tile would be seen if triangles were painted in the order of the
/// sort. Cells are those of painter_entry.
struct cell_sight {
    std::uint64_t shown; ///< cells in which this triangle would be painted last
    /// Cells in which the sort may be wrong. There another triangle would be painted last, although
    /// it is not wholly in front of this triangle.
    std::uint64_t doubtful;
};

/// For each cell of a tile, row by row, the index of the tile's member that the sort paints last
/// there; -1 if there is none.
using tile_fronts = std::array<std::int32_t, 64>;

/// Finds the member that the sort paints last in each cell of a tile, and the sight of each member.
/// Shape:   `of` gets the sight of each member, and has as many elements as there are members.
/// Expects: the members stand in the order of rising numbers.
void find_sight(std::span<const painter_entry> members, tile_fronts& fronts, cell_sight* of);

} // namespace l3d_detail

#endif
