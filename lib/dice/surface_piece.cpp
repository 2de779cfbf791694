// SPDX-License-Identifier: MIT
// l3d_cut_piece: halves that fit their neighbours.
#include "dice/surface_piece.h"

std::array<l3d_surface_piece, 2> l3d_cut_piece(const l3d_surface_piece& p, bool along_u,
                                               const l3d_dice_view& view, l3d_edge_polylines& edges,
                                               l3d_dice_counts& counts) {
    auto result = l3d_halves(p, along_u);
    auto& [low, high] = result;
    for (const std::size_t across : {along_u ? std::size_t{0} : 2, along_u ? std::size_t{1} : 3}) {
        const double middle = (p.sides[across].t0 + p.sides[across].t1) / 2;
        low.sides[across].t1 = high.sides[across].t0 = middle;
    }
    const std::size_t edge = edges.add(along_u ? low.net.column(3) : low.net.row(3), view);
    counts.add_edge(edges[edge].size(), edges[edge].bound());
    low.sides[along_u ? 3 : 1] = high.sides[along_u ? 2 : 0] = l3d_piece_side{edge, 0, 1};
    return result;
}
