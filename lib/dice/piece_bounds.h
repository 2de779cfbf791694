// SPDX-License-Identifier: MIT
// l3d_piece_bounds: the nets of a piece, and the errors of its vertices.
#ifndef L3D_DICE_PIECE_BOUNDS_H
#define L3D_DICE_PIECE_BOUNDS_H

#include "geom/step_bound.h"
#include "scene/dice_view.h"
#include "dice/drawn_error.h"

#include <array>
#include <cstddef>
#include <span>

/// The most steps of a strip in a piece that needs clipping; others have l3d_most_steps_whole.
/// Clipped pieces are drawn slowly, and their triangles have no contours for smooth edges. So
/// pieces are cut until nearly all parts before the near plane go to the lanes. With 4 steps, 30
/// edge pixels of a ball beside the eye err by over 30 levels; with 2, only 9 do (`near_outline`).
inline constexpr int l3d_most_steps_clipped = 2;

/// The nets of a piece and of its blocks, the way to draw the piece, and the errors of its
/// vertices.
///
/// Shape: block 4 * b + a is u-strip a, v-strip b; or there is one block.
template <class T> class l3d_piece_bounds {
public:
    l3d_piece_bounds(const l3d_image_net& piece, const l3d_dice_view& view);

    const l3d_image_net& net() const { return net_; }
    std::span<const l3d_image_patch> blocks() const { return std::span(blocks_).first(count_); }

    /// Whether the piece needs no clipping: it lies between the near and the far plane and in the
    /// guard band.
    bool whole() const { return whole_; }

    /// Whether the piece is walked by forward differences in T. Else each vertex is evaluated,
    /// because walking would add more than l3d_dice_view::walk_allowance to the error.
    bool walked() const { return walked_; }

    /// The number that stands for 1 in a walk's registers, a power of two. Fixed point gets the
    /// largest coordinates that fit, however far all else in the picture is.
    double unit() const { return unit_; }

    /// The error that rounding of the vertices adds to the chord error. Units: pixels.
    double vertex_error() const { return vertex_error_; }

    /// The error that rounding of vertices adds to the chord error of slits along the piece's
    /// sides. Units: pixels.
    double row_error() const {
        return whole_ ? vertex_error_ - l3d_vertex_accuracy::of_centre() : vertex_error_;
    }

    /// Error of the vertices' w. Units: those of w.
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
