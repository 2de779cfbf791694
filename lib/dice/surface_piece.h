// SPDX-License-Identifier: MIT
// l3d_surface_piece: a patch in the image, or a part that was cut off a patch.
#ifndef L3D_DICE_SURFACE_PIECE_H
#define L3D_DICE_SURFACE_PIECE_H

#include "scene/counts.h"
#include "dice/edges/edge_polylines.h"
#include "dice/near_clip.h"
#include "geom/patch_part.h"

#include <array>
#include <cstddef>

/// The stretch of an edge polyline (l3d_edge_polyline) along which a piece's side lies, from t0 to
/// t1.
struct l3d_piece_side {
    std::size_t edge = 0; ///< index among the patch's edges
    double t0 = 0, t1 = 1;

    bool whole() const { return t0 == 0 && t1 == 1; }
};

/// A part of a patch that is diced by itself. It knows the edges that it shares with its
/// neighbours.
///
/// Shape: sides [0] v low, [1] v high (both along u), [2] u low, [3] u high (both along v).
struct l3d_surface_piece : l3d_patch_part {
    std::array<l3d_piece_side, 4> sides;

    /// The vertex of a corner, for clipping. All pieces that share the corner get the same place.
    /// The vertex has no normal.
    l3d_clip_vertex corner(bool high_u, bool high_v, const l3d_dice_view& view) const {
        l3d_clip_vertex result = l3d_canonical_vertex(net.at(high_v ? 3 : 0, high_u ? 3 : 0), view);
        result.dice.u = high_u ? u1 : u0;
        result.dice.v = high_v ? v1 : v0;
        return result;
    }
};

/// Cuts a piece into two halves, along u or along v. The sides across the cut are halved. The cut
/// itself becomes a new edge, which both halves have as a whole side. The new edge is added to
/// `edges` and `counts`.
inline std::array<l3d_surface_piece, 2> l3d_cut_piece(const l3d_surface_piece& p, bool along_u,
                                                      const l3d_dice_view& view,
                                                      l3d_edge_polylines& edges,
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

#endif
