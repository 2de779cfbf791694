// SPDX-License-Identifier: MIT
// tile_sight: the cells of a tile that each triangle would show if the sort alone decided.
#ifndef L3D_PIPELINE_ZSORT_TILE_SIGHT_P_H
#define L3D_PIPELINE_ZSORT_TILE_SIGHT_P_H

#include "pipeline/zsort/painter_tiles_p.h"

#include <array>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// The cells of a triangle in a tile that would be seen if triangles were painted in the order of
/// the sort. Cells are those of painter_entry.
struct cell_sight {
    std::uint64_t shown; ///< cells where all others are painted before it
    /// Hidden cells in which the sort may be wrong: their last painted triangle does not lie wholly
    /// in front of this one.
    std::uint64_t doubtful;
};

/// For each cell, row by row, the index of the member that is painted there last; -1 if none is.
using tile_fronts = std::array<std::int32_t, 64>;

/// Finds the members in front in a tile, and the sight of each member.
/// Shape:   `of` has as many elements as there are members.
/// Expects: members by rising numbers.
void find_sight(std::span<const painter_entry> members, tile_fronts& fronts, cell_sight* of);

} // namespace l3d_detail

#endif
