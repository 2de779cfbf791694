// SPDX-License-Identifier: MIT
// l3d_piece_pool: hands out pieces, and keeps their memory.
#ifndef L3D_DICE_PIECE_POOL_H
#define L3D_DICE_PIECE_POOL_H

#include "dice/diced_piece.h"

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

/// The diced pieces of a patch, in the order in which they were diced. The pool keeps the memory of
/// its pieces for later pieces.
///
/// Shape: a pool begins a pair of cache lines, since other workers write to other pools.
/// Cost:  allocates only if pieces are more, or larger, than ever before.
class alignas(128) l3d_piece_pool {
public:
    l3d_piece_pool() = default;

    /// Makes a pool whose pieces keep the parameters of their triangles.
    static l3d_piece_pool with_parameters() {
        l3d_piece_pool result;
        result.keep_parameters_ = true;
        return result;
    }

    /// Sets whether the pieces keep the parameters of their triangles from now on.
    void keep_parameters(bool keep) {
        if (keep_parameters_ == keep)
            return;
        keep_parameters_ = keep;
        for (l3d_diced_piece& piece : pieces_)
            piece.keep_parameters = keep;
    }

    /// Hands out an empty piece. Lives: the reference holds until next() is called again.
    l3d_diced_piece& next() {
        if (used_ == pieces_.size())
            pieces_.emplace_back().keep_parameters = keep_parameters_;
        l3d_diced_piece& piece = pieces_[used_++];
        piece.clear();
        return piece;
    }

    /// Takes back the piece that was handed out last. Expects: the piece is not used any more.
    void give_back() {
        assert(used_ > 0);
        --used_;
    }

    /// The pieces handed out since the last clear(), except for those given back.
    std::span<const l3d_diced_piece> used() const { return {pieces_.data(), used_}; }
    std::span<l3d_diced_piece> used() { return {pieces_.data(), used_}; }

    void clear() { used_ = 0; }

private:
    std::vector<l3d_diced_piece> pieces_;
    std::size_t used_ = 0;
    bool keep_parameters_ = false;
};

#endif
