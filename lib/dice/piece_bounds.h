// SPDX-License-Identifier: MIT
// l3d_piece_bounds: nets of a piece and of its blocks, and bounds of the errors of its vertices.
#ifndef L3D_DICE_PIECE_BOUNDS_H
#define L3D_DICE_PIECE_BOUNDS_H

#include "geom/step_bound.h"
#include "scene/dice_view.h"
#include "dice/drawn_error.h"

#include <array>
#include <cstddef>
#include <span>

/// The largest number of steps of a strip in a piece that needs clipping. For other pieces, it is
/// l3d_most_steps_whole.
///
/// Clipped pieces are drawn slowly, and their triangles have no contours for smooth edges. So
/// pieces are cut until the lane dicer takes nearly all parts in front of the near plane. With 4
/// steps, 30 edge pixels of a ball beside the eye err by over 30 shade levels; with 2 steps, only 9
/// do (`near_outline`).
inline constexpr int l3d_most_steps_clipped = 2;

/// The nets of a piece and of its blocks. This class decides whether the piece is clipped and
/// whether it is walked, and bounds the errors of the piece's vertices.
///
/// Shape: block 4 * b + a is u-strip a, v-strip b; a small piece has one block.
template <class T> class l3d_piece_bounds {
public:
    l3d_piece_bounds(const l3d_image_net& piece, const l3d_dice_view& view);

    const l3d_image_net& net() const { return net_; }
    std::span<const l3d_image_patch> blocks() const { return std::span(blocks_).first(count_); }

    /// Whether the piece needs no clipping. Such a piece lies between the near and the far plane,
    /// in the guard band, and wholly on the kept side of a section.
    bool whole() const { return whole_; }

    /// Whether the piece's vertices are walked by forward differences in T. Else each vertex is
    /// evaluated, because walking would add more than l3d_dice_view::walk_allowance to the error.
    bool walked() const { return walked_; }

    /// The number that stands for 1 in the registers of a walk, a power of two. With this number,
    /// the piece's coordinates in fixed point are the largest that fit. The number depends on the
    /// piece alone.
    double unit() const { return unit_; }

    /// Bounds what rounding of the vertices adds to the chord error. Units: pixels.
    double vertex_error() const { return vertex_error_; }

    /// Bounds what rounding of the vertices adds to the chord error of slits along the piece's
    /// sides. Units: pixels.
    double row_error() const {
        return whole_ ? vertex_error_ - l3d_vertex_accuracy::of_centre() : vertex_error_;
    }

    /// Bounds the error of the vertices' w. Units: scaled w.
    double error_w() const { return error_w_; }

private:
    void bound_vertices(l3d_vertex_accuracy accuracy, const l3d_dice_view& view);

    l3d_image_net net_;
    std::size_t count_ = 1;
    std::array<l3d_image_patch, 16> blocks_;
    bool whole_ = false;
    bool walked_ = false;
    double unit_ = 1;
    double vertex_error_ = 0, error_w_ = 0;
};

#endif
