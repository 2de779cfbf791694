// SPDX-License-Identifier: MIT
// l3d_patch_part: a part of a patch, and its halves.
#ifndef L3D_GEOM_PATCH_PART_H
#define L3D_GEOM_PATCH_PART_H

#include "geom/normal_net.h"
#include "geom/step_bound.h"

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

/// A rectangle of a patch's parameters, and the homogeneous image net of the patch over the
/// rectangle. Searches halve parts, since the net of a smaller part bounds the patch more closely.
struct l3d_patch_part {
    l3d_image_net net;
    double u0 = 0, u1 = 1, v0 = 0, v1 = 1; ///< the rectangle's sides, without rounding errors
    int depth = 0; ///< the number of cuts that led to this part from the whole patch
};

/// A part of a patch, with the polynomial of the patch's normals over it, for searches that need
/// both.
struct l3d_exact_part : l3d_patch_part {
    l3d_normal_polynomial normals;
};

/// Cuts a part of a patch in half along u or along v, and returns both halves, the lower one first.
/// The halves get nets, ranges of parameters, depths and normals of their own; other members are
/// copied.
template <class Piece> std::array<Piece, 2> l3d_halves(const Piece& p, bool along_u) {
    std::array<Piece, 2> result{p, p};
    auto& [low, high] = result;
    low.depth = high.depth = p.depth + 1;
    std::tie(low.net, high.net) = along_u ? p.net.split_u() : p.net.split_v();
    (along_u ? low.u1 : low.v1) = (along_u ? high.u0 : high.v0) =
        along_u ? (p.u0 + p.u1) / 2 : (p.v0 + p.v1) / 2;
    if constexpr (std::is_base_of_v<l3d_exact_part, Piece>)
        std::tie(low.normals, high.normals) = along_u ? p.normals.split_u() : p.normals.split_v();
    return result;
}

/// Cuts a net at quarters of u and of v into 4 x 4 nets.
/// Shape: index 4 * row + column, columns along u.
template <class Net> std::array<Net, 16> l3d_blocks_of(const Net& net) {
    std::array<Net, 16> result;
    std::array<Net, 4> rows;
    const auto [low, high] = net.split_v();
    std::tie(rows[0], rows[1]) = low.split_v();
    std::tie(rows[2], rows[3]) = high.split_v();
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const auto [left, right] = rows[row].split_u();
        std::tie(result[4 * row], result[4 * row + 1]) = left.split_u();
        std::tie(result[4 * row + 2], result[4 * row + 3]) = right.split_u();
    }
    return result;
}

#endif
