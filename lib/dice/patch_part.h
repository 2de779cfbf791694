// SPDX-License-Identifier: MIT
// l3d_patch_part: a part of a patch, and its halves.
#ifndef L3D_DICE_PATCH_PART_H
#define L3D_DICE_PATCH_PART_H

#include "geom/step_bound.h"

#include <array>
#include <tuple>

/// A part of a patch: its own homogeneous image net, and its range of parameters.
struct l3d_patch_part {
    l3d_image_patch net;
    double u0 = 0, u1 = 1, v0 = 0, v1 = 1;
    int depth = 0; ///< cuts that made it
};

/// Both halves of a piece, cut across u or across v; all members beyond l3d_patch_part are copies.
/// The lower half comes first.
template <class Piece> std::array<Piece, 2> l3d_halves(const Piece& p, bool along_u) {
    std::array<Piece, 2> result{p, p};
    auto& [low, high] = result;
    low.depth = high.depth = p.depth + 1;
    if (along_u) {
        std::tie(low.net, high.net) = p.net.split_u();
        low.u1 = high.u0 = (p.u0 + p.u1) / 2;
    } else {
        std::tie(low.net, high.net) = p.net.split_v();
        low.v1 = high.v0 = (p.v0 + p.v1) / 2;
    }
    return result;
}

#endif
